"""The drawing of a network (network-vessels.csv): vessels from node to node, as long and as wide as they are."""

import os

import plot_style
import tables

COLUMNS = ("from node", "to node", "length", "radius at start", "radius at end")
WIDEST = 7.0  # points, of the widest vessel


def read(run):
    """(names of the vessels, names of the nodes, one row a vessel), or None."""
    table = tables.read_table(os.path.join(run["folder"], "network-vessels.csv"))
    if table is None:
        return None
    names = [name for name, _ in table[0]]
    rows = [[float(row[names.index(column)]) for column in COLUMNS] for row in table[1]]
    vessels = [(int(row[0]) - 1, int(row[1]) - 1, *row[2:]) for row in rows]
    return run["summary"].get("vessels", []), run["summary"].get("nodes", []), vessels


def places(vessels):
    """(distance from the first node along the vessels, row) of each node. Branches share the rows of the loose ends behind them."""
    ways = {}
    for start, end, length, *_ in vessels:
        ways.setdefault(start, []).append((end, length))
        ways.setdefault(end, []).append((start, length))
    first = vessels[0][0]
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
    """Of the first run that has a network."""
    for run in runs:
        network = read(run)
        if network is not None:
            draw_network(sheet, *network)
            return


def draw_network(sheet, names, nodes, vessels):
    where, n_rows = places(vessels)
    figure, axes = sheet.figure(min(0.2 + 0.025 * n_rows, 0.85))
    widest = max(max(vessel[3:5]) for vessel in vessels)
    for number, (start, end, _, radius, radius_at_end) in enumerate(vessels):
        (x, y), (x_end, y_end) = where[start], where[end]
        n_pieces = 8
        for piece in range(n_pieces):  # a taper
            a, b = piece / n_pieces, (piece + 1) / n_pieces
            width = radius + (a + b) / 2 * (radius_at_end - radius)
            axes.plot([x + a * (x_end - x), x + b * (x_end - x)], [y + a * (y_end - y), y + b * (y_end - y)],
                      color=plot_style.COLOURS[0], linewidth=max(WIDEST * width / widest, 0.6), solid_capstyle="round")  # without gaps between the pieces
        if number < len(names) and len(vessels) <= 12:
            axes.annotate(names[number], ((x + x_end) / 2, (y + y_end) / 2), xytext=(0, 5), textcoords="offset points", ha="center", fontsize=7)
    axes.plot([x for x, _ in where.values()], [y for _, y in where.values()], "o", color=plot_style.COLOURS[1], markersize=2.5)
    if len(vessels) <= 12:
        for node, (x, y) in where.items():
            if node < len(nodes):
                axes.annotate(nodes[node], (x, y), xytext=(0, -9), textcoords="offset points", ha="center", fontsize=6.5)
    axes.set_title("Width of a line: radius of the vessel, not to scale; dots: junctions and ends", fontsize=8, loc="left")
    axes.spines["left"].set_visible(False)
    axes.set_xlabel("Distance along the vessels [m]")
    axes.set_yticks([])
    axes.margins(x=0.06, y=0.4 if n_rows < 5 else 0.03)
    axes.invert_yaxis()
    sheet.save(figure, "network")
    sheet.save_data("network", ["vessel [1]", "from node [1]", "to node [1]", "length [m]", "radius at start [m]", "radius at end [m]"],
                    [[float(number + 1) for number in range(len(vessels))], *([float(vessel[i] + (1 if i < 2 else 0)) for vessel in vessels]
                                                                             for i in range(5))])
