#!/usr/bin/python3
"""The Python package continua on results of the program: numbers beside closed formulas, how runs end, studies. The program is that of
the environment variable CONTINUA_PROGRAM."""

import csv
import fcntl
import math
import os
import pickle
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
import warnings

import numpy

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "python"))
import continua  # noqa: E402
from continua import program as program_module  # noqa: E402

CASES = os.path.join(ROOT, "tests", "tiny_runs")
SHEAR = os.path.join(CASES, "wall_shear_over_time.prm")
PATCH = os.path.join(CASES, "patch_plane_strain.prm")
STEP = 0.0078125  # s, of SHEAR


def plate(time):
    """Velocity of the upper plate of SHEAR [m/s]; the stress on the lower one is 20 Pa s/m times it."""
    return 0.5 + numpy.sin(2 * math.pi * time)


class WithFolder(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name
        warnings.simplefilter("error")  # none of these runs may give a warning that is not expected
        # xarray imports it where python3-sparse is installed.
        warnings.filterwarnings("ignore", category=DeprecationWarning, module=r"llvmlite\.")

    def path(self, name):
        return os.path.join(self.folder, name)

    def assert_raises(self, error, text, function, *arguments, **options):
        with self.assertRaises(error) as caught:
            function(*arguments, **options)
        self.assertIn(text, str(caught.exception))
        return caught.exception


class Tables(WithFolder):
    def test_history(self):
        run = continua.run(SHEAR, {"Time/End time": "1.25 s"}, output=self.path("run"))
        self.assertEqual((run.status, run.reason, run.missing_runs), ("finished", "", []))
        stress = run.probes["bottom: wall shear stress x"]
        self.assertEqual(len(stress), 161)
        self.assertLess(abs(stress.index - STEP * numpy.arange(161)).max(), 1e-12)
        # The first row is the state at rest.
        self.assertLess(abs(stress.iloc[1:] - 20 * plate(stress.index[1:])).max(), 1e-6)
        units = run.probes.attrs["units"]
        self.assertEqual((units["bottom: wall shear stress x"], units["middle: vorticity z"], units["bottom: oscillatory shear index"],
                          units["time"]), ("Pa", "1/s", "1", "s"))
        # A pressure of 0 Pa at both ends: the plate alone does work, its force times its velocity. 20 mm of it are there.
        external = run.power["external"]
        self.assertLess(abs(external - 0.02 * 20 * plate(external.index)**2).max(), 1e-6)
        self.assertEqual(run.power.attrs["units"]["work of loads"], "J")
        self.assertEqual(run.summary["title"], "Wall shear stress over time")
        self.assertAlmostEqual(run.quantity("maximum wall shear stress x", "bottom: wall shear stress x"), 30, delta=1e-5)
        self.assertEqual(run.tables, ["power", "probes"])

    def test_steady(self):
        run = continua.run(os.path.join(CASES, "force_of_a_weight.prm"), output=self.path("run"))
        weight = 1000 * 10 * 2  # of 2 m^3
        self.assertAlmostEqual(run.quantity("final force y", "ground: force y"), -weight, delta=1e-6)
        self.assertEqual(run.probes.shape, (1, 3))
        self.assertAlmostEqual(run.probes["ground: force y"].iloc[0], -weight, delta=1e-6)
        check = run.checks[run.checks["name"] == "final force y"].iloc[0]
        self.assertEqual((check["probe"], check["unit"], check["passed"]), ("ground: force y", "kN", True))
        self.assertAlmostEqual(check["value"], -20, delta=1e-9)
        self.assertEqual(run.quantities.set_index(["probe", "name"]).loc[("ground: force y", "final force y"), "unit"], "N")

    def test_waves(self):
        case = os.path.join(ROOT, "parameter_files", "examples", "own-tube.prm")
        run = continua.run(case, {"Analysis": "linear wave theory", "Wave theory/Level": "womersley", "Time/End time": "40 ms"},
                           output=self.path("run"))
        waves = run.waves["stations"]
        pressure = waves["pressure"]
        self.assertEqual(pressure.dims, ("source", "position", "time"))
        self.assertEqual(pressure["position"].to_numpy().tolist(), [0.1, 0.3, 0.5, 0.7])
        self.assertEqual((pressure.attrs["units"], waves["flow rate"].attrs["units"]), ("Pa", "m^3/s"))
        # What was "measured" is another file, in mmHg, and not at 0.7 m; flow rates were not.
        with open(os.path.join(ROOT, "parameter_files", "examples", "stations.csv"), encoding="utf-8") as stream:
            rows = [line.split(",") for line in stream if line[0].isdigit()]
        measured = pressure.sel(source="measured")
        for row in rows[:20]:
            at = measured.sel(time=1e-3 * float(row[0]), method="nearest", tolerance=1e-9)
            self.assertLess(abs(at.sel(position=[0.1, 0.3, 0.5]) - 133.322387415 * numpy.array(row[1:4], float)).max(), 1e-6)
        self.assertTrue(measured.sel(position=0.7).isnull().all())
        self.assertTrue(waves["flow rate"].sel(source="measured").isnull().all())
        # A pressure pulse that rises from its 80 mmHg to 120 mmHg at the inlet.
        self.assertTrue(30 < pressure.sel(source="theory", position=0.1).max() / 133.322387415 < 40)

    def test_digits(self):
        """All digits of a file: numbers are those that Python reads."""
        texts = ["0.1", "0.30000000000000004", "5e-324", "1.7976931348623157e+308", "123456789.12345679", "2.2250738585072011e-308", "-0"]
        with open(self.path("probes.csv"), "w", encoding="utf-8") as stream:
            stream.write('time [s],"a, b: pressure [Pa]",\'-x: pressure [N/m^2]\n')
            stream.writelines(f"{text},nan,{text}\n" for text in texts)
        frame = continua.open(self.folder).table("probes")
        self.assertEqual(list(frame), ["time", "a, b: pressure", "-x: pressure"])
        self.assertEqual(frame.attrs["units"]["-x: pressure"], "N/m^2")
        for text, value in zip(texts, frame["-x: pressure"]):
            self.assertEqual(repr(float(text)), repr(value))
        self.assertTrue(frame["a, b: pressure"].isna().all())


class Fields(WithFolder):
    """The exact solution of the patch test stands in its file, in polynomials."""

    def check(self, ranks):
        run = continua.run(PATCH, {"Output/Field interval": "0.5 s"}, output=self.path("run"), ranks=ranks)
        fields = run.fields
        self.assertEqual(fields.times.tolist(), [0, 0.5, 1])
        self.assertEqual(len(fields), 3)
        self.assertEqual(fields.nearest(0.7).time, 0.5)
        self.assert_raises(continua.ResultsError, "there is no state at 0.7 s; the nearest of the 3 states is at 0.5 s", fields.at, 0.7)
        state = fields.at(0.5)
        self.assertEqual(len(state.files), ranks)
        data, t = state.dataset, 0.5
        x, y = data["x"].to_numpy().astype(float), data["y"].to_numpy().astype(float)
        exact = {"velocity": numpy.stack([t * x**2 / 100 + t * x * y / 100, -t * x * y / 50 + t * x / 100 + t * y**2 / 100, 0 * x], axis=1),
                 "displacement": numpy.stack([t**2 * x**2 / 200 + t**2 * x * y / 200,
                                              -t**2 * x * y / 100 + t**2 * x / 200 + t**2 * y**2 / 200, 0 * x], axis=1),
                 "pressure": -65 * t**2 * y / 2,
                 "stress_xy": 5 * t**2 * x - 10 * t**2 * y + 5 * t**2 + t * x - 2 * t * y + t}
        for name, values in exact.items():
            self.assertEqual(data[name].shape, values.shape)
            # Files are in single precision.
            self.assertLess(abs(data[name] - values).max(), 2e-6 * abs(values).max(), name)
        self.assertEqual([data[name].attrs["units"] for name in ("velocity", "displacement", "pressure", "stress_xy", "x", "phase")],
                         ["m/s", "m", "Pa", "Pa", "m", "1"])
        self.assertEqual(data.attrs["time"], 0.5)
        # Nine cells of 2 x 2 in the file, which fill the square.
        corners = data["cells"].to_numpy()
        self.assertEqual(corners.shape, (36, 4))
        px, py = x[corners], y[corners]
        areas = 0.5 * ((px[:, 0] - px[:, 2]) * (py[:, 1] - py[:, 3]) - (px[:, 1] - px[:, 3]) * (py[:, 0] - py[:, 2]))
        self.assertTrue((areas > 0).all())
        self.assertAlmostEqual(areas.sum(), 1, delta=1e-6)
        self.assertEqual(state.grid.GetNumberOfCells(), 36)
        self.assertLess(abs(numpy.array(state.grid.GetBounds()) - [0, 1, 0, 1, 0, 0]).max(), 1e-7)
        self.assertEqual([other.time for other in fields[1:]], [0.5, 1])
        return run

    def test_one_rank(self):
        run = self.check(1)
        # What is damaged is said, and the other states can still be read.
        file = run.fields[1].files[0]
        with open(file, "rb") as stream:
            whole = stream.read()
        for length in (0, 100, len(whole) // 2, len(whole) - 40):
            with open(file, "wb") as stream:
                stream.write(whole[:length])
            error = self.assert_raises(continua.ResultsError, "VTK cannot read it", lambda: continua.open(run.folder).fields[1].grid)
            self.assertEqual(error.path, file)
        place = whole.index(b'Name="stress_xx"') + 200
        with open(file, "wb") as stream:
            stream.write(whole[:place] + b"AAAAAAAA" + whole[place + 8:])
        self.assert_raises(continua.ResultsError, "VTK cannot read it", lambda: continua.open(run.folder).fields[1].dataset)
        os.remove(file)
        self.assert_raises(continua.ResultsError, "the file is missing", lambda: continua.open(run.folder).fields[1].dataset)
        self.assertEqual(continua.open(run.folder).fields[2].dataset.attrs["time"], 1)
        with open(os.path.join(run.folder, "fields.pvd"), "r+", encoding="utf-8") as stream:
            stream.truncate(120)
        self.assert_raises(continua.ResultsError, "fields.pvd: cannot be read", lambda: continua.open(run.folder).fields)
        os.remove(os.path.join(run.folder, "fields.pvd"))
        self.assert_raises(continua.ResultsError, "the run wrote no fields.pvd. Set Output", lambda: continua.open(run.folder).fields)

    def test_two_ranks(self):
        run = self.check(2)
        os.remove(os.path.join(run.folder, "fields", "solution-00001.1.vtu"))
        self.assert_raises(continua.ResultsError, "solution-00001.1.vtu: the file is missing", lambda: run.fields[1].dataset)


class Studies(WithFolder):
    def test_comparison(self):
        study = continua.run(PATCH, {"Analysis": "comparison", "Comparison/Meshes": [0, 1], "Comparison/Refine the time step": False},
                             output=self.path("study"))
        self.assertEqual(list(study.runs), ["taylor-hood-0", "cell-wise-0", "taylor-hood-1", "cell-wise-1"])
        runs = study.table("runs").set_index("run")
        self.assertEqual(runs["cells"].to_dict(), {"taylor-hood-0": 9, "cell-wise-0": 9, "taylor-hood-1": 36, "cell-wise-1": 36})
        # The elements hold the solution, and dissipate the integral over the square and over the steps of
        # 2 eta e:e, which is for e.g. v = t (...) a sum of t^2: found by the midpoint rule, which is exact for polynomials on this grid.
        n = 400
        x, y = numpy.meshgrid((numpy.arange(n) + 0.5) / n, (numpy.arange(n) + 0.5) / n)
        xx, yy, xy = (2 * x + y) / 100, (2 * y - 2 * x) / 100, 0.5 * (x / 100 + (1 - 2 * y) / 100)
        mean = (xx + yy) / 3
        square = (xx - mean)**2 + (yy - mean)**2 + mean**2 + 2 * xy**2
        steps = sum(0.25 * (0.25 * step)**2 for step in range(1, 5))
        dissipated = 2 * 100 * square.mean() * steps
        self.assertAlmostEqual(study.runs["taylor-hood-1"].quantity("energy dissipated", "body") / dissipated, 1, delta=1e-5)
        table = study.table("comparison").set_index("quantity")
        row = table.loc["body: energy dissipated [J]"]
        self.assertAlmostEqual(row["taylor hood, mesh 1"] / dissipated, 1, delta=1e-5)
        self.assertEqual((row["taylor hood, sequence"], row["verdict"]), ("settled", "agree"))
        self.assertTrue(numpy.isnan(row["taylor hood, order"]))
        self.assertIn("cell-wise-1", str(study))
        os.rename(self.path("study/cell-wise-1"), self.path("elsewhere"))
        study = continua.open(self.path("study"))
        self.assertEqual((list(study.runs)[-1], study.missing_runs), ("taylor-hood-1", ["cell-wise-1"]))
        self.assertIn("runs that are not there: cell-wise-1", str(study))


class Ends(WithFolder):
    def test_wrong_input(self):
        sets = {"Mesh/Cels": [3, 2.5], "Output/Final fields": True, "Time/End time": "2 s", "Time/Time step": numpy.float64(1e-5)}
        error = self.assert_raises(continua.RunFailed, "Mesh/Cels': unknown entry. Did you mean 'Cells'?", continua.run, SHEAR, sets,
                                   output=self.path("run"))
        self.assertEqual((error.status, error.output), (2, self.path("run")))
        self.assertEqual(error.command[2:], ["--set", "Mesh/Cels=3, 2.5", "--set", "Output/Final fields=true", "--set", "Time/End time=2 s",
                                             "--set", "Time/Time step=1e-05", "--output", self.path("run")])
        self.assertEqual(str(pickle.loads(pickle.dumps(error))), str(error))
        self.assert_raises(continua.ResultsError, "there is no such folder", continua.open, self.path("run"))
        # The same words of several ranks, without those of MPI.
        several = self.assert_raises(continua.RunFailed, "unknown entry", continua.run, SHEAR, sets, output=self.path("run"), ranks=2)
        self.assertEqual((several.status, several.message), (2, error.message))
        self.assert_raises(continua.RunFailed, "does not exist", continua.run, self.path("none.prm"))
        self.assert_raises(TypeError, "the value None of 'Mesh/Cells'", continua.run, SHEAR, {"Mesh/Cells": None})
        self.assert_raises(TypeError, 'sets is a list; it needs a dictionary such as {"Time/End time": "1 s"}', continua.run, SHEAR,
                           ["Mesh/Cells=4"])
        self.assert_raises(ValueError, "ranks is 0", continua.run, SHEAR, ranks=0)
        self.assert_raises(continua.ProgramNotFound, "/nowhere/continua is no program", continua.run, SHEAR, program="/nowhere/continua")

    def test_failed(self):
        # sin(2 pi/8) + 0.5 is more than 1.2; the sixteenth step brings it.
        sets = {"Time/Velocity limit": "1.2 m/s"}
        error = self.assert_raises(continua.RunFailed, "the run diverges", continua.run, SHEAR, sets, output=self.path("run"))
        self.assertEqual(error.status, 1)
        self.assertIn("t = 0.125 s is 1.20711 m/s", error.message)
        run = continua.open(error.output)
        self.assertEqual(run.status, "failed")
        self.assertIn("1.20711 m/s", run.reason)
        self.assertAlmostEqual(run.probes.index[-1], 15 * STEP, delta=1e-12)
        stress = run.probes["bottom: wall shear stress x"].iloc[1:]
        self.assertLess(abs(stress - 20 * plate(stress.index)).max(), 1e-6)
        self.assert_raises(continua.ResultsError, "no wave.csv; the run failed. The run diverges", lambda: run.waves)
        # A folder that holds a run is refused, and taken when this is asked for.
        self.assert_raises(continua.RunFailed, "In Python these are overwrite=True", continua.run, SHEAR, output=self.path("run"))
        self.assertEqual(continua.run(SHEAR, {"Time/End time": "0.6 s"}, output=self.path("run"), overwrite=True).status, "finished")

    def start_long_run(self, *options, longer_than=2000):
        process = subprocess.Popen([program_module.find_program(), SHEAR, "--set", "Time/End time=100 s", "--output", self.path("run"), *options],
                                   env=program_module.environment(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        table = self.path("run/probes.csv")
        end = time.monotonic() + 120
        while not os.path.exists(table) or os.path.getsize(table) < longer_than:
            self.assertTrue(process.poll() is None and time.monotonic() < end, "the run writes no table")
            time.sleep(0.05)
        return process

    def test_running_and_killed(self):
        process = self.start_long_run()
        run = continua.open(self.path("run"))
        self.assertEqual(run.status, "running")
        self.assertIn(f"process {process.pid} on ", run.reason)
        self.assert_raises(continua.ResultsError, "there is no summary.json; the run is still running. Process", lambda: run.summary)
        process.kill()
        process.wait()
        run = continua.open(self.path("run"))
        self.assertEqual(run.status, "killed")
        self.assert_raises(continua.ResultsError, f"there is no summary.json; the run was killed. Process {process.pid} on ",
                           lambda: run.summary)
        os.remove(self.path("run/lock"))  # as in a copy
        self.assert_raises(continua.ResultsError, "there is no summary.json; the run was killed. There is no summary, and no process",
                           lambda: run.summary)
        self.assertIn("no summary", str(run))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # the last line may be cut
            stress = run.probes["bottom: wall shear stress x"]
        self.assertLess(abs(stress.iloc[1:] - 20 * plate(stress.index[1:])).max(), 1e-6)

    def test_killed_after_a_restart(self):
        """The summary of the interrupted part stays in the folder of the killed run."""
        def press(line):
            if line.startswith("t ="):
                raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            continua.run(SHEAR, {"Time/End time": "100 s"}, output=self.path("run"), progress=press)
        reached = os.path.getsize(self.path("run/probes.csv"))
        process = self.start_long_run("--restart", longer_than=reached + 2000)
        process.kill()
        process.wait()
        with self.assertWarnsRegex(continua.ContinuaWarning, "of an earlier part of the run"):
            run = continua.open(self.path("run"))
        self.assertEqual(run.status, "killed")
        self.assertIn(f"process {process.pid} on ", run.reason)

    def test_keyboard(self):
        """The run ends by itself, with its summary and a checkpoint, and goes on later."""
        def press(line):
            if line.startswith("t ="):
                raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            continua.run(SHEAR, {"Time/End time": "20 s"}, output=self.path("run"), progress=press)
        run = continua.open(self.path("run"))
        self.assertEqual(run.status, "interrupted")
        self.assertIn("SIGINT", run.reason)
        reached = run.probes.index[-1]
        self.assertLess(reached, 20)
        end = STEP * (round(reached / STEP) + 4)
        run = continua.run(SHEAR, {"Time/End time": f"{end} s"}, output=self.path("run"), restart=True)
        self.assertEqual(run.status, "finished")
        self.assertAlmostEqual(run.probes.index[-1], end, delta=1e-9)

    def test_signal(self):
        script = self.path("program")
        with open(script, "w", encoding="utf-8") as stream:
            stream.write("#!/bin/sh\necho begins\nkill -SEGV $$\n")
        os.chmod(script, 0o755)
        shown = []
        error = self.assert_raises(continua.RunFailed, "ended by the signal SIGSEGV", continua.run, SHEAR, program=script,
                                   output=self.path("run"), progress=shown.append)
        self.assertEqual((error.status, shown, error.text), (-signal.SIGSEGV, ["begins"], "begins\n"))

    def test_find_program(self):
        usual = os.environ["CONTINUA_PROGRAM"]
        self.addCleanup(os.environ.update, {"CONTINUA_PROGRAM": usual})
        self.assertEqual(continua.find_program(), os.path.abspath(usual))
        os.environ["CONTINUA_PROGRAM"] = self.path("none")
        self.assert_raises(continua.ProgramNotFound, "CONTINUA_PROGRAM", continua.find_program)


class Damaged(WithFolder):
    """Folders and tables that are not, or not wholly, what a run writes."""

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8", newline="") as stream:
            stream.write(text)

    def test_folders(self):
        self.assert_raises(continua.ResultsError, "none of the files that a run of Continua writes", continua.open, self.folder)
        self.write("case.prm", "set Title = x\n")
        self.assert_raises(continua.ResultsError, "this is a file, no folder. Give the folder of the results, or run it", continua.open,
                           self.path("case.prm"))
        os.makedirs(self.path("beam"))
        self.write("beam/parameters.prm", "")
        self.assert_raises(continua.ResultsError, "There are results in the folders beam in it", continua.open, self.folder)
        self.assertEqual(continua.open(self.path("beam")).status, "killed")
        self.assert_raises(continua.ResultsError, "there is no probes.csv; the run was killed", lambda: continua.open(self.path("beam")).probes)

    def test_other_version(self):
        self.write("summary.json", '{"version": "0.0.1", "status": "finished"}')
        with self.assertWarnsRegex(continua.ContinuaWarning, f"Continua 0.0.1 wrote these results, and this package belongs to Continua "
                                                             f"{continua.__version__}"):
            run = continua.open(self.folder)
        self.assertEqual(run.status, "finished")
        self.write("summary.json", '{"results": 1}')
        with self.assertWarnsRegex(continua.ContinuaWarning, "does not name the version"):
            continua.open(self.folder)
        with open(os.path.join(ROOT, "VERSION"), encoding="utf-8") as stream:
            self.assertEqual(continua.__version__, stream.read().strip())

    def test_summary(self):
        self.write("summary.json", '{"version": "' + continua.__version__ + '", "quant')
        self.assert_raises(continua.ResultsError, "summary.json: cannot be read", continua.open, self.folder)
        self.write("summary.json", "[]")
        self.assert_raises(continua.ResultsError, "this is no summary of Continua", continua.open, self.folder)
        self.write("summary.json", '{"version": "' + continua.__version__ + '", "status": "finished", "quantities": [{"name": "a", "value": 1, '
                   '"unit": "m", "probe": "one"}, {"name": "a", "value": null, "unit": "m", "probe": "two"}]}')
        run = continua.open(self.folder)
        self.assertTrue(math.isnan(run.quantity("a", "two")))
        self.assert_raises(continua.ResultsError, "several probes have 'a': 'one', 'two'", run.quantity, "a")
        self.assert_raises(continua.ResultsError, "no quantity 'b'. There are a", run.quantity, "b")
        self.assert_raises(continua.ResultsError, "There are the probes 'one', 'two'", run.quantity, "a", "three")
        self.assert_raises(continua.ResultsError, "the run wrote no probes.csv. The parameter file has no section Probes", lambda: run.probes)

    def test_damaged_files(self):
        """Whatever is damaged, the error names the file and what is wrong with it."""
        start = '{"version": "' + continua.__version__ + '", '
        for summary, wrong in ((start + '"quantities": 1}', "'quantities' is no list"), (start + '"quantities": [{"value": 1}]}', "entry 0 of"),
                               (start + '"quantities": [{"name": "a"}]}', "'value' of 'a' in 'quantities' is neither a number nor null"),
                               (start + '"checks": [{"name": "a", "value": "1"}]}', "'value' of 'a' in 'checks'"),
                               (start + '"status": 1}', "'status' is no text")):
            self.write("summary.json", summary)
            self.assert_raises(continua.ResultsError, wrong, lambda: continua.open(self.folder).quantities)
        self.write("summary.json", start + '"status": "finished"}')
        for name, content, wrong, ask in (
                ("other-files.txt", b"\xff/\n", "cannot be read", lambda run: run.runs),
                ("probes.csv", b"t [s],a [m]\n0,1\n", "no column 'time'", lambda run: run.probes),
                ("wave.csv", b"time [s],tube - m: pressure; theory [Pa]\n0,1\n", None, lambda run: run.waves),
                ("fields.pvd", b"<VTKFile><Collection><DataSet timestep='0' file='a.pvtu'/></Collection></VTKFile>", "a.pvtu: lists no files",
                 lambda run: run.fields[0].dataset)):
            with open(self.path(name), "wb") as stream:
                stream.write(content)
            if name == "fields.pvd":
                self.write("a.pvtu", "<VTKFile><Piece/></VTKFile>")
            if wrong:
                self.assert_raises(continua.ResultsError, wrong, ask, continua.open(self.folder))
            else:
                self.assertRaises(continua.ResultsError, ask, continua.open(self.folder))
            os.remove(self.path(name))
        for name, ask in (("log.txt", lambda run: run.log), ("power.csv", lambda run: run.power), ("other-files.txt", lambda run: run.runs)):
            os.mkdir(self.path(name))
            self.assert_raises(continua.ResultsError, f"{name}: cannot be read", ask, continua.open(self.folder))
            if name.endswith(".csv"):
                self.assertIn("table power: cannot be read", str(continua.open(self.folder)))
            os.rmdir(self.path(name))

    def test_lock(self):
        """A lock of a process that is there and has it, of one that is there and has none, of one that is not, of another machine."""
        self.write("summary.json", '{"version": "' + continua.__version__ + '", "status": "interrupted", "interruption": "by a test"}')
        run = continua.open(self.folder)
        own, other = f"Continua: process {os.getpid()} on {socket.gethostname()} since today\n", "Continua: process 1 on elsewhere since today\n"
        self.assertEqual((run.status, run.reason), ("interrupted", "by a test"))
        # A restart of it that was killed.
        self.write("lock", own)
        self.assertEqual(run.status, "killed")
        self.assertIn(own[10:-1] + " left its lock", run.reason)
        with self.assertWarnsRegex(continua.ContinuaWarning, "summary.json is of an earlier part of the run: process .* was killed"):
            self.assertEqual(continua.open(self.folder).summary["status"], "interrupted")
        with open(self.path("lock"), encoding="utf-8") as stream:
            fcntl.flock(stream, fcntl.LOCK_EX)
            self.assertEqual((run.status, run.reason), ("running", own[10:-1] + " works in the folder"))
            with self.assertWarnsRegex(continua.ContinuaWarning, "summary.json is of an earlier part of the run"):
                self.assertEqual(continua.open(self.folder).summary["status"], "interrupted")
        self.write("lock", own.replace(str(os.getpid()), "4194305"))  # above the largest number there can be
        self.assertEqual(run.status, "killed")
        self.write("lock", other)
        self.assertEqual(run.status, "running")
        self.assertIn("process 1 on elsewhere since today (another machine: whether it still runs cannot be seen from here)", run.reason)
        self.write("lock", "something else\n")
        self.assertEqual(run.status, "interrupted")

    def test_lazy(self):
        """A folder is opened without reading what is in it, and without the packages that read it."""
        for name in ("probes.csv", "wave.csv", "fields.pvd"):
            self.write(name, "")
        code = ("import sys, continua; run = continua.open(sys.argv[1]); run.status; run.tables; "
                "print([name for name in ('pandas', 'xarray', 'vtkmodules', 'numpy') if name in sys.modules])")
        done = subprocess.run([sys.executable, "-B", "-c", code, self.folder], env={**os.environ, "PYTHONPATH": os.path.join(ROOT, "python")},
                              capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout, "[]\n")
        error = self.assert_raises(continua.ResultsError, "wave.csv: the table is empty", lambda: continua.open(self.folder).waves)
        self.assertEqual(str(pickle.loads(pickle.dumps(error))), str(error))

    def test_tables(self):
        header = "time [s],tip: pressure [Pa],tip: velocity x [m/s]\n"
        for text, wrong in (("", "probes.csv: the table is empty"), (header[:20], "the first line is cut short"),
                            (header + "0,1,2\n1,2\n2,3,4\n", "probes.csv:3: the line has 2 cells, the first line has 3"),
                            (header + "0,1,2\n1,2,3,4\n2,3,4\n", "probes.csv:3: the line has 4 cells"),
                            # As many commas as there should be.
                            (header + "0,1,2\n1,2,3,4\n2,3\n", "probes.csv:3: the line has 4 cells"),
                            (header + "0,1\n1,2,3,4\n", "probes.csv:2: the line has 2 cells"),
                            (header + "0,1,2,3\n1,2,3,4\n", "probes.csv:2: the line has 4 cells"),
                            ("time [s]\n0\n\n1\n", "probes.csv:3: '' in the column 'time' is no number"),
                            (header + "0,1,2\n1,,3\n", "probes.csv:3: '' in the column 'tip: pressure' is no number"),
                            (header + "0,1,2\n1,2,three\n", "probes.csv:3: 'three' in the column 'tip: velocity x' is no number"),
                            (header + "\n0,1,2\n", "probes.csv:2: the line has 1 cells"),
                            ("time [s],a [m],a [m/s]\n", "two columns have the name 'a'")):
            self.write("probes.csv", text)
            self.assert_raises(continua.ResultsError, wrong, lambda: continua.open(self.folder).probes)
        self.write("probes.csv", header)
        self.assertEqual(continua.open(self.folder).probes.shape, (0, 2))
        self.write("wave.csv", 'time [s],"tube 0 m: pressure, theory [Pa]"\n')
        self.assert_raises(continua.ResultsError, "wave.csv has no rows", lambda: continua.open(self.folder).waves)
        for cut in ("1,2,3", "1,2", "1"):
            self.write("probes.csv", header + "0,1,2\n" + cut)
            with self.assertWarnsRegex(continua.ContinuaWarning, "line 3 is cut short and is left out; 1 rows are there"):
                self.assertEqual(continua.open(self.folder).probes.to_numpy().tolist(), [[1, 2]])
        with open(self.path("probes.csv"), "wb") as stream:
            stream.write(b"time [s],\xff [m]\n0,1\n")
        self.assert_raises(continua.ResultsError, "cannot be read", lambda: continua.open(self.folder).probes)

    def test_tables_with_texts(self):
        self.write("runs.csv", 'run,cells [1],time [s],failure\n"a, ""b""",3,,""\n"c",4,0.5,"bad\nluck"\n')
        frame = continua.open(self.folder).table("runs")
        self.assertEqual(frame["run"].tolist(), ['a, "b"', "c"])
        self.assertEqual((frame["cells"].tolist(), frame["failure"].tolist(), frame["time"].iloc[1]), ([3, 4], ["", "bad\nluck"], 0.5))
        self.assertTrue(math.isnan(frame["time"].iloc[0]))
        with open(self.path("runs.csv"), encoding="utf-8", newline="") as stream:
            self.assertEqual([row[0] for row in list(csv.reader(stream))[1:]], frame["run"].tolist())
        for text, wrong in (('run,cells [1]\n"a",3\n"b",', "runs.csv:3: the row is cut short"), ('run,cells [1]\n"a",3,4\n', "the row has 3 cells"),
                            ('run,cells [1]\n"a",x\n', "the column 'cells' has what is no number")):
            self.write("runs.csv", text)
            self.assert_raises(continua.ResultsError, wrong, lambda: continua.open(self.folder).table("runs"))
        self.assert_raises(continua.ResultsError, "there is no modes.csv", lambda: continua.open(self.folder).table("modes"))


if __name__ == "__main__":
    unittest.main()
