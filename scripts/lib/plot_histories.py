"""Figures over time: probes, the envelope of those that oscillate, and the power balance."""

import os

import matplotlib.lines
import numpy
import plot_style
import tables

TOO_MANY = 20000  # points of a curve; above, each bin shows its smallest and largest value
PROMINENCE = 0.05  # a turn counts for the envelope when it stands out by this share of the curve's range


def thinned(time, values):
    """What is drawn of a long curve: the smallest and largest value of each bin, in order of time."""
    if len(time) <= TOO_MANY:
        return time, values
    kept = []
    for part in numpy.array_split(numpy.arange(len(time)), TOO_MANY // 4):
        kept += sorted({part[numpy.argmin(values[part])], part[numpy.argmax(values[part])]})
    kept = numpy.unique([0, *kept, len(time) - 1])
    return time[kept], values[kept]


def turning_points(time, values):
    """(times and values of the maxima, those of the minima) that stand out by PROMINENCE of the range."""
    threshold = PROMINENCE * (values.max() - values.min())
    maxima, minima = [], []
    if not threshold > 0:
        return maxima, minima
    lowest = highest = 0
    rising = None
    for i in range(len(values)):
        if values[i] > values[highest]:
            highest = i
        if values[i] < values[lowest]:
            lowest = i
        if rising is not False and values[i] < values[highest] - threshold:
            if rising:
                maxima.append(tables.peak(time, values, highest))
            rising, lowest = False, i
        elif rising is not True and values[i] > values[lowest] + threshold:
            if rising is False:
                minima.append(tables.peak(time, values, lowest))
            rising, highest = True, i
    return maxima, minima


def draw_probes(sheet, runs):
    """One figure a field (and unit), and one of its envelope where something oscillates."""
    curves = {}
    for run in runs:
        table = tables.read_table(os.path.join(run["folder"], "probes.csv"))
        if table is None:
            sheet.notes.append(f"probes of {run['folder']} (no rows in probes.csv)")
            continue
        columns, data = table
        for column, (name, unit) in enumerate(columns[1:], 1):
            probe, colon, field = name.rpartition(": ")
            finite = numpy.isfinite(data[:, column])
            if finite.sum() > 1:
                oscillates = is_oscillation(run.get("summary", {}), name, field)
                curves.setdefault((field, unit), []).append(
                    (run["title"], probe if colon else "", data[finite, 0], data[finite, column], oscillates))
            elif finite.any():
                note = f"histories of {run['folder']} (one state: summary.json has its values)"
                if note not in sheet.notes:
                    sheet.notes.append(note)
    for (field, unit), entries in curves.items():
        # A value at a point and the integral over a boundary have different units, and a figure each.
        units = [other for name, other in curves if name == field]
        draw_field(sheet, field, unit, entries, len(runs) > 1, f" {unit}" if len(units) > 1 and unit != units[0] else "")


def is_oscillation(summary, name, field):
    """Whether the fit of the summary says that the history is a damped oscillation, or there is none."""
    labels = (name, name[: -len(field) - 2] if name.endswith(f": {field}") else name)
    residuals = [entry["value"] for entry in summary.get("quantities", []) if entry["name"] == "fit residual"
                 and entry["probe"] in labels]
    return not any(value is not None and value > 0.1 for value in residuals)


def label_of(title, probe, several):
    return ", ".join(part for part in ((title if several else ""), probe) if part)


def draw_field(sheet, field, unit, entries, several, suffix=""):
    """The histories of one field and its envelope; a suffix of the files' names."""
    probes = list(dict.fromkeys(entry[1] for entry in entries))
    titles = list(dict.fromkeys(entry[0] for entry in entries))
    end = max(entry[2].max() for entry in entries)
    largest = max(abs(entry[3]).max() for entry in entries)
    time_factor, time_unit = plot_style.readable(end, "s")
    factor, axis_unit = plot_style.readable(largest, unit, field)

    figure, axes = sheet.figure()
    header, columns, envelopes = [], [], []
    for title, probe, time, values, oscillates in entries:
        colour = plot_style.COLOURS[(titles.index(title) if len(probes) == 1 else probes.index(probe))
                                    % len(plot_style.COLOURS)]
        line = plot_style.LINES[titles.index(title) % len(plot_style.LINES)]
        label = label_of(title, probe, several)
        drawn_time, drawn = thinned(time, values)
        axes.plot(time_factor * drawn_time, factor * drawn, line, color=colour, label=label)
        header += [f"{label}: time [s]" if label else "time [s]", f"{label}: {field} [{unit}]" if label
                   else f"{field} [{unit}]"]
        columns += [drawn_time, drawn]
        maxima, minima = turning_points(time, values)
        if oscillates and len(maxima) >= 3 and len(minima) >= 2:
            envelopes.append((label, colour, line, maxima, minima))
    finish(sheet, axes, time_factor * end, time_unit, field, axis_unit, len(entries))
    name = plot_style.file_name(field + suffix)
    sheet.save(figure, "history-" + name)
    sheet.save_data("history-" + name, header, columns)
    if envelopes:
        left_out = [label for label in (label_of(entry[0], entry[1], several) for entry in entries)
                    if label not in [envelope[0] for envelope in envelopes]]
        if left_out:
            sheet.notes.append(f"envelopes of {field}: {', '.join(left_out)} (no oscillation)")
        draw_envelope(sheet, field, unit, envelopes, (time_factor, time_unit, factor, axis_unit, end), name)


def draw_envelope(sheet, field, unit, envelopes, scales, name):
    time_factor, time_unit, factor, axis_unit, end = scales
    figure, axes = sheet.figure()
    header, columns = [], []
    for label, colour, line, maxima, minima in envelopes:
        for kind, points in (("maxima", maxima), ("minima", minima)):
            time, values = numpy.array(points).T
            axes.plot(time_factor * time, factor * values, line, color=colour, marker="o", markersize=2.2,
                      linewidth=0.8, label=label if kind == "maxima" else None)
            prefix = f"{label}: " if label else ""
            header += [f"{prefix}time of {kind} [s]", f"{prefix}{field}, {kind} [{unit}]"]
            columns += [time, values]
    finish(sheet, axes, time_factor * end, time_unit, f"{field}, maxima and minima", axis_unit, len(envelopes))
    sheet.save(figure, "envelope-" + name)
    sheet.save_data("envelope-" + name, header, columns)


def finish(sheet, axes, end, time_unit, name, unit, n_entries):
    axes.set_xlim(0, end if end > 0 else 1)
    axes.set_xlabel(plot_style.axis_label("time", time_unit))
    axes.set_ylabel(plot_style.axis_label(name, unit))
    sheet.legend(axes, n_entries)


def draw_power(sheet, runs):
    """The terms of the power balance in all, by colour (runs by line), and the residual in a panel of its own."""
    terms, residuals = [], []
    for run in runs:
        table = tables.read_table(os.path.join(run["folder"], "power.csv"))
        if table is None:
            sheet.notes.append(f"power balance of {run['folder']} (no rows in power.csv)")
            continue
        columns, data = table
        # The scheme may balance the powers between two steps; the table says when.
        at = next((i for i, (name, _) in enumerate(columns) if name == "balance time"), 0)
        watts = [(i, name, unit) for i, (name, unit) in enumerate(columns) if i and unit.startswith("W")]
        # "fluid: kinetic" is one material's share of "kinetic".
        totals = [entry for entry in watts if ": " not in entry[1]] or watts
        for i, name, unit in totals:
            finite = numpy.isfinite(data[:, i])
            if finite.any():
                target = residuals if "residual" in name.lower() else terms
                target.append((run["title"], name, unit, data[finite, at], data[finite, i]))
    # A term that is zero throughout (no fluid, say) would only fill the legend.
    shown = [entry for entry in terms if numpy.abs(entry[4]).max() > 0]
    if not shown:
        if terms:
            sheet.notes.append("power balance (every term is zero)")
        return
    draw_balance(sheet, shown, residuals, len(runs) > 1)


def draw_balance(sheet, terms, residuals, several):
    panels = [terms] + ([residuals] if residuals else [])
    figure, all_axes = sheet.figure(0.72 if residuals else 0.55, nrows=len(panels), sharex=True, squeeze=False,
                                    gridspec_kw={"height_ratios": [3, 1][:len(panels)]})
    end = max(entry[3].max() for entry in terms)
    time_factor, time_unit = plot_style.readable(end, "s")
    names = list(dict.fromkeys(entry[1] for entry in terms))
    titles = list(dict.fromkeys(entry[0] for entry in terms + residuals))
    header, columns = [], []
    for axes, entries, title in zip(all_axes[:, 0], panels, ("power", "residual")):
        factor, unit = plot_style.readable(max(abs(entry[4]).max() for entry in entries), entries[0][2])
        for run, name, _, time, values in entries:
            drawn_time, drawn = thinned(time, values)
            colour = plot_style.COLOURS[names.index(name) % len(plot_style.COLOURS)] if name in names else "#000000"
            label = label_of(run, name, several)
            axes.plot(time_factor * drawn_time, factor * drawn,
                      plot_style.LINES[titles.index(run) % len(plot_style.LINES)], color=colour, label=label)
            header += [f"{label}: time [s]", f"{label} [{entries[0][2]}]"]
            columns += [drawn_time, drawn]
        axes.set_ylabel(plot_style.axis_label(title, unit))
        axes.set_xlim(0, time_factor * end if end > 0 else 1)
    all_axes[-1, 0].set_xlabel(plot_style.axis_label("time", time_unit))
    handles = None
    if several:
        # The terms by colour and the runs by line: not each term of each run.
        handles = [matplotlib.lines.Line2D([], [], color=plot_style.COLOURS[i % len(plot_style.COLOURS)], label=name)
                   for i, name in enumerate(names)]
        handles += [matplotlib.lines.Line2D([], [], color="#000000", label=title,
                                            linestyle=plot_style.LINES[i % len(plot_style.LINES)])
                    for i, title in enumerate(titles)]
    sheet.legend(all_axes[0, 0], len(terms), handles)
    sheet.save(figure, "power")
    sheet.save_data("power", header, columns)
