"""Figures of waves in a tube: curves by station, pressure over place and time, dispersion, and how the tube was made."""

import math
import os
import textwrap

import matplotlib
import matplotlib.lines
import numpy
import plot_style
import tables
import wave_tables

N_MARKERS = 40  # of a measured curve
LEVELS = numpy.linspace(-1, 1, 11)  # of the lines in space and time, over the largest pressure
OVERLAP = 1.6  # height of the tallest curve, in distances of stations
MOST_THEORIES = 3  # in one picture of several runs
THEORIES = ("theory", "nonlinear theory")
N_PLACES = 200  # columns of the space-time picture
MOST_ON_A_LINEAR_AXIS = 8.0  # the largest value over the smallest one; above, the axis is logarithmic


def draw(sheet, runs, normalised):
    for probe, waves in draw_curves(sheet, runs, normalised).items() or [("", [])]:
        there = [name for _, fields in waves for name in fields]
        if not there or "pressure" in sheet.choice.fields_of(there):
            draw_space_time(sheet, waves, len(runs) > 1, probe)
    draw_dispersion(sheet, runs[0])
    draw_loaded_tube(sheet, runs)
    draw_spin_coating(sheet, runs)


def draw_curves(sheet, runs, normalised):
    """The curves at the stations, one figure a probe and field; of each probe [(run, fields)] of the runs that have some."""
    of_probes = {}
    for run in runs:
        found = wave_tables.read_waves_of_probes(run["folder"])
        # One probe of each run: they are compared, whatever their names are.
        for probe, fields in found.items():
            of_probes.setdefault(probe if len(found) > 1 else "", []).append((run, fields))
        if not found:
            sheet.notes.append(f"waves of {run['folder']} (no rows in wave.csv or wave-PROBE.csv)")
    for probe, waves in of_probes.items():
        there = list(dict.fromkeys(name for _, fields in waves for name in fields))
        for name in sheet.choice.fields_of(there):
            entries = [(run, fields[name], time_scale(sheet, run, fields) if normalised else 1.0)
                       for run, fields in waves if name in fields]
            draw_stations(sheet, name, [entry for entry in entries if entry[2]], normalised, len(runs) > 1, probe)
    return of_probes


def time_scale(sheet, run, fields):
    """What time is divided by: the travel time of the first pulse to the last station. None when there is no such pulse."""
    pressure = fields.get("pressure")
    if pressure is not None and len(pressure.positions) > 1:
        travel = wave_tables.travel_time(pressure, pressure.best())
        if travel > 0:
            return travel
    note = f"normalised waves of {run['folder']} (no pressure pulse that travels from the first station to the last)"
    if note not in sheet.notes:
        sheet.notes.append(note)
    return None


def darker(colour):
    return tuple(0.45 * part for part in matplotlib.colors.to_rgb(colour))


def look_of(i, source, several, n_points=0):
    """Of the i-th run: the simulated curve in the run's own colour (and dash), theory thin and dark, nonlinear theory with dots between
    its dashes, measured values as circles."""
    own = plot_style.of_run(i, n_points) if several else {"color": plot_style.COLOURS[0], "linestyle": "-"}
    if source == "simulated":
        return {**own, "linewidth": 1.3}
    look = {"color": darker(own["color"]), "linestyle": (0, (4, 2)), "linewidth": 0.8}
    if source == "nonlinear theory":
        look.update(linestyle=(0, (6, 1.5, 1, 1.5)), linewidth=1.0)
        if not several:
            look.update(color=plot_style.COLOURS[1])
    if source == "measured":
        look.update(color=plot_style.MEASURED if i == 0 else darker(own["color"]), linestyle="none", marker="o", markersize=3,
                    markerfacecolor="none", markeredgewidth=0.7)
    return look


def repeats(entries, i, source):
    """Whether an earlier run has the same theory or the same measurement, which is drawn once."""
    def same(one, other):
        return (source in one.sources and source in other.sources and one.positions == other.positions
                and numpy.array_equal(one.time, other.time)
                and numpy.allclose(one.sources[source], other.sources[source], rtol=1e-9, equal_nan=True))
    return source != "simulated" and any(same(field, entries[i][1]) for _, field, _ in entries[:i])


def draw_one_station(sheet, name, entries, several, probe):
    """The curves of one field at the only station there is, over time."""
    unit = entries[0][1].unit
    largest = max(numpy.nanmax(numpy.abs(curves)) for _, field, _ in entries for curves in field.sources.values())
    if not (largest > 0 and math.isfinite(largest)):
        sheet.notes.append(f"waves of {name} (nothing but zero)")
        return
    factor, axis_unit = plot_style.readable(largest, unit, name)
    time_factor, time_unit = plot_style.readable(max(field.time[-1] for _, field, _ in entries), "s")
    figure, axes = sheet.figure()
    header, columns = [], []
    for i, (run, field, _) in enumerate(entries):
        label = f"{run['title']}: " if several else ""
        header.append(f"{label}time [s]")
        columns.append(field.time)
        for source, curves in field.sources.items():
            header.append(f"{label}{field.positions[0]:g} m: {name}, {source} [{unit}]")
            columns.append(curves[0])
            if not repeats(entries, i, source):
                every = {"markevery": marked(field.time, curves[0])} if source == "measured" else {}
                axes.plot(time_factor * field.time, factor * curves[0], label=f"{label}{source}",
                          **{**look_of(i, source, several, len(field.time)), **every})
    place_factor, place_unit = plot_style.readable(entries[0][1].positions[0], "m")
    axes.set_title(f"{probe + ', ' if probe else ''}station at {place_factor * entries[0][1].positions[0]:.4g} {place_unit}", fontsize=8.5,
                   loc="left", pad=22)
    axes.set_xlim(0, None)
    axes.set_xlabel(plot_style.axis_label("time", time_unit))
    axes.set_ylabel(plot_style.axis_label(name, axis_unit))
    sheet.legend(axes, len(axes.lines))
    save(sheet, figure, "wave-" + plot_style.file_name(f"{name} {probe}"), header, columns)


def save(sheet, figure, name, header, columns):
    sheet.save(figure, name)
    sheet.save_data(name, header, columns)


def draw_stations(sheet, name, entries, normalised, several, probe=""):
    """The curves of one field, each from the height of its station's position; below them, where something was measured, the
    differences from it. `probe`: its name where a run has several with stations."""
    if not entries:
        return
    if not normalised and all(len(field.positions) == 1 for _, field, _ in entries) and not differences(entries):
        draw_one_station(sheet, name, entries, several, probe)
        return
    unit = entries[0][1].unit
    positions = numpy.unique([position for _, field, _ in entries for position in field.positions])
    distance = numpy.diff(positions).min() if len(positions) > 1 else 1.0
    factors = [1 / wave_tables.first_peak(field.time, field.best()[0])[1] if normalised else 1.0
               for _, field, _ in entries]
    largest = max(numpy.nanmax(numpy.abs(curves)) * factor for (_, field, _), factor in zip(entries, factors)
                  for curves in field.sources.values())
    if not (largest > 0 and math.isfinite(largest)):
        sheet.notes.append(f"waves of {name} (nothing but zero)")
        return
    end = max(field.time[-1] / scale for _, field, scale in entries)
    time_factor, time_unit = (1.0, "1") if normalised else plot_style.readable(end, "s")
    place_factor, place_unit = plot_style.readable(positions[-1], "m")
    height = OVERLAP * distance / largest

    # Many runs with a theory each hide each other.
    crowded = [source for source in THEORIES if MOST_THEORIES < sum(
        source in field.sources and "simulated" in field.sources and not repeats(entries, i, source)
        for i, (_, field, _) in enumerate(entries))]
    for source in crowded:
        sheet.notes.append(f"{source} of {name} in the picture (more than {MOST_THEORIES} runs have one of their own; the csv file has it)")
    compared = differences(entries)
    figure, all_axes = sheet.figure(1.3 if compared else 0.85, nrows=2 if compared else 1, sharex=True, squeeze=False,
                                    gridspec_kw={"height_ratios": [0.85, 0.45] if compared else [1]})
    axes = all_axes[0, 0]
    handles, others, header, columns = [], {}, [], []
    for i, ((run, field, scale), factor) in enumerate(zip(entries, factors)):
        label = f"{run['title']}: " if several else ""
        time = field.time / scale
        header.append(f"{label}time / travel time" if normalised else f"{label}time [s]")
        columns.append(time)
        for source, curves in field.sources.items():
            for position, values in zip(field.positions, curves):
                header.append(f"{label}{position:g} m: {name}, {source} [{'1' if normalised else unit}]")
                columns.append(factor * values)
            if repeats(entries, i, source) or source in crowded:
                continue
            # Theory alone is what the run has computed.
            is_result = source == "theory" and several and "simulated" not in field.sources
            look = look_of(i, "simulated" if is_result else source, several, len(time))
            for position, values in zip(field.positions, curves):
                every = {"markevery": marked(time, values)} if source == "measured" else {}
                axes.plot(time_factor * time, place_factor * (position + height * factor * values), **{**look, **every})
            # A line for each run, and one for all theories: their colours tell whose they are.
            if several and source != "simulated" and not is_result:
                others.setdefault(source, {**look, "color": "#555555"} if source in THEORIES else look)
                continue
            text = run["title"] if several else source
            handles.append(matplotlib.lines.Line2D([], [], label=text, **{key: value for key, value in look.items() if key != "markevery"}))
        if i in compared:
            header += [f"{label}{position:g} m: {name}, simulated - measured [{'1' if normalised else unit}]"
                       for position in field.positions]
            columns += list(factor * compared[i])
    handles += [matplotlib.lines.Line2D([], [], label=source, **look) for source, look in others.items()]
    axes.set_xlim(0, time_factor * end)
    scale_bar(axes, largest, place_factor * height, "1" if normalised else unit, name)
    if compared:
        draw_differences(all_axes[1, 0], entries, compared, factors, several, "1" if normalised else unit, name,
                         (time_factor, place_factor, distance))
    for axes in all_axes[:, 0]:
        # A mark at each station says which curve is whose.
        axes.set_yticks(place_factor * positions)
        axes.grid(axis="y", linewidth=0.3, color="#BBBBBB")
        axes.set_ylabel(plot_style.axis_label("axial position", place_unit))
    axes.set_xlabel("Time / travel time to the last station" if normalised else plot_style.axis_label("time", time_unit))
    if probe:
        handles.insert(0, matplotlib.lines.Line2D([], [], linestyle="none", label=f"Probe {probe}:"))
    sheet.legend(all_axes[0, 0], len(handles), handles)
    save(sheet, figure, "wave-" + plot_style.file_name(f"{name} {probe}"), header, columns)


def differences(entries):
    """{number of the run: simulated minus measured, by station and time}, of the runs that have both at some time."""
    found = {}
    for i, (_, field, _) in enumerate(entries):
        if "simulated" in field.sources and "measured" in field.sources:
            difference = field.sources["simulated"] - field.sources["measured"]
            if numpy.isfinite(difference).any():
                found[i] = difference
    return found


def draw_differences(axes, entries, compared, factors, several, unit, name, scales):
    """Simulated minus measured, in the order of the panel above and with a scale of its own."""
    time_factor, place_factor, distance = scales
    largest = max(numpy.nanmax(numpy.abs(difference)) * factors[i] for i, difference in compared.items())
    height = 0.48 * distance / largest if largest > 0 else 0.0  # noise of neighbours would hide each other
    for i, difference in compared.items():
        _, field, scale = entries[i]
        for position, values in zip(field.positions, difference):
            axes.plot(time_factor * field.time / scale, place_factor * (position + height * factors[i] * values),
                      **{**look_of(i, "simulated", several, len(field.time)), "linewidth": 0.8})
    factor, axis_unit = plot_style.readable(largest, unit, name)
    amount = f"{factor * largest:.3g} {plot_style.axis_label('', axis_unit).strip(' []')}"
    amount = f"{largest:.2g} of the first pulse" if unit == "1" else amount
    axes.set_title(f"Simulated − measured: at most {amount}", fontsize=8.5, loc="left")
    if largest > 0:
        scale_bar(axes, largest, place_factor * height, unit, "difference", quantity=name)


def marked(time, values):
    """The numbers of the values that get a marker, evenly in time."""
    there = numpy.flatnonzero(numpy.isfinite(values))
    if there.size <= N_MARKERS:
        return there.tolist()
    wanted = numpy.linspace(time[there[0]], time[there[-1]], N_MARKERS)
    return numpy.unique(there[numpy.searchsorted(time[there], wanted).clip(0, there.size - 1)]).tolist()


def scale_bar(axes, largest, height, unit, name, quantity=None):
    """At the right, beside the axes: how high a round part of the tallest curve is drawn. `quantity`: whose units it has, if it
    has another name."""
    factor, axis_unit = plot_style.readable(largest, unit, quantity or name)
    exponent = 10.0**math.floor(math.log10(factor * largest))
    value = max(step * exponent for step in (1, 2, 5) if step * exponent <= factor * largest) / factor
    low, high = axes.get_ylim()
    middle = 0.5 * (low + high)
    bar = [middle - 0.5 * value * height, middle + 0.5 * value * height]
    axes.plot([1.02, 1.02], bar, "-", color="#000000", linewidth=1.5, clip_on=False,
              transform=axes.get_yaxis_transform())
    axes.set_ylim(low, high)
    unit = plot_style.axis_label("", axis_unit).strip(" []")
    pulse = "height of the first pulse" if value == 1 else f"{value:g} times the height of the first pulse"
    text = f"{name},\n{pulse}" if axis_unit == "1" else f"{name}, {factor * value:.4g} {unit}"
    axes.annotate(text, (1.02, middle), xycoords=axes.get_yaxis_transform(), xytext=(4, 0),
                  textcoords="offset points", rotation=90, va="center", ha="left", fontsize=8)


def between(time, lower, upper, share, delay):
    """A travelling curve between two stations, from those of both, each shifted to where it has come."""
    return ((1 - share) * numpy.interp(time - share * delay, time, lower)
            + share * numpy.interp(time + (1 - share) * delay, time, upper))


def space_time(fields, name="pressure"):
    """(positions, time, values by place and time, their source). Between stations the waves of pressure that travel forward and
    backward are followed at the speed of the first pulse; where they are not told apart, values are linear."""
    pressure = fields[name]
    source = next(iter(pressure.sources))
    curves = pressure.sources[source]
    parts = [(curves, 0.0)]
    if name == "pressure" and all(wave in fields and source in fields[wave].sources for wave in ("forward wave", "backward wave")):
        parts = [(fields["forward wave"].sources[source], 1.0), (fields["backward wave"].sources[source], -1.0)]
    arrivals = [wave_tables.first_peak(pressure.time, values)[0] for values in parts[0][0]]
    places = numpy.linspace(pressure.positions[0], pressure.positions[-1], N_PLACES)
    found = []
    for place in places:
        i = min(numpy.searchsorted(pressure.positions, place, side="right"), len(pressure.positions) - 1) - 1
        share = (place - pressure.positions[i]) / (pressure.positions[i + 1] - pressure.positions[i])
        delay = numpy.nan_to_num(arrivals[i + 1] - arrivals[i])
        found.append(sum(between(pressure.time, part[i], part[i + 1], share, sign * delay) for part, sign in parts))
    return places, pressure.time, numpy.array(found), source


def draw_space_time(sheet, waves, several, probe=""):
    shown = [(run, fields) for run, fields in waves if "pressure" in fields and len(fields["pressure"].positions) > 1
             and numpy.isfinite(fields["pressure"].best()).all()]
    if waves and not shown:
        sheet.notes.append(f"space-time picture{' of ' + probe if probe else ''} (no pressure at two stations or more)")
    if not shown:
        return
    pictures = [space_time(fields) for _, fields in shown]
    largest = max(numpy.abs(values).max() for _, _, values, _ in pictures)
    lowest = min(values.min() for _, _, values, _ in pictures)
    factor, unit = plot_style.readable(largest, "Pa", "pressure")
    time_factor, time_unit = plot_style.readable(max(time[-1] for _, time, _, _ in pictures), "s")
    place_factor, place_unit = plot_style.readable(max(places[-1] for places, _, _, _ in pictures), "m")
    # White is zero where there is suction as well as pressure.
    signed = lowest < -0.1 * largest
    look = {"cmap": "RdBu_r" if signed else "cividis", "vmin": -factor * largest if signed else factor * min(lowest, 0),
            "vmax": factor * largest}

    n_columns = min(len(shown), 3 if sheet.width > 5 else 1)
    n_rows = math.ceil(len(shown) / n_columns)
    figure, all_axes = sheet.figure((0.75 if n_columns == 1 else 0.6 if n_columns == 2 else 0.5) * n_rows, nrows=n_rows, ncols=n_columns,
                                    sharex=True, sharey=True, squeeze=False)
    header, columns = [], []
    for (run, _), (places, time, values, source), axes in zip(shown, pictures, all_axes.flat):
        step = max(1, len(time) // 600)
        extent = (place_factor * places[0], place_factor * places[-1], time_factor * time[0], time_factor * time[-1])
        image = axes.imshow(factor * values.T[::step], origin="lower", aspect="auto", extent=extent, **look)
        levels = factor * largest * LEVELS
        drawn = factor * values.T[::step]
        levels = levels[(levels > numpy.nanmin(drawn)) & (levels < numpy.nanmax(drawn))]
        if levels.size:
            axes.contour(place_factor * places, time_factor * time[::step], drawn, levels, colors="#000000", linewidths=0.3, linestyles="-")
        if several:
            axes.set_title(textwrap.fill(run["title"], int(13 * (sheet.width - 1) / n_columns)), fontsize=8, loc="left")
        prefix = f"{run['title']}: " if several else ""
        kept = range(0, len(places), 10)
        header += [f"{prefix}time [s]"] + [f"{prefix}{places[i]:.5g} m: pressure, {source} [Pa]" for i in kept]
        columns += [time[::step]] + [values[i, ::step] for i in kept]
    for axes in all_axes.flat[len(shown):]:
        axes.set_axis_off()
    for axes in all_axes[-1]:
        axes.set_xlabel(plot_style.axis_label("axial position", place_unit))
    for axes in all_axes[:, 0]:
        axes.set_ylabel(plot_style.axis_label("time", time_unit))
    if probe and not several:
        all_axes[0, 0].set_title(f"Probe {probe}", fontsize=8.5, loc="left")
    bar = figure.colorbar(image, ax=all_axes, label=plot_style.axis_label("pressure", unit), shrink=0.9, aspect=30)
    for level in factor * largest * LEVELS:
        if look["vmin"] < level < look["vmax"]:
            bar.ax.axhline(level, color="#000000", linewidth=0.3)  # of the lines in the picture
    save(sheet, figure, plot_style.file_name(f"space time pressure {probe}"), header, columns)


def draw_dispersion(sheet, run):
    """Phase speed, group speed and attenuation over frequency, of the first run."""
    table = tables.read_table(os.path.join(run["folder"], "dispersion.csv"))
    if table is None:
        sheet.notes.append(f"dispersion of {run['folder']} (no rows in dispersion.csv)")
        return
    names, data = table
    # About a loaded state there is no group speed.
    panels = [quantity for quantity in ("phase speed", "group speed", "attenuation") if any(name.endswith(quantity) for name, _ in names)]
    families = list(dict.fromkeys(name.rpartition(": ")[0] for name, _ in names[1:]))
    exact = [family for family in families if family.endswith(" wave")]
    figure, all_axes = sheet.figure((1.1 if sheet.width > 4 else 1.8) * len(panels) / 3, nrows=len(panels), sharex=True)
    limits = data[0, 0], max(highest_frequency(run["summary"], data[-1, 0]), 2 * data[0, 0])
    inside = (data[:, 0] >= limits[0]) & (data[:, 0] <= limits[1])
    for axes, quantity in zip(all_axes, panels):
        drawn = []
        for i, (name, unit) in enumerate(names[1:], 1):
            family, _, what = name.rpartition(": ")
            positive = numpy.isfinite(data[:, i]) & (data[:, i] > 0)
            # A wave that there is only beyond these frequencies would be in the legend alone.
            if what != quantity or (positive & inside).sum() < 2:
                continue
            # Two bending waves may have one attenuation: dashes show the one below, too.
            curve = data[positive & inside, i]
            is_covering = any(len(other) == len(curve) and numpy.median(abs(numpy.log(curve / other))) < 0.01 for other in drawn)
            drawn.append(curve)
            is_exact = family in exact
            values = numpy.where(positive, data[:, i], numpy.nan)
            style = ((0, (4, 4)) if is_covering else "-") if is_exact else plot_style.LINES[1 + families.index(family) % 3]
            axes.plot(data[:, 0], values, linestyle=style,
                      color=plot_style.COLOURS[families.index(family) % len(plot_style.COLOURS)],
                      linewidth=1.4 if is_exact else 0.9, label=family)
            axes.set_ylabel(plot_style.axis_label(quantity, unit))
        # A logarithmic axis is for decades; from 6 to 9 m/s it has no readable marks.
        if drawn and max(values.max() for values in drawn) > MOST_ON_A_LINEAR_AXIS * min(values.min() for values in drawn):
            axes.set_yscale("log")
            axes.set_ylim(0.8 * min(values.min() for values in drawn), 1.25 * max(values.max() for values in drawn))
        elif drawn:
            axes.set_ylim(0.9 * min(values.min() for values in drawn), 1.1 * max(values.max() for values in drawn))
        mark_load(axes, run["summary"], axes is all_axes[0])
        if axes.get_yscale() == "log":
            plot_style.readable_logarithm(axes)
    all_axes[0].set_xscale("log")
    all_axes[-1].set_xlabel("Frequency [Hz]")
    all_axes[0].set_xlim(*limits)
    handles = {}
    for axes in all_axes:
        for handle, label in zip(*axes.get_legend_handles_labels()):
            handles.setdefault(label, handle)
    sheet.legend(all_axes[0], len(handles), [handles[family] for family in [*families, "load"] if family in handles])
    sheet.save(figure, "dispersion")
    sheet.save_data("dispersion", [name if unit == "1" else f"{name} [{unit}]" for name, unit in names], list(data.T))


def frequency_of_load(summary):
    """Below which nine tenths of the load's energy are [Hz]; None if it does not vary."""
    report = summary.get("pre-flight report", {})
    return report.get("load frequency [Hz]") if isinstance(report, dict) else None


def highest_frequency(summary, last):
    """Up to which frequency the load has something to say: ten times its own, or the end of the table."""
    own = frequency_of_load(summary)
    return min(last, 10 * own) if own else last


def mark_load(axes, summary, is_named):
    """The band in which the load is, in grey."""
    own = frequency_of_load(summary)
    if own:
        axes.axvspan(1e-9 * own, own, color="#DDDDDD", zorder=0, linewidth=0, label="load" if is_named else "_")


def draw_loaded_tube(sheet, runs):
    """Radius and speed of long waves over the mean pressure."""
    shown = []
    for run in runs:
        table = tables.read_table(os.path.join(run["folder"], "loaded-tube.csv"))
        if table is not None and len(table[1]) > 1:
            shown.append((run, table))
    if not shown:
        return
    narrow = sheet.width < 4
    figure, all_axes = sheet.figure(1.5 if narrow else 0.45, nrows=2 if narrow else 1, ncols=1 if narrow else 2)
    header, columns = [], []
    pressure_factor, pressure_unit = plot_style.readable(max(data[:, 0].max() for _, (_, data) in shown), "Pa", "pressure")
    for axes, quantity in zip(all_axes, ("inner radius", "speed of long waves")):
        for number, (run, (names, data)) in enumerate(shown):
            i = [name for name, _ in names].index(quantity)
            unit = names[i][1]
            factor, axis_unit = plot_style.readable(max(table[1][:, i].max() for _, table in shown), unit, quantity)
            axes.plot(pressure_factor * data[:, 0], factor * data[:, i], label=run["title"], **plot_style.of_run(number, len(data)))
            axes.set_ylabel(plot_style.axis_label(quantity, axis_unit))
        axes.set_xlabel(plot_style.axis_label("pressure", pressure_unit))
        axes.set_xlim(0, None)
        axes.set_ylim(0, None)
    for run, (names, data) in shown:
        prefix = f"{run['title']}: " if len(shown) > 1 else ""
        header += [f"{prefix}{name} [{unit}]" for name, unit in names]
        columns += list(data.T)
    if len(shown) > 1:
        plot_style.legend_above(figure, all_axes[0].get_legend_handles_labels()[0], sheet.width)
    sheet.save(figure, "loaded-tube")
    sheet.save_data("loaded-tube", header, columns)


def draw_spin_coating(sheet, runs):
    """What the motors do along the rod, and the tube that comes of it."""
    shown = []
    for run in runs:
        table = tables.read_table(os.path.join(run["folder"], "spin-coating.csv"))
        if table is not None:
            shown.append((run, table))
    if not shown:
        return
    names = [name for name, _ in shown[0][1][0]]
    panels = [name for name in ("trolley speed", "rod speed", "wall thickness", "diameter") if name in names]
    narrow = sheet.width < 4
    figure, all_axes = sheet.figure(2.2 if narrow else 0.65, nrows=4 if narrow else 2, ncols=1 if narrow else 2,
                                    sharex=True, squeeze=False)
    header, columns = [], []
    place_factor, place_unit = plot_style.readable(max(table[1][:, 0].max() for _, table in shown), "m")
    for axes, quantity in zip(all_axes.flat, panels):
        i = names.index(quantity)
        unit = shown[0][1][0][i][1]
        factor, axis_unit = plot_style.readable(max(table[1][:, i].max() for _, table in shown), unit)
        for number, (run, (_, data)) in enumerate(shown):
            axes.plot(place_factor * data[:, 0], factor * data[:, i], label=run["title"], **plot_style.of_run(number, len(data)))
            prefix = f"{run['title']}: " if len(shown) > 1 else ""
            if quantity == panels[0]:
                header.append(f"{prefix}position [m]")
                columns.append(data[:, 0])
            header.append(f"{prefix}{quantity} [{unit}]")
            columns.append(data[:, i])
        axes.set_ylabel(plot_style.axis_label(quantity, axis_unit))
        axes.set_ylim(0, None)
    for axes in all_axes[-1]:
        axes.set_xlabel(plot_style.axis_label("position along the rod", place_unit))
    if len(shown) > 1:
        handles, labels = all_axes[0, 0].get_legend_handles_labels()
        # Above all panels, in room added for it.
        width, height = figure.get_size_inches()
        room = 0.18 * len(labels) + 0.05
        figure.set_size_inches(width, height + room)
        figure.get_layout_engine().set(rect=(0, 0, 1, height / (height + room)))
        figure.legend(handles, labels, loc="upper left", borderaxespad=0.2)
    sheet.save(figure, "spin-coating")
    sheet.save_data("spin-coating", header, columns)
