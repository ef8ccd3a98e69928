#!/usr/bin/env bash
# Library:  VTK (vtkCellSizeFilter, vtkIntegrateAttributes)
# Version:  Debian 12: python3-vtk9 9.1.0
# Sentence: The volume of a cube of 27-node hexahedra is 0, and that of a cube of 18-node prisms is a sixth.
#
# Guessed:  A unit cube has the volume 1, whatever the cells are that fill it. An integral over the body is as good.
# Seen:     A cube of 27-node hexahedra (VTK_TRIQUADRATIC_HEXAHEDRON) or of 24-node ones has the volume 0, and so has
#           every integral over it. VTK warns "Number of points (2) is not divisible by 4 - skipping". A cube of 18-node or of 12-node prisms has
#           the volume 1/6, without a warning. VTK's own shape functions of the same cells give the volume 1. The Lagrange cells
#           (VTK_LAGRANGE_HEXAHEDRON, VTK_LAGRANGE_WEDGE) with as many nodes have the right volume, and so has the 20-node
#           hexahedron.
# Output:   The unit cube as one hexahedron or two prisms: volume, its integral of x (exact 0.5), volume by VTK's shape functions, and
#           volume of the tetrahedra of vtkDataSetTriangleFilter:
#               20-node hexahedron           volume 1.0000  integral 0.5000  shape functions 1.0000  tetrahedra  1.0000
#               24-node hexahedron           volume 0.0000  integral 0.0000  shape functions 1.0000  tetrahedra  1.0000
#               27-node hexahedron           volume 0.0000  integral 0.0000  shape functions 1.0000  tetrahedra  1.0000
#               27-node Lagrange hexahedron  volume 1.0000  integral 0.5000  shape functions 1.0000  tetrahedra  1.0000
#               12-node prism                volume 0.1667  integral 0.0833  shape functions 1.0000  tetrahedra -1.0000
#               18-node prism                volume 0.1667  integral 0.0833  shape functions 1.0000  tetrahedra -1.0000
#               18-node Lagrange prism       volume 1.0000  integral 0.5000  shape functions 1.0000  tetrahedra  1.0000
#           The VTK 9.2 inside ParaView 5.11.0 of Debian 12 gave the same numbers when this finding was written.
# Matters:  Gmsh writes these cells into a .vtk of a mesh of second order (Mesh.ElementOrder = 2). Who compares the volume of a
#           vessel, a mean pressure or an energy of another code with Continua gets a wrong number, and from prisms no warning.
#           Continua writes linear cells, or Lagrange cells with `set Higher order cells = true`. Those are right.
# To do:    Before you integrate, compare the volume with a known one. Write Lagrange cells, or hexahedra of 20 nodes
#           (Mesh.SecondOrderIncomplete = 1 in Gmsh). Or cut the cells into tetrahedra first, by vtkDataSetTriangleFilter
#           ("Tetrahedralize" in ParaView). Those of prisms are turned inside out, so their integrals have the wrong sign.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../scripts/lib/findings.sh"
need_installed python3-vtk9 9.1.0

cat >finding.py <<'END'
import itertools
import sys

import vtk

GAUSS = (0.5 - 0.5 / 3**0.5, 0.5 + 0.5 / 3**0.5)
TRIANGLE = ((1 / 6, 1 / 6), (2 / 3, 1 / 6), (1 / 6, 2 / 3))
HEXAHEDRON = [(1 / 8, point) for point in itertools.product(GAUSS, repeat=3)]
PRISM = [(1 / 12, (*point, z)) for point in TRIANGLE for z in GAUSS]
# Name, class, nodes of a Lagrange cell, rule of integration.
CELLS = [
    ("20-node hexahedron", vtk.vtkQuadraticHexahedron, 0, HEXAHEDRON),
    ("24-node hexahedron", vtk.vtkBiQuadraticQuadraticHexahedron, 0, HEXAHEDRON),
    ("27-node hexahedron", vtk.vtkTriQuadraticHexahedron, 0, HEXAHEDRON),
    ("27-node Lagrange hexahedron", vtk.vtkLagrangeHexahedron, 27, HEXAHEDRON),
    ("12-node prism", vtk.vtkQuadraticLinearWedge, 0, PRISM),
    ("18-node prism", vtk.vtkBiQuadraticQuadraticWedge, 0, PRISM),
    ("18-node Lagrange prism", vtk.vtkLagrangeWedge, 18, PRISM),
]
RIGHT = {"20-node hexahedron", "27-node Lagrange hexahedron", "18-node Lagrange prism"}


def body(kind, n_lagrange, is_prism):
    """The unit cube as cells whose nodes stand where VTK's own parameters have them, with the coordinate x as a field."""
    cell = kind()
    if n_lagrange:
        cell.GetPointIds().SetNumberOfIds(n_lagrange)
        cell.GetPoints().SetNumberOfPoints(n_lagrange)
        cell.SetUniformOrderFromNumPoints(n_lagrange)
    n = cell.GetNumberOfPoints()
    parameters = cell.GetParametricCoords()
    nodes = [tuple(parameters[3 * i + k] for k in range(3)) for i in range(n)]
    grid, points, x = vtk.vtkUnstructuredGrid(), vtk.vtkPoints(), vtk.vtkDoubleArray()
    points.SetDataTypeToDouble()
    x.SetName("x")
    grid.SetPoints(points)
    # The second prism is the first, turned by 180 degrees about the middle of the cube's axis.
    for half in range(2 if is_prism else 1):
        for node in nodes:
            place = (1 - node[0], 1 - node[1], node[2]) if half else node
            points.InsertNextPoint(place)
            x.InsertNextValue(place[0])
        grid.InsertNextCell(cell.GetCellType(), n, list(range(half * n, (half + 1) * n)))
    grid.GetPointData().AddArray(x)
    return grid


def volume_by_shape_functions(cell, rule):
    """The integral of the Jacobian's determinant, from central differences, which are exact for second order."""
    weights, step = [0.0] * cell.GetNumberOfPoints(), 0.01

    def place(parameters):
        result = [0.0] * 3
        cell.EvaluateLocation(vtk.reference(0), parameters, result, weights)
        return result

    total = 0.0
    for weight, point in rule:
        columns = []
        for k in range(3):
            up, down = list(point), list(point)
            up[k] += step
            down[k] -= step
            columns.append([(a - b) / (2 * step) for a, b in zip(place(up), place(down))])
        total += weight * vtk.vtkMath.Determinant3x3(*columns)
    return total


def integrate(source):
    """Volume and integral of x of what a filter or a trivial producer gives."""
    integral = vtk.vtkIntegrateAttributes()
    integral.SetInputConnection(source.GetOutputPort())
    integral.Update()
    return (integral.GetOutput().GetCellData().GetArray("Volume").GetValue(0),
            integral.GetOutput().GetPointData().GetArray("x").GetValue(0))


def size(source, n_cells):
    """The sum of the volumes of vtkCellSizeFilter."""
    sizes = vtk.vtkCellSizeFilter()
    sizes.SetInputConnection(source.GetOutputPort())
    sizes.Update()
    volumes = sizes.GetOutput().GetCellData().GetArray("Volume")
    return sum(volumes.GetValue(i) for i in range(n_cells))


vtk.vtkObject.GlobalWarningDisplayOff()
still_so = True
for name, kind, n_lagrange, rule in CELLS:
    grid = body(kind, n_lagrange, rule is PRISM)
    n_cells = grid.GetNumberOfCells()
    producer = vtk.vtkTrivialProducer()
    producer.SetOutput(grid)
    cut = vtk.vtkDataSetTriangleFilter()
    cut.SetInputConnection(producer.GetOutputPort())
    volume, of_x = integrate(producer)
    found = (size(producer, n_cells), volume, 2 * of_x,
             sum(volume_by_shape_functions(grid.GetCell(i), rule) for i in range(n_cells)), integrate(cut)[0])
    print("{:27}  volume {:.4f}  integral {:.4f}  shape functions {:.4f}  tetrahedra {:7.4f}".format(
        name, volume, of_x, found[3], found[4]))
    share = 1.0 if name in RIGHT else 0.0 if rule is HEXAHEDRON else 1 / 6
    turned = -1.0 if rule is PRISM and not n_lagrange else 1.0
    still_so = still_so and all(abs(a - b) < 1e-6 for a, b in zip(found, (share, share, share, 1.0, turned)))
sys.exit(0 if still_so else 3)
END
judge "$python" finding.py
