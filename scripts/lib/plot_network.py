"""The drawing of a network (network-vessels.csv, network-elements.csv): vessels from node to node, as long and as wide as they are, and
elements without a length as signs; and the pressure over the volume of each chamber of a heart (probes.csv)."""

import math
import os
import textwrap

import numpy
import plot_style
import tables

COLUMNS = ("from node", "to node", "length", "radius at start", "radius at end")
WIDEST = 7.0  # points, of the widest vessel
SIGNS = {"resistance": "s", "compliance": "D", "chamber": "o"}  # of a valve: a triangle that points along the flow
LENGTH_OF_ELEMENT = 0.4  # of the mean length of a vessel, between the nodes of an element
LETTER, LINE = 0.066, 0.14  # inches, of a caption
MOST_NAMES = 12  # of vessels and elements that are drawn with their names


def read(run):
    """(names of the vessels, names of the nodes, one row a vessel, (name, type, from node, to node) of each element), or None."""
    table = tables.read_table(os.path.join(run["folder"], "network-vessels.csv"))
    vessels = []
    if table is not None:
        names = [name for name, _ in table[0]]
        rows = [[float(row[names.index(column)]) for column in COLUMNS] for row in table[1]]
        vessels = [(int(row[0]) - 1, int(row[1]) - 1, *row[2:]) for row in rows]
    summary, elements = run["summary"], []
    of_elements = tables.read_table(os.path.join(run["folder"], "network-elements.csv"))
    if of_elements is not None and "elements" in summary:
        elements = [(name, kind, int(row[0]) - 1, int(row[1]) - 1)
                    for name, kind, row in zip(summary["elements"], summary["types of elements"], of_elements[1])]
    if not vessels and not elements:
        return None
    return summary.get("vessels", []), summary.get("nodes", []), vessels, elements


def places(vessels, elements):
    """(distance from the first node along the vessels, row) of each node. Branches share the rows of the loose ends behind them."""
    ways = {}
    of_element = LENGTH_OF_ELEMENT * sum(vessel[2] for vessel in vessels) / len(vessels) if vessels else 1.0
    for start, end, length in [vessel[:3] for vessel in vessels] + [(start, end, of_element) for _, _, start, end in elements]:
        ways.setdefault(start, []).append((end, length))
        ways.setdefault(end, []).append((start, length))
    first = vessels[0][0] if vessels else elements[0][2]
    distance, rows, n_rows = {first: 0.0}, {}, 0
    # A depth-first walk without recursion: a node has its row once all behind it have theirs.
    stack = [(first, iter(ways[first]), [])]
    while stack:
        node, further, behind = stack[-1]
        step = next(further, None)
        if step is not None:
            if step[0] not in distance:
                distance[step[0]] = distance[node] + step[1]
                behind.append(step[0])
                stack.append((step[0], iter(ways[step[0]]), []))
            continue
        stack.pop()
        if behind:
            rows[node] = sum(rows[other] for other in behind) / len(behind)
        else:
            rows[node] = float(n_rows)
            n_rows += 1
    return {node: (distance[node], rows[node]) for node in distance}, n_rows


def draw(sheet, runs):
    """Of the first run that has a network; the loops of all."""
    for run in runs:
        network = read(run)
        if network is not None:
            draw_network(sheet, *network)
            break
    draw_loops(sheet, runs)


def chambers(columns):
    """(name, column of the pressure, column of the volume) of what has a work."""
    names = [name for name, _ in columns]
    for name in names:
        chamber, _, field = name.rpartition(": ")
        if field == "work" and f"{chamber}: volume" in names and f"{chamber}: pressure" in names:
            yield chamber, names.index(f"{chamber}: pressure"), names.index(f"{chamber}: volume")


def draw_loops(sheet, runs):
    """The pressure of each chamber over its volume: all beats thin, the last one thick."""
    loops = {}
    for run in runs:
        table = tables.read_table(os.path.join(run["folder"], "probes.csv"))
        if table is None:
            continue
        columns, data = table
        n_beats = int(next((quantity["value"] for quantity in run["summary"].get("quantities", []) if quantity.get("name") == "beats"), 1))
        first = (len(data) - 1) // n_beats * (n_beats - 1)
        for chamber, pressure, volume in chambers(columns):
            loops.setdefault(chamber, []).append((run["title"], data[:, volume], data[:, pressure], first))
    for chamber, entries in loops.items():
        of_volume, volume_unit = plot_style.readable(max(numpy.abs(volume).max() for _, volume, *_ in entries), "m^3", "volume")
        of_pressure, pressure_unit = plot_style.readable(max(numpy.abs(pressure).max() for _, _, pressure, _ in entries), "Pa", "pressure")
        figure, axes = sheet.figure(0.75)
        header, kept = [], []
        for i, (title, volume, pressure, first) in enumerate(entries):
            colour = plot_style.COLOURS[i % len(plot_style.COLOURS)]
            axes.plot(volume * of_volume, pressure * of_pressure, color=colour, linewidth=0.5, alpha=0.5)
            axes.plot(volume[first:] * of_volume, pressure[first:] * of_pressure, color=colour, linewidth=1.6, label=title)
            header += [f"{title}: volume [{volume_unit}]", f"{title}: pressure [{pressure_unit}]"]
            kept += [volume[first:] * of_volume, pressure[first:] * of_pressure]
        axes.set_xlabel(plot_style.axis_label("volume", volume_unit))
        axes.set_ylabel(plot_style.axis_label("pressure", pressure_unit))
        axes.set_title(f"{chamber}: the thick line is the last beat", fontsize=8, loc="left")
        sheet.legend(axes, len(entries) if len(entries) > 1 else 0)
        name = "loop-" + plot_style.file_name(chamber)
        sheet.save(figure, name)
        sheet.save_data(name, header, kept)


def draw_sign(axes, start, end, marker, size):
    axes.plot((start[0] + end[0]) / 2, (start[1] + end[1]) / 2, marker=marker, color=plot_style.COLOURS[2], markersize=size,
              markerfacecolor="white", zorder=3)


def draw_network(sheet, names, nodes, vessels, elements):
    where, n_rows = places(vessels, elements)
    room = (0.9 + 0.25 * n_rows) / sheet.width if len(vessels) + len(elements) <= MOST_NAMES else 0  # for the names
    figure, axes = sheet.figure(max(min(0.2 + 0.025 * n_rows, 0.85), room))
    widest = max((max(vessel[3:5]) for vessel in vessels), default=1.0)
    for number, (start, end, _, radius, radius_at_end) in enumerate(vessels):
        (x, y), (x_end, y_end) = where[start], where[end]
        n_pieces = 8
        for piece in range(n_pieces):  # a taper
            a, b = piece / n_pieces, (piece + 1) / n_pieces
            width = radius + (a + b) / 2 * (radius_at_end - radius)
            axes.plot([x + a * (x_end - x), x + b * (x_end - x)], [y + a * (y_end - y), y + b * (y_end - y)],
                      color=plot_style.COLOURS[0], linewidth=max(WIDEST * width / widest, 0.6), solid_capstyle="round")  # without gaps between the pieces
        if number < len(names) and len(vessels) <= MOST_NAMES:
            axes.annotate(names[number], ((x + x_end) / 2, (y + y_end) / 2), xytext=(0, 5), textcoords="offset points", ha="center", fontsize=7)
    axes.plot([x for x, _ in where.values()], [y for _, y in where.values()], "o", color=plot_style.COLOURS[1], markersize=2.5)
    named, valves = set(), []
    for name, kind, start, end in elements:
        (x, y), (x_end, y_end) = where[start], where[end]
        if start != end:
            axes.plot([x, x_end], [y, y_end], color=plot_style.COLOURS[2], linewidth=0.8)
        if kind == "valve":
            valves.append((where[start], where[end]))
        else:
            draw_sign(axes, where[start], where[end], SIGNS[kind], 6 if start != end else 9)
        if len(vessels) + len(elements) <= MOST_NAMES:
            axes.annotate(name, ((x + x_end) / 2, (y + y_end) / 2), xytext=(0, 8), textcoords="offset points", ha="center", fontsize=7)
            named.add((name, start if start == end else None))
    if len(vessels) <= MOST_NAMES:
        for node, (x, y) in where.items():
            if node < len(nodes) and (nodes[node], node) not in named:
                axes.annotate(nodes[node], (x, y), xytext=(0, -9), textcoords="offset points", ha="center", fontsize=6.5)
    parts = (["width of a line: radius of the vessel, not to scale"] if vessels else []) + ["dots: junctions and ends"]
    if elements:
        parts.append("signs of elements: square resistance, triangle valve, diamond compliance, circle chamber")
    caption = "; ".join(parts)
    lines = textwrap.wrap(caption[0].upper() + caption[1:], int((sheet.width - 0.2) / LETTER))
    figure.set_size_inches(sheet.width, figure.get_size_inches()[1] + LINE * (len(lines) - 1))
    axes.set_title("\n".join(lines), fontsize=8, loc="left")
    axes.spines["left"].set_visible(False)
    axes.set_xlabel("Distance along the vessels [m]" if vessels else "Elements without a length")
    if not vessels:
        axes.set_xticks([])
    axes.set_yticks([])
    axes.margins(x=0.06, y=0.4 if n_rows < 5 else 0.03)
    axes.invert_yaxis()
    if valves:
        figure.canvas.draw()  # the places on the paper are known
    for start, end in valves:
        (x, y), (x_end, y_end) = axes.transData.transform([start, end])
        draw_sign(axes, start, end, (3, 0, math.degrees(math.atan2(y_end - y, x_end - x)) - 90), 7)
    sheet.save(figure, "network")
    if vessels:
        sheet.save_data("network", ["vessel [1]", "from node [1]", "to node [1]", "length [m]", "radius at start [m]", "radius at end [m]"],
                        [[float(number + 1) for number in range(len(vessels))], *([float(vessel[i] + (1 if i < 2 else 0)) for vessel in vessels]
                                                                                 for i in range(5))])
