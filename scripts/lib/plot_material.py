"""Figures of the material laboratory: relaxation, creep, the complex modulus over frequency, the loops of harmonic tests
and curves of stress over stretch."""

import glob
import os
import re

import matplotlib.ticker
import numpy
import plot_style
import tables

REFERENCES = (("closed solution", "--", "#000000"), ("power law", ":", "#D55E00"))
CURVES = ("uniaxial", "equibiaxial", "planar", "shear")


def draw(sheet, runs):
    draw_table(sheet, runs)
    draw_history(sheet, runs, "relaxation", "stress")
    draw_history(sheet, runs, "creep", "strain")
    draw_modulus(sheet, runs)
    draw_loops(sheet, runs)
    draw_curves(sheet, runs)


def read_all(runs, file):
    """(run, names, data) of the runs that have the table."""
    found = []
    for run in runs:
        table = tables.read_table(os.path.join(run["folder"], file))
        if table is not None:
            found.append((run, table[0], table[1]))
    return found


def column(names, data, name):
    found = [i for i, (other, _) in enumerate(names) if other == name]
    return data[:, found[0]] if found else None


def prefix(runs, run):
    return f"{run['title']}: " if len(runs) > 1 else ""


def look_of(shown, i, n_points):
    """Of the i-th run: several are told apart by colour, dash and marker."""
    return plot_style.of_run(i, n_points) if len(shown) > 1 else {"color": plot_style.COLOURS[0], "linestyle": "-"}


def both_scales(sheet):
    """Two panels, the left with logarithmic, the right with linear axes; narrow sheets have them one below the other."""
    narrow = sheet.width < 4
    figure, panels = sheet.figure(1.5 if narrow else 0.45, nrows=2 if narrow else 1, ncols=1 if narrow else 2)
    panels[0].set_xscale("log")
    panels[0].set_yscale("log")
    return figure, panels


def legend_above(sheet, figure, axes):
    handles, labels = axes.get_legend_handles_labels()
    if len(handles) < 2:
        return
    width, height = figure.get_size_inches()
    columns = max(1, int(width / (0.075 * max(map(len, labels)) + 0.5)))
    room = 0.2 * -(-len(labels) // columns) + 0.05
    figure.set_size_inches(width, height + room)
    figure.set_constrained_layout_pads(h_pad=0.04)
    figure.get_layout_engine().set(rect=(0, 0, 1, height / (height + room)))
    figure.legend(handles, labels, loc="upper left", ncol=columns, borderaxespad=0.3, handlelength=1.8)


def draw_table(sheet, runs):
    """The measured relaxation modulus with the power law that was fitted to it."""
    shown = read_all(runs, "relaxation-table.csv")
    if not shown:
        return
    figure, panels = both_scales(sheet)
    header, columns = [], []
    factor, unit = plot_style.readable(max(numpy.nanmax(data[:, 1]) for _, _, data in shown), "Pa")
    for i, (run, names, data) in enumerate(shown):
        colour = plot_style.COLOURS[i % len(plot_style.COLOURS)]
        time, modulus = data[:, 0], data[:, 1]
        law, fitted = column(names, data, "modulus of the power law"), column(names, data, "fitted") > 0
        for axes in panels:
            axes.plot(time[~fitted], factor * modulus[~fitted], "x", color="#999999", markersize=3,
                      label=f"{prefix(shown, run)}not fitted")
            axes.plot(time[fitted], factor * modulus[fitted], "o", color=colour, markersize=2.5, fillstyle="none",
                      markeredgewidth=0.6, label=f"{prefix(shown, run)}table")
            axes.plot(time[fitted], factor * law[fitted], "-", color="#000000", linewidth=0.9,
                      label=f"{prefix(shown, run)}power law")
        header += [f"{prefix(shown, run)}{name} [{unit}]" for name, unit in names]
        columns += list(data.T)
    for axes in panels:
        axes.set_xlabel("Time [s]")
        axes.set_ylabel(plot_style.axis_label("stress over the strain held", unit))
    # Moduli seldom go over more than a decade or two, where powers of ten alone would label nothing.
    panels[0].yaxis.set_major_locator(matplotlib.ticker.LogLocator(subs=(1, 2, 5)))
    panels[0].yaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
    panels[0].yaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
    panels[1].set_ylim(0, None)
    panels[1].set_xlim(0, None)
    legend_above(sheet, figure, panels[0])
    plot_style.readable_logarithm(panels[0])
    sheet.save(figure, "relaxation-table")
    sheet.save_data("relaxation-table", header, columns)


def draw_history(sheet, runs, test, quantity):
    """Stress or strain of a test over time, with the exact answers."""
    shown = read_all(runs, f"{test}.csv")
    if not shown:
        return
    figure, panels = both_scales(sheet)
    header, columns = [], []
    unit = "Pa" if quantity == "stress" else "1"
    factor, axis_unit = plot_style.readable(max(column(names, data, quantity).max() for _, names, data in shown), unit)
    for i, (run, names, data) in enumerate(shown):
        positive = data[:, 0] > 0
        for axes in panels:
            axes.plot(data[positive, 0], factor * column(names, data, quantity)[positive], label=f"{prefix(shown, run)}simulated",
                      **look_of(shown, i, positive.sum()))
            for reference, line, shade in REFERENCES:
                values = column(names, data, f"{quantity} of the {reference}")
                if values is not None:
                    axes.plot(data[positive, 0], factor * values[positive], line, color=shade, linewidth=1.1,
                              label="_" if i else reference)
        header += [f"{prefix(shown, run)}{name} [{unit}]" for name, unit in names]
        columns += list(data.T)
    for axes in panels:
        axes.set_xlabel("Time [s]")
        axes.set_ylabel(plot_style.axis_label(quantity, axis_unit))
    panels[1].set_xlim(0, None)
    panels[1].set_ylim(0, None)
    legend_above(sheet, figure, panels[0])
    plot_style.readable_logarithm(panels[0])
    sheet.save(figure, test)
    sheet.save_data(test, header, columns)


def draw_modulus(sheet, runs):
    """Storage modulus, loss modulus and tan delta over frequency: the law, and the harmonic tests as points."""
    shown = read_all(runs, "modulus.csv")
    # A fit finds another modulus than that of the parameter file, from which its search starts.
    fitted = [run for run, _, _ in shown if glob.glob(os.path.join(glob.escape(run["folder"]), "fit-*.csv"))]
    for run in fitted:
        sheet.notes.append(f"modulus of {run['folder']} (modulus.csv has that from which the fit starts)")
    shown = [entry for entry in shown if entry[0] not in fitted]
    if not shown:
        return
    tests = {run["folder"]: (names, data) for run, names, data in read_all(runs, "harmonic.csv")}
    narrow = sheet.width < 4
    figure, panels = sheet.figure(1.8 if narrow else 0.4, nrows=3 if narrow else 1, ncols=1 if narrow else 3)
    header, columns = [], []
    for axes, quantity in zip(panels, ("storage modulus", "loss modulus", "tan delta")):
        largest = max(column(names, data, quantity).max() for _, names, data in shown)
        factor, unit = plot_style.readable(largest, "1" if quantity == "tan delta" else "Pa")
        for i, (run, names, data) in enumerate(shown):
            colour = plot_style.of_run(i)["color"]
            axes.plot(data[:, 0], factor * column(names, data, quantity), label=f"{prefix(shown, run)}law",
                      **look_of(shown, i, len(data)))
            series = column(names, data, f"{quantity} of the Prony series")
            if series is not None:
                axes.plot(data[:, 0], factor * series, "--", color="#000000", linewidth=0.9,
                          label=f"{prefix(shown, run)}Prony series")
            if run["folder"] in tests:
                of_tests = tests[run["folder"]]
                axes.plot(of_tests[1][:, 0], factor * column(*of_tests, quantity), "o", color=colour, markersize=4,
                          label=f"{prefix(shown, run)}simulated")
        axes.set_xscale("log")
        axes.set_ylim(0, 1.1 * factor * largest if largest > 0 else None)
        axes.set_xlabel("Frequency [Hz]")
        axes.set_ylabel("tan δ" if quantity == "tan delta" else plot_style.axis_label(quantity, unit))
    for run, names, data in shown:
        header += [f"{prefix(shown, run)}{name} [{unit}]" for name, unit in names]
        columns += list(data.T)
        if run["folder"] in tests:
            names, data = tests[run["folder"]]
            header += [f"{prefix(shown, run)}test: {name} [{unit}]" for name, unit in names]
            columns += list(data.T)
    legend_above(sheet, figure, panels[0])
    sheet.save(figure, "modulus")
    sheet.save_data("modulus", header, columns)


def draw_loops(sheet, runs):
    """Stress over strain in the last period of each harmonic test: the area of a loop is what it loses."""
    loops = []
    for run, names, tests in read_all(runs, "harmonic.csv"):
        frequencies = column(names, tests, "frequency")
        files = glob.glob(os.path.join(glob.escape(run["folder"]), "harmonic-*.csv"))
        numbered = {int(re.search(r"-(\d+)\.csv$", file).group(1)): file for file in files}
        for i, frequency in enumerate(frequencies):
            if i + 1 in numbered:
                table = tables.read_table(numbered[i + 1])
                if table is not None:
                    loops.append((run, frequency, *table))
    if not loops:
        return
    figure, axes = sheet.figure(0.7)
    header, columns = [], []
    factor, unit = plot_style.readable(max(numpy.abs(column(names, data, "stress")).max() for _, _, names, data in loops), "Pa")
    for i, (run, frequency, names, data) in enumerate(loops):
        last = data[:, 0] > data[-1, 0] - 1.001 / frequency
        strain, stress = column(names, data, "strain")[last], column(names, data, "stress")[last]
        label = f"{prefix(runs, run)}{frequency:g} Hz"
        axes.plot(strain, factor * stress, plot_style.LINES[i // len(plot_style.COLOURS) % len(plot_style.LINES)],
                  color=plot_style.COLOURS[i % len(plot_style.COLOURS)], label=label)
        header += [f"{label}: strain [1]", f"{label}: stress [Pa]"]
        columns += [strain, stress]
    axes.set_xlabel("Strain")
    axes.set_ylabel(plot_style.axis_label("stress", unit))
    sheet.legend(axes, len(loops))
    sheet.save(figure, "hysteresis")
    sheet.save_data("hysteresis", header, columns)


def draw_curves(sheet, runs):
    """Nominal stress over stretch or shear of each test at large strains, with the measured rows of a fit."""
    for test in CURVES:
        shown, fitted = read_all(runs, f"{test}.csv"), read_all(runs, f"fit-{test}.csv")
        if not shown and not fitted:
            continue
        figure, axes = sheet.figure()
        header, columns = [], []
        stresses = [column(names, data, "nominal stress") for _, names, data in shown] + [
            column(names, data, "measured stress") for _, names, data in fitted]
        factor, unit = plot_style.readable(max(numpy.abs(stress).max() for stress in stresses), "Pa")
        for i, (run, names, data) in enumerate(shown):
            axes.plot(data[:, 0], factor * column(names, data, "nominal stress"), label=f"{prefix(shown, run)}law",
                      **look_of(shown, i, len(data)))
        for i, (run, names, data) in enumerate(fitted):
            axes.plot(data[:, 0], factor * column(names, data, "measured stress"), "o", color=plot_style.of_run(i)["color"],
                      markersize=3, fillstyle="none", label=f"{prefix(fitted, run)}table")
        for run, names, data in shown + fitted:
            header += [f"{prefix(runs, run)}{name} [{unit}]" for name, unit in names]
            columns += list(data.T)
        axes.set_xlabel("Amount of shear" if test == "shear" else "Stretch")
        axes.set_ylabel(plot_style.axis_label(f"nominal stress ({test})", unit))
        legend_above(sheet, figure, axes)
        sheet.save(figure, f"stress-{test}")
        sheet.save_data(f"stress-{test}", header, columns)
