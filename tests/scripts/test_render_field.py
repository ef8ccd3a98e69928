#!/usr/bin/python3
"""scripts/lib/render_field.py: which part of a body in space a picture shows, and a mesh that moves."""

import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "lib"))
sys.dont_write_bytecode = True

import numpy  # noqa: E402
import render_field  # noqa: E402
import vtk  # noqa: E402
from vtk.util.numpy_support import numpy_to_vtk  # noqa: E402


def liquid_beside_solid(lowest):
    """Two unit cubes side by side from z = `lowest` to 1, the first of a liquid."""
    points, cells, phase = vtk.vtkPoints(), vtk.vtkCellArray(), []
    for i in (0, 1):
        hexahedron = vtk.vtkHexahedron()
        for k, (x, y) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1)) * 2):
            hexahedron.GetPointIds().SetId(k, points.InsertNextPoint(i + x, y, lowest if k < 4 else 1))
            phase.append(float(i))
        cells.InsertNextCell(hexahedron)
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(points)
    grid.SetCells(vtk.VTK_HEXAHEDRON, cells)
    array = numpy_to_vtk(numpy.array(phase), deep=True)
    array.SetName("phase")
    grid.GetPointData().AddArray(array)
    return grid


class Deform(unittest.TestCase):
    def test_mesh_that_moves(self):
        """In finite deformation all points go where their displacement leads, also where no solid is."""
        for phases in ((0, 1), (0, 0)):
            grid = liquid_beside_solid(0)
            phase = grid.GetPointData().GetArray("phase")
            for i in range(phase.GetNumberOfTuples()):
                phase.SetTuple1(i, phases[int(phase.GetTuple1(i))])
            before = render_field.vtk_to_numpy(grid.GetPoints().GetData()).copy()
            displacement = numpy.stack([before[:, 1]**2, 0.1 * before[:, 0], -before[:, 2]], axis=1)
            array = numpy_to_vtk(displacement, deep=True)
            array.SetName("displacement")
            grid.GetPointData().AddArray(array)
            for liquid_follows in (True, False):
                moved = vtk.vtkUnstructuredGrid()
                moved.DeepCopy(grid)
                render_field.deform(moved, 1, liquid_follows, mesh_moves=True)
                after = render_field.vtk_to_numpy(moved.GetPoints().GetData())
                self.assertLess(abs(after - before - displacement).max(), 1e-6)


def highest(grid):
    """The largest z of a cell; a clipped grid keeps points without cells."""
    return max(grid.GetCell(i).GetBounds()[5] for i in range(grid.GetNumberOfCells()))


class OpenUp(unittest.TestCase):
    def test_half_body_with_round_off(self):
        for lowest in (0, -2e-5, 2e-5):
            shown, direction = render_field.open_up(liquid_beside_solid(lowest))
            self.assertAlmostEqual(highest(shown), 1)
            self.assertLess(direction[2], 0)

    def test_whole_body(self):
        shown, direction = render_field.open_up(liquid_beside_solid(-1))
        self.assertAlmostEqual(highest(shown), 0)
        self.assertGreater(direction[2], 0)


if __name__ == "__main__":
    unittest.main()
