"""What scripts/measure/equal-error measures and how it judges: the runs, their errors, and the cheapest of them at an error."""

import dataclasses
import math
import os
import re

UNITS = {"m": 1.0, "Pa": 1.0, "MPa": 1e6, "GPa": 1e9, "kg/m^3": 1.0, "Hz": 1.0, "": 1.0}
THRESHOLDS = (0.01, 0.001)


@dataclasses.dataclass
class Run:
    """One run, or what was seen of it before it was stopped; times in seconds."""
    code: str
    cells: tuple
    time_step: float
    detail: str  # what else tells it from the others
    n_dofs: int = 0
    wall: float = 0.0
    processor: float = 0.0  # user and system
    memory: float = 0.0  # largest resident [bytes]
    reached: float = 0.0  # the time the run came to; less than asked for when it was stopped
    asked: float = 0.0
    frequency: float = math.nan  # [Hz]
    mean: float = math.nan  # [m]
    decay: float = math.nan  # factor of the amplitude an oscillation
    frequency_error: float = math.nan
    mean_error: float = math.nan

    @property
    def is_whole(self):
        return self.reached > 0.999 * self.asked

    @property
    def whole_processor(self):
        """Of the whole run: the time of one that was stopped grows with its steps."""
        return self.processor * self.asked / self.reached if self.reached > 0 else math.inf

    @property
    def error(self):
        """The larger one of the two; NaN where the run was stopped too early to tell."""
        return max(abs(self.frequency_error), abs(self.mean_error)) \
            if not math.isnan(self.frequency_error + self.mean_error) else math.nan

    @property
    def loss(self):
        return 1 - self.decay


def cheapest(runs, threshold, with_loss=False):
    """The run of least processor time whose errors are within the threshold, or None. `with_loss`: nor may the amplitude of
    the undamped beam change by more than that an oscillation."""
    fitting = [run for run in runs if run.error <= threshold and (not with_loss or abs(run.loss) <= threshold)]
    return min(fitting, key=lambda run: run.whole_processor, default=None)


def finest(runs):
    """The run with the smallest error, of those that say one."""
    return min((run for run in runs if not math.isnan(run.error)), key=lambda run: run.error, default=None)


def time_at(runs, threshold, with_loss=False):
    """(run, whether it is only a lower bound) of a code at an error: where no run satisfies it, the one closest to it took
    at least its time, as long as a run with a smaller error costs more."""
    run = cheapest(runs, threshold, with_loss)
    if run:
        return run, False
    return finest(runs), True


def entry(text, key):
    """The value in SI units of the first `set KEY = NUMBER UNIT` of a parameter file's text."""
    match = re.search(rf"^\s*set\s+{re.escape(key)}\s*=\s*([-+.\deE]+)[ \t]*([^\s,]*)", text, re.MULTILINE)
    if not match:
        raise ValueError(f"the parameter file has no entry '{key}'")
    return float(match.group(1)) * UNITS[match.group(2)]


def beam_of(text):
    """(the beam, its reference values) of the text of parameter_files/thesis/chapter-4/beam.prm, in SI units."""
    traction = re.search(r"^\s*set\s+Traction\s*=\s*0 Pa,\s*(\S+)\s+(\S+)", text, re.MULTILINE)
    if not traction:
        raise ValueError("the parameter file has no shear traction 'Traction = 0 Pa, ...'")
    beam = {"length": entry(text, "Length"), "height": entry(text, "Height"), "young": entry(text, "Young's modulus"),
            "poisson": entry(text, "Poisson's ratio"), "density": entry(text, "Density"),
            "shear": float(traction.group(1)) * UNITS[traction.group(2)]}
    reference = {"frequency": entry(text, "tip: mode 1 frequency"), "mean": entry(text, "tip: mean displacement y")}
    return beam, reference


def processor_name():
    """Of /proc/cpuinfo."""
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as stream:
            names = [line.split(":", 1)[1].strip() for line in stream if line.startswith("model name")]
    except OSError:
        names = []
    return f"{names[0] if names else 'unknown processor'}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}"


def percent(value):
    return "-" if math.isnan(value) else f"{100 * value:.2g} %"


def plain(value, digits=3):
    if math.isnan(value) or math.isinf(value):
        return "-"
    return f"{value:.{digits}g}" if abs(value) < 10**digits else f"{value:.0f}"


RUN_HEADER = ("code", "cells", "step [ms]", "", "dofs", "frequency [Hz]", "error", "mean [m]", "error", "loss an oscillation",
              "processor [s]", "wall [s]", "memory [MB]")


def row_of(run):
    """A run's cells of RUN_HEADER."""
    time = plain(run.whole_processor)
    if not run.is_whole:
        time += f" (stopped at {run.reached:.2g} s after {run.processor:.0f})"
    return (run.code, f"{run.cells[0]} x {run.cells[1]}", f"{1e3 * run.time_step:g}", run.detail, str(run.n_dofs),
            plain(run.frequency, 5), percent(run.frequency_error), plain(run.mean, 5), percent(run.mean_error),
            percent(run.loss), time, plain(run.wall), plain(run.memory / 1e6))


CHOICE_HEADER = ("error", "code", "cells", "step [ms]", "", "error of it", "processor [s]", "start alone [s]",
                 "over the first code")


def choices(codes, starts, thresholds=THRESHOLDS, with_loss=False):
    """Rows of CHOICE_HEADER. `codes`: runs by code, the first one is what the others are compared with; `starts`: processor
    time of starting and ending the program alone, by code."""
    rows = []
    for threshold in thresholds:
        base = None
        for number, (code, runs) in enumerate(codes.items()):
            run, is_bound = time_at(runs, threshold, with_loss)
            if run is None:
                rows.append((percent(threshold), code) + ("-", ) * (len(CHOICE_HEADER) - 2))
                continue
            if number == 0 and not is_bound:
                base = run.whole_processor
            sign = "> " if is_bound else ""
            ratio = "-" if base is None else sign + plain(run.whole_processor / base)
            rows.append((percent(threshold), code, f"{run.cells[0]} x {run.cells[1]}", f"{1e3 * run.time_step:g}", run.detail,
                         percent(run.error), sign + plain(run.whole_processor), plain(starts.get(code, 0.0)), ratio))
    return rows


def markdown(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return lines + ["| " + " | ".join(row) + " |" for row in rows]
