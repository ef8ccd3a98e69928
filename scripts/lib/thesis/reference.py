"""What the thesis says (parameter_files/thesis/thesis.toml), and how each of it is measured here (chapter_N.toml)."""

import glob
import os
import tomllib

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(HERE)))
FILE = os.path.join(ROOT, "parameter_files", "thesis", "thesis.toml")
CHAPTERS = ("2", "3", "4", "5", "6", "7", "A")
# Where a value comes from, in the order of the report's columns.
SOURCES = {"taylor_hood": "Taylor-Hood", "cell_wise": "cell-wise", "theory": "theory"}
MEASURE_KEYS = {*SOURCES, "judged", "kind", "same_as", "holds", "ours", "ours_band", "why", "note", "unjudged"}


class DataError(Exception):
    """The data contradict themselves."""


class Entry:
    """A number or a finding of the thesis, with its measures."""

    def __init__(self, kind, data):
        self.kind = kind  # "number" | "finding"
        self.data = data
        self.measure = {}

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        return self.data.get(name)

    @property
    def sources(self):
        """{source: expression} of those that are given."""
        return {source: self.measure[source] for source in SOURCES if source in self.measure}

    @property
    def judged(self):
        """The source whose value decides; none where nothing is measured."""
        return self.measure.get("judged") or next(iter(self.sources), None)


class Figure:
    """A figure or table of the thesis."""

    def __init__(self, data):
        self.data = data

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        return self.data.get(name)


def data_of_file():
    with open(FILE, "rb") as stream:
        return tomllib.load(stream)


def numbers():
    """{id: value} of all that the thesis prints."""
    return {entry["id"]: entry["value"] for entry in data_of_file()["number"] if "value" in entry}


def read():
    """(figures, entries) in the order of the file."""
    data = data_of_file()
    figures = [Figure(figure) for figure in data["figure"]]
    entries = [Entry(kind, entry) for kind in ("number", "finding") for entry in data[kind]]
    by_id = {}
    for item in [*figures, *entries]:
        if item.id in by_id:
            raise DataError(f"{FILE}: '{item.id}' is there twice")
        by_id[item.id] = item
        if item.chapter not in CHAPTERS:
            raise DataError(f"{FILE}: '{item.id}' is of chapter '{item.chapter}', which the thesis has not")
    for path in sorted(glob.glob(os.path.join(HERE, "chapter_*.toml"))):
        with open(path, "rb") as stream:
            measures = tomllib.load(stream)
        for name, measure in measures.items():
            entry = by_id.get(name)
            if not isinstance(entry, Entry):
                raise DataError(f"{path}: there is no number or finding '{name}' in {os.path.basename(FILE)}")
            unknown = set(measure) - MEASURE_KEYS
            if unknown:
                raise DataError(f"{path}: '{name}' has the unknown key '{sorted(unknown)[0]}'")
            if entry.measure:
                raise DataError(f"{path}: '{name}' is measured twice")
            entry.measure = measure
            if not entry.sources:
                raise DataError(f"{path}: '{name}' gives none of {', '.join(SOURCES)}")
            if entry.judged not in entry.sources:
                raise DataError(f"{path}: '{name}' is judged by '{entry.judged}', which it does not give")
            if entry.comparable is not False and "ours" not in measure and (entry.deviation or "why" in measure):
                raise DataError(f"{path}: '{name}' explains a deviation without the value 'ours' that was explained; is it a note?")
            if entry.kind == "finding" and not {"holds", "unjudged"} & set(measure):
                raise DataError(f"{path}: the finding '{name}' needs 'holds'")
            if measure.get("kind", "input") not in ("input", "formula", "guard"):
                raise DataError(f"{path}: '{name}' is of the kind '{measure['kind']}', which is not 'input', 'formula' or 'guard'")
            if entry.kind == "number" and "value" not in entry.data and not (measure.get("kind") == "guard" and "holds" in measure):
                raise DataError(f"{path}: '{name}' has no value of the thesis, and is no guard that 'holds'")
    check_repetitions(entries)
    return figures, entries


def check_repetitions(entries):
    """Whether same_as stands where the same expression judges twice, and there alone."""
    first = {}
    for entry in entries:
        if not entry.sources or entry.comparable is False:
            continue
        expression = " ".join(entry.sources[entry.judged].split())
        other = first.setdefault(expression, entry.id)
        if entry.measure.get("same_as") != (other if other != entry.id else None):
            raise DataError(f"'{entry.id}' needs same_as = \"{other}\", which is judged by the same expression" if other != entry.id else
                            f"'{entry.id}' is not judged by the expression of '{entry.measure['same_as']}'")
