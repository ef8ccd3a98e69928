"""What the view of a body in the browser (report/view.js) is given: the surface and slices of a run's states, their fields and
displacements, as packed numbers. Reads the states with VTK's filters alone, which need no display."""

import base64
import os
import zlib

import numpy
import plot_choice
import plot_field
import plot_style

MOST_STATES = 40
MOST_POINTS = 40000  # of a part; more are thinned
SLICES_ACROSS = 5
MOST_LINES = 2500  # of the mesh that are drawn without being asked for
ABSENT = 4095  # in place of a value of 12 bits
COSTLY_TO_FOLLOW = 4e6  # points times states above which the liquid's mesh does not follow the solids
# Fields at the nodes of walls, 0 elsewhere; in the order of what a reader looks for.
OF_WALLS = ("wall_shear_stress", "time_averaged_wall_shear_stress", "oscillatory_shear_index")
FIRST = ("pressure", "velocity", *OF_WALLS, "displacement")
NOT_SHOWN = ("phase", "rank", "material_id", "TIME", "CYCLE", "motion of the view", "number of the point")


def pack(data):
    return base64.b64encode(zlib.compress(data, 9)).decode("ascii")


def in_planes(numbers):
    """Numbers of two bytes as all high bytes, then all low bytes, which packs better."""
    pairs = numpy.ascontiguousarray(numbers, dtype=">u2" if numbers.dtype.kind == "u" else ">i2").view(numpy.uint8).reshape(-1, 2)
    return pairs[:, 0].tobytes() + pairs[:, 1].tobytes()


def chosen_states(entries, most):
    """Evenly among the entries of fields.pvd, with the first and the last."""
    if len(entries) <= most:
        return entries
    return [entries[i] for i in numpy.unique(numpy.linspace(0, len(entries) - 1, most).round().astype(int))]


class Part:
    """A surface or a slice: for each state points, groups, triangles, edges and arrays, with points of one place and region made one."""

    def __init__(self, name):
        self.name = name
        self.meshes, self.mesh_of_state, self.arrays = [], [], []
        self.size = 0.0
        self.known = None

    def add(self, polydata, names):
        import render_field
        from vtk.util.numpy_support import vtk_to_numpy

        if polydata.GetNumberOfPoints() == 0:
            self.mesh_of_state.append(-1)
            self.arrays.append({})
            return
        points = vtk_to_numpy(polydata.GetPoints().GetData()).astype(float)
        data = polydata.GetPointData()
        if self.known is None or len(points) != len(self.known[0]) or not numpy.array_equal(points, self.known[0]):
            self.meshes.append(self.make_mesh(points, polydata, render_field))
            self.known = points, self.meshes[-1]
        mesh = self.known[1]
        self.mesh_of_state.append(len(self.meshes) - 1)
        found = {}
        for name in names:
            array = data.GetArray(name)
            if array is not None:
                values = vtk_to_numpy(array).astype(float)
                found[name] = mesh["mean"](values if values.ndim == 2 else values[:, None])
        self.arrays.append(found)

    def make_mesh(self, points, polydata, render_field):
        """Points of one place and region become one, and their values the mean of those of the cells that meet."""
        from vtk.util.numpy_support import vtk_to_numpy

        data = polydata.GetPointData()
        region = data.GetArray("material_id")
        region = numpy.zeros(len(points)) if region is None else numpy.round(vtk_to_numpy(region))
        solid = render_field.in_solid(polydata)
        extent = max(numpy.ptp(points, axis=0).max(), 1e-300)
        keys = numpy.column_stack([numpy.round(points / (1e-6 * extent)), region]).astype(numpy.int64)
        _, first, inverse = numpy.unique(keys, axis=0, return_index=True, return_inverse=True)
        inverse = inverse.ravel()
        counts = numpy.bincount(inverse)

        def mean(values):
            return numpy.column_stack([numpy.bincount(inverse, numpy.nan_to_num(column), len(counts)) / counts for column in values.T])

        lines, triangles = polygons(polydata)
        triangles = inverse[triangles]
        triangles = triangles[(triangles[:, 0] != triangles[:, 1]) & (triangles[:, 1] != triangles[:, 2]) & (triangles[:, 0] != triangles[:, 2])]
        edges = numpy.unique(numpy.sort(inverse[lines], axis=1), axis=0)
        edges = edges[edges[:, 0] != edges[:, 1]]
        return {"points": points[first], "groups": numpy.zeros(len(first), numpy.uint8) if solid is None else solid[first].astype(numpy.uint8),
                "triangles": triangles, "edges": edges, "mean": mean}


def polygons(polydata):
    """(edges of the polygons, their triangles) as numbers of points."""
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    polys = polydata.GetPolys()
    offsets, corners = vtk_to_numpy(polys.GetOffsetsArray()), vtk_to_numpy(polys.GetConnectivityArray())
    ends = corners.copy()
    ends[:-1] = corners[1:]
    ends[offsets[1:] - 1] = corners[offsets[:-1]]
    triangulate = vtk.vtkTriangleFilter()
    triangulate.SetInputData(polydata)
    triangulate.PassLinesOff()
    triangulate.PassVertsOff()
    triangulate.Update()
    triangles = vtk_to_numpy(triangulate.GetOutput().GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return numpy.column_stack([corners, ends]), triangles


def outside(grid):
    import vtk
    faces = vtk.vtkDataSetSurfaceFilter()
    faces.SetInputData(grid)
    faces.SetNonlinearSubdivisionLevel(1)
    faces.Update()
    return faces.GetOutput()


def cut(grid, normal, distance):
    import vtk
    plane = vtk.vtkPlane()
    plane.SetNormal(*normal)
    plane.SetOrigin(*(distance * numpy.asarray(normal)))
    cutter = vtk.vtkCutter()
    cutter.SetInputData(grid)
    cutter.SetCutFunction(plane)
    cutter.GenerateTrianglesOff()
    cutter.Update()
    return cutter.GetOutput()


def slices_of(bounds):
    """Planes through the middle, and across the longest direction."""
    low, high = numpy.array(bounds[::2]), numpy.array(bounds[1::2])
    found = []
    for d in (2, 1, 0):
        # A body that ends at a plane of symmetry has its middle there.
        at = low[d] if abs(low[d]) < 1e-3 * (high[d] - low[d]) else 0.5 * (low[d] + high[d])
        found.append((f"along {'xyz'[d]} = {at:.4g} m", d, at + 1e-4 * (high[d] - low[d])))
    longest = int(numpy.argmax(high - low))
    for i in range(SLICES_ACROSS):
        at = low[longest] + (i + 0.5) / SLICES_ACROSS * (high[longest] - low[longest])
        name = f"across {'xyz'[longest]} = {at:.4g} m"
        if all(abs(at - other) > 0.01 * (high[d] - low[d]) or d != longest for _, d, other in found):
            found.append((name, longest, at))
    return [{"name": name, "normal": numpy.eye(3)[d].tolist(), "distance": float(at)} for name, d, at in found]


def field_names(grid):
    """What the view can show, in the order of what a reader looks for."""
    data = grid.GetPointData()
    names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays()) if data.GetArrayName(i) not in NOT_SHOWN]
    return [name for name in FIRST if name in names] + sorted(name for name in names if name not in FIRST)


def read_states(run, states, follows):
    """(dimension, slices, parts, names of fields) with all arrays of the states."""
    import render_field
    from vtk.util.numpy_support import numpy_to_vtk
    from vtk_part import part_of

    parts, slices, dim, names = None, [], 2, []
    moves = run["summary"].get("deformation") == "finite"
    largest = numpy.zeros(3)
    factors = []
    bounds = None
    for _, pieces in states:
        plot_field.check_pieces(pieces)
        grid = render_field.read(pieces)
        motion = render_field.displacement_of(grid, moves)
        if motion is not None:
            points, displacement, solid = motion
            factors.append(render_field.factor_of([grid]))
            if solid is not None and not solid.all():
                if follows:
                    number = numpy_to_vtk(numpy.arange(len(points), dtype=float), deep=True)
                    number.SetName("number of the point")
                    grid.GetPointData().AddArray(number)
                    displacement = render_field.follow(grid, points, displacement, solid)
                else:
                    displacement = numpy.where(solid[:, None], displacement, 0.0)
            largest = numpy.maximum(largest, numpy.abs(displacement).max(axis=0))
            array = numpy_to_vtk(displacement, deep=True)
            array.SetName("motion of the view")
            grid.GetPointData().AddArray(array)
        if parts is None:
            bounds = grid.GetBounds()
            dim = 2 if bounds[5] - bounds[4] < 1e-9 * max(bounds[1] - bounds[0], bounds[3] - bounds[2]) else 3
            slices = slices_of(bounds) if dim == 3 else []
            parts = [Part("surface")] + [Part(one["name"]) for one in slices]
            names = field_names(grid)
            # What a wall hides, and what is known at the wall of the lumen alone.
            solid = render_field.in_solid(grid)
            if dim == 3 and solid is not None and solid.any() and not solid.all():
                parts.append(Part("liquids"))
        wanted = [*names, "motion of the view"]
        parts[0].add(outside(grid), wanted)
        for one, part in zip(slices, parts[1:]):
            part.add(cut(grid, one["normal"], one["distance"]), wanted)
        if len(parts) > 1 + len(slices):
            parts[-1].add(outside(part_of(grid)), wanted)
    factor = 1 if moves else min((value for value in factors if value > 0), default=0)
    return {"dim": dim, "slices": slices, "parts": parts, "names": names, "largest": largest, "factor": factor, "bounds": bounds}


def scalar(values):
    return values[:, 0] if values.shape[1] == 1 else numpy.linalg.norm(values, axis=1)


def groups_of(name, parts):
    """The ranges of colours over all states, as scripts/plot draws them: liquids and solids apart, except for what is continuous."""
    import render_field
    found = []
    for part in parts:
        for mesh, arrays in zip(part.mesh_of_state, part.arrays):
            if mesh >= 0 and name in arrays:
                values = scalar(arrays[name])
                solid = part.meshes[mesh]["groups"].astype(bool)
                if name in OF_WALLS:
                    values = numpy.where(values == 0, numpy.nan, values)
                if numpy.isfinite(values).any():
                    found.append(render_field.extremes(values, None if name in OF_WALLS else solid, name))
    if not found:
        return []
    every = {what: None for extremes in found for what in extremes}
    found = [{what: extremes.get(what) for what in every} for extremes in found]
    if len(every) > 1:  # a part of the body may have liquid or solid alone
        found = [{"liquid": extremes.get("liquid"), "solid": extremes.get("solid")} for extremes in found]
    return [{"what": what, "map": colours, "low": low, "high": high} for what, colours, low, high in render_field.ranges_of(found)]


def encode(values, groups, which):
    """12 bits of the group's range."""
    share = numpy.full(len(values), numpy.nan)
    for i, group in enumerate(groups):
        mine = which == i if len(groups) > 1 else numpy.ones(len(values), bool)
        span = group["high"] - group["low"]
        share[mine] = (values[mine] - group["low"]) / (span if span > 0 else 1.0)
    numbers = numpy.where(numpy.isfinite(share), numpy.round(4094 * numpy.clip(share, 0, 1)), ABSENT).astype(numpy.uint16)
    return pack(in_planes(numbers))


def thinned(mesh, most):
    """A mesh too fine for a page, with fewer of its own points: {points, groups, triangles, edges, kept: their numbers}."""
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

    n = len(mesh["points"])
    if n <= most:
        return {**mesh, "kept": numpy.arange(n)}
    polydata, points = vtk.vtkPolyData(), vtk.vtkPoints()
    points.SetData(numpy_to_vtk(mesh["points"], deep=True))
    polydata.SetPoints(points)
    cells = vtk.vtkCellArray()
    triangles = mesh["triangles"]
    cells.SetCells(len(triangles), numpy_to_vtkIdTypeArray(numpy.column_stack([numpy.full(len(triangles), 3), triangles]).ravel().astype(numpy.int64),
                                                           deep=True))
    polydata.SetPolys(cells)
    number = numpy_to_vtk(numpy.arange(n, dtype=float), deep=True)
    number.SetName("number")
    polydata.GetPointData().AddArray(number)
    fewer = vtk.vtkDecimatePro()  # which keeps points of its input
    fewer.SetInputData(polydata)
    fewer.SetTargetReduction(1 - most / n)
    fewer.PreserveTopologyOff()
    fewer.Update()
    result = fewer.GetOutput()
    kept = numpy.round(vtk_to_numpy(result.GetPointData().GetArray("number"))).astype(int)
    corners = vtk_to_numpy(result.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return {"points": mesh["points"][kept], "groups": mesh["groups"][kept], "triangles": corners,
            "edges": numpy.zeros((0, 2), int), "kept": kept}


class View:
    """One run's view with some number of states and fields, and its size in the page."""

    def __init__(self, run, read, states, caption):
        self.run, self.read, self.states, self.caption = run, read, states, caption
        self.low = numpy.array(read["bounds"][::2])
        self.extent = numpy.maximum(numpy.array(read["bounds"][1::2]) - self.low, 1e-300)

    def packed_mesh(self, mesh):
        places = numpy.round(65535 * numpy.clip((mesh["points"] - self.low) / self.extent, 0, 1)).astype(numpy.uint16)
        return {"n": len(mesh["points"]), "points": pack(in_planes(places.ravel())), "groups": pack(mesh["groups"].tobytes()),
                "triangles": pack(mesh["triangles"].astype("<u4").tobytes()), "edges": pack(mesh["edges"].astype("<u4").tobytes())}

    def packed_motion(self, part, meshes):
        scale = numpy.where(self.read["largest"] > 0, self.read["largest"], 1.0)
        found = []
        for mesh, arrays in zip(part.mesh_of_state, part.arrays):
            if mesh < 0 or "motion of the view" not in arrays:
                found.append(pack(b""))
                continue
            numbers = numpy.round(32767 * arrays["motion of the view"][meshes[mesh]["kept"]] / scale).astype(numpy.int16)
            found.append(pack(in_planes(numbers.ravel())))
        return found

    def packed_field(self, name, meshes_of_parts):
        parts = self.read["parts"]
        groups = groups_of(name, parts)
        if not groups:
            return None
        values = []
        for part, meshes in zip(parts, meshes_of_parts):
            of_part = []
            for mesh, arrays in zip(part.mesh_of_state, part.arrays):
                if mesh < 0 or name not in arrays:
                    of_part.append(pack(b""))
                    continue
                kept = meshes[mesh]["kept"]
                numbers = scalar(arrays[name][kept])
                if name in OF_WALLS:
                    numbers = numpy.where(numbers == 0, numpy.nan, numbers)
                of_part.append(encode(numbers, groups, meshes[mesh]["groups"]))
            values.append(of_part)
        unit = plot_field.unit_of(self.run["summary"], name)
        largest = max(max(abs(group["low"]), abs(group["high"])) for group in groups)
        factor, shown = plot_style.readable(largest, unit, name)
        is_vector = any(name in arrays and arrays[name].shape[1] > 1 for part in parts for arrays in part.arrays)
        label = name.replace("_", " ") + (" magnitude" if is_vector else "")
        return {"name": name, "label": label, "unit": "" if shown == "1" else shown, "factor": factor, "groups": groups, "values": values,
                "ofWalls": name in OF_WALLS}

    def data(self, budget, wanted):
        """(what the browser is given, names of fields that have no room)."""
        read = self.read
        meshes = [[thinned(mesh, MOST_POINTS) for mesh in part.meshes] for part in read["parts"]]
        moving = read["largest"].max() > 0
        place_factor, place_unit = plot_style.readable(self.extent.max(), "m")
        ratio = self.extent[0] / self.extent[1]
        import render_field
        stretch = render_field.nice(ratio / plot_field.FLATTEST) if read["dim"] == 2 and ratio > 1.99 * plot_field.FLATTEST else 1
        view = {"dim": read["dim"], "low": self.low.tolist(), "extent": self.extent.tolist(), "stretch": stretch,
                "factor": read["factor"] if moving else 0, "motionScale": read["largest"].tolist() if moving else None,
                "placeFactor": place_factor, "placeUnit": place_unit, "times": [self.caption(at) for at, _ in self.states],
                "modal": self.run["summary"].get("analysis") == "modal", "slices": read["slices"],
                "lines": sum(len(mesh["edges"]) for mesh in meshes[0]) / max(len(meshes[0]), 1) < MOST_LINES,
                "turn": turn_of(), "fields": [],
                "parts": [{"meshes": [self.packed_mesh(mesh) for mesh in of_part], "meshOfState": part.mesh_of_state,
                           "motion": self.packed_motion(part, of_part) if moving else None} for part, of_part in zip(read["parts"], meshes)]}
        solid = numpy.concatenate([mesh["groups"] for mesh in read["parts"][0].meshes])
        full = bool(solid.any()) and any(0 in mesh["groups"] for part in read["parts"][1:] for mesh in part.meshes)
        open_at_plane = abs(read["bounds"][4]) < 1e-3 * (read["bounds"][5] - read["bounds"][4])
        view["firstSlice"] = 0 if read["dim"] == 3 and full and not open_at_plane else -1
        view["liquidPart"] = len(read["parts"]) - 1 if len(read["parts"]) > 1 + len(read["slices"]) else None
        if open_at_plane:
            view["turn"] = turn_of(-1.0)
        used, left_out = size_of(view), []
        for name in read["names"]:
            if wanted is not None and name not in wanted:
                continue
            field = self.packed_field(name, meshes)
            if field is None:
                continue
            if view["fields"] and used + size_of(field) > budget:
                left_out.append(name)
                continue
            used += size_of(field)
            view["fields"].append(field)
        return view, left_out, used


def turn_of(side=1.0):
    """The first direction of view, as the pictures have it, as columns of a matrix."""
    direction = numpy.array([0.35, 0.4, side])
    direction /= numpy.linalg.norm(direction)
    across = numpy.cross([0, 1, 0], direction)
    across /= numpy.linalg.norm(across)
    return numpy.array([across, numpy.cross(direction, across), direction]).T.ravel().tolist()


def size_of(data):
    """Characters of the page that texts and numbers take."""
    if isinstance(data, str):
        return len(data) + 3
    if isinstance(data, dict):
        return sum(size_of(key) + size_of(value) for key, value in data.items())
    if isinstance(data, (list, tuple)):
        return sum(map(size_of, data)) + len(data)
    return 12


def caption_of(run):
    """What a state is called: its time, or the mode."""
    modes = run["summary"].get("modes", [])
    if run["summary"].get("analysis") == "modal" and modes:
        return lambda number: modes[round(number) - 1].partition(";")[0] if 1 <= round(number) <= len(modes) else f"mode {number:g}"
    return lambda at: plot_field.caption(run, at, None)


def make(run, budget, wanted=None):
    """(view or None, notes) of a run whose data take at most `budget` characters, as far as one field with one state does."""
    path = os.path.join(run["folder"], "fields.pvd")
    if not os.path.exists(path):
        return None, []
    entries = plot_choice.entries_of(path)
    if not entries:
        return None, []
    try:
        import vtk  # noqa: F401 # pylint: disable=unused-import
    except ImportError:
        return None, [f"the view of {run['title']} (python3-vtk9 is not installed)"]
    notes, most = [], MOST_STATES
    # One state tells how many there is room for.
    size = sum(os.path.getsize(piece) for piece in entries[-1][1] if os.path.exists(piece))
    for _ in range(4):
        states = chosen_states(entries, most)
        points = max(1, size) / 40  # a point takes about this many bytes of a state
        follows = points * len(states) < COSTLY_TO_FOLLOW
        read = read_states(run, states, follows)
        view, left_out, used = View(run, read, states, caption_of(run)).data(budget, wanted)
        needed = [name for name in left_out if name in FIRST]
        if (used <= budget and not needed) or len(states) == 1:
            break
        most = max(1, min(len(states) // 2, int(0.9 * len(states) * budget / max(used, 1))))
    if len(states) < len(entries):
        notes.append(f"the view of {run['title']} shows {len(states)} of its {len(entries)} states")
    if left_out:
        notes.append(f"the view of {run['title']} has no room for {', '.join(left_out)} (--fields NAME,... chooses)")
    if not follows and read["largest"].max() > 0:
        notes.append(f"in the view of {run['title']} the liquid's mesh does not follow the solids (there are many points)")
    return (view, notes) if view["fields"] else (None, notes)
