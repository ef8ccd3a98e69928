"""Values of the thesis and of Continua beside each other: what the verdict is, and why."""

import math
import os
import re

import case_runs

from .results import Broken, NotThere, files_of

# In the order of the summary. The last three are failures.
AGREES, FORMULA, INPUT, GUARD, EXPLAINED, SHOWN, NOT_COMPARABLE, NOT_MEASURED, NOT_RUN, CHANGED, DIFFERS, BROKEN = (
    "agrees", "formula", "input", "guard", "explained", "shown", "not comparable", "not measured", "not run", "CHANGED", "DIFFERS", "BROKEN")
VERDICTS = {
    AGREES: "the value lies in the thesis's band, or the finding is true",
    FORMULA: "the same, but the value rests on formulas alone: no simulation is behind it",
    INPUT: "the same, but the value is an input: the run gives back what it was given",
    GUARD: "the thesis has no number; the value is that of exact theory, and guards the input against a change",
    EXPLAINED: "the value lies elsewhere; the reason stands beside it, and the value is the one that was explained",
    SHOWN: "a value without a verdict, since it depends on the machine",
    NOT_COMPARABLE: "Continua has no such quantity, or the thesis does not state enough",
    NOT_MEASURED: "comparable, but this report has no measure of it",
    NOT_RUN: "needs a run that was not asked for, or that failed",
    CHANGED: "a deviation that was explained has another value now, or is gone",
    DIFFERS: "the value lies outside of the thesis's band, without a reason",
    BROKEN: "the runs are there, but the measure gives no value",
}
FAILURES = (CHANGED, DIFFERS, BROKEN)
# What an entry of chapter_N.toml may say of its judged value; without it a simulation is behind the value.
KINDS = {"formula": FORMULA, "input": INPUT, "guard": GUARD}


def criterion(text):
    """The function of a text '> x', '< x' or 'a .. b' that says whether a value meets it."""
    match = re.fullmatch(r"\s*([<>])\s*([-+.\deE]+)\s*", text)
    if match:
        bound = float(match.group(2))
        return (lambda value: value < bound) if match.group(1) == "<" else (lambda value: value > bound)
    match = re.fullmatch(r"\s*([-+.\deE]+)\s*\.\.\s*([-+.\deE]+)\s*", text)
    if not match:
        raise ValueError(f"'{text}' is no '> x', '< x' or 'a .. b'")
    low, high = float(match.group(1)), float(match.group(2))
    return lambda value: low <= value <= high


def is_near(value, reference, band):
    return abs(value - reference) <= band * (abs(reference) if reference else 1.0) * (1 + 1e-9)


class Row:
    """One number or finding with its values and its verdict."""

    def __init__(self, entry, results):
        self.entry = entry
        self.values, self.missing, self.broken = {}, {}, {}
        for source, expression in entry.sources.items():
            try:
                self.values[source] = results.value(expression)
            except NotThere as error:
                self.missing[source] = str(error)
            except Broken as error:
                self.broken[source] = str(error)
        self.value = self.values.get(entry.judged)
        self.verdict, self.why = self.judge()
        self.cost = self.cost_of_runs(results)

    def judge(self):
        entry, measure = self.entry, self.entry.measure
        if entry.comparable is False:
            return NOT_COMPARABLE, entry.why_not or ""
        if not entry.sources:
            return NOT_MEASURED, entry.why_not or ""
        if self.broken:
            return BROKEN, "; ".join(self.broken.values())
        if self.value is None:
            return NOT_RUN, self.missing[entry.judged]
        if "unjudged" in measure:
            return SHOWN, measure["unjudged"]
        notes = [entry.note, measure.get("note")]
        why = " ".join(text for text in (entry.deviation, measure.get("why"), *notes) if text)
        if "holds" in measure:
            agrees = criterion(measure["holds"])(self.value)
        else:
            agrees = is_near(self.value, entry.value, entry.band)
        is_explained = "ours" in measure and is_near(self.value, measure["ours"], measure.get("ours_band", 0.01))
        # A deviation that is gone has changed, too: two errors may cancel.
        if measure.get("kind") == "guard" and not agrees:
            return CHANGED, why
        if "ours" in measure and not is_explained:
            return CHANGED, f"{why} Explained was {measure['ours']:.6g}.".strip()
        if agrees:  # without what explains a deviation
            return KINDS.get(measure.get("kind"), AGREES), " ".join(text for text in notes if text)
        if is_explained:
            return EXPLAINED, why
        return DIFFERS, why

    def files(self):
        """The parameter files behind the judged value, in their order."""
        return files_of(self.entry.sources[self.entry.judged]) if self.entry.sources else []

    def deviation(self):
        """Of a number, relative to the thesis's; none where that is zero or the verdict asks for something else."""
        if self.value is None or self.entry.kind != "number" or "holds" in self.entry.measure or not self.entry.value:
            return None
        return self.value / self.entry.value - 1

    def cost_of_runs(self, results):
        """Seconds on the clock of the runs behind the judged value; none without runs."""
        total = None
        for path in self.files():
            summary = case_runs.read_summary(os.path.join(results.folder, case_runs.name_of(path)))
            wall = (summary.get("wall time [s]") or {}).get("total")
            if wall is not None:
                total = (total or 0.0) + wall + summary.get("wall time before the restart [s]", 0.0)
        return total


def needed_files(entries):
    """The parameter files behind the entries that can be compared, in their order."""
    found = {}
    for entry in entries:
        if entry.comparable is False:
            continue
        for expression in entry.sources.values():
            for path in files_of(expression):
                found.setdefault(path, None)
    return list(found)


def repeated(rows):
    """The rows that are judged by the same expression as another one, and have its verdict: they do not count twice."""
    verdicts = {row.entry.id: row.verdict for row in rows}
    return [row for row in rows if verdicts.get(row.entry.measure.get("same_as")) == row.verdict]


def counts(rows):
    """{verdict: how many} in the order of VERDICTS, without what is repeated."""
    left_out = repeated(rows)
    return {verdict: sum(row.verdict == verdict and row not in left_out for row in rows) for verdict in VERDICTS}


def text_of(value, unit=""):
    """Four significant digits and the unit."""
    if value is None or not math.isfinite(value):
        return "-"
    text = f"{value:.4g}"
    return f"{text} {unit}" if unit and unit != "1" else text
