#!/usr/bin/python3
"""Draws one state of a run with VTK. Reads a request (json) from stdin, writes picture.png (or picture.npz, for a plane
mesh without OpenGL) and picture.json into the request's folder. Exit status 3: the data or the request are at fault.
"""

import json
import math
import os
import sys

import matplotlib
import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy


def fault(text):
    print(text, file=sys.stderr)
    sys.exit(3)


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
        field = next((name for name in ("velocity", "pressure", "displacement") if name in names), None)
        if field is None and names:
            field = names[0]
    if field not in names:
        fault(f"there is no field {field}; there are {', '.join(names) or 'none'}")
    values = vtk_to_numpy(data.GetArray(field)).astype(float)
    if values.ndim == 2:
        return field, f"{field} magnitude", numpy.linalg.norm(values, axis=1)
    return field, field, values


def nice(number):
    """The largest of 1, 2, 5, 10, ... that is not above the number."""
    power = 10.0**math.floor(math.log10(number))
    return max(step * power for step in (1, 2, 5) if step * power <= number * (1 + 1e-9))


def deform(grid):
    """Moves the points by the displacement, enlarged until it can be seen. Returns the factor, 0 without one."""
    array = grid.GetPointData().GetArray("displacement")
    if array is None or array.GetNumberOfComponents() != 3:
        return 0
    displacement = numpy.nan_to_num(vtk_to_numpy(array).astype(float))
    points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    size = (points.max(axis=0) - points.min(axis=0))
    largest = numpy.linalg.norm(displacement, axis=1).max()
    if not largest > 0:
        return 0
    # A tenth of the length shows; but a thin wall must not fold over itself, hence not more than the width either.
    wanted = min(0.1 * size.max(), 0.4 * size[size > 1e-9 * size.max()].min())
    factor = nice(wanted / largest)
    if 0.5 <= factor <= 2:
        factor = 1
    moved = vtk.vtkPoints()
    moved.SetData(numpy_to_vtk(points + factor * displacement, deep=True))
    grid.SetPoints(moved)
    return factor


def mesh_lines(grid):
    """The edges of the cells; those of curved cells as several pieces."""
    edges = vtk.vtkExtractEdges()
    edges.SetInputData(grid)
    edges.Update()
    return edges.GetOutput()


def surface(grid):
    faces = vtk.vtkDataSetSurfaceFilter()
    faces.SetInputData(grid)
    faces.SetNonlinearSubdivisionLevel(2)
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(faces.GetOutputPort())
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


def colour_table(low, high):
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i, colour in enumerate(matplotlib.colormaps["viridis"](numpy.linspace(0, 1, 256))):
        table.SetTableValue(i, *colour)
    table.SetRange(low, high if high > low else low + 1)
    return table


def camera_of(renderer, bounds, plane):
    """Looks straight at a plane mesh, from a corner at a solid one. Returns (left, right, bottom, top) seen."""
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    centre = numpy.array([(bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)])
    direction = numpy.array([0, 0, 1.0] if plane else [0.5, 0.45, 1.0])
    direction /= numpy.linalg.norm(direction)
    across = numpy.cross([0, 1, 0], direction)
    across /= numpy.linalg.norm(across)
    up = numpy.cross(direction, across)
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
    return (centre[0] - half_width, centre[0] + half_width, centre[1] - half_height, centre[1] + half_height)


def draw_with_opengl(faces, lines, plane, low, high, request):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(faces)
    mapper.SetLookupTable(colour_table(low, high))
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    coloured = vtk.vtkActor()
    coloured.SetMapper(mapper)
    if plane:
        coloured.GetProperty().LightingOff()
    renderer.AddActor(coloured)
    line_mapper = vtk.vtkPolyDataMapper()
    line_mapper.SetInputData(lines)
    line_mapper.ScalarVisibilityOff()
    drawn = vtk.vtkActor()
    drawn.SetMapper(line_mapper)
    drawn.GetProperty().SetColor(0.1, 0.1, 0.1)
    drawn.GetProperty().SetLineWidth(1.0)
    drawn.GetProperty().LightingOff()
    renderer.AddActor(drawn)

    left, right, bottom, top = camera_of(renderer, faces.GetBounds(), plane)
    width = 2 * request["pixels"]
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
    writer.SetFileName(os.path.join(request["folder"], "picture.png"))
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
    return left, right, bottom, top


def dump_for_matplotlib(faces, lines, request):
    points = vtk_to_numpy(faces.GetPoints().GetData())
    triangles = vtk_to_numpy(faces.GetPolys().GetData()).reshape(-1, 4)[:, 1:]
    ends = vtk_to_numpy(lines.GetLines().GetData()).reshape(-1, 3)[:, 1:]
    corners = vtk_to_numpy(lines.GetPoints().GetData())[:, :2]
    numpy.savez(os.path.join(request["folder"], "picture.npz"), x=points[:, 0], y=points[:, 1], triangles=triangles,
                values=vtk_to_numpy(faces.GetPointData().GetArray("shown")), edges=corners[ends])
    bounds = faces.GetBounds()
    return bounds[:4]


def main():
    request = json.load(sys.stdin)
    grid = read(request["pieces"])
    field, label, values = values_of(grid, request["field"])
    finite = values[numpy.isfinite(values)]
    if finite.size == 0:
        fault(f"the field {field} has no finite value")
    bounds = grid.GetBounds()
    plane = bounds[5] - bounds[4] < 1e-9 * max(bounds[1] - bounds[0], bounds[3] - bounds[2])
    shown = numpy_to_vtk(values, deep=True)
    shown.SetName("shown")
    grid.GetPointData().AddArray(shown)
    grid.GetPointData().SetActiveScalars("shown")
    deformation = deform(grid)

    bounds = grid.GetBounds()
    ratio = (bounds[1] - bounds[0]) / max(bounds[3] - bounds[2], 1e-300)
    stretch = nice(ratio / request["flattest"]) if plane and ratio > 1.99 * request["flattest"] else 1
    faces, lines = surface(grid), mesh_lines(grid)
    faces.GetPointData().SetActiveScalars("shown")
    low, high = float(finite.min()), float(finite.max())
    if request["way"] == "gl":
        if stretch != 1:
            faces, lines = stretched(faces, stretch), stretched(lines, stretch)
        left, right, bottom, top = draw_with_opengl(faces, lines, plane, low, high, request)
        bottom, top = bottom / stretch, top / stretch
    elif plane:
        left, right, bottom, top = dump_for_matplotlib(faces, lines, request)
    else:
        sys.exit("a solid mesh needs OpenGL: install xvfb, xauth and libgl1-mesa-dri")
    with open(os.path.join(request["folder"], "picture.json"), "w", encoding="utf-8") as stream:
        json.dump({"field": field, "label": label, "range": [low, high], "extent": [left, right, bottom, top],
                   "plane": bool(plane), "deformation": deformation, "stretch": stretch}, stream)


if __name__ == "__main__":
    main()
