"""Figures of Analysis = amplification: how schemes in time damp and slow waves down."""

import math
import os

import numpy
import plot_style
import tables

NUMBER, WAVES = "Courant number", "cells in a wavelength"


def read(run):
    """{scheme: {column: values}} in the order of the table."""
    table = tables.read_table(os.path.join(run["folder"], "amplification.csv"))
    schemes, shared = {}, {}
    for i, (name, _) in enumerate(table[0] if table else ()):
        scheme, colon, quantity = name.partition(": ")
        if colon:
            schemes.setdefault(scheme, dict(shared))[quantity] = table[1][:, i]
        else:
            shared[name] = table[1][:, i]
    return schemes


def draw(sheet, runs):
    """Of the first run that has any."""
    for run in runs:
        schemes = read(run)
        if schemes:
            for scheme, columns in schemes.items():
                draw_portrait(sheet, scheme, columns)
            if len(schemes) > 1:
                draw_comparison(sheet, schemes)
            return


def marks(axes, x, y, colour):
    """The measured values, as small rings."""
    axes.plot(x, y, "o", color=colour, markersize=2.6, markerfacecolor="none", markeredgewidth=0.6)


def draw_portrait(sheet, scheme, columns):
    """Amplitude and speed over the cells in a wavelength, one curve a Courant number (figure 3.8)."""
    narrow = sheet.width < 4
    figure, panels = sheet.figure(1.3 if narrow else 0.45, nrows=2 if narrow else 1, ncols=1 if narrow else 2)
    numbers = list(dict.fromkeys(columns[NUMBER]))
    header, data = [], []
    for i, number in enumerate(numbers):
        chosen = columns[NUMBER] == number
        colour = plot_style.COLOURS[i % len(plot_style.COLOURS)]
        header.append(f"Co = {number:g}: cells in a wavelength [1]")
        data.append(columns[WAVES][chosen])
        for axes, quantity in zip(panels, ("amplitude", "speed ratio")):
            axes.plot(columns[WAVES][chosen], columns[quantity][chosen], color=colour, label=f"Co = {number:g}")
            header.append(f"Co = {number:g}: {quantity} [1]")
            data.append(columns[quantity][chosen])
            of_run = columns.get(f"{quantity} of the run")
            if of_run is not None:
                marks(axes, columns[WAVES][chosen], of_run[chosen], colour)
                header.append(f"Co = {number:g}: {quantity} of the run [1]")
                data.append(of_run[chosen])
    for axes, label in zip(panels, ("Amplification |G|", "Numerical over exact speed")):
        axes.set_xlabel("Cells in a wavelength")
        axes.set_ylabel(label)
        axes.set_xlim(left=0)
    panels[-1].legend(loc="lower right")
    name = plot_style.file_name(f"amplification {scheme}")
    sheet.save(figure, name)
    sheet.save_data(name, header, data)


def draw_comparison(sheet, schemes):
    """The amplitudes of all schemes, one panel a Courant number (figure 3.10)."""
    first = next(iter(schemes.values()))
    numbers = list(dict.fromkeys(first[NUMBER]))
    n_columns = 2 if sheet.width < 4 else 3
    n_rows = math.ceil(len(numbers) / n_columns)
    figure, panels = sheet.figure(0.33 * n_rows * 3 / n_columns, nrows=n_rows, ncols=n_columns, squeeze=False,
                                  sharex=True)
    header, data = [], []
    for panel, number in zip(panels.flat, numbers):
        for i, (scheme, columns) in enumerate(schemes.items()):
            chosen = columns[NUMBER] == number
            panel.plot(columns[WAVES][chosen], columns["amplitude"][chosen],
                       plot_style.LINES[i % len(plot_style.LINES)], color=plot_style.COLOURS[i % len(plot_style.COLOURS)],
                       label=scheme)
            header += [f"{scheme}, Co = {number:g}: cells in a wavelength [1]", f"{scheme}, Co = {number:g}: amplitude [1]"]
            data += [columns[WAVES][chosen], columns["amplitude"][chosen]]
        panel.set_title(f"Co = {number:g}", fontsize=8.5)
        lowest = min(numpy.min(line.get_ydata()) for line in panel.lines)
        panel.set_ylim(lowest - 0.05 * (1 - lowest), 1 + 0.05 * (1 - lowest))
    for panel in list(panels.flat)[len(numbers):]:
        panel.set_visible(False)
    for panel in panels[-1]:
        panel.set_xlabel("Cells in a wavelength")
    for row in panels:
        row[0].set_ylabel("Amplification |G|")
    handles, labels = panels.flat[0].get_legend_handles_labels()
    width, height = figure.get_size_inches()
    columns_of_legend = max(1, int(width / (0.06 * max(map(len, labels)) + 0.5)))
    room = 0.2 * math.ceil(len(labels) / columns_of_legend) + 0.05
    figure.set_size_inches(width, height + room)
    figure.get_layout_engine().set(rect=(0, 0, 1, height / (height + room)))
    figure.legend(handles, labels, loc="upper left", ncol=columns_of_legend, borderaxespad=0.3)
    sheet.save(figure, "amplification")
    sheet.save_data("amplification", header, data)
