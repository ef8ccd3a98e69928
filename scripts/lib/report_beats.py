"""The last beat over its phase, beside the one before."""

import continua
import numpy
import plot_style


def beats_of(run):
    """[(number, start [s], end [s])] of the beats in the summary."""
    beats = run["summary"].get("beats", {})
    times, numbers = beats.get("time [s]", []), beats.get("beat [1]", [])
    if not times:
        return []
    period = times[1] - times[0] if len(times) > 1 else times[0]
    return [(int(number), end - period, end) for number, end in zip(numbers, times)]


def draw(sheet, runs):
    """One figure a field: the last beat of each run and probe, and thin the beat before."""
    curves = {}
    for run in runs:
        beats = beats_of(run)
        if not beats:
            continue
        try:
            probes = run["results"].probes
        except continua.ResultsError:
            continue
        time = probes.index.to_numpy()
        for column in probes.columns:
            probe, _, field = column.rpartition(": ")
            if field not in sheet.choice.fields_of([field]):
                continue
            for number, start, end in beats[-2:]:
                inside = (time >= start - 1e-9 * end) & (time <= end * (1 + 1e-9))
                if inside.sum() > 2:
                    label = ", ".join(filter(None, [run["title"] if len(runs) > 1 else "", probe]))
                    curves.setdefault((field, probes.attrs["units"].get(column, "1")), []).append(
                        (label, number, number == beats[-1][0], (time[inside] - start) / (end - start), probes[column].to_numpy()[inside]))
    for (field, unit), entries in curves.items():
        draw_field(sheet, field, unit, entries)


def draw_field(sheet, field, unit, entries):
    labels = list(dict.fromkeys(entry[0] for entry in entries))
    factor, axis_unit = plot_style.readable(max(numpy.abs(entry[4]).max() for entry in entries), unit, field)
    figure, axes = sheet.figure()
    header, columns = [], []
    for label, number, is_last, phase, values in entries:
        look = plot_style.of_run(labels.index(label))
        axes.plot(phase, factor * values, label=f"{label}, beat {number}" if is_last else "_", linewidth=1.2 if is_last else 0.5, **look)
        header += [f"{label}, beat {number}: phase [1]", f"{label}, beat {number}: {field} [{unit}]"]
        columns += [phase, values]
    axes.set_xlim(0, 1)
    axes.set_xlabel("Phase of the beat (thin: the beat before)")
    axes.set_ylabel(plot_style.axis_label(field, axis_unit))
    sheet.legend(axes, len(labels))
    name = "last-beat-" + plot_style.file_name(field)
    sheet.save(figure, name)
    sheet.save_data(name, header, columns)
