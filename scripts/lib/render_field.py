#!/usr/bin/python3
"""Draws states of a run with VTK, all with the same colours, factor of the displacement and section. Reads a request (json) from
stdin, writes picture-0.png, picture-1.png, ... (or picture-0.npz, ... for a plane mesh without OpenGL) and picture.json into the
request's folder. Exit status 3: the data or the request are at fault; 4: the field has no value yet.
"""

import json
import math
import os
import sys

import matplotlib
import numpy
import vtk
from PIL import Image
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import render_streamlines  # noqa: E402
from vtk_part import part_of  # noqa: E402


NOTHING_TO_SEE = 4
CUT = "cells are cut"  # of a grid some of whose cells are pieces of those of the mesh


def fault(text, status=3):
    print(text, file=sys.stderr)
    sys.exit(status)


def read(pieces):
    """All pieces as one unstructured grid."""
    append = vtk.vtkAppendFilter()
    for piece in pieces:
        kind = vtk.vtkXMLPUnstructuredGridReader if piece.endswith(".pvtu") else vtk.vtkXMLUnstructuredGridReader
        reader = kind()
        reader.SetFileName(piece)
        reader.Update()
        append.AddInputData(reader.GetOutput())
    append.Update()
    grid = vtk.vtkUnstructuredGrid()
    grid.ShallowCopy(append.GetOutput())
    if grid.GetNumberOfPoints() == 0:
        fault(f"{pieces[0]} has no points")
    return grid


def values_of(grid, field):
    """(name, label, one number a point) of a field; a vector gives its magnitude."""
    data = grid.GetPointData()
    names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
    if field is None:
        # A solid at rest has no velocity to show.
        usual = [name for name in ("velocity", "displacement", "pressure") if name in names]
        field = next((name for name in usual if vtk_to_numpy(data.GetArray(name)).any()), (usual or names or [None])[0])
    if field not in names:
        fault(f"there is no field {field}; there are {', '.join(names) or 'none'}")
    values = vtk_to_numpy(data.GetArray(field)).astype(float)
    label = f"{field} magnitude" if values.ndim == 2 else field
    if values.ndim == 2:
        values = numpy.linalg.norm(values, axis=1)
    # There are no values but at the nodes of walls: the files have 0 elsewhere.
    return field, label, numpy.where(values == 0, numpy.nan, values) if field in OF_WALLS else values


def nice(number):
    """The largest of 1, 2, 5, 10, ... that is not above the number."""
    power = 10.0**math.floor(math.log10(number))
    return max(step * power for step in (1, 2, 5) if step * power <= number * (1 + 1e-9))


def in_solid(grid):
    """Of each point whether its cell is of a solid; None where the data do not say. Cells of different regions share no
    points in the files of Continua."""
    phase = grid.GetPointData().GetArray("phase")
    return None if phase is None else vtk_to_numpy(phase) > 0.5


def as_one(points):
    """(number of the place of each point, number of places): points of several cells at one place have one number."""
    size = (points.max(axis=0) - points.min(axis=0)).max()
    places, numbers = numpy.unique(numpy.round(points / (1e-9 * size)).astype(numpy.int64), axis=0, return_inverse=True)
    return numbers.ravel(), len(places)


def follow(grid, points, displacement, solid):
    """The liquid's mesh between what moves it: harmonic, equal to the solids' displacement where both meet. On the other ends
    that are plane it slides along them, elsewhere it stays. (Its own displacement is the way of its particles.)"""
    numbers, n_places = as_one(points)
    liquid = part_of(grid)
    own = vtk_to_numpy(liquid.GetPointData().GetArray("number of the point")).astype(int)
    # Along the edges of the cells, by the inverse of their length.
    edges = vtk.vtkExtractEdges()
    edges.SetInputData(liquid)
    edges.Update()
    ends = numbers[vtk_to_numpy(edges.GetOutput().GetPointData().GetArray("number of the point")).astype(int)[
        vtk_to_numpy(edges.GetOutput().GetLines().GetConnectivityArray()).reshape(-1, 2)]]
    ends = numpy.unique(numpy.sort(ends, axis=1), axis=0)
    ends = ends[ends[:, 0] != ends[:, 1]]
    place = numpy.zeros((n_places, 3))
    place[numbers] = points
    weight = 1 / numpy.linalg.norm(place[ends[:, 0]] - place[ends[:, 1]], axis=1)
    is_liquid = numpy.zeros(n_places, bool)
    is_liquid[numbers[own]] = True
    moved = numpy.zeros((n_places, 3))
    is_held = numpy.zeros((n_places, 3), bool)
    low, high = place[is_liquid].min(axis=0), place[is_liquid].max(axis=0)
    tolerance = 1e-6 * (high - low).max()
    for d in range(3):
        is_held[:, d] |= is_liquid & ((place[:, d] < low[d] + tolerance) | (place[:, d] > high[d] - tolerance))
    common = numpy.zeros(n_places, bool)
    common[numbers[solid]] = True
    common &= is_liquid
    is_held[common] = True
    moved[numbers[solid]] = displacement[solid]
    moved[is_liquid & ~common] = 0
    for d in range(3):
        solve_harmonic(moved[:, d], ends, weight, is_liquid & ~is_held[:, d])
    result = displacement.copy()
    result[~solid] = moved[numbers[~solid]]
    return result


def solve_harmonic(values, ends, weight, free):
    """Sets the free values to the weighted means of their neighbours: conjugate gradients."""
    diagonal = numpy.zeros(len(values))
    for side in (0, 1):
        numpy.add.at(diagonal, ends[:, side], weight)
    free = free & (diagonal > 0)

    def residual(x):
        difference = weight * (x[ends[:, 0]] - x[ends[:, 1]])
        result = numpy.bincount(ends[:, 1], difference, len(x)) - numpy.bincount(ends[:, 0], difference, len(x))
        return numpy.where(free, result, 0)

    rest = residual(values)
    start = math.sqrt(rest @ rest)
    if start == 0:
        return
    scale = numpy.where(free, 1 / numpy.where(diagonal > 0, diagonal, 1), 0)
    preconditioned = scale * rest
    direction, product = preconditioned, rest @ preconditioned
    for _ in range(2000):
        image = -residual(direction)
        step = product / (direction @ image)
        values += step * direction
        rest = rest - step * image
        if math.sqrt(rest @ rest) < 1e-6 * start:
            return
        preconditioned = scale * rest
        before, product = product, rest @ preconditioned
        direction = preconditioned + product / before * direction


def displacement_of(grid, mesh_moves=False):
    """(points, their displacement, whether each is of a solid or None); of a body without a displacement or a solid None. That of
    liquids is the way of their particles; in finite deformation their mesh moves by it, and it counts as that of solids."""
    array = grid.GetPointData().GetArray("displacement")
    solid = None if mesh_moves else in_solid(grid)
    if array is None or array.GetNumberOfComponents() != 3 or solid is not None and not solid.any():
        return None
    return (vtk_to_numpy(grid.GetPoints().GetData()).astype(float), numpy.nan_to_num(vtk_to_numpy(array).astype(float)), solid)


def factor_of(grids):
    """The factor that makes the displacement of the solids visible in all of these states, 1 for large ones, 0 without any."""
    size, largest = numpy.zeros(3), numpy.zeros(3)
    for grid in grids:
        found = displacement_of(grid)
        if found is None:
            continue
        points, displacement, solid = found
        size = numpy.maximum(size, points.max(axis=0) - points.min(axis=0))
        largest = numpy.maximum(largest, numpy.abs(displacement if solid is None else displacement[solid]).max(axis=0))
    if not largest.max() > 0:
        return 0
    # A tenth of the length shows; but a thin body must not fold over itself, hence not more than its width along it. What is a
    # thousandth of the motion does not count.
    factor = nice(min(min(0.1 * size.max(), 0.4 * size[d]) / largest[d] for d in range(3)
                      if largest[d] > 1e-3 * largest.max() and size[d] > 1e-9 * size.max()))
    return 1 if 0.5 <= factor <= 2 else factor


def deform(grid, factor=None, liquid_follows=True, mesh_moves=False):
    """Moves the points by the displacement of the solids times the factor, or times one that makes it visible; the liquid's
    mesh follows them, or stays, or has a motion of its own. Returns the factor, 0 without a displacement."""
    factor = factor_of([grid]) if factor is None else factor
    found = displacement_of(grid, mesh_moves)
    if found is None or factor == 0:
        return factor
    points, displacement, solid = found
    if solid is not None and not liquid_follows:
        displacement[~solid] = 0
    elif solid is not None and not solid.all():
        number = numpy_to_vtk(numpy.arange(len(points), dtype=float), deep=True)
        number.SetName("number of the point")
        grid.GetPointData().AddArray(number)
        displacement = follow(grid, points, displacement, solid)
    moved = vtk.vtkPoints()
    moved.SetData(numpy_to_vtk(points + factor * displacement, deep=True))
    grid.SetPoints(moved)
    return factor


def only(grid, regions):
    """The cells of these regions (material_id); all of them for None. Cells of different regions share no points."""
    if regions is None:
        return grid
    array = grid.GetPointData().GetArray("material_id")
    if array is None:
        fault("the states have no field material_id, which --region needs")
    shown = numpy.isin(numpy.round(vtk_to_numpy(array)).astype(int), regions)
    if not shown.any():
        fault(f"the states have no cell of the region with the material_id {', '.join(map(str, regions))}")
    mark = numpy_to_vtk(shown.astype(float), deep=True)
    mark.SetName("is shown")
    grid.GetPointData().AddArray(mark)
    return part_of(grid, "is shown", above=True)


def mesh_lines(grid):
    """The edges of the cells; those of curved cells as several pieces."""
    edges = vtk.vtkExtractEdges()
    edges.SetInputData(grid)
    edges.Update()
    return edges.GetOutput()


def outline_of(grid):
    """The ends of a plane body, and where liquid and solid meet: where colours are near white nothing else shows them."""
    both = vtk.vtkAppendPolyData()
    for is_solid in (False, True):
        part = grid
        if grid.GetPointData().GetArray("phase") is not None:
            part = part_of(grid, above=is_solid)
        if not part.GetNumberOfCells():
            continue
        edges = vtk.vtkFeatureEdges()
        edges.SetInputData(outside(render_streamlines.with_shared_points(part)))
        edges.BoundaryEdgesOn()
        edges.FeatureEdgesOff()
        edges.NonManifoldEdgesOff()
        edges.ManifoldEdgesOff()
        edges.ColoringOff()
        edges.Update()
        both.AddInputData(edges.GetOutput())
    both.Update()
    return both.GetOutput()


def whole_cells(grid):
    """Of a body that was cut: the cells with six faces, which are those of the mesh. The pieces of the others have fewer."""
    if grid.GetFieldData().GetArray(CUT) is None:
        return grid
    whole = numpy.flatnonzero(vtk_to_numpy(grid.GetCellTypesArray()) == vtk.VTK_HEXAHEDRON)
    if not whole.size:
        return grid
    ids = vtk.vtkIdList()
    for number in whole:
        ids.InsertNextId(int(number))
    extract = vtk.vtkExtractCells()
    extract.SetInputData(grid)
    extract.SetCellList(ids)
    extract.Update()
    return extract.GetOutput()


def outside(grid):
    """The faces of the surface, as the cells have them."""
    faces = vtk.vtkDataSetSurfaceFilter()
    faces.SetInputData(grid)
    faces.SetNonlinearSubdivisionLevel(2)
    faces.Update()
    return faces.GetOutput()


def surface(grid):
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputData(outside(grid))
    triangles.Update()
    return triangles.GetOutput()


def stretched(data, stretch):
    transform = vtk.vtkTransform()
    transform.Scale(1, stretch, 1)
    scale = vtk.vtkTransformPolyDataFilter()
    scale.SetTransform(transform)
    scale.SetInputData(data)
    scale.Update()
    return scale.GetOutput()


MOST_LINES = 30000  # of the mesh of a body in space: more make the picture dark
# Fields that are the same on both sides of an interface; of others liquids and solids have a range each.
COMMON = ("velocity", "displacement")
# Fields at the nodes of walls.
OF_WALLS = ("wall_shear_stress", "time_averaged_wall_shear_stress", "oscillatory_shear_index")
NOT_THERE = (0.85, 0.85, 0.85)
LONG = 1.5  # times as long along x as high, from which a body lies from left to right
FINEST_MESH = 7.0  # pixels of the middle edge of a cell, below which the mesh's lines would cover the colours
MAPS = {"liquid": ("viridis", "RdBu_r"), "solid": ("copper", "PuOr_r")}  # of one sign, of both


def extremes(values, solid, field):
    """{what: (low, high)} of the liquids and the solids, or of both together."""
    groups = {"": numpy.isfinite(values)}
    if solid is not None and solid.any() and not solid.all() and field not in COMMON + OF_WALLS:
        groups = {name: numpy.isfinite(values) & (solid == (name == "solid")) for name in ("liquid", "solid")}
    return {what: (float(values[chosen].min()), float(values[chosen].max())) if chosen.any() else None
            for what, chosen in groups.items()}


def colour_ranges(values, solid, field):
    return ranges_of([extremes(values, solid, field)])


def ranges_of(found):
    """[(what, map, low, high)] of the extremes of all states; a field of both signs has white at zero."""
    ranges = []
    for what in found[0]:
        there = [state[what] for state in found if state.get(what) is not None] or [(0.0, 0.0)]
        low, high = min(low for low, _ in there), max(high for _, high in there)
        largest = max(abs(low), abs(high))
        signed = low < -0.05 * largest and high > 0.05 * largest
        ranges.append((what, MAPS[what or "liquid"][signed], -largest if signed else low, largest if signed else high))
    return ranges


def on_the_maps(values, solid, ranges):
    """The values as places on the maps, put one after the other: 0 to 1 of one, 0 to 2 of two."""
    shown = numpy.zeros(len(values))
    for i, (what, _, low, high) in enumerate(ranges):
        chosen = numpy.ones(len(values), bool) if not what else solid == (what == "solid")
        share = (values[chosen] - low) / (high - low if high > low else 1)
        shown[chosen] = i + numpy.clip(share, 1e-6, 1 - 1e-6)
    return shown


def colour_table(ranges):
    colours = numpy.concatenate([matplotlib.colormaps[name](numpy.linspace(0, 1, 256)) for _, name, _, _ in ranges])
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(len(colours))
    for i, colour in enumerate(colours):
        table.SetTableValue(i, *colour)
    table.SetRange(0, len(ranges))
    table.SetNanColor(*NOT_THERE, 1.0)
    return table


def wall_of(grid):
    """(the liquids, whose surface has the values at walls; the side from which the wall is seen that is not a plane of symmetry)."""
    solid = in_solid(grid)
    if solid is not None and not solid.all():
        grid = part_of(grid)
    low, high = grid.GetBounds()[4:]
    return grid, numpy.array([0.35, 0.4, -1.0 if abs(high) < 1e-3 * (high - low) else 1.0])


def cut_plane(grid, section):
    """The section of a body in space by the plane `axis` = `at` [m], turned into the plane of its two other axes."""
    axis, at = section["axis"], section["at"]
    plane = vtk.vtkPlane()
    plane.SetNormal(*numpy.eye(3)[axis])
    plane.SetOrigin(*(at * numpy.eye(3)[axis]))
    cutter = vtk.vtkCutter()
    cutter.SetInputData(grid)
    cutter.SetCutFunction(plane)
    cutter.GenerateTrianglesOff()
    append = vtk.vtkAppendFilter()
    append.AddInputConnection(cutter.GetOutputPort())
    append.Update()
    result = vtk.vtkUnstructuredGrid()
    result.ShallowCopy(append.GetOutput())
    if result.GetNumberOfPoints() == 0:
        low, high = grid.GetBounds()[2 * axis:2 * axis + 2]
        fault(f"the section {'xyz'[axis]} = {at:g} m does not meet the body, which goes from {low:g} m to {high:g} m")
    others = [d for d in range(3) if d != axis]
    points = vtk_to_numpy(result.GetPoints().GetData()).astype(float)
    moved = vtk.vtkPoints()
    moved.SetData(numpy_to_vtk(numpy.column_stack([points[:, others], numpy.zeros(len(points))]), deep=True))
    result.SetPoints(moved)
    return result


def open_up(grid):
    """(the part of a body that shows its inside, where the reader looks from): the half behind the middle of a whole body with a
    liquid in it; the whole of a body that ends at the plane z = 0, which is seen through it."""
    bounds = grid.GetBounds()
    solid = in_solid(grid)
    from_front, from_behind = numpy.array([0.35, 0.4, 1.0]), numpy.array([0.35, 0.4, -1.0])
    # The plane of symmetry is there up to the round-off of single precision, times the factor of the displacement.
    if solid is not None and solid.all():  # there is nothing to see inside
        return grid, from_front
    if abs(bounds[4]) < 1e-3 * (bounds[5] - bounds[4]):
        return grid, from_behind
    if solid is None or not solid.any():
        return grid, from_front
    plane = vtk.vtkPlane()
    plane.SetOrigin(*((bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)))
    plane.SetNormal(0, 0, 1)
    clip = vtk.vtkTableBasedClipDataSet()  # leaves the cells whole that it does not cut
    clip.SetInputData(grid)
    clip.SetClipFunction(plane)
    clip.InsideOutOn()
    clip.Update()
    half = vtk.vtkUnstructuredGrid()
    half.ShallowCopy(clip.GetOutput())
    mark = vtk.vtkIntArray()
    mark.SetName(CUT)
    half.GetFieldData().AddArray(mark)
    return half, from_front


def camera_of(renderer, bounds, direction):
    """Looks at the body along a direction. Returns (left, right, bottom, top) seen and where x, y and z point to in the picture."""
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    centre = numpy.array([(bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)])
    direction = direction / numpy.linalg.norm(direction)
    across = numpy.cross([0, 1, 0], direction)
    across /= numpy.linalg.norm(across)
    up = numpy.cross(direction, across)
    if across[0] < 0 and bounds[1] - bounds[0] > LONG * (bounds[3] - bounds[2]):
        # Of a long body x goes to the right, as it is read, also where it is seen from behind.
        across, up = -across, -up
    corners = numpy.array([[bounds[i], bounds[2 + j], bounds[4 + k]]
                           for i in (0, 1) for j in (0, 1) for k in (0, 1)]) - centre
    size = numpy.abs(corners).max()
    half_width, half_height = 1.01 * (corners @ across).max(), 1.01 * (corners @ up).max()
    margin = 0.01 * max(half_width, half_height)
    half_width, half_height = half_width + margin, half_height + margin
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(centre + 10 * size * direction))
    camera.SetViewUp(*up)
    camera.SetParallelScale(half_height)
    renderer.ResetCameraClippingRange()
    return ((centre[0] - half_width, centre[0] + half_width, centre[1] - half_height, centre[1] + half_height),
            numpy.array([across, up]).T.tolist())


def coloured_actor(data, ranges):
    """What is coloured by the values that are shown."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetLookupTable(colour_table(ranges))
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


def add_streamlines(renderer, body, flow, ranges, pixel):
    """Lines with arrow heads in a body that is glass; `pixel` is the size of one [m]."""
    body.GetMapper().ScalarVisibilityOff()
    body.GetProperty().SetColor(0.55, 0.55, 0.6)
    body.GetProperty().SetOpacity(0.25)
    body.GetProperty().FrontfaceCullingOn()  # what lies behind the lines alone
    flow.GetPointData().SetActiveScalars("shown")
    for data in (flow, render_streamlines.arrow_heads(flow, 26 * pixel)):
        actor = coloured_actor(data, ranges)
        actor.GetProperty().SetLineWidth(2.5)
        actor.GetProperty().LightingOff()
        renderer.AddActor(actor)


def draw_with_opengl(faces, lines, plane, ranges, request, direction, bounds, number, flow=None, outline=None):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    coloured = coloured_actor(faces, ranges)
    if plane:
        coloured.GetProperty().LightingOff()
    else:
        coloured.GetProperty().SetAmbient(0.5)
        coloured.GetProperty().SetDiffuse(0.5)
    renderer.AddActor(coloured)
    line_mapper = vtk.vtkPolyDataMapper()
    line_mapper.SetInputData(lines)
    line_mapper.ScalarVisibilityOff()
    drawn = vtk.vtkActor()
    drawn.SetMapper(line_mapper)
    drawn.GetProperty().SetColor(0.1, 0.1, 0.1)
    drawn.GetProperty().SetLineWidth(1.0)
    drawn.GetProperty().LightingOff()
    (left, right, bottom, top), axes = camera_of(renderer, bounds, direction)
    width = 2 * request["pixels"]
    if flow is not None:
        add_streamlines(renderer, coloured, flow, ranges, (right - left) / width)
    elif wants_lines(lines, width / (right - left), request.get("mesh"), plane):
        renderer.AddActor(drawn)
    elif outline is not None:
        line_mapper.SetInputData(outline)
        drawn.GetProperty().SetColor(0.3, 0.3, 0.3)
        renderer.AddActor(drawn)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.AddRenderer(renderer)
    window.SetSize(width, max(1, round(width * (top - bottom) / (right - left))))
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(os.path.join(request["folder"], f"picture-{number}.png"))
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
    window.Finalize()
    return left, right, bottom, top, axes


def wants_lines(lines, pixels_a_metre, asked, plane):
    """Whether the mesh is drawn: as asked for, or where its lines leave room for the colours."""
    if asked is not None:
        return asked
    if not plane and lines.GetNumberOfLines() >= MOST_LINES or lines.GetNumberOfLines() == 0:
        return False
    ends = vtk_to_numpy(lines.GetPoints().GetData())[vtk_to_numpy(lines.GetLines().GetConnectivityArray()).reshape(-1, 2)]
    lengths = numpy.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    return bool(numpy.median(lengths) * pixels_a_metre > FINEST_MESH)


def without_margins(path, extent):
    """The extent of a picture of a body in space without what is white at its sides, which the picture loses."""
    with Image.open(path) as image:
        shown = numpy.asarray(image.convert("RGB")) < 250
    rows, columns = numpy.flatnonzero(shown.any(axis=(1, 2))), numpy.flatnonzero(shown.any(axis=(0, 2)))
    if not len(rows) or not len(columns):
        return extent
    return crop_of(extent, shown.shape[:2], rows, columns)


def crop_of(extent, shape, rows, columns):
    """The part of the extent between the first and the last of these rows and columns of pixels, and a hundredth around it."""
    left, right, bottom, top = extent
    margin = 0.01 * max(shape)
    across, up = (right - left) / shape[1], (top - bottom) / shape[0]
    return (left + across * max(0, columns[0] - margin), left + across * min(shape[1], columns[-1] + 1 + margin),
            top - up * min(shape[0], rows[-1] + 1 + margin), top - up * max(0, rows[0] - margin))


def dump_velocity(grid, request, number, extent, stretch):
    """The velocity [m/s] in the plane that is shown on an even grid over the extent [m]; nan outside of the body."""
    left, right, bottom, top = extent
    shape = (top - bottom) * stretch / (right - left)
    longer = {"vectors": 28, "streamlines": 160}[request["arrows"]]
    n_across, n_up = (longer, max(6, round(longer * shape))) if shape <= 1 else (max(6, round(longer / shape)), longer)
    x = left + (numpy.arange(n_across) + 0.5) / n_across * (right - left)
    y = bottom + (numpy.arange(n_up) + 0.5) / n_up * (top - bottom)
    places, at = vtk.vtkPolyData(), vtk.vtkPoints()
    at.SetData(numpy_to_vtk(numpy.array([[one, other, 0.0] for other in y for one in x]), deep=True))
    places.SetPoints(at)
    probe = vtk.vtkProbeFilter()
    probe.SetInputData(places)
    probe.SetSourceData(grid)
    probe.Update()
    data = probe.GetOutput().GetPointData()
    if data.GetArray("velocity") is None:
        fault("the states have no velocity, of which arrows or streamlines are")
    section = request.get("section")
    components = [d for d in range(3) if not section or d != section["axis"]][:2]
    velocity = vtk_to_numpy(data.GetArray("velocity")).astype(float)[:, components]
    velocity[vtk_to_numpy(data.GetArray(probe.GetValidPointMaskArrayName())) == 0] = numpy.nan
    numpy.savez(os.path.join(request["folder"], f"velocity-{number}.npz"), x=x, y=y, velocity=velocity.reshape(n_up, n_across, 2))


def dump_for_matplotlib(faces, lines, request, number):
    points = vtk_to_numpy(faces.GetPoints().GetData())
    triangles = vtk_to_numpy(faces.GetPolys().GetData()).reshape(-1, 4)[:, 1:]
    ends, corners = numpy.zeros((0, 2), int), numpy.zeros((0, 2))
    if lines.GetNumberOfLines():
        ends = vtk_to_numpy(lines.GetLines().GetData()).reshape(-1, 3)[:, 1:]
        corners = vtk_to_numpy(lines.GetPoints().GetData())[:, :2]
    numpy.savez(os.path.join(request["folder"], f"picture-{number}.npz"), x=points[:, 0], y=points[:, 1], triangles=triangles,
                values=vtk_to_numpy(faces.GetPointData().GetArray("shown")), edges=corners[ends])


class Scale:
    """What all states have in common: the field, its colours, the factor of the displacement, and which place is seen."""

    def __init__(self, request):
        self.regions, self.section = request["regions"], request.get("section")
        found, self.undeformed = [], None
        self.field, self.label, self.liquid = request["field"], "", False
        if self.field is None:  # by the last state: at the start all may be at rest
            self.field = values_of(only(read(request["states"][-1]), self.regions), None)[0]
        grids = (self.read_state(pieces, found) for pieces in request["states"])
        self.deformation = factor_of(grids)
        self.mesh_moves = request.get("deformation") == "finite"
        if self.mesh_moves:  # its equations are those of the body as it is
            self.deformation = 1
        if self.field in OF_WALLS and not any(state.get("") for state in found):
            fault(f"no wall has a value of {self.field}", NOTHING_TO_SEE)
        self.ranges = ranges_of(found)
        bounds = self.undeformed
        if self.section and bounds[5] - bounds[4] < 1e-9 * max(bounds[1] - bounds[0], bounds[3] - bounds[2]):
            fault("a section is of a body in space, and this one is plane")
        if self.section:
            bounds = [bounds[2 * d + i] for d in range(3) if d != self.section["axis"] for i in (0, 1)] + [0.0, 0.0]
        self.plane = bounds[5] - bounds[4] < 1e-9 * max(bounds[1] - bounds[0], bounds[3] - bounds[2])

    def read_state(self, pieces, found):
        """The state whole; the extremes of its field are added to what was found."""
        grid = read(pieces)
        shown = only(grid, self.regions)
        self.field, self.label, values = values_of(shown, self.field)
        if not numpy.isfinite(values).any() and self.field not in OF_WALLS:
            fault(f"the field {self.field} has no finite value")
        solid = in_solid(shown)
        self.liquid = self.liquid or bool(solid is not None and not solid.all())
        found.append(extremes(values, solid, self.field))
        self.undeformed = united(self.undeformed, grid.GetBounds())
        return grid


def union_of(one, other):
    """The extent (left, right, bottom, top) of both."""
    return other if one is None else (min(one[0], other[0]), max(one[1], other[1]), min(one[2], other[2]), max(one[3], other[3]))


def united(bounds, others):
    if bounds is None:
        return others
    return tuple((min, max)[i % 2](bounds[i], others[i]) for i in range(6))


def prepared(pieces, scale, liquid_follows=True, whole=False):
    """(the deformed part that is shown, or all of it; where it is looked at from)."""
    grid = read(pieces)
    deform(grid, scale.deformation, liquid_follows, scale.mesh_moves)
    grid = only(grid, scale.regions)
    if scale.section:
        grid = cut_plane(grid, scale.section)
    _, _, values = values_of(grid, scale.field)
    of_wall = scale.field in OF_WALLS
    shown = numpy_to_vtk(on_the_maps(values if of_wall else numpy.nan_to_num(values), in_solid(grid), scale.ranges), deep=True)
    shown.SetName("shown")
    grid.GetPointData().AddArray(shown)
    grid.GetPointData().SetActiveScalars("shown")
    if scale.plane:
        return grid, numpy.array([0, 0, 1.0])
    if whole:
        return grid, open_up(grid)[1]
    return wall_of(grid) if of_wall else open_up(grid)


def flow_of(grid):
    if grid.GetPointData().GetArray("velocity") is None:
        fault("the states have no velocity, of which arrows or streamlines are")
    lines = render_streamlines.streamlines(grid)
    if lines is None or lines.GetNumberOfCells() == 0:
        fault("nothing moves in this state, so that it has no streamlines")
    return lines


def main():
    request = json.load(sys.stdin)
    scale = Scale(request)
    if request["way"] != "gl" and not scale.plane:
        sys.exit("a solid mesh needs OpenGL: install xvfb, xauth and libgl1-mesa-dri")
    bounds, states = None, request["states"]
    has_streamlines = request.get("arrows") == "streamlines" and not scale.plane
    one = prepared(states[0], scale, whole=has_streamlines) if len(states) == 1 else None
    for pieces in states:
        # Between the solids the liquid does not matter for the section, and its mesh takes long.
        bounds = united(bounds, (one or prepared(pieces, scale, False))[0].GetBounds())
    ratio = (bounds[1] - bounds[0]) / max(bounds[3] - bounds[2], 1e-300)
    flattest = request["flattest"]
    stretch = nice(ratio / flattest) if scale.plane and ratio > 1.99 * flattest else 1
    axes, cropped, mesh = None, None, request.get("mesh")
    for number, pieces in enumerate(states):
        grid, direction = one or prepared(pieces, scale)
        if request.get("arrows") and scale.plane:
            dump_velocity(grid, request, number, bounds[:4], stretch)
        faces, lines = surface(render_streamlines.glass_of(grid) if has_streamlines else grid), mesh_lines(grid if scale.plane else outside(whole_cells(grid)))
        faces.GetPointData().SetActiveScalars("shown")
        if request["way"] == "gl":
            if stretch != 1:
                faces, lines = stretched(faces, stretch), stretched(lines, stretch)
            seen = [bound * (stretch if i in (2, 3) else 1) for i, bound in enumerate(bounds)]
            flow = flow_of(grid) if has_streamlines else None
            outline = stretched(outline_of(grid), stretch) if scale.plane else None
            left, right, bottom, top, axes = draw_with_opengl(faces, lines, scale.plane, scale.ranges, request, direction, seen, number, flow, outline)
            bottom, top = bottom / stretch, top / stretch
            if not scale.plane:
                path = os.path.join(request["folder"], f"picture-{number}.png")
                cropped = union_of(cropped, without_margins(path, (left, right, bottom, top)))
        else:
            left, right, bottom, top = bounds[:4]
            if not wants_lines(lines, 2 * request["pixels"] / (right - left), mesh, True):
                lines = vtk.vtkPolyData()
            dump_for_matplotlib(faces, lines, request, number)
    with open(os.path.join(request["folder"], "picture.json"), "w", encoding="utf-8") as stream:
        json.dump({"seen": cropped or [left, right, bottom, top], "section": scale.section, "field": scale.field,
                   "label": scale.label, "ranges": scale.ranges, "extent": [left, right, bottom, top],
                   "plane": bool(scale.plane), "axes": axes, "deformation": scale.deformation, "stretch": stretch,
                   "liquid": scale.liquid}, stream)


if __name__ == "__main__":
    main()
