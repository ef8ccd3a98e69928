"""Figures of harmonic analyses: amplitude and phase over frequency (Bode), the response in the complex plane (Nyquist), and its sensitivities."""

import csv
import math
import os
import re

import numpy
import plot_style
import tables

# A list of frequencies is drawn as points, a range as a curve.
FEWEST_OF_A_CURVE = 8


MOST_SENSITIVITIES = 12


def draw(sheet, runs):
    draw_sensitivities(sheet, runs[0])
    for file, kind in (("response.csv", "response"), ("impedance.csv", "impedance"), ("transfer.csv", "transfer")):
        curves = read_curves(runs, file)
        fields = dict.fromkeys(curve["field"] for curve in curves)
        for field in fields if kind == "impedance" else sheet.choice.fields_of(fields):
            shown = [curve for curve in curves if curve["field"] == field]
            name = kind if field == kind else f"{kind}-{plot_style.file_name(field)}"
            draw_bode(sheet, shown, name)
            if kind != "transfer":
                draw_nyquist(sheet, shown, "nyquist-" + plot_style.file_name(field))


def read_curves(runs, file):
    """One for each complex column of the runs: its label, field, unit, frequencies and complex values."""
    curves = []
    for run in runs:
        table = tables.read_table(os.path.join(run["folder"], file))
        if table is None:
            continue
        names, data = table
        for i, (name, unit) in enumerate(names):
            match = re.fullmatch(r"(.*): (.*) (amplitude|ratio)", name)
            if not match:
                continue
            values = data[:, i] * numpy.exp(1j * data[:, i + 1])
            label = match.group(1) if len(runs) == 1 else f"{run['title']}: {match.group(1)}"
            curves.append({"label": label, "field": match.group(2), "unit": unit, "frequency": data[:, 0], "values": values})
    return curves


def is_wide(values):
    """Whether positive values need a logarithmic axis."""
    values = values[numpy.isfinite(values) & (values > 0)]
    return len(values) > 1 and values.max() > 20 * values.min()


def look(i, curve):
    of_run = plot_style.of_run(i, len(curve["frequency"]))
    if len(curve["frequency"]) < FEWEST_OF_A_CURVE:
        of_run.update(marker="o", markersize=3.5, markevery=1, linestyle="none")
    return of_run


def draw_bode(sheet, curves, name):
    factor, unit = plot_style.readable(max(numpy.nanmax(abs(curve["values"])) for curve in curves), curves[0]["unit"], curves[0]["field"])
    figure, panels = sheet.figure(0.75, nrows=2, sharex=True)
    for i, curve in enumerate(curves):
        frequency = curve["frequency"]
        panels[0].plot(frequency, factor * abs(curve["values"]), label=curve["label"], **look(i, curve))
        # Along a curve a phase has no jumps but where the response passes zero.
        phase = numpy.angle(curve["values"])
        phase = numpy.degrees(phase if len(frequency) < FEWEST_OF_A_CURVE else numpy.unwrap(phase))
        panels[1].plot(frequency, phase, **look(i, curve))
    if is_wide(numpy.concatenate([curve["frequency"] for curve in curves])):
        for axes in panels:
            axes.set_xscale("log")
    if is_wide(numpy.concatenate([abs(curve["values"]) for curve in curves])):
        panels[0].set_yscale("log")
    else:
        panels[0].set_ylim(0, 1.08 * factor * max(numpy.nanmax(abs(curve["values"])) for curve in curves))
    what = "ratio" if name.startswith("transfer") else "magnitude" if name == "impedance" else f"amplitude of {curves[0]['field']}"
    panels[0].set_ylabel(plot_style.axis_label(what, unit))
    panels[1].set_ylabel("Phase [°]")
    panels[1].set_xlabel("Frequency [Hz]")
    plot_style.readable_logarithm(panels[0])
    sheet.legend(panels[0], len(curves))
    sheet.save(figure, name)
    header, columns = [], []
    for curve in curves:
        header += ["frequency [Hz]", f"{curve['label']} amplitude [{curve['unit']}]", f"{curve['label']} phase [rad]"]
        columns += [curve["frequency"], abs(curve["values"]), numpy.angle(curve["values"])]
    sheet.save_data(name, header, columns)


def draw_nyquist(sheet, curves, name):
    if max(len(curve["frequency"]) for curve in curves) < FEWEST_OF_A_CURVE:
        return
    factor, unit = plot_style.readable(max(numpy.nanmax(abs(curve["values"])) for curve in curves), curves[0]["unit"], curves[0]["field"])
    figure, axes = sheet.figure(0.8)
    for i, curve in enumerate(curves):
        values = factor * curve["values"]
        axes.plot(values.real, values.imag, label=curve["label"], **look(i, curve))
    axes.axhline(0, color="#999999", linewidth=0.5)
    axes.axvline(0, color="#999999", linewidth=0.5)
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_xlabel(plot_style.axis_label("real part", unit))
    axes.set_ylabel(plot_style.axis_label("imaginary part", unit))
    sheet.legend(axes, len(curves))
    sheet.save(figure, name)
    header, columns = [], []
    for curve in curves:
        header += [f"{curve['label']} real part [{curve['unit']}]", f"{curve['label']} imaginary part [{curve['unit']}]"]
        columns += [curve["values"].real, curve["values"].imag]
    sheet.save_data(name, header, columns)


def largest_sensitivities(folder):
    """(label, sensitivity of the amplitude, frequency) of each response and entry where it is largest over the frequencies; the largest first."""
    path = os.path.join(folder, "sensitivities.csv")
    if not os.path.exists(path):
        return []
    largest = {}
    with open(path, encoding="utf-8", newline="") as stream:
        for row in csv.DictReader(stream):
            value = float(row["logarithmic sensitivity [1]"] or "nan")
            name = f"{row['probe']}: {row['response']} by {row['entry']}"
            if math.isfinite(value) and value != 0 and abs(value) > abs(largest.get(name, (0, 0))[0]):
                largest[name] = (value, float(row["frequency [Hz]"]))
    return sorted(((name, *numbers) for name, numbers in largest.items()), key=lambda one: -abs(one[1]))


def draw_sensitivities(sheet, run):
    """Of the first run: bars of the largest."""
    shown = largest_sensitivities(run["folder"])[:MOST_SENSITIVITIES]
    if not shown:
        return
    figure, axes = sheet.figure(0.1 + 0.05 * len(shown))
    places = range(len(shown))
    axes.barh(places, [value for _, value, _ in shown], height=0.6)
    axes.set_yticks(places, [f"{name}, {frequency:g} Hz" for name, _, frequency in shown])
    axes.invert_yaxis()
    axes.axvline(0, color="#999999", linewidth=0.5)
    axes.set_xlabel("Response by 1 % of the entry [%]")
    sheet.save(figure, "sensitivities")
    sheet.save_data("sensitivities", [f"{name} at {frequency:g} Hz [1]" for name, _, frequency in shown], [[value] for _, value, _ in shown])
