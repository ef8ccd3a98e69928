"""Figures of a sweep: each quantity over the values of the entries, and the histories of its runs laid over each other."""

import math
import os
import textwrap

import continua
import continua.tables
import matplotlib
import numpy
import plot_histories
import plot_material
import plot_style
import plot_waves

MOST_CURVES = 6  # of a family; more are a map
MOST_LOOKS = 8  # curves that colour, dash and marker tell apart
MOST_RUNS = 8  # whose histories are laid over each other


class Axis:
    """A swept entry: `name` for its axis, `unit`, and its value in each row; words have their place from 0 on as their number."""

    def __init__(self, column, unit, cells, names):
        self.column, self.unit = column, unit
        self.name = next(tail for tail in tails(column) if sum(tail in tails(other) for other in names) == 1 or tail == column)
        self.words = [] if all(isinstance(cell, (int, float, numpy.number)) for cell in cells) else list(dict.fromkeys(map(str, cells)))
        self.values = numpy.array([self.words.index(str(cell)) if self.words else float(cell) for cell in cells])
        self.factor, self.shown_unit = (1.0, "") if self.words else plot_style.readable(abs(self.values).max(), unit)

    def distinct(self):
        return sorted(set(self.values))

    def text(self, value):
        """"2 MPa", or the word."""
        if self.words:
            return self.words[int(value)]
        unit = "" if self.shown_unit in ("", "1") else f" {self.shown_unit}"
        return f"{self.factor * value:.6g}{unit}"

    def is_logarithmic(self):
        """Whether the values are at equal ratios, over more than a decade."""
        values = self.distinct()
        if self.words or len(values) < 3 or values[0] <= 0 or values[-1] < 10 * values[0]:
            return False
        ratios = numpy.diff(numpy.log(values))
        return bool(ratios.max() < 1.1 * ratios.min())

    def dress(self, panel, which):
        """Label, scale and ticks of the axis "x" or "y" of a panel."""
        axis = panel.xaxis if which == "x" else panel.yaxis
        axis.set_label_text(plot_style.axis_label(self.name, self.shown_unit))
        if self.words:
            axis.set_ticks(range(len(self.words)), self.words)
        elif self.is_logarithmic():
            getattr(panel, f"set_{which}scale")("log")


def tails(column):
    """"c", "b/c", "a/b/c" of a/b/c."""
    parts = column.split("/")
    return ["/".join(parts[-n:]) for n in range(1, len(parts) + 1)]


def is_sweep(folder):
    return os.path.exists(os.path.join(folder, "sweep.csv"))


def read(folder):
    """(list of Axis, [(quantity, unit, values)], names of the runs, whether each failed)."""
    results = continua.open(folder)
    table = results.table("sweep")
    if table.empty:
        raise plot_style.PlotError(f"{folder}/sweep.csv has no rows")
    swept = [continua.tables.split_unit(column)[0] for column in results.summary.get("swept", [])]
    units = table.attrs["units"]
    missing = [name for name in swept if name not in table]
    if not swept or missing:
        raise plot_style.PlotError(f"{folder}: summary.json and sweep.csv do not belong together")
    axes = [Axis(name, units.get(name, ""), list(table[name]), swept) for name in swept]
    quantities = [(name, units.get(name, ""), numpy.array(table[name], dtype=float)) for name in table.columns
                  if name not in ("run", "wall time", "failure", *swept)]
    failed = numpy.array([bool(text) and text == text for text in table["failure"]])
    return axes, quantities, list(table["run"]), failed


def draw(sheet, folder, normalised):
    axes, quantities, names, failed = read(folder)
    varied = [axis for axis in axes if len(axis.distinct()) > 1] or axes[:1]
    for name, unit, values in quantities:
        if numpy.isfinite(values).any():
            draw_quantity(sheet, varied, name, unit, values, failed)
        else:
            sheet.notes.append(f"{name} (no run has a value)")
    draw_histories(sheet, folder, varied, names, failed, normalised)


def draw_quantity(sheet, axes, name, unit, values, failed):
    """A curve over one entry, a family of curves or a map over two; over more, a curve for each combination of the others."""
    factor, shown_unit = plot_style.readable(numpy.nanmax(abs(values)), unit, name.rpartition(": ")[2])
    label = textwrap.fill(plot_style.axis_label(name, shown_unit), 50)
    # Over numbers rather than words, and over the entry with the most values.
    along = max(axes, key=lambda axis: (not axis.words, len(axis.distinct())))
    others = [axis for axis in axes if axis is not along]
    moves_together = len(axes) > 1 and len(axes[0].values) == len(along.distinct())
    if moves_together:
        others = []
    combinations = list(dict.fromkeys(zip(*(axis.values for axis in others)))) if others else [()]
    is_map = len(others) == 1 and len(combinations) > MOST_CURVES and not along.words and not others[0].words
    if len(combinations) > MOST_LOOKS and not is_map:
        sheet.notes.append(f"{name} ({len(combinations)} curves over {along.name} are too many for one picture; sweep.csv has the values)")
        return
    figure, panel = sheet.figure(0.6 if is_map else 0.55)
    file = "sweep-" + plot_style.file_name(name)
    if is_map:
        draw_map(figure, panel, along, others[0], factor * values, label)
        sheet.save(figure, file)
        return
    header, columns = [], []
    for i, combination in enumerate(combinations):
        chosen = numpy.ones(len(values), dtype=bool)
        for axis, value in zip(others, combination):
            chosen &= axis.values == value
        rows = [row for row in numpy.flatnonzero(chosen) if math.isfinite(values[row])]
        rows.sort(key=lambda row: along.values[row])
        text = ", ".join(f"{axis.name} {axis.text(value)}" for axis, value in zip(others, combination))
        look = plot_style.of_run(i)
        panel.plot(along.factor * along.values[rows], factor * values[rows], label=text, marker=plot_style.MARKERS[i % 8] or "o",
                   markersize=4, linestyle="none" if along.words else look["linestyle"], color=look["color"], clip_on=False)
        header += [f"{text}: {along.name} [{along.unit}]" if text else f"{along.name} [{along.unit}]",
                   f"{text}: {name} [{unit}]" if text else f"{name} [{unit}]"]
        columns += [along.values[rows], values[rows]]
    along.dress(panel, "x")
    panel.set_ylabel(label)
    room_for_one_value(panel)
    if failed.any():
        panel.plot(along.factor * along.values[failed], numpy.zeros(failed.sum()), "x", color="#7F7F7F", markersize=4, label="failed",
                   transform=panel.get_xaxis_transform(), clip_on=False)
    if along.words:
        panel.set_xlim(-0.5, len(along.words) - 0.5)
    sheet.legend(panel, len(panel.lines))
    sheet.save(figure, file)
    sheet.save_data(file, header, columns)


def room_for_one_value(panel):
    """A quantity that does not change is no reason to show its last digits."""
    low, high = panel.get_ylim()
    values = numpy.concatenate([line.get_ydata() for line in panel.lines])
    middle = abs(values).max()
    if middle > 0 and values.max() - values.min() < 1e-6 * middle and panel.get_yscale() == "linear":
        panel.set_ylim(min(low, values.min() - 0.1 * middle), max(high, values.max() + 0.1 * middle))


def draw_map(figure, panel, along, across, values, label):
    """Colours over two entries, each value as a field of its own: nothing is interpolated."""
    xs, ys = along.distinct(), across.distinct()
    grid = numpy.full((len(ys), len(xs)), math.nan)
    for x, y, value in zip(along.values, across.values, values):
        grid[ys.index(y), xs.index(x)] = value
    edges = [axis.factor * numpy.array(edges_of(axis)) for axis in (along, across)]
    along.dress(panel, "x")
    across.dress(panel, "y")
    colours = matplotlib.colormaps["viridis"].with_extremes(bad="#DDDDDD")
    image = panel.pcolormesh(*edges, grid, cmap=colours, linewidth=0, rasterized=True)
    panel.set_xlim(edges[0][0], edges[0][-1])
    panel.set_ylim(edges[1][0], edges[1][-1])
    figure.colorbar(image, ax=panel, label=label)
    if not numpy.isfinite(grid).all():
        panel.text(1.0, 1.01, "grey: no value", fontsize=7.5, ha="right", va="bottom", transform=panel.transAxes)


def edges_of(axis):
    """The borders of the fields around the values, halfway between two of them on their scale."""
    values = numpy.array(axis.distinct())
    if axis.is_logarithmic():
        return numpy.exp(borders(numpy.log(values)))
    return borders(values)


def borders(values):
    middles = 0.5 * (values[1:] + values[:-1])
    return [values[0] - (middles[0] - values[0]), *middles, values[-1] + (values[-1] - middles[-1])]


def draw_histories(sheet, folder, axes, names, failed, normalised):
    """Of up to eight runs, evenly chosen where there are more."""
    there = [i for i, name in enumerate(names) if not failed[i] and os.path.isdir(os.path.join(folder, name))]
    chosen = [there[round(k)] for k in numpy.linspace(0, len(there) - 1, MOST_RUNS)] if len(there) > MOST_RUNS else there
    if len(chosen) < len(there):
        sheet.notes.append(f"histories of {len(there) - len(chosen)} of the {len(there)} runs (one picture shows {MOST_RUNS}); "
                           "scripts/plot RUN... draws those that you name")
    runs = []
    for i in chosen:
        title = ", ".join(f"{axis.name} {axis.text(axis.values[i])}" for axis in axes)
        path = os.path.join(folder, names[i])
        results = continua.open(path)
        runs.append({"folder": path, "title": title, "summary": results.summary if results.has("summary.json") else {}})
    notes = len(sheet.notes)
    if runs:
        plot_histories.draw_probes(sheet, runs)
        plot_waves.draw_curves(sheet, runs, normalised)
        plot_material.draw(sheet, runs)
    # That there is no tube, no material or no history in any run is no news.
    kept = [note for note in sheet.notes[notes:] if not any(run["folder"] in note for run in runs)]
    del sheet.notes[notes:]
    sheet.notes += kept
