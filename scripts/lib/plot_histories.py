"""Figures over time: probes, the envelope of those that oscillate, and the power balance."""

import os

import numpy
import plot_choice
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
        chosen = sheet.choice.fields_of([name.rpartition(": ")[2] for name, _ in columns[1:]])
        for column, (name, unit) in enumerate(columns[1:], 1):
            probe, colon, field = name.rpartition(": ")
            if field not in chosen:
                continue
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


def draw_over(sheet, runs, over):
    """Each probe over another one, such as a diameter over the pressure: one figure a field. `over`: the column's name without its unit."""
    shown = []
    for run in runs:
        table = tables.read_table(os.path.join(run["folder"], "probes.csv"))
        names = [name for name, _ in table[0]] if table else []
        if over not in names:
            raise plot_choice.ChoiceError(f"--over {over}: probes.csv of {run['folder']} has no such column; it has {', '.join(names[1:]) or 'none'}")
        columns, data = table
        shown.append((run, columns[1:], data[:, 1:], names.index(over) - 1))
    draw_columns(sheet, shown, len(runs) > 1, f"over {over}")


def draw_loads(sheet, runs):
    """The probes over the load of steady runs whose loads come in steps."""
    shown = []
    for run in runs:
        table = tables.read_table(os.path.join(run["folder"], "load-steps.csv"))
        if table is not None:
            shown.append((run, *table, 0))
    draw_columns(sheet, shown, len(runs) > 1, "load")


def draw_columns(sheet, shown, several, prefix):
    """One figure a field of tables [(run, columns, data, number of the column that is the abscissa)]."""
    curves = {}
    for run, columns, data, x in shown:
        chosen = sheet.choice.fields_of([name.rpartition(": ")[2] for i, (name, _) in enumerate(columns) if i != x])
        for i, (name, unit) in enumerate(columns):
            probe, _, field = name.rpartition(": ")
            finite = numpy.isfinite(data[:, i]) & numpy.isfinite(data[:, x])
            if i != x and field in chosen and finite.sum() > 1:
                curves.setdefault((field, unit), []).append((label_of(run["title"], probe, several), data[finite, x], data[finite, i]))
    if not curves:
        return
    name, unit_of_x = shown[0][1][shown[0][3]]
    x_factor, x_unit = plot_style.readable(max(numpy.nanmax(numpy.abs(data[:, x])) for *_, data, x in shown), unit_of_x, name.rpartition(": ")[2])
    for (field, unit), entries in curves.items():
        factor, axis_unit = plot_style.readable(max(numpy.abs(values).max() for *_, values in entries), unit, field)
        figure, axes = sheet.figure()
        header, kept = [], []
        for i, (label, places, values) in enumerate(entries):
            axes.plot(x_factor * places, factor * values, label=label, **plot_style.of_run(i))
            header += [f"{label}: {name.rpartition(': ')[2]} [{unit_of_x}]", f"{label}: {field} [{unit}]"]
            kept += [places, values]
        axes.set_xlabel(plot_style.axis_label("part of the load" if name == "load" else name, x_unit))
        axes.set_ylabel(plot_style.axis_label(field, axis_unit))
        sheet.legend(axes, len(entries))
        picture = plot_style.file_name(f"{prefix} {field}")
        sheet.save(figure, picture)
        sheet.save_data(picture, header, kept)


def is_oscillation(summary, name, field):
    """Whether the fit of the summary says that the history is a damped oscillation, or there is none. Beats have no envelope: they are
    equal in the end."""
    if summary.get("beats"):
        return False
    labels = (name, name[: -len(field) - 2] if name.endswith(f": {field}") else name)
    residuals = [entry["value"] for entry in summary.get("quantities", []) if entry["name"] == "fit residual"
                 and entry["probe"] in labels]
    return not any(value is not None and value > 0.1 for value in residuals)


def label_of(title, probe, several):
    return ", ".join(part for part in ((title if several else ""), probe) if part)


def panels(sheet, probes, several):
    """(the figure, {probe: its axes}): one panel for all probes of one run; of several runs one for each probe, and the runs in each
    of them."""
    if not several or len(probes) == 1:
        figure, axes = sheet.figure()
        return figure, dict.fromkeys(probes, axes)
    n_columns = 2 if sheet.width > 5 and len(probes) > 3 else 1
    n_rows = -(-len(probes) // n_columns)
    figure, grid = sheet.figure(0.33 * n_rows if n_columns == 1 else 0.28 * n_rows, nrows=n_rows, ncols=n_columns, sharex=True,
                                squeeze=False)
    for axes in list(grid.flat)[len(probes):]:
        axes.set_axis_off()
        grid[-2, 1].tick_params(labelbottom=True)  # which is the lowest of its column
    for probe, axes in zip(probes, grid.flat):
        axes.set_title(probe, fontsize=8, loc="left")
    return figure, dict(zip(probes, grid.flat))


def look_of(titles, title, probes, probe, n_points):
    """Several runs are told apart by colour, dash and marker; the probes of one run by colour and dash."""
    if len(titles) > 1:
        return plot_style.of_run(titles.index(title), n_points)
    return plot_style.of_run(probes.index(probe))


def draw_field(sheet, field, unit, entries, several, suffix=""):
    """The histories of one field and its envelope; a suffix of the files' names."""
    probes = list(dict.fromkeys(entry[1] for entry in entries))
    titles = list(dict.fromkeys(entry[0] for entry in entries))
    end = max(entry[2].max() for entry in entries)
    largest = max(abs(entry[3]).max() for entry in entries)
    time_factor, time_unit = plot_style.readable(end, "s")
    factor, axis_unit = plot_style.readable(largest, unit, field)

    figure, axes_of = panels(sheet, probes, several)
    header, columns, envelopes = [], [], []
    for title, probe, time, values, oscillates in entries:
        label = label_of(title, probe, several)
        drawn_time, drawn = thinned(time, values)
        axes_of[probe].plot(time_factor * drawn_time, factor * drawn, label=title if several else label,
                            **look_of(titles, title, probes, probe, len(drawn)))
        header += [f"{label}: time [s]" if label else "time [s]", f"{label}: {field} [{unit}]" if label
                   else f"{field} [{unit}]"]
        columns += [drawn_time, drawn]
        maxima, minima = turning_points(time, values)
        if oscillates and len(maxima) >= 3 and len(minima) >= 2:
            envelopes.append((title, probe, maxima, minima))
    finish(sheet, figure, axes_of, time_factor * end, time_unit, field, axis_unit)
    name = plot_style.file_name(field + suffix)
    sheet.save(figure, "history-" + name)
    sheet.save_data("history-" + name, header, columns)
    if envelopes:
        left_out = [label_of(entry[0], entry[1], several) for entry in entries
                    if entry[:2] not in [envelope[:2] for envelope in envelopes]]
        if left_out:
            sheet.notes.append(f"envelopes of {field}: {', '.join(left_out)} (no oscillation)")
        draw_envelope(sheet, field, unit, envelopes, (time_factor, time_unit, factor, axis_unit, end), name, several)


def draw_envelope(sheet, field, unit, envelopes, scales, name, several):
    time_factor, time_unit, factor, axis_unit, end = scales
    probes = list(dict.fromkeys(entry[1] for entry in envelopes))
    titles = list(dict.fromkeys(entry[0] for entry in envelopes))
    figure, axes_of = panels(sheet, probes, several)
    header, columns = [], []
    for title, probe, maxima, minima in envelopes:
        label = label_of(title, probe, several)
        look = look_of(titles, title, probes, probe, 0)
        marker = plot_style.MARKERS[titles.index(title) % 8] or "o"
        for kind, points in (("maxima", maxima), ("minima", minima)):
            time, values = numpy.array(points).T
            axes_of[probe].plot(time_factor * time, factor * values, **look, marker=marker, markersize=2.6, linewidth=0.8,
                                label=(title if several else label) if kind == "maxima" else "_")
            prefix = f"{label}: " if label else ""
            header += [f"{prefix}time of {kind} [s]", f"{prefix}{field}, {kind} [{unit}]"]
            columns += [time, values]
    finish(sheet, figure, axes_of, time_factor * end, time_unit, f"{field}, maxima and minima", axis_unit)
    sheet.save(figure, "envelope-" + name)
    sheet.save_data("envelope-" + name, header, columns)


def finish(sheet, figure, axes_of, end, time_unit, name, unit):
    """Axes and legend: above the axes, or above all panels."""
    shown = list(dict.fromkeys(axes_of.values()))
    for axes in shown:
        axes.set_xlim(0, end if end > 0 else 1)
    if len(shown) == 1:
        shown[0].set_xlabel(plot_style.axis_label("time", time_unit))
        shown[0].set_ylabel(plot_style.axis_label(name, unit))
        sheet.legend(shown[0], len([line for line in shown[0].lines if not line.get_label().startswith("_")]))
        return
    figure.supxlabel(plot_style.axis_label("time", time_unit), fontsize=8.5)
    figure.supylabel(plot_style.axis_label(name, unit), fontsize=8.5)
    plot_style.legend_above(figure, labelled(shown), sheet.width)


def labelled(panels_of_figure):
    """One handle for each label of the panels."""
    handles = {}
    for axes in panels_of_figure:
        for handle, label in zip(*axes.get_legend_handles_labels()):
            handles.setdefault(label, handle)
    return list(handles.values())


def draw_power(sheet, runs):
    """The terms of the power balance in all, or of the regions that are wanted, with the residual in a panel of its own."""
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
        # "fluid: kinetic" is one region's share of "kinetic".
        if sheet.choice.regions:
            totals = [entry for entry in watts if entry[1].rpartition(": ")[0] in sheet.choice.regions]
            if not totals:
                sheet.notes.append(f"power of the regions of {run['folder']} (power.csv has no such columns)")
        else:
            # What leaves through an outlet is a term of the balance, too; what the outlet stores is a part of it.
            totals = [entry for entry in watts if ": " not in entry[1] or is_outflow(entry[1])] or watts
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


def is_outflow(name):
    """Whether a column is the power that leaves through an outlet: "outlet distal: leaving"."""
    return name.startswith("outlet ") and name.endswith(": leaving")


def draw_balance(sheet, terms, residuals, several):
    """Of one run all terms in one panel; of several runs a panel for each term."""
    names = list(dict.fromkeys(entry[1] for entry in terms))
    titles = list(dict.fromkeys(entry[0] for entry in terms + residuals))
    groups = [("power", terms)]
    if several:
        groups = [(name, [entry for entry in terms if entry[1] == name]) for name in names]
    if residuals:
        groups.append(("residual", residuals))
    heights = [1] * len(groups) if several else [3, 1][:len(groups)]
    figure, all_axes = sheet.figure(0.28 * len(groups) if several else 0.72 if residuals else 0.55, nrows=len(groups), sharex=True,
                                    squeeze=False, gridspec_kw={"height_ratios": heights})
    end = max(entry[3].max() for entry in terms)
    time_factor, time_unit = plot_style.readable(end, "s")
    header, columns = [], []
    # The terms have one scale, so that the panels can be compared.
    scale = plot_style.readable(max(abs(entry[4]).max() for entry in terms), terms[0][2])
    for axes, (title, entries) in zip(all_axes[:, 0], groups):
        factor, unit = scale
        if title == "residual":
            factor, unit = plot_style.readable(max(abs(entry[4]).max() for entry in entries), entries[0][2])
        for run, name, _, time, values in entries:
            drawn_time, drawn = thinned(time, values)
            label = label_of(run, name, several)
            look = plot_style.of_run(titles.index(run), len(drawn)) if several else \
                plot_style.of_run(names.index(name)) if name in names else {"color": "#000000"}
            axes.plot(time_factor * drawn_time, factor * drawn, label=run if several else label, **look)
            header += [f"{label}: time [s]", f"{label} [{entries[0][2]}]"]
            columns += [drawn_time, drawn]
        axes.set_ylabel(plot_style.axis_label(title, unit))
        axes.set_xlim(0, time_factor * end if end > 0 else 1)
    all_axes[-1, 0].set_xlabel(plot_style.axis_label("time", time_unit))
    if several:
        plot_style.legend_above(figure, labelled(all_axes[:, 0]), sheet.width)
    else:
        sheet.legend(all_axes[0, 0], len(terms))
    sheet.save(figure, "power")
    sheet.save_data("power", header, columns)
