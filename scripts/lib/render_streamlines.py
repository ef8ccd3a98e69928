"""Streamlines of the velocity through a body in space, for render_field.py."""

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtk_part import part_of

SEEDS = 60  # about so many places from which lines go, evenly in the liquid
SLOWEST = 1e-4  # of the largest speed: where the liquid is slower, a line ends


def liquid_of(grid):
    """The liquid of a body that has one, else the whole body."""
    if grid.GetPointData().GetArray("phase") is None:
        return grid
    liquid = part_of(grid)
    return liquid if liquid.GetNumberOfCells() else grid


def glass_of(grid):
    """The liquid, whose cells share their points: its surface has no faces between cells."""
    return with_shared_points(liquid_of(grid))


def with_shared_points(grid):
    """The cells without their fields. Points at one place are one."""
    points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    size = numpy.ptp(points, axis=0).max()
    _, first, numbers = numpy.unique(numpy.round(points / (1e-6 * size)).astype(numpy.int64), axis=0, return_index=True, return_inverse=True)
    cells = grid.GetCells()
    connectivity = numpy.ascontiguousarray(numbers.ravel()[vtk_to_numpy(cells.GetConnectivityArray())].astype(numpy.int64))
    offsets = numpy.ascontiguousarray(vtk_to_numpy(cells.GetOffsetsArray()).astype(numpy.int64))
    shared = vtk.vtkCellArray()
    shared.SetData(*(numpy_to_vtk(array, deep=True, array_type=vtk.VTK_ID_TYPE) for array in (offsets, connectivity)))
    at = vtk.vtkPoints()
    at.SetData(numpy_to_vtk(points[first], deep=True))
    result = vtk.vtkUnstructuredGrid()
    result.SetPoints(at)
    result.SetCells(grid.GetCellTypesArray(), shared)
    return result


def seeds_in(grid, n_wanted=SEEDS):
    """Places [m] in the middle of cells: one in each of equal cubes that have any, about as many as wanted."""
    centres = vtk.vtkCellCenters()
    centres.SetInputData(grid)
    centres.Update()
    points = vtk_to_numpy(centres.GetOutput().GetPoints().GetData()).astype(float)
    low, size = points.min(axis=0), max(float(numpy.ptp(points, axis=0).max()), 1e-300)
    # The more cubes lie along the longest side, the more of them have cells.
    for n_along in range(1, 400):
        cubes = numpy.floor((points - low) / size * n_along * (1 - 1e-12)).astype(int)
        _, first = numpy.unique(cubes, axis=0, return_index=True)
        if len(first) >= min(n_wanted, len(points)):
            break
    return points[numpy.sort(first)]


def streamlines(grid, n_wanted=SEEDS):
    """Lines along the velocity of the liquid, with the values of the points of the grid. None if nothing moves or nothing is known of it."""
    liquid = liquid_of(grid)
    velocity = liquid.GetPointData().GetArray("velocity")
    if velocity is None:
        return None
    fastest = numpy.nanmax(numpy.linalg.norm(vtk_to_numpy(velocity).astype(float), axis=1), initial=0.0)
    if not fastest > 0:
        return None
    at = vtk.vtkPoints()
    at.SetData(numpy_to_vtk(seeds_in(liquid, n_wanted), deep=True))
    seeds = vtk.vtkPolyData()
    seeds.SetPoints(at)
    bounds = liquid.GetBounds()
    tracer = vtk.vtkStreamTracer()
    tracer.SetInputData(liquid)
    tracer.SetSourceData(seeds)
    tracer.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, "velocity")
    tracer.SetIntegratorTypeToRungeKutta45()
    tracer.SetIntegrationDirectionToBoth()
    tracer.SetMaximumPropagation(3 * max(bounds[2 * d + 1] - bounds[2 * d] for d in range(3)))
    tracer.SetMaximumNumberOfSteps(5000)
    tracer.SetTerminalSpeed(SLOWEST * fastest)
    tracer.SetComputeVorticity(False)
    tracer.Update()
    return tracer.GetOutput()


def arrow_heads(lines, length):
    """A cone of this length [m] in the middle of each line, along the velocity there."""
    points, velocity = lines.GetPoints(), lines.GetPointData().GetArray("velocity")
    shown = lines.GetPointData().GetArray("shown")
    middles, ways, values = [], [], []
    for i in range(lines.GetNumberOfCells()):
        ids = lines.GetCell(i).GetPointIds()
        if ids.GetNumberOfIds() < 2:
            continue
        middle = ids.GetId(ids.GetNumberOfIds() // 2)
        middles.append(points.GetPoint(middle))
        ways.append(velocity.GetTuple(middle))
        values.append(shown.GetValue(middle))
    data, at = vtk.vtkPolyData(), vtk.vtkPoints()
    at.SetData(numpy_to_vtk(numpy.array(middles, float).reshape(-1, 3), deep=True))
    data.SetPoints(at)
    for name, array in (("velocity", numpy.array(ways, float).reshape(-1, 3)), ("shown", numpy.array(values, float))):
        converted = numpy_to_vtk(array, deep=True)
        converted.SetName(name)
        data.GetPointData().AddArray(converted)
    data.GetPointData().SetActiveVectors("velocity")
    data.GetPointData().SetActiveScalars("shown")
    cone = vtk.vtkConeSource()
    cone.SetResolution(12)
    cone.SetHeight(1.0)
    cone.SetRadius(0.35)
    glyphs = vtk.vtkGlyph3D()
    glyphs.SetInputData(data)
    glyphs.SetSourceConnection(cone.GetOutputPort())
    glyphs.SetVectorModeToUseVector()
    glyphs.SetScaleModeToDataScalingOff()
    glyphs.SetColorModeToColorByScalar()
    glyphs.SetScaleFactor(length)
    glyphs.Update()
    return glyphs.GetOutput()
