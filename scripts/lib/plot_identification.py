"""Figures of an identification: measured values with the fit and its residuals, correlations, profiles, and the errors that stations
would give."""

import os
import textwrap

import continua
import matplotlib
import numpy
import plot_style

MOST_BARS = 60  # of a measured curve; error bars of all data would be a band
MARK = {"marker": "o", "markersize": 3, "markerfacecolor": "none", "markeredgewidth": 0.7, "color": plot_style.MEASURED}


def is_identification(folder):
    return os.path.exists(os.path.join(folder, "identification.csv"))


def table(folder, name):
    """The table NAME.csv with rows, or None."""
    results = continua.open(folder)
    if not results.has(f"{name}.csv"):
        return None
    found = results.table(name)
    return None if found.empty else found


def draw(sheet, folder):
    for name, function in (("fit", draw_fits), ("correlation", draw_correlation), ("profiles", draw_profiles),
                           ("expected-errors", draw_expected_errors)):
        found = table(folder, name)
        if found is None:
            sheet.notes.append(f"{name} (no rows in {name}.csv)")
        else:
            function(sheet, found)


def groups_of(column):
    """[(value, rows)] of a column of texts, in their order."""
    cells = [str(cell) for cell in column]
    return [(name, [i for i, cell in enumerate(cells) if cell == name]) for name in dict.fromkeys(cells)]


def numbers(found, column, rows=None):
    values = numpy.array(found[column], dtype=float)
    return values if rows is None else values[rows]


def texts(found, column):
    """The cells of a column as texts, "" where there is none."""
    return ["" if cell is None or cell != cell else str(cell) for cell in found[column]]


def draw_fits(sheet, found):
    """A figure for each record: open markers with their noise, the fit as a line, and below them the residuals with the band of the
    noise."""
    for record, rows in groups_of(found["record"]):
        field = record.rpartition(": ")[2]
        if field not in sheet.choice.fields_of([field]):
            continue
        unit = str(found["unit"][rows[0]])
        time, measured, fitted, residual, noise = (numbers(found, name, rows) for name in ("time", "measured", "fitted", "residual", "noise"))
        time_factor, time_unit = plot_style.readable(abs(time).max(), "s")
        factor, axis_unit = plot_style.readable(numpy.nanmax(abs(measured)), unit, field)
        small_factor, small_unit = plot_style.readable(max(numpy.nanmax(abs(residual)), numpy.nanmax(noise)), unit, field)
        figure, (above, below) = sheet.figure(0.72, nrows=2, sharex=True, gridspec_kw={"height_ratios": [3, 1.4]})
        shown = numpy.unique(numpy.linspace(0, len(rows) - 1, min(len(rows), MOST_BARS)).round().astype(int))
        above.errorbar(time_factor * time[shown], factor * measured[shown], yerr=factor * noise[shown], linestyle="none", elinewidth=0.6,
                       capsize=1.5, capthick=0.6, ecolor=plot_style.MEASURED, label=label_of_data(len(shown), len(rows)), **MARK)
        above.plot(time_factor * time, factor * fitted, color=plot_style.COLOURS[0], label="fit", zorder=3)
        below.fill_between(time_factor * time, -small_factor * noise, small_factor * noise, color="#DDDDDD", linewidth=0)
        below.axhline(0, color="#7F7F7F", linewidth=0.6)
        below.plot(time_factor * time, small_factor * residual, color=plot_style.MEASURED, linewidth=0.7)
        above.set_ylabel(textwrap.fill(plot_style.axis_label(record, axis_unit), 36))
        below.set_ylabel(plot_style.axis_label("residual", small_unit))
        below.set_xlabel(plot_style.axis_label("time", time_unit))
        below.text(1.0, 1.02, "grey: ± noise", fontsize=7.5, ha="right", va="bottom", transform=below.transAxes)
        above.set_xlim(time_factor * time.min(), time_factor * time.max())
        # A test of a material, whose rows go over decades.
        if field == "relaxation" and time.min() > 0:
            below.set_xscale("log")
            above.set_ylabel(f"ln({record} modulus/Pa)")
        sheet.legend(above, 2)
        figure.align_ylabels()
        sheet.save(figure, "fit-" + plot_style.file_name(record))


def label_of_data(n_shown, n):
    return "measured ± noise" if n_shown == n else f"measured ± noise, {n_shown} of {n} data"


def draw_correlation(sheet, found):
    names = [str(name) for name in found["parameter"]]
    matrix = numpy.array([[float(found[name][i]) for name in names] for i in range(len(names))])
    if len(names) < 2:
        sheet.notes.append("correlation (of one parameter alone)")
        return
    figure, axes = sheet.figure(0.35 + 0.07 * len(names))
    image = axes.imshow(matrix, cmap="RdBu_r", vmin=-1, vmax=1)
    for i, j in numpy.ndindex(matrix.shape):
        text = f"{matrix[i, j]:.2f}"
        # 0.998 is not 1: how near it is decides.
        if i != j and abs(matrix[i, j]) > 0.995:
            text = f"{matrix[i, j]:.5f}".rstrip("0")
        axes.text(j, i, text.replace("-", "−"), ha="center", va="center", fontsize=7.5, color="white" if abs(matrix[i, j]) > 0.6 else "black")
    axes.set_xticks(range(len(names)), names, rotation=30, ha="right", rotation_mode="anchor")
    axes.set_yticks(range(len(names)), names)
    axes.tick_params(length=0)
    for spine in axes.spines.values():
        spine.set_visible(False)
    figure.colorbar(image, ax=axes, label="Correlation")
    sheet.save(figure, "correlation")


def draw_profiles(sheet, found):
    """The misfit above its least value over each parameter, with the threshold of its interval."""
    for name, rows in groups_of(found["parameter"]):
        unit = str(found["unit"][rows[0]])
        value, misfit, threshold = (numbers(found, column, rows) for column in ("value", "misfit", "threshold"))
        order = numpy.argsort(value)
        factor, axis_unit = plot_style.readable(abs(value).max(), unit)
        figure, axes = sheet.figure()
        axes.plot(factor * value[order], misfit[order], marker="o", markersize=3.5, label="misfit above its least")
        axes.axhline(threshold[0], color=plot_style.MEASURED, linewidth=0.9, linestyle="--", label=f"threshold {threshold[0]:.4g}")
        low, high = interval(value[order], misfit[order], threshold[0])
        axes.axvspan(factor * low, factor * high, color="#EEEEEE", linewidth=0, zorder=0)
        axes.set_ylim(0, min(misfit.max(), 4 * threshold[0]) * 1.05)
        axes.set_xlabel(plot_style.axis_label(name, axis_unit))
        axes.set_ylabel("Misfit above its least")
        sheet.legend(axes, 2)
        sheet.save(figure, "profile-" + plot_style.file_name(name))


def interval(value, misfit, threshold):
    """Where the broken line through the values crosses the threshold, around its least value; the end of the line where it does not."""
    least = int(numpy.argmin(misfit))
    ends = []
    for step, stop in ((-1, -1), (1, len(value))):
        end = value[least]
        for i in range(least + step, stop, step):
            if misfit[i] > threshold:
                share = (threshold - misfit[i - step]) / (misfit[i] - misfit[i - step])
                end = value[i - step] + share * (value[i] - value[i - step])
                break
            end = value[i]
        ends.append(end)
    return ends


def of_errors(found):
    """{parameter: (column, unit)} of "NAME: standard error [UNIT]"."""
    ending = ": standard error"
    units = found.attrs["units"]
    return {column[: -len(ending)]: (column, units.get(column, "")) for column in found.columns if column.endswith(ending)}


def draw_expected_errors(sheet, found):
    """For each parameter: one station more, over its position, a curve a field; two stations more, a map for each pair of fields."""
    ranks = numbers(found, "rank")
    position, second = numbers(found, "position"), numbers(found, "second position")
    first_fields, second_fields = texts(found, "field"), texts(found, "second field")
    single = [i for i in range(len(ranks)) if ranks[i] > 0 and numpy.isfinite(position[i]) and not second_fields[i]]
    pairs = [i for i in range(len(ranks)) if numpy.isfinite(position[i]) and numpy.isfinite(second[i])]
    alone = numpy.flatnonzero(ranks == 0)
    # Material tests have no place: each is a line across the picture.
    tests = [i for i in range(len(ranks)) if ranks[i] > 0 and first_fields[i] and not second_fields[i] and not numpy.isfinite(position[i])]
    for name, (column, unit) in of_errors(found).items():
        errors = numbers(found, column)
        if single:
            draw_errors_of_one(sheet, name, unit, found, errors, single, alone, tests)
        if pairs:
            draw_errors_of_two(sheet, name, unit, found, errors, pairs)
    if not single and not pairs:
        sheet.notes.append("expected errors (no candidate is one station or two)")


def draw_errors_of_one(sheet, name, unit, found, errors, rows, alone, tests):
    position = numbers(found, "position")
    finite = [errors[i] for i in rows if numpy.isfinite(errors[i])]
    if not finite:
        sheet.notes.append(f"expected errors of {name} (not seen with any of the stations)")
        return
    factor, axis_unit = plot_style.readable(max(finite), unit)
    place_factor, place_unit = plot_style.readable(position[rows].max(), "m")
    figure, axes = sheet.figure()
    for i, (field, of_field) in enumerate(groups_of([found["field"][row] for row in rows])):
        chosen = sorted((rows[k] for k in of_field), key=lambda row: position[row])
        look = plot_style.of_run(i)
        axes.plot(place_factor * position[chosen], factor * errors[chosen], marker=plot_style.MARKERS[i % 8] or "o", markersize=4,
                  label=field, **look)
    for i, row in enumerate(tests):
        if numpy.isfinite(errors[row]):
            axes.axhline(factor * errors[row], color=plot_style.COLOURS[(i + 4) % len(plot_style.COLOURS)], linewidth=0.9, linestyle="--", label=f"with {found['field'][row]}")
    if len(alone) and numpy.isfinite(errors[alone[0]]):
        axes.axhline(factor * errors[alone[0]], color="#7F7F7F", linewidth=0.9, linestyle=":", label="records of the file alone")
    axes.set_ylim(bottom=0)
    axes.set_xlabel(plot_style.axis_label("position of the added station", place_unit))
    axes.set_ylabel(plot_style.axis_label(f"expected standard error of {name}", axis_unit))
    sheet.legend(axes, max(2, len(axes.lines)))
    sheet.save(figure, "expected-errors-" + plot_style.file_name(name))


def draw_errors_of_two(sheet, name, unit, found, errors, rows):
    """A map over both positions; where both fields are the same, both orders of the pair."""
    position, second = numbers(found, "position"), numbers(found, "second position")
    pairs = groups_of([f"{found['field'][i]} and {found['second field'][i]}" for i in rows])
    finite = [errors[i] for i in rows if numpy.isfinite(errors[i])]
    if not finite:
        sheet.notes.append(f"expected errors of {name} (not seen with any pair of stations)")
        return
    factor, axis_unit = plot_style.readable(max(finite), unit)
    places = sorted(set(position[rows]) | set(second[rows]))
    place_factor, place_unit = plot_style.readable(places[-1], "m")
    colours = matplotlib.colormaps["viridis_r"].with_extremes(bad="#DDDDDD")
    limits = factor * min(finite), factor * max(finite)
    for pair, of_pair in pairs:
        grid = numpy.full((len(places), len(places)), numpy.nan)
        first_field, second_field = pair.split(" and ", 1)
        for k in of_pair:
            i = rows[k]
            x, y = places.index(position[i]), places.index(second[i])
            grid[y, x] = factor * errors[i]
            if first_field == second_field:
                grid[x, y] = factor * errors[i]
        figure, axes = sheet.figure(0.7)
        image = axes.imshow(grid, origin="lower", cmap=colours, vmin=limits[0], vmax=limits[1], aspect="equal")
        labels = [f"{place_factor * place:.4g}" for place in places]
        every = max(1, -(-len(places) // 12))
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_ticks(range(0, len(places), every), labels[::every])
        axes.set_xlabel(plot_style.axis_label(f"position of {first_field}", place_unit))
        axes.set_ylabel(plot_style.axis_label(f"position of {second_field}", place_unit))
        figure.colorbar(image, ax=axes, label=plot_style.axis_label(f"expected standard error of {name}", axis_unit))
        if not numpy.isfinite(grid).all():
            axes.text(1.0, 1.01, "grey: no such pair", fontsize=7.5, ha="right", va="bottom", transform=axes.transAxes)
        sheet.save(figure, "expected-errors-" + plot_style.file_name(f"{name} {pair}"))
