#!/usr/bin/python3
"""What scripts/plot draws of walls, outlets, several probes with stations, sections; which field and which lines of the mesh; sizes; --follow."""

import argparse
import csv
import importlib.machinery
import importlib.util
import math
import os
import sys
import tempfile
import types
import unittest

import numpy
import vtk
import xarray
from vtk.util.numpy_support import numpy_to_vtk

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import test_plot  # noqa: E402
from test_plot import SCRIPTS, write  # noqa: E402

import plot_choice  # noqa: E402
import plot_histories  # noqa: E402
import plot_movie  # noqa: E402
import plot_wall  # noqa: E402
import plot_waves  # noqa: E402
import render_field  # noqa: E402
import render_streamlines  # noqa: E402


def header_of(path):
    with open(path, encoding="utf-8") as stream:
        return next(csv.reader(stream))


class Tables(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name
        self.plots = os.path.join(self.folder, "plots")
        os.mkdir(self.plots)
        self.sheet = test_plot.Looks.Sheet(self.plots, 6)
        self.run = {"folder": self.folder, "title": "run", "summary": {}}

    def test_power_balances(self):
        """What leaves through an outlet is drawn; what it stores is a part of it, and a region's share a part of a term."""
        write(os.path.join(self.folder, "power.csv"), "time [s],external [W],kinetic [W],fluid: kinetic [W],outlet end: leaving [W],outlet end: stored [W]\n"
                                                      "0,5,2,1,3,1\n1,6,2,1,4,2\n")
        plot_histories.draw_power(self.sheet, [self.run])
        names = header_of(os.path.join(self.plots, "power.csv"))[1::2]
        self.assertEqual(names, ["external [W]", "kinetic [W]", "outlet end: leaving [W]"])
        with open(os.path.join(self.plots, "power.csv"), encoding="utf-8") as stream:
            for row in list(csv.reader(stream))[1:]:
                self.assertEqual(float(row[1]), float(row[3]) + float(row[5]))

    def test_one_probe_over_another(self):
        """A loop: the diameter 2 p - p^2/100 over the pressure, up and down."""
        pressures = [*range(0, 50), *range(50, -1, -1)]
        write(os.path.join(self.folder, "probes.csv"), "time [s],tube: pressure [Pa],tube: wall distension [m],axis: pressure [Pa]\n"
              + "".join(f"{i},{p},{1e-3 * (2 * p - p * p / 100)},{p + 1}\n" for i, p in enumerate(pressures)))
        plot_histories.draw_over(self.sheet, [self.run], "tube: pressure")
        path = os.path.join(self.plots, "over-tube-pressure-wall-distension.csv")
        self.assertEqual(header_of(path), ["tube: pressure [Pa]", "tube: wall distension [m]"])
        with open(path, encoding="utf-8") as stream:
            rows = [[float(value) for value in row] for row in list(csv.reader(stream))[1:]]
        self.assertEqual([row[0] for row in rows], pressures)
        for p, distension in rows:
            self.assertAlmostEqual(distension, 1e-3 * (2 * p - p * p / 100))
        with self.assertRaises(plot_choice.ChoiceError) as caught:
            plot_histories.draw_over(self.sheet, [self.run], "tube: presure")
        self.assertIn("it has tube: pressure, tube: wall distension, axis: pressure", str(caught.exception))

    def test_every_probe_with_stations(self):
        for probe in ("parent", "branch"):
            write(os.path.join(self.folder, f"wave-{probe}.csv"), f'time [s],"{probe} 0 m: pressure, simulated [Pa]","{probe} 0.1 m: pressure, simulated [Pa]"\n'
                                                                 + "".join(f"{t},{t * (5 - t)},{t * (4 - t)}\n" for t in range(5)))
        plot_waves.draw(self.sheet, [self.run], False)
        made = {os.path.basename(path) for path in self.sheet.written if path.endswith("csv")}
        self.assertEqual(made, {f"{picture}-pressure-{probe}.csv" for picture in ("wave", "space-time") for probe in ("parent", "branch")})
        self.assertEqual(self.sheet.legends["wave-pressure-parent"][0], "Probe parent:")

    def test_one_station(self):
        """A curve over time with its values on the axis."""
        write(os.path.join(self.folder, "wave.csv"), 'time [s],"tube 0.1 m: pressure, simulated [Pa]"\n' + "".join(f"{t},{1000 * t * (5 - t)}\n" for t in range(5)))
        plot_waves.draw(self.sheet, [self.run], False)
        self.assertEqual(self.sheet.panels["wave-pressure"], [("station at 100 mm", 1)])
        self.assertEqual(self.sheet.outside, [])

    def test_beats_have_no_envelope(self):
        time = numpy.linspace(0, 6, 301)
        write(os.path.join(self.folder, "probes.csv"), "time [s],tip: pressure [Pa]\n" + "".join(f"{t},{math.sin(2 * math.pi * t)}\n" for t in time.tolist()))
        for beats, wanted in (({}, True), ({"time [s]": [1.0]}, False)):
            sheet = test_plot.Looks.Sheet(self.plots, 6)
            plot_histories.draw_probes(sheet, [{**self.run, "summary": {"beats": beats}}])
            self.assertEqual(any("envelope" in path for path in sheet.written), wanted)

    def test_axes_of_the_dispersion(self):
        rows = "".join(f"{f},{speed},{10.0 ** (f / 40)},{'nan' if f < 90 else 3}\n" for f, speed in zip(range(1, 101), numpy.linspace(6, 9, 100)))
        write(os.path.join(self.folder, "dispersion.csv"), "frequency [Hz],pressure wave: phase speed [m/s],pressure wave: attenuation [1/m],bending wave: phase speed [m/s]\n" + rows)
        scales = {}
        self.sheet.save = lambda figure, name: scales.update({name: [axes.get_yscale() for axes in figure.axes]})
        plot_waves.draw_dispersion(self.sheet, {**self.run, "summary": {"pre-flight report": {"load frequency [Hz]": 4.0}}})
        # From 6 to 9 m/s, and over two decades. A wave that there is from 90 Hz on is beyond ten times the load's frequency.
        self.assertEqual(scales["dispersion"], ["linear", "log"])
        self.assertNotIn("bending wave", [text for texts in self.sheet.legends.values() for text in texts])

    def test_waves_of_one_attenuation(self):
        """The wave that lies on another one is dashed, and the axis ends with what is drawn."""
        rows = "".join(f"{f},6,{0.001 * f ** 2},200,{200.5 if f < 90 else 210}\n" for f in range(1, 101))
        write(os.path.join(self.folder, "dispersion.csv"),
              "frequency [Hz],pressure wave: phase speed [m/s],pressure wave: attenuation [1/m],bending wave: attenuation [1/m],other bending wave: attenuation [1/m]\n" + rows)
        found = {}
        self.sheet.save = lambda figure, name: found.update({"lines": {line.get_label(): line.get_linestyle() for line in figure.axes[1].lines},
                                                             "limits": figure.axes[1].get_ylim()})
        plot_waves.draw_dispersion(self.sheet, {**self.run, "summary": {"pre-flight report": {"load frequency [Hz]": 4.0}}})
        self.assertEqual(found["lines"], {"pressure wave": "-", "bending wave": "-", "other bending wave": "--"})
        numpy.testing.assert_allclose(found["limits"], (0.8 * 0.001, 1.25 * 200.5))


def plane(nx, ny, field):
    """A state (xarray) of the unit square of nx times ny cells without common points, `field` of (x, y), of a liquid."""
    points, cells = [], []
    for i in range(nx):
        for j in range(ny):
            cells.append([len(points) + k for k in range(4)])
            points += [(i / nx, j / ny), ((i + 1) / nx, j / ny), ((i + 1) / nx, (j + 1) / ny), (i / nx, (j + 1) / ny)]
    points = numpy.array(points)
    values = numpy.array([field(x, y) for x, y in points])
    return xarray.Dataset({"oscillatory_shear_index": ("point", values), "phase": ("point", numpy.zeros(len(points))), "cells": (("cell", "corner"), numpy.array(cells))},
                          {"x": ("point", points[:, 0]), "y": ("point", points[:, 1]), "z": ("point", numpy.zeros(len(points)))})


class Walls(unittest.TestCase):
    def test_two_walls(self):
        """Of a channel: the values at y = 0 and y = 1, in order of x; the ends have none."""
        walls = plot_wall.walls_of(plane(8, 4, lambda x, y: 1 + x + y if y in (0, 1) else 0), "oscillatory_shear_index")
        self.assertEqual(len(walls), 2)
        for (points, values), y in zip(walls, (0, 1)):
            place, name = plot_wall.position_along(points)
            self.assertEqual((name, len(place)), ("x", 9))
            numpy.testing.assert_allclose(points[:, 1], y)
            numpy.testing.assert_allclose(values, 1 + points[:, 0] + y)

    def test_edges_inside(self):
        """Values at all nodes of a row of cells: the way around it, without the edges between two cells."""
        (points, _), = plot_wall.walls_of(plane(4, 1, lambda x, y: 1.0), "oscillatory_shear_index")
        self.assertEqual(len(points), 11)

    def test_wall_around_a_corner(self):
        """Along x = 1 and y = 1 the position is the length."""
        (points, _), = plot_wall.walls_of(plane(4, 4, lambda x, y: float(x == 1 or y == 1)), "oscillatory_shear_index")
        place, name = plot_wall.position_along(points)
        self.assertEqual(name, "length along the wall")
        self.assertAlmostEqual(place[-1], 2)
        numpy.testing.assert_allclose(numpy.diff(place), 0.25)


def cube():
    """A grid of one cell, 0 to 1, with the linear field 1 + 2 x + 3 y + 4 z as pressure, a velocity of 0 and a displacement."""
    grid = vtk.vtkUnstructuredGrid()
    points, cell = vtk.vtkPoints(), vtk.vtkHexahedron()
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    for i, corner in enumerate(corners):
        cell.GetPointIds().SetId(i, points.InsertNextPoint(*corner))
    grid.SetPoints(points)
    grid.InsertNextCell(vtk.VTK_HEXAHEDRON, cell.GetPointIds())
    for name, values in (("pressure", [1 + 2 * x + 3 * y + 4 * z for x, y, z in corners]), ("velocity", numpy.zeros((8, 3))), ("displacement", numpy.ones((8, 3))),
                         ("wall_shear_stress", [(0, 0, 0)] * 4 + [(3, 4, 0)] * 4)):
        array = numpy_to_vtk(numpy.array(values, float), deep=True)
        array.SetName(name)
        grid.GetPointData().AddArray(array)
    return grid


def lattice(n, velocity, phase=lambda x, y, z: 0.0, bottom=0.0):
    """n x n x n cells of a cube, 0 to 1 (along z from `bottom`), with a velocity, a phase of each cell's middle and the values x + 2 z; each cell has points of its own."""
    grid, points = vtk.vtkUnstructuredGrid(), vtk.vtkPoints()
    vectors, phases, values = [], [], []
    for i, j, k in numpy.ndindex(n, n, n):
        cell = vtk.vtkHexahedron()
        for number, (a, b, c) in enumerate([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]):
            x, y, z = (i + a) / n, (j + b) / n, (k + c) / n
            cell.GetPointIds().SetId(number, points.InsertNextPoint(x, y, z + bottom))
            vectors.append(velocity(x, y, z))
            values.append(x + 2 * z)
            phases.append(phase((i + 0.5) / n, (j + 0.5) / n, (k + 0.5) / n))
        grid.InsertNextCell(vtk.VTK_HEXAHEDRON, cell.GetPointIds())
    grid.SetPoints(points)
    for name, array in (("velocity", vectors), ("phase", phases), ("shown", values)):
        array = numpy_to_vtk(numpy.array(array, float), deep=True)
        array.SetName(name)
        grid.GetPointData().AddArray(array)
    return grid


class Rendering(unittest.TestCase):
    def test_section(self):
        """The plane y = 0.25 in the coordinates x and z, with the field as it is there."""
        section = render_field.cut_plane(cube(), {"axis": 1, "at": 0.25})
        points = render_field.vtk_to_numpy(section.GetPoints().GetData())
        self.assertEqual(points[:, 2].max(), 0)
        values = render_field.vtk_to_numpy(section.GetPointData().GetArray("pressure"))
        numpy.testing.assert_allclose(values, 1.75 + 2 * points[:, 0] + 4 * points[:, 1], rtol=1e-6)
        with self.assertRaises(SystemExit):
            render_field.cut_plane(cube(), {"axis": 1, "at": 2.0})

    def test_field_of_a_solid_at_rest(self):
        self.assertEqual(render_field.values_of(cube(), None)[0], "displacement")

    def test_values_at_walls_alone(self):
        values = render_field.values_of(cube(), "wall_shear_stress")[2]
        self.assertTrue(numpy.isnan(values[:4]).all())
        numpy.testing.assert_allclose(values[4:], 5)

    def test_lines_of_the_mesh(self):
        lines = render_field.mesh_lines(cube())
        self.assertTrue(render_field.wants_lines(lines, 20, None, True))
        self.assertFalse(render_field.wants_lines(lines, 5, None, True))
        self.assertTrue(render_field.wants_lines(lines, 5, True, True))
        self.assertFalse(render_field.wants_lines(lines, 20, False, True))

        # Cells that the plane in the middle of a body cuts into pieces with fewer faces are no cells of the mesh.
        body = lattice(3, lambda x, y, z: (0.0, 0.0, 0.0), lambda x, y, z: float(x > 0.5), -0.5)
        points = render_field.vtk_to_numpy(body.GetPoints().GetData())
        points[:, 2] += 1.7 * points[:, 0] + 0.9 * points[:, 1]
        half, _ = render_field.open_up(body)
        types = [half.GetCellType(i) for i in range(half.GetNumberOfCells())]
        whole = render_field.whole_cells(half)
        self.assertLess(whole.GetNumberOfCells(), len(types))
        self.assertEqual([whole.GetCellType(i) for i in range(whole.GetNumberOfCells())], [vtk.VTK_HEXAHEDRON] * types.count(vtk.VTK_HEXAHEDRON))
        self.assertIs(render_field.whole_cells(body), body)
        # The twelve edges of the cube: no face is cut into triangles.
        self.assertEqual(render_field.mesh_lines(render_field.outside(cube())).GetNumberOfLines(), 12)

    def test_outline(self):
        """Of 4 x 4 squares, of which those with x > 0.5 are solid: 12 edges round each half."""
        grid, points, phases = vtk.vtkUnstructuredGrid(), vtk.vtkPoints(), []
        for i, j in numpy.ndindex(4, 4):
            cell = vtk.vtkQuad()
            for number, (a, b) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1))):
                cell.GetPointIds().SetId(number, points.InsertNextPoint((i + a) / 4, (j + b) / 4, 0))
                phases.append(float(i > 1))
            grid.InsertNextCell(vtk.VTK_QUAD, cell.GetPointIds())
        grid.SetPoints(points)
        array = numpy_to_vtk(numpy.array(phases), deep=True)
        array.SetName("phase")
        grid.GetPointData().AddArray(array)
        self.assertEqual(render_field.outline_of(grid).GetNumberOfLines(), 24)

    def test_streamlines(self):
        """A body that turns about the middle of each plane z: a line stays at its distance from the axis, and has the field that is there."""
        grid = lattice(6, lambda x, y, z: (0.5 - y, x - 0.5, 0.0))
        self.assertEqual(len(render_streamlines.seeds_in(grid, 10**6)), 216)
        self.assertTrue(20 <= len(render_streamlines.seeds_in(grid, 20)) <= 40)
        lines = render_streamlines.streamlines(grid, 20)
        self.assertGreaterEqual(lines.GetNumberOfCells(), 10)
        points, values = (render_field.vtk_to_numpy(data) for data in (lines.GetPoints().GetData(), lines.GetPointData().GetArray("shown")))
        numpy.testing.assert_allclose(values, points[:, 0] + 2 * points[:, 2], atol=1e-5)
        for i in range(lines.GetNumberOfCells()):
            ids = [lines.GetCell(i).GetPointIds().GetId(k) for k in range(lines.GetCell(i).GetPointIds().GetNumberOfIds())]
            distance = numpy.hypot(points[ids, 0] - 0.5, points[ids, 1] - 0.5)
            self.assertLess(numpy.ptp(distance), 0.02)
            self.assertLess(numpy.ptp(points[ids, 2]), 1e-6)
        heads = render_streamlines.arrow_heads(lines, 0.1)
        self.assertGreater(heads.GetNumberOfPolys(), 12 * 10)
        self.assertIsNone(render_streamlines.streamlines(lattice(2, lambda x, y, z: (0.0, 0.0, 0.0))))

    def test_streamlines_in_the_liquid(self):
        """The half x > 0.5 is solid: no line begins or ends there."""
        grid = lattice(6, lambda x, y, z: (0.0, 1.0, 0.0), lambda x, y, z: float(x > 0.5))
        points = render_field.vtk_to_numpy(render_streamlines.streamlines(grid, 50).GetPoints().GetData())
        self.assertLessEqual(points[:, 0].max(), 0.5)
        self.assertGreater(numpy.ptp(points[:, 1]), 0.95)
        # The surface of 3 x 6 x 6 cells: two triangles a face, no face between cells.
        self.assertEqual(render_field.surface(render_streamlines.glass_of(grid)).GetNumberOfPolys(), 2 * (2 * 36 + 4 * 18))

    def test_margins(self):
        """100 x 50 pixels of 2 m x 1 m, of which the columns 20 to 59 and the rows 10 to 29 show something."""
        extent = render_field.crop_of((0, 2, 0, 1), (50, 100), range(10, 30), range(20, 60))
        numpy.testing.assert_allclose(extent, (0.38, 1.22, 0.38, 0.82))


class Options(unittest.TestCase):
    def test_section(self):
        self.assertEqual(plot_choice.read_section("z = -2.5 mm"), {"axis": 2, "at": -0.0025})
        for wrong in ("x=20", "w=1mm", "x", "x=1..2mm"):
            with self.assertRaises(argparse.ArgumentTypeError):
                plot_choice.read_section(wrong)

    def test_size(self):
        self.assertEqual(plot_movie.read_size("1920x1080"), (1920, 1080))
        for wrong in ("1920", "1920x", "10x10", "1e3x100"):
            with self.assertRaises(argparse.ArgumentTypeError):
                plot_movie.read_size(wrong)
        frame = plot_movie.filled(plot_movie.PIL.Image.new("RGB", (60, 20), "black"), (100, 40))
        self.assertEqual((frame.size, frame.getpixel((19, 20)), frame.getpixel((20, 20))), ((100, 40), (255, 255, 255), (0, 0, 0)))

    def test_follow(self):
        """Drawn until the run has ended; a table that is being written is read the next time."""
        loader = importlib.machinery.SourceFileLoader("plot_script", os.path.join(SCRIPTS, "plot"))
        script = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
        loader.exec_module(script)
        states, drawn = iter(["running", "running", "finished"]), []

        def draw(arguments):
            drawn.append(arguments)
            if len(drawn) == 1:
                raise script.continua.ResultsError("probes.csv", "is being written")

        script.continua = types.SimpleNamespace(open=lambda folder: types.SimpleNamespace(status=next(states)), ResultsError=script.continua.ResultsError)
        script.draw, script.time = draw, types.SimpleNamespace(sleep=lambda seconds: None, monotonic=lambda: 0.0)
        script.follow(types.SimpleNamespace(folders=["folder"]))
        self.assertEqual(len(drawn), 2)


if __name__ == "__main__":
    unittest.main()
