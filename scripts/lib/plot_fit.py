"""Figures of fits: measured values as open markers, the fit as a line, below them what is left over the noise; and correlations."""

import os

import numpy
import plot_style
import tables

# File -> its panels: measured column, the name on the axis, column of the residual.
SERIES = {
    "fit-relaxation": ("time", (("relaxation modulus", "residual over the noise"),)),
    "fit-creep": ("time", (("compliance", "residual over the noise"),)),
    "fit-moduli": ("frequency", (("storage modulus", "residual of the storage modulus over the noise"),
                                 ("loss modulus", "residual of the loss modulus over the noise"))),
}
AXES = {"time": "Time [s]", "frequency": "Frequency [Hz]"}
MARKERS = ["o", "s", "^", "D", "v", "p", "h", "<"]


def draw(sheet, runs):
    for name, (abscissa, panels) in SERIES.items():
        for run in runs:
            draw_series(sheet, runs, run, name, abscissa, panels)
    for run in runs:
        draw_inflation(sheet, runs, run)
        draw_correlation(sheet, runs, run)


def read(run, name):
    """(column by name, its unit by name) of a table of the run; None if it has none."""
    table = tables.read_table(os.path.join(run["folder"], f"{name}.csv"))
    if table is None:
        return None
    names, data = table
    return {column: data[:, i] for i, (column, _) in enumerate(names)}, dict(names)


def name_of(runs, run, name):
    """Of the picture: a run has one of its own, since a fit is no curve to be laid over others."""
    return name if len(runs) == 1 else f"{name}-{plot_style.file_name(run['title'])}"


def two_rows(sheet, n_columns, height=0.5):
    """Panels for values, and lower ones below them for residuals, as rows of an array."""
    narrow = sheet.width < 4 and n_columns > 1
    figure, axes = sheet.figure(1.1 if narrow else height + (0.25 if n_columns == 1 else 0), nrows=2, ncols=n_columns, sharex="col",
                                squeeze=False, gridspec_kw={"height_ratios": [3, 1]})
    return figure, axes


def draw_residuals(axes, abscissa, residual, **look):
    axes.axhline(0, color="#999999", linewidth=0.6)
    axes.plot(abscissa, residual, linestyle="none", fillstyle="none", markersize=3, markeredgewidth=0.6, **look)


def draw_series(sheet, runs, run, name, abscissa, panels):
    """A table over time or frequency, logarithmic."""
    found = read(run, name)
    if found is None:
        return
    values, units = found
    figure, axes = two_rows(sheet, len(panels))
    x = values[abscissa]
    for column, (quantity, residual) in enumerate(panels):
        factor, unit = plot_style.readable(numpy.abs(values[quantity]).max(), units[quantity])
        upper, lower = axes[0][column], axes[1][column]
        upper.plot(x, factor * values[quantity], "o", color=plot_style.MEASURED, markersize=3, fillstyle="none", markeredgewidth=0.6,
                   label="measured")
        upper.plot(x, factor * values[f"{quantity} of the fit"], "-", color=plot_style.COLOURS[0], label="fit")
        upper.set_xscale("log")
        upper.set_ylabel(plot_style.axis_label(quantity, unit))
        draw_residuals(lower, x, values[residual], marker="o", color=plot_style.MEASURED)
        lower.set_xlabel(AXES[abscissa])
        lower.set_ylabel("Residual / noise" if column == 0 else "")
    plot_style.legend_above(figure, axes[0][0].get_lines(), sheet.width)
    finish(sheet, figure, name_of(runs, run, name), values, units)


def draw_inflation(sheet, runs, run):
    """Diameter and axial force over the pressure, a curve for each axial stretch."""
    found = read(run, "fit-inflation")
    if found is None:
        return
    values, units = found
    diameter = "outer diameter" if "outer diameter" in values else "inner diameter"
    panels = [(diameter, "residual of the diameter over the noise")]
    if "axial force" in values:
        panels.append(("axial force", "residual of the axial force over the noise"))
    figure, axes = two_rows(sheet, len(panels))
    of_pressure, unit_of_pressure = plot_style.readable(values["pressure"].max(), "Pa", "pressure")
    handles = []
    for column, (quantity, residual) in enumerate(panels):
        factor, unit = plot_style.readable(numpy.abs(values[quantity]).max(), units[quantity])
        upper, lower = axes[0][column], axes[1][column]
        for i, stretch in enumerate(numpy.unique(values["axial stretch"])):
            rows = values["axial stretch"] == stretch
            rows = numpy.flatnonzero(rows)[numpy.argsort(values["pressure"][rows], kind="stable")]
            colour, marker = plot_style.COLOURS_OF_RUNS[i % 8], MARKERS[i % 8]
            x = of_pressure * values["pressure"][rows]
            upper.plot(x, factor * values[quantity][rows], marker, color=colour, markersize=3, fillstyle="none", markeredgewidth=0.6)
            line, = upper.plot(x, factor * values[f"{quantity} of the fit"][rows], "-", color=colour, label=f"axial stretch {stretch:g}")
            draw_residuals(lower, x, values[residual][rows], marker=marker, color=colour)
            if column == 0:
                handles.append(line)
        upper.set_ylabel(plot_style.axis_label(quantity, unit))
        lower.set_xlabel(plot_style.axis_label("pressure", unit_of_pressure))
        lower.set_ylabel("Residual / noise" if column == 0 else "")
    measured, = axes[0][0].plot([], [], "o", color="#555555", markersize=3, fillstyle="none", markeredgewidth=0.6, label="measured")
    plot_style.legend_above(figure, [measured, *handles], sheet.width)
    finish(sheet, figure, name_of(runs, run, "fit-inflation"), values, units)


def draw_correlation(sheet, runs, run):
    """The correlations of what was found, as coloured squares with their numbers."""
    found = read(run, "correlation")
    if found is None or len(found[0]) < 2:
        return
    values, units = found
    matrix = numpy.array(list(values.values())).T
    names, n = list(values), len(values)
    figure, axes = sheet.figure(min(1.0, 0.35 + 0.07 * n))
    image = axes.imshow(matrix, cmap="RdBu_r", vmin=-1, vmax=1)
    for i in range(n):
        for j in range(n):
            axes.text(j, i, f"{matrix[i, j]:.2f}", ha="center", va="center", fontsize=7 if n < 9 else 5.5,
                      color="white" if abs(matrix[i, j]) > 0.6 else "black")
    axes.set_xticks(range(n), names, rotation=35, ha="right")
    axes.set_yticks(range(n), names)
    axes.spines[:].set_visible(False)
    figure.colorbar(image, ax=axes, label="Correlation", shrink=0.8)
    finish(sheet, figure, name_of(runs, run, "correlation"), values, units)


def finish(sheet, figure, name, values, units):
    sheet.save(figure, name)
    sheet.save_data(name, [f"{column} [{units[column]}]" for column in values], list(values.values()))
