#!/usr/bin/python3
"""Options of scripts/plot: which fields, regions and times; what is measured; many runs in one picture."""

import csv
import itertools
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import test_plot  # noqa: E402
from test_plot import SCRIPTS, plot, write  # noqa: E402

import plot_choice  # noqa: E402
import plot_field  # noqa: E402
import plot_histories  # noqa: E402
import plot_style  # noqa: E402
import plot_waves  # noqa: E402
import render_field  # noqa: E402

LENGTH, RADIUS = 0.1, 0.01
TIMES = (0.0, 0.01, 0.02, 0.03)


def wave(x, t):
    """A pressure [Pa] and a distension [m] that run along the tube at 2 m/s."""
    return 100 * math.sin(2 * math.pi * (x - 2 * t) / LENGTH), 1e-5 * math.sin(2 * math.pi * (x - 2 * t) / LENGTH)


def write_state(path, t):
    """An axisymmetric tube along x, liquid below the radius and wall above. The pressure in a section is p (1 + r^2/R^2 - 1/2), whose
    mean is p; the wall's pressure is 1000 times that of the axis."""
    grid, points = vtk.vtkUnstructuredGrid(), vtk.vtkPoints()
    data = {"phase": [], "material_id": [], "pressure": [], "displacement": [], "velocity": []}
    cells = []
    for solid, radii in ((0, numpy.linspace(0, RADIUS, 5)), (1, (RADIUS, 1.2 * RADIUS))):
        places = numpy.linspace(0, LENGTH, 41)
        for left, right in zip(places, places[1:]):
            for low, high in zip(radii, radii[1:]):
                corners = []
                for x, r in ((left, low), (right, low), (right, high), (left, high)):
                    corners.append(points.InsertNextPoint(x, r, 0))
                    pressure, distension = wave(x, t)
                    data["phase"].append(solid)
                    data["material_id"].append(solid)
                    data["pressure"].append(1000 * pressure if solid else pressure * (0.5 + (r / RADIUS)**2))
                    data["displacement"].append((0, distension / 2, 0) if solid else (0.02, 0, 0))
                    data["velocity"].append((t, 0, 0))
                cells.append(corners)
    grid.SetPoints(points)
    for corners in cells:
        grid.InsertNextCell(vtk.VTK_QUAD, 4, corners)
    for name, values in data.items():
        array = numpy_to_vtk(numpy.array(values, float), deep=True)
        array.SetName(name)
        grid.GetPointData().AddArray(array)
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetFileName(path)
    writer.SetInputData(grid)
    writer.Write()


def write_run(folder, times=TIMES, summary=None):
    os.makedirs(os.path.join(folder, "fields"))
    entries = ""
    for i, t in enumerate(times):
        write_state(os.path.join(folder, "fields", f"{i}.vtu"), t)
        entries += f'<DataSet timestep="{t}" part="0" file="fields/{i}.vtu"/>'
    write(os.path.join(folder, "fields.pvd"),
          f'<?xml version="1.0"?><VTKFile type="Collection"><Collection>{entries}</Collection></VTKFile>')
    write(os.path.join(folder, "probes.csv"),
          "time [s],axis: pressure [Pa],axis: velocity x [m/s]\n" + "".join(f"{t},{t},{2 * t}\n" for t in (*times, 0.035)))
    write(os.path.join(folder, "power.csv"), "time [s],strain [W],fluid: strain [W],wall: strain [W]\n0,1,2,3\n0.03,4,5,6\n")
    write(os.path.join(folder, "summary.json"), json.dumps(
        {"model": "axisymmetric", "analysis": "transient", "regions": ["fluid", "wall"],
         "field units": {"pressure": "Pa", "displacement": "m", "velocity": "m/s"}, **(summary or {})}))


class Run(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = os.path.join(self.temporary.name, "run")
        self.plots = os.path.join(self.folder, "plots")
        self.addCleanup(self.temporary.cleanup)

    def refused(self, message, *arguments):
        done = plot(self.folder, *arguments)
        self.assertEqual(done.returncode, 2, done.stderr + done.stdout)
        self.assertIn(message, done.stderr)
        self.assertFalse(os.path.exists(self.plots))


class Refused(Run):
    def test_names_and_times(self):
        write_run(self.folder)
        self.refused("--fields presure: there is no such field; there are pressure, velocity x, displacement, velocity", "--fields", "presure")
        self.refused("--region walls: there is no such region; there are fluid, wall", "--region", "fluid,walls")
        self.refused("--times 0.04 s: this is outside of the run, which goes from 0 s to 0.035 s", "--times", "10 ms,40 ms")
        self.refused("'-' is not a time", "--times", "-")
        self.refused("'5 mm' is not a time such as 0.2 s or 5 ms", "--times", "5 mm")
        self.refused("has an empty name", "--fields", "pressure,")
        self.refused("is not a number of frames", "--movie", "field", "--frames", "1")
        self.refused("is not a length such as 8", "--movie", "field", "--seconds", "0")
        self.refused("--times is for pictures", "--movie", "field", "--times", "1")
        self.refused("there are pressure and wall distension", "--movie", "waves", "--gif", "--fields", "velocity")
        self.refused("no state has velocity x; there are pressure", "--movie", "field", "--gif", "--fields", "velocity x")

    def test_unit_of_no_field(self):
        write_run(self.folder)
        done = plot(self.folder, "--units", "presure=kPa")
        self.assertEqual(done.returncode, 2)
        self.assertIn("no picture shows a field 'presure'", done.stderr)

    def test_damaged_list_of_states(self):
        write_run(self.folder)
        path = os.path.join(self.folder, "fields.pvd")
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
        for damaged in (text[:len(text) // 2], text.replace('timestep="0.01"', 'timestep="soon"')):
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(damaged)
            done = plot(self.folder, "--fields", "pressure")
            self.assertEqual(done.returncode, 1)
            self.assertIn("fields.pvd: cannot be read", done.stderr)
            self.assertNotIn("Traceback", done.stderr)

    def test_no_names_of_regions(self):
        write_run(self.folder, summary={"regions": []})
        self.refused("has no names of regions; give their numbers", "--region", "wall")

    def test_one_output_time(self):
        write_run(self.folder, (0.0,))
        self.refused("has one output time; a movie needs two or more", "--movie", "field", "--gif")

    def test_no_states(self):
        write(os.path.join(self.folder, "probes.csv"), "time [s],a: pressure [Pa]\n0,1\n1,2\n")
        self.refused("has no states of fields", "--movie", "field", "--gif")
        self.refused("has no states of fields", "--times", "1")
        self.refused("no run has states of a straight tube at two times or more, nor two stations", "--movie", "waves", "--gif")

    def test_modes(self):
        write_run(self.folder, (1.0, 2.0), {"analysis": "modal", "modes": ["mode 1, 3 Hz", "mode 2, 9 Hz"]})
        self.refused("--times 3: there are the modes 1 to 2", "--times", "3")
        self.refused("a modal analysis has shapes", "--movie", "field", "--gif")

    def test_no_ffmpeg(self):
        write_run(self.folder)
        empty = os.path.join(self.temporary.name, "bin")
        os.mkdir(empty)
        done = subprocess.run(["/usr/bin/python3", os.path.join(SCRIPTS, "plot"), self.folder, "--movie", "field"],
                              env={**os.environ, "PATH": empty}, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("--movie needs ffmpeg, which is not installed", done.stderr)


class Chosen(Run):
    def test_names(self):
        def of(*names):
            return plot_choice.Choice(list(names)).fields_of(["pressure", "axis pressure", "stress_xx", "stress_yy", "velocity x"])
        self.assertEqual(of("pressure"), ["pressure"])
        self.assertEqual(of("Stress"), ["stress_xx", "stress_yy"])
        self.assertEqual(of("stress yy", "velocity", "pressure"), ["stress_yy", "velocity x", "pressure"])
        self.assertEqual(of("flow"), [])

    def test_times(self):
        self.assertEqual(plot_style.read_times("0.2 s, 5 ms,1"), [0.2, 0.005, 1])
        run = {"summary": {}}
        self.assertEqual(plot_field.caption(run, 0.02, 0.02), "t = 0.02 s")
        self.assertEqual(plot_field.caption(run, 0.02, None), "t = 0.02 s")
        self.assertEqual(plot_field.caption(run, 0.02, 0.0236), "t = 0.02 s (the output nearest to 0.0236 s)")
        self.assertEqual(plot_choice.nearest([(0.0, "a"), (0.01, "b"), (0.02, "c")], 0.0149)[1], "b")

    def test_files(self):
        write_run(self.folder)
        done = plot(self.folder, "--fields", "pressure,displacement", "--times", "10 ms,0.021", "--region", "wall")
        self.assertEqual(done.returncode, 0, done.stderr)
        there = {name for name in os.listdir(self.plots) if name.endswith(".svg")}
        self.assertEqual(there, {"history-pressure.svg", "power.svg", *(f"field-{field}-{time}-s.svg" for field in
                                 ("pressure", "displacement") for time in ("0.01", "0.02"))})
        with open(os.path.join(self.plots, "field-pressure-0.02-s.svg"), encoding="utf-8") as stream:
            text = stream.read()
        self.assertIn("t = 0.02 s (the output nearest to 0.021 s), region wall, displacement × 500", text)
        # Of the wall alone, which has 1000 times the pressure of the liquid.
        self.assertIn("Pressure [kPa]", text)
        self.assertNotIn("liquid", text)
        # Of the power the wall's part alone.
        with open(os.path.join(self.plots, "power.csv"), encoding="utf-8") as stream:
            self.assertEqual(next(csv.reader(stream)), ["wall: strain: time [s]", "wall: strain [W]"])

    def test_region_of_a_state(self):
        write_run(self.folder, (0.005,))
        grid = render_field.read([os.path.join(self.folder, "fields", "0.vtu")])
        for regions, radii in (([0], (0, RADIUS)), ([1], (RADIUS, 1.2 * RADIUS)), ([0, 1], (0, 1.2 * RADIUS)), (None, (0, 1.2 * RADIUS))):
            bounds = render_field.only(grid, regions).GetBounds()
            self.assertAlmostEqual(bounds[2], radii[0], delta=1e-9)
            self.assertAlmostEqual(bounds[3], radii[1], delta=1e-9)


class Several(unittest.TestCase):
    def test_styles(self):
        """Eight runs differ in colour; and in grey, where colours look alike, in dash and marker."""
        styles = [plot_style.of_run(i, 1000) for i in range(8)]
        for one, other in itertools.combinations(styles, 2):
            self.assertNotEqual(one["color"], other["color"])
            self.assertNotEqual(one["linestyle"], other["linestyle"])
            self.assertNotEqual(one.get("marker"), other.get("marker"))

    def test_eight_runs(self):
        """A panel for each probe with all runs in it, every run once in the legend, no text cut."""
        with tempfile.TemporaryDirectory() as folder:
            plots = os.path.join(folder, "plots")
            os.mkdir(plots)
            names = [f"probe {i}" for i in range(5)]
            write(os.path.join(folder, "probes.csv"), "time [s]," + ",".join(f"{name}: pressure [Pa]" for name in names) + "\n" + "".join(
                f"{t}," + ",".join(str(t * i) for i in range(5)) + "\n" for t in range(20)))
            write(os.path.join(folder, "power.csv"), "time [s],kinetic [W],loads [W],residual [W]\n0,1,2,0\n1,2,3,1e-9\n")
            runs = [{"folder": folder, "title": f"Young's modulus {i} MPa", "summary": {}} for i in range(8)]
            for width in (160, 85):
                sheet = test_plot.Looks.Sheet(plots, width / 25.4)
                plot_histories.draw_probes(sheet, runs)
                plot_histories.draw_power(sheet, runs)
                self.assertEqual(sheet.outside, [], width)
                for figure in ("history-pressure", "power"):
                    self.assertEqual(sheet.legends[figure], [run["title"] for run in runs])
                self.assertEqual([title for title, lines in sheet.panels["history-pressure"] if lines == 8], names)
                self.assertEqual([lines for _, lines in sheet.panels["power"]], [8, 8, 8])

    def test_every_probe_is_drawn(self):
        with tempfile.TemporaryDirectory() as folder:
            plots = os.path.join(folder, "plots")
            os.mkdir(plots)
            write(os.path.join(folder, "probes.csv"), "time [s],a: pressure [Pa],b: pressure [Pa],c: pressure [Pa]\n0,1,2,3\n1,2,3,4\n")
            sheet = test_plot.Looks.Sheet(plots, 6)
            plot_histories.draw_probes(sheet, [{"folder": folder, "title": "run", "summary": {}}])
            self.assertEqual(sheet.legends["history-pressure"], ["a", "b", "c"])
            self.assertEqual([lines for _, lines in sheet.panels["history-pressure"]], [3])


class Measured(unittest.TestCase):
    def test_differences(self):
        """Simulated is the measured curve and 3 sin(t): the panel below has that, and says 3."""
        with tempfile.TemporaryDirectory() as folder:
            plots = os.path.join(folder, "plots")
            os.mkdir(plots)
            time = numpy.linspace(0, 2 * math.pi, 201)
            rows = "".join(f"{t!r},{50 * t + 3 * math.sin(t)!r},{50 * t!r},{t!r}\n" for t in time.tolist())
            write(os.path.join(folder, "wave.csv"), 'time [s],"tube 0 m: pressure, simulated [Pa]","tube 0 m: pressure, measured [Pa]",'
                  '"tube 0 m: flow rate, simulated [m^3/s]"\n' + rows)
            sheet = test_plot.Looks.Sheet(plots, 6)
            plot_waves.draw(sheet, [{"folder": folder, "title": "run", "summary": {}}], False)
            titles = [title for title, _ in sheet.panels["wave-pressure"]]
            self.assertEqual(titles, ["", "Simulated − measured: at most 3 Pa"])
            self.assertEqual(len(sheet.panels["wave-flow-rate"]), 1)
            self.assertEqual(sheet.outside, [])
            with open(os.path.join(plots, "wave-pressure.csv"), encoding="utf-8", newline="") as stream:
                header, *data = list(csv.reader(stream))
            column = header.index("0 m: pressure, simulated - measured [Pa]")
            self.assertTrue(numpy.allclose([float(row[column]) for row in data], 3 * numpy.sin(time), atol=1e-9))


if __name__ == "__main__":
    unittest.main()
