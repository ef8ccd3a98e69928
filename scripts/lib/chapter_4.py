"""The figures of the thesis's chapter 4 from runs of the cell-wise beams, and the thesis's numbers beside theirs.

What the thesis prints stands in parameter_files/thesis/thesis.toml. The runs of figures 4.7 to 4.15 are those that scripts/reproduce-thesis
judges.
"""

import math
import os

import continua
import numpy
import plot_histories
import plot_style
import tables
from thesis import reference

TIP = "tip: displacement y"
GREY = "#808080"
THESIS = reference.numbers()


class Run:
    """The results of one run: histories and quantities."""

    def __init__(self, folder, name):
        self.name = name
        self.folder = os.path.join(folder, name)
        self.quantities = {}
        self.summary = {}
        self.problem = "" if os.path.exists(os.path.join(self.folder, "summary.json")) else "no such run"
        if self.problem:
            return
        results = continua.open(self.folder)
        self.summary = results.summary
        if results.status == "failed":
            self.problem = f"the run failed: {results.reason}"
        found = [quantity for quantity in self.summary.get("quantities", []) if quantity["value"] is not None]
        names = [quantity["name"] for quantity in found]
        for quantity in found:
            # What several probes have belongs to none of them.
            if not quantity.get("probe") or names.count(quantity["name"]) == 1:
                self.quantities[quantity["name"]] = quantity["value"]

    def column(self, file, column):
        """(times, values) of a column, or None."""
        table = tables.read_table(os.path.join(self.folder, file))
        if table is None:
            return None
        columns, data = table
        names = [name for name, _ in columns]
        if column not in names:
            return None
        time = names.index("balance time") if "balance time" in names else 0
        values = data[:, names.index(column)]
        finite = numpy.isfinite(values)
        return data[finite, time], values[finite]

    def quantity(self, *names):
        """The first of these quantities that the run has."""
        return next((self.quantities[name] for name in names if name in self.quantities), math.nan)

    def maxima(self):
        """Times and values of the tip's maxima."""
        tip = self.column("probes.csv", TIP)
        maxima = plot_histories.turning_points(*tip)[0] if tip else []
        return numpy.array(maxima).reshape(-1, 2).T

    def loss(self, end):
        """The part of the first maximum that the last one before `end` [s] has lost."""
        times, values = self.maxima()
        values = values[times <= end]
        return 1 - values[-1] / values[0] if len(values) > 1 else math.nan

    def loss_by_mode(self, end):
        """The same of a beam that swings in its first mode alone, by the decay that is fitted to it: beats do not count."""
        decay, rate = self.quantity("mode 1 decay per oscillation"), self.quantity("mode 1 frequency")
        return (1 - decay**(rate * end)) / 2

    def beat(self):
        """Frequency [Hz] of the beats of the maxima: of the sine that with an offset and a trend fits them best."""
        times, values = self.maxima()
        if len(times) < 20:
            return math.nan
        duration = times[-1] - times[0]
        best = (math.inf, math.nan)
        # From one period in the record to the highest that samples at the maxima tell apart.
        for frequency in numpy.arange(1 / duration, 0.5 * (len(times) - 1) / duration, 0.01 / duration):
            angle = 2 * math.pi * frequency * times
            basis = numpy.stack([numpy.ones_like(times), times, numpy.cos(angle), numpy.sin(angle)], axis=1)
            residual = values - basis @ numpy.linalg.lstsq(basis, values, rcond=None)[0]
            best = min(best, (float(residual @ residual), frequency))
        return best[1]

    def power_residual(self):
        """Root mean square [W] of the power residual."""
        power = self.column("power.csv", "residual")
        return math.sqrt(numpy.mean(power[1]**2)) if power else math.nan


def losses(what, name, thesis, end=30.0):
    """The two rows of a run that loses motion."""
    return [(f"lost of the first maximum in {end:g} s, {what}", name, thesis, lambda run: 100 * run.loss(end), "%"),
            ("the same, by mode 1 alone", name, "", lambda run: 100 * run.loss_by_mode(end), "%")]


class Figure:
    """One figure: caption, runs with their labels, and what is told of it in numbers."""

    def __init__(self, caption, runs, draw, numbers=(), **options):
        self.caption = caption
        self.runs = runs  # name -> label
        self.draw = draw
        self.numbers = numbers  # (what, run, thesis's, function of the run, unit)
        self.options = options


def curve_style(i):
    return {"color": plot_style.COLOURS[i % len(plot_style.COLOURS)],
            "linestyle": plot_style.LINES[i // len(plot_style.COLOURS) % len(plot_style.LINES)]}


def finish(sheet, number, axes, columns, end, labels):
    axes.set_xlim(0, end)
    axes.set_xlabel("Time [s]")
    if labels:
        sheet.legend(axes, 2)  # of one curve, too: it says which run there is
    sheet.save(axes.get_figure(), f"figure-{number}")
    sheet.save_data(f"figure-{number}", [name for name, _ in columns], [values for _, values in columns])


def draw_thesis_lines(axes, options, end):
    """The values that the thesis prints, as lines across."""
    for value, text in options.get("thesis", []):
        axes.axhline(value, color=GREY, linewidth=0.7, linestyle=(0, (6, 3)))
        axes.annotate(text, (end, value), xytext=(-2, 2), textcoords="offset points", ha="right", fontsize=6.5, color=GREY)


def draw_histories(sheet, number, figure, runs):
    """The tip's displacement over time, as it is or its maxima and minima."""
    envelope = figure.options.get("envelope", False)
    _, axes = sheet.figure()
    end = figure.options["end"]
    columns, labels, colours = [], [], list(figure.runs)
    for run in runs:
        tip = run.column("probes.csv", TIP)
        if tip is None:
            sheet.notes.append(f"{run.name} in figure {number} (it has no '{TIP}')")
            continue
        label = figure.runs[run.name]
        inside = tip[0] <= end * (1 + 1e-9)
        time, values = tip[0][inside], tip[1][inside]
        style = curve_style(colours.index(run.name))
        labels.append(label)
        if not envelope:
            time, values = plot_histories.thinned(time, values)
            axes.plot(time, values, label=label, **style)
            columns += [(f"{label}: time [s]", time), (f"{label}: displacement y [m]", values)]
            continue
        for kind, points in zip(("maxima", "minima"), plot_histories.turning_points(time, values)):
            times, heights = numpy.array(points).reshape(-1, 2).T
            axes.plot(times, heights, marker="." if len(times) < 200 else None, markersize=3, linewidth=0.8,
                      label=label if kind == "maxima" else None, **style)
            columns += [(f"{label}: time of {kind} [s]", times), (f"{label}: {kind} of displacement y [m]", heights)]
    if not columns:
        plot_style.plt.close(axes.get_figure())
        return
    draw_thesis_lines(axes, figure.options, end)
    axes.set_ylabel("Displacement of the tip [m]" if not envelope else "Maxima and minima of the tip's displacement [m]")
    finish(sheet, number, axes, columns, end, labels)


def draw_power(sheet, number, figure, runs):
    """The power residual over time, each run in a panel of its own, since the noisiest would hide the others."""
    curves = [(run, run.column("power.csv", "residual")) for run in runs]
    for run, power in curves:
        if power is None:
            sheet.notes.append(f"{run.name} in figure {number} (no residual in power.csv)")
    curves = [(run, power) for run, power in curves if power is not None]
    if not curves:
        return
    _, all_axes = sheet.figure(0.25 + 0.2 * len(curves), nrows=len(curves), sharex=True, squeeze=False)
    end = figure.options["end"]
    columns = []
    for axes, (run, power) in zip(all_axes[:, 0], curves):
        inside = power[0] <= end * (1 + 1e-9)
        time, values = plot_histories.thinned(power[0][inside], power[1][inside])
        factor, unit = plot_style.readable(max(abs(values), default=0), "W")
        label = figure.runs[run.name]
        axes.plot(time, factor * values, linewidth=0.7, **curve_style(list(figure.runs).index(run.name)))
        rms = run.power_residual()
        axes.set_title(f"{label}: root mean square {rms:.3g} W", fontsize=7.5, loc="left")
        axes.set_ylabel(plot_style.axis_label("residual", unit))
        columns += [(f"{label}: time [s]", time), (f"{label}: residual [W]", values)]
    finish(sheet, number, all_axes[-1, 0], columns, end, [])


def bernoulli_roots(n):
    """The first n roots of cos(m) cosh(m) = -1, the eigenvalues of a cantilever."""
    roots = []
    for k in range(1, n + 1):
        low, high = (k - 1) * math.pi, k * math.pi
        # Divided by cosh, which overflows.
        value = lambda m: math.cos(m) + 1 / math.cosh(min(m, 700))  # noqa: E731
        for _ in range(200):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if value(low) * value(middle) > 0 else (low, middle)
        roots.append(0.5 * (low + high))
    return roots


def draw_eigenvalues(sheet, number, figure, runs):
    """The thesis's formula (4.8), the numbers it prints, and the modes of the plane body."""
    modulus, height, length, density = 4e9, 5.0, 20.0, 1450.0
    roots = numpy.array(bernoulli_roots(100))
    frequencies = roots**2 * math.sqrt(modulus * height**2 / (12 * density * length**4)) / (2 * math.pi)
    _, axes = sheet.figure()
    order = numpy.arange(1, len(roots) + 1)
    axes.loglog(order, frequencies, "-", color=plot_style.COLOURS[0], label="Euler-Bernoulli beam, equation 4.8")
    printed = [THESIS[f"4.2-f-{n}"] for n in range(1, 6)]
    axes.loglog(range(1, 6), printed, "o", color=GREY, markersize=5, markerfacecolor="none", label="printed in the thesis")
    columns = [("mode [1]", order), ("Euler-Bernoulli [Hz]", frequencies), ("thesis [Hz]", printed)]
    for i, run in enumerate(runs):
        modes = [run.quantity(f"mode {n} frequency") for n in (1, 2)]
        found = [(n, value) for n, value in zip((1, 2), modes) if math.isfinite(value)]
        if found:
            axes.loglog(*zip(*found), "x", color=plot_style.COLOURS[1 + i], label=figure.runs[run.name])
            columns.append((f"{figure.runs[run.name]} [Hz]", [value for _, value in found]))
    axes.set_xlabel("Mode of bending")
    axes.set_ylabel("Frequency [Hz]")
    sheet.legend(axes, 3)
    sheet.save(axes.get_figure(), f"figure-{number}")
    sheet.save_data(f"figure-{number}", [name for name, _ in columns], [values for _, values in columns])


def maximum(run):
    return run.quantity("first maximum displacement y", "maximum displacement y")


def frequency(run):
    return run.quantity("mode 1 frequency", "frequency of the fit", "frequency")


def beam(number, name, caption, end):
    thesis_maximum = THESIS[f"{number}-maximum"]
    return Figure(caption, {name: "cell-wise, backward differencing"}, draw_histories,
                  [("first maximum", name, thesis_maximum, maximum, "m"),
                   ("frequency", name, THESIS[f"{number}-frequency"], frequency, "Hz")],
                  end=end, thesis=[(thesis_maximum, f"thesis: {thesis_maximum:g} m")])


# With velocity and pressure, and AS_WRITTEN with Rhie and Chow's correction as the thesis writes it.
EULER, BACKWARD = "fv-velocity-pressure-longitudinal-30s", "fv-velocity-pressure-longitudinal-backward-differencing-30s"
AS_WRITTEN, MIDDLE = "fv-velocity-pressure-thesis-coupled-30s", "fv-velocity-pressure-longitudinal-60x20"
# FINEST is in the velocity form: with pressure it takes an hour.
FINE, FINEST, LOOSE = "fv-velocity-pressure-longitudinal-1e-5-30s", "fv-velocity-1e-6-30s", "fv-displacement-1e-5-17s"


def figures(names):
    """All figures by their number; `names`: the runs that there may be, of which those of 4.12 are not known here."""
    pressure = {"fv-velocity-pressure": "continua's variant", "fv-velocity-pressure-thesis": "thesis's variant",
                "fv-velocity-pressure-thesis-coupled": "thesis's variant, coupled"}
    prefix = "fv-pressure-"
    pressure.update({name: name[len(prefix):].replace("-", " ") for name in sorted(names) if name.startswith(prefix)})
    return {**FIGURES, "4.12": Figure(
        "Conditions for the pressure at boundaries", pressure, draw_histories,
        [(f"first maximum, {label}", name, "", maximum, "m") for name, label in pressure.items()], end=1.0)}


FIGURES = {
    "4.2": Figure("Eigenvalues of the cantilever", {"fv-displacement": "cell-wise, displacement form",
                                                    "fv-velocity": "cell-wise, velocity form"}, draw_eigenvalues,
                  [("mode 1", "fv-displacement", THESIS["4.2-f-1"], frequency, "Hz"),
                   ("mode 2", "fv-displacement", THESIS["4.2-f-2"], lambda run: run.quantity("mode 2 frequency"), "Hz")]),
    "4.3": Figure("End displacement, displacement form", {"fv-displacement": "displacement form"}, draw_histories,
                  [("first maximum", "fv-displacement", THESIS["4.3-maximum"], maximum, "m"),
                   ("frequency", "fv-displacement", THESIS["4.3-frequency"], frequency, "Hz"),
                   ("deflection at rest", "fv-displacement", THESIS["4.3-static"],
                    lambda run: run.quantity("modes offset", "mean displacement y"), "m")],
                  end=2.0, thesis=[(THESIS["4.3-maximum"], f"thesis: maximum {THESIS['4.3-maximum']:g} m"),
                                    (THESIS["4.3-static"], f"thesis: at rest {THESIS['4.3-static']:g} m")]),
    "4.4": Figure("Displacement form, envelope over 17 s",
                  {LOOSE: "tolerance 1e-5", "fv-displacement-30s": "coupled"}, draw_histories,
                  losses("tolerance 1e-5", LOOSE, "all of the motion", 17.0) +
                  losses("coupled", "fv-displacement-30s", "", 17.0),
                  end=THESIS["4.4-end"], envelope=True, thesis=[(THESIS["4.3-static"], f"thesis: at rest after {THESIS['4.4-end']:.0f} s")]),
    "4.5": Figure("Power residual, accumulated term consistent and inconsistent",
                  {"fv-velocity-inconsistent": "inconsistent (div grad)", "fv-velocity": "consistent (Laplacian)",
                   "fv-velocity-inconsistent-wide": "inconsistent, power by the wide operator",
                   "fv-velocity-wide": "consistent, power by the wide operator"}, draw_power,
                  [("root mean square, inconsistent", "fv-velocity-inconsistent", f"erratic, axis to ±{THESIS['4.5-axis']:.0g} W", Run.power_residual, "W"),
                   ("root mean square, consistent", "fv-velocity", "around 0", Run.power_residual, "W"),
                   ("the former by the wide operator", "fv-velocity-inconsistent-wide", "", Run.power_residual, "W"),
                   ("the latter by the wide operator", "fv-velocity-wide", "", Run.power_residual, "W")], end=1.0),
    "4.6": Figure("Power residual by tolerance",
                  {"fv-velocity-1e-6": "tolerance 1e-6", "fv-velocity-1e-7": "tolerance 1e-7",
                   "fv-velocity-1e-8": "tolerance 1e-8"}, draw_power,
                  [(f"root mean square, {tolerance}", f"fv-velocity-{tolerance}", text, Run.power_residual, "W")
                   for tolerance, text in (("1e-6", f"axis to {THESIS['4.6-axis']:.0g} W"), ("1e-7", "between"), ("1e-8", "smallest"))], end=1.0),
    "4.7": Figure("Displacement form and velocity-pressure form, Euler, envelopes over 30 s",
                  {"fv-displacement-30s": "displacement form", LOOSE: "displacement form, tolerance 1e-5",
                   EULER: "velocity-pressure form", AS_WRITTEN: "velocity-pressure form as the thesis writes it"}, draw_histories,
                  losses("velocity-pressure form", EULER, THESIS["4.7-loss-30s"]) +
                  losses("velocity-pressure form as the thesis writes it", AS_WRITTEN, THESIS["4.7-loss-30s"]) +
                  losses("displacement form", "fv-displacement-30s", "all of the motion"), end=30.0, envelope=True),
    "4.8": Figure("Euler and backward differencing, envelopes", {EULER: "Euler implicit",
                                                                BACKWARD: "backward differencing"}, draw_histories,
                  losses("Euler", EULER, THESIS["4.8-loss-30s"]) + losses("backward differencing", BACKWARD, "much smaller"),
                  end=30.0, envelope=True),
    "4.9": Figure("Time steps, Euler, envelopes", {EULER: "1e-4 s", FINE: "1e-5 s", FINEST: "1e-6 s (velocity form)"}, draw_histories,
                  losses("1e-4 s", EULER, "", 14.0) + losses("1e-5 s", FINE, f"{THESIS['4.9-gain-1e-5']:g} % less", 14.0) +
                  losses("1e-6 s", FINEST, f"{THESIS['4.9-gain-1e-6']:g} % less than 1e-5 s", 14.0), end=14.0, envelope=True),
    "4.10": Figure("Euler with 1e-5 s, backward differencing with 1e-4 s, envelopes",
                   {FINE: "Euler implicit, 1e-5 s", BACKWARD: "backward differencing, 1e-4 s"}, draw_histories,
                   losses("Euler, 1e-5 s", FINE, f"{THESIS['4.10-difference']:g} % more than backward differencing") +
                   losses("backward differencing, 1e-4 s", BACKWARD, ""), end=30.0, envelope=True),
    "4.11": Figure("Meshes, backward differencing, envelopes",
                   {BACKWARD: "40 x 10", MIDDLE: "60 x 20", "fv-200x50": "200 x 50 (velocity form)"}, draw_histories,
                   # 40 x 10: its page 96 prints two values.
                   [(f"beats, {mesh}", name, value, Run.beat, "Hz")
                    for mesh, name, value in (
                        ("40 x 10", BACKWARD, f"{THESIS['4.11-beat-40x10']:g} Hz, {THESIS['4.11-beat-40x10-second']:g} Hz"),
                        ("60 x 20", MIDDLE, THESIS["4.11-beat-60x20"]), ("200 x 50", "fv-200x50", THESIS["4.11-beat-200x50"]))], end=30.0, envelope=True),
    "4.12": None,  # in its place, see figures()
    "4.13": beam("4.13", "fv-velocity-pressure-beam-10x5", "Beam 10 m x 5 m", 1.0),
    "4.14": beam("4.14", "fv-velocity-pressure-beam-40x5", "Beam 40 m x 5 m", 5.0),
    "4.15": beam("4.15", "fv-velocity-pressure-beam-half-load", "Beam 20 m x 5 m, half the load", 1.0),
}

# Table 4.3: beam, run, and the names of its row and of its prediction in the data.
TABLE = [("10 m x 5 m, 1 MPa", "fv-velocity-pressure-beam-10x5", "T4.3-10x5", "4.13"),
         ("20 m x 5 m, 1 MPa", "fv-displacement", "T4.3-20x5", "T4.3-20x5"),
         ("40 m x 5 m, 1 MPa", "fv-velocity-pressure-beam-40x5", "T4.3-40x5", "4.14"),
         ("20 m x 5 m, 0.5 MPa", "fv-velocity-pressure-beam-half-load", "T4.3-half", "4.15")]


def text_of(value, unit=""):
    if isinstance(value, str):
        return value
    return f"{value:.4g}" + (f" {unit}" if unit else "") if math.isfinite(value) else "-"


def draw(sheet, chosen, folder):
    """Draws what runs there are; returns the lines of the numbers, as Markdown."""
    runs = {name: Run(folder, name) for name in
            dict.fromkeys([name for figure in chosen.values() for name in figure.runs] +
                          [row[1] for row in TABLE])}
    lines = ["| figure | what | thesis | here | run |", "|---|---|---|---|---|"]
    for name, run in runs.items():
        numbers = ", ".join(number for number, figure in chosen.items() if name in figure.runs)
        if run.problem:
            sheet.notes.append(f"{name}{' in figure ' if numbers else ''}{numbers} ({run.problem})")
    for number, figure in chosen.items():
        present = [runs[name] for name in figure.runs if not runs[name].problem]
        if present or figure.draw is draw_eigenvalues:
            figure.draw(sheet, number, figure, present)
        for what, name, thesis, value, unit in figure.numbers:
            here = value(runs[name]) if not runs[name].problem else math.nan
            lines.append(f"| {number} | {what} | {text_of(thesis, unit)} | {text_of(here, unit)} | {name} |")
    lines += ["", "Table 4.3", "",
              "| beam | displacement: analytical | thesis | here | frequency: analytical | thesis | here | run |",
              "|---" * 8 + "|"]
    for title, name, row, prediction in TABLE:
        run = runs[name]
        here = (math.nan, math.nan) if run.problem else (maximum(run), frequency(run))
        displacements, frequencies = ((THESIS[f"{row}-analytical-{kind}"], THESIS[f"{prediction}-{kind}"]) for kind in ("maximum", "frequency"))
        lines.append(f"| {title} | {displacements[0]:g} m | {displacements[1]:g} m | {text_of(here[0], 'm')} | "
                     f"{frequencies[0]:g} Hz | {frequencies[1]:g} Hz | {text_of(here[1], 'Hz')} | {name} |")
    return lines
