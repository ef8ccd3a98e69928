"""What is known at the nodes of walls alone: wall shear stress, its mean and its oscillation, along the walls of a plane body."""

import numpy
import plot_style

OF_WALLS = ("wall_shear_stress", "time_averaged_wall_shear_stress", "oscillatory_shear_index")
LABELS = {"wall_shear_stress": "wall shear stress, magnitude"}


def walls_of(data, field):
    """[(points of shape (n, 2) [m] in order along a wall, values)] of a plane state (xarray). A node has a value if it is not 0."""
    points = numpy.column_stack([data["x"].to_numpy(), data["y"].to_numpy()])
    values = data[field].to_numpy().astype(float)
    values = numpy.linalg.norm(values, axis=1) if values.ndim == 2 else values
    solid = data["phase"].to_numpy() > 0.5 if "phase" in data else numpy.zeros(len(points), bool)
    size = numpy.ptp(points, axis=0).max()
    _, numbers = numpy.unique(numpy.round(points / (1e-7 * size)).astype(numpy.int64), axis=0, return_inverse=True)
    numbers = numbers.ravel()
    # The edges of the liquid's cells that belong to one cell alone, with a value at both ends.
    cells = data["cells"].to_numpy()
    cells = cells[~solid[cells[:, 0]]]
    ends = numpy.concatenate([numpy.stack([cells[:, i], cells[:, (i + 1) % cells.shape[1]]], axis=1) for i in range(cells.shape[1])])
    keys, first, counts = numpy.unique(numpy.sort(numbers[ends], axis=1), axis=0, return_index=True, return_counts=True)
    of_wall = (counts == 1) & (values[ends[first]] != 0).all(axis=1)
    keys, ends = keys[of_wall], ends[first][of_wall]
    place, value = {}, {}
    for pair, names in zip(ends, numbers[ends]):
        for point, name in zip(pair, names):
            place[name], value[name] = points[point], values[point]
    found = [(numpy.array([place[name] for name in chain]), numpy.array([value[name] for name in chain])) for chain in chains(keys)]
    return sorted(found, key=lambda wall: wall[0][:, 1].mean())


def chains(edges):
    """The edges, pairs of numbers, as lists of numbers in a row; a ring ends where it began."""
    neighbours = {}
    for one, other in edges.tolist():
        neighbours.setdefault(one, []).append(other)
        neighbours.setdefault(other, []).append(one)
    left, found = set(map(frozenset, edges.tolist())), []
    for start in sorted(neighbours, key=lambda name: len(neighbours[name])):  # ends before the middle
        while any(frozenset((start, other)) in left for other in neighbours[start]):
            chain = [start]
            while True:
                following = next((other for other in neighbours[chain[-1]] if frozenset((chain[-1], other)) in left), None)
                if following is None:
                    break
                left.remove(frozenset((chain[-1], following)))
                chain.append(following)
            found.append(chain)
    return found


def position_along(points):
    """(x [m], "x") of a wall along which x grows or falls throughout, else (the length along it [m], "length along the wall")."""
    steps = numpy.diff(points[:, 0])
    if (steps > 0).all() or (steps < 0).all():
        return points[:, 0], "x"
    return numpy.concatenate([[0], numpy.cumsum(numpy.linalg.norm(numpy.diff(points, axis=0), axis=1))]), "length along the wall"


def draw(sheet, run, pieces, field, of, suffix=""):
    """The curves along the walls of a plane body. Whether the body is plane: of one in space the wall's surface is drawn."""
    try:
        from continua.fields import State
    except ImportError:
        sheet.notes.append(f"{field.replace('_', ' ')} of {run['folder']} (python3-vtk9 is not installed)")
        return True
    data = State(0.0, pieces).dataset
    if numpy.ptp(data["z"].to_numpy()) > 1e-9 * numpy.ptp(data["x"].to_numpy()):
        return False
    walls = [(points, values) for points, values in walls_of(data, field) if len(points) > 1]
    label = LABELS.get(field, field.replace("_", " "))
    if not walls:
        sheet.notes.append(f"{label} of {run['folder']} (no wall has a value at {of})")
        return True
    along = [(*position_along(points), points, values) for points, values in walls]
    name = along[0][1] if len({kind for _, kind, _, _ in along}) == 1 else "x or length along the wall"
    unit = run["summary"].get("field units", {}).get(field, "1")
    factor, axis_unit = plot_style.readable(max(numpy.abs(values).max() for *_, values in along), unit, label)
    place_factor, place_unit = plot_style.readable(max(numpy.abs(place).max() for place, *_ in along), "m")
    figure, axes = sheet.figure(0.5)
    header, columns = [], []
    for i, (place, _, points, values) in enumerate(along):
        order = numpy.argsort(place)
        y_factor, y_unit = plot_style.readable(numpy.abs(points[:, 1]).max(), "m")
        low, high = y_factor * points[:, 1].min(), y_factor * points[:, 1].max()
        wall = f"y = {low:.4g} {y_unit}" if high - low < 1e-3 * abs(high) else f"y = {low:.4g} to {high:.4g} {y_unit}"
        axes.plot(place_factor * place[order], factor * values[order], label=wall, **plot_style.of_run(i))
        header += [f"{wall}: {name} [m]", f"{wall}: {label} [{unit}]"]
        columns += [place[order], values[order]]
    axes.set_ylim(0, None)  # magnitudes and shares
    axes.set_title(of, fontsize=8.5, loc="left", pad=22 if len(along) > 1 else 6)
    axes.set_xlabel(plot_style.axis_label(name, place_unit) if name != "x" else f"x [{place_unit}]")
    axes.set_ylabel(plot_style.axis_label(label, axis_unit))
    sheet.legend(axes, len(along))
    picture = f"wall-{plot_style.file_name(field)}{suffix}"
    sheet.save(figure, picture)
    sheet.save_data(picture, header, columns)
    return True
