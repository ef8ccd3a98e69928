#!/usr/bin/python3
"""scripts/measure/equal-error: the fit of signals that are known, OpenFOAM's output, the choice of the cheapest run. Needs no OpenFOAM."""

import math
import os
import subprocess
import sys
import tempfile
import unittest

import numpy

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
sys.path.insert(0, os.path.join(ROOT, "scripts", "lib"))
sys.dont_write_bytecode = True
import damped_signal  # noqa: E402
import equal_error  # noqa: E402
import openfoam_beam  # noqa: E402

TIP = """# Region type : patch end
# Faces       : 10
# Time        \tareaAverage(D)
0.001         \t(1.2e-10 1.5e-04 0.0e+00)
0.002         \t(2.4e-10 -6.0e-04 0.0e+00)
0.003         \t(2.4e-10 -6.0"""


def run(processor, error, loss=0.0, reached=1.0, code="code"):
    return equal_error.Run(code, (4, 1), 1e-3, "", processor=processor, reached=reached, asked=1.0, frequency_error=-error,
                           mean_error=error / 2, decay=1 - loss)


class Fit(unittest.TestCase):
    def test_damped_waves(self):
        time = numpy.arange(0, 1.2, 0.002)
        values = 0.304 - 0.28 * numpy.exp(-0.5 * time) * numpy.cos(2 * math.pi * 3.36 * time)
        values -= 0.02 * numpy.exp(-3 * time) * numpy.cos(2 * math.pi * 16.9 * time + 0.3)
        frequency, mean, decay = damped_signal.mean_and_mode(time, values, 3.4)
        self.assertAlmostEqual(frequency, 3.36, delta=1e-6)
        self.assertAlmostEqual(mean, 0.304, delta=1e-7)
        self.assertAlmostEqual(decay, math.exp(-0.5 / 3.36), delta=1e-6)
        # Noise of a thousandth: what it is good for beside a goal of a thousandth.
        noisy = values + 3e-4 * numpy.random.default_rng(1).standard_normal(len(values))
        frequency, mean, _ = damped_signal.mean_and_mode(time, noisy, 3.4)
        self.assertAlmostEqual(frequency, 3.36, delta=2e-3)
        self.assertAlmostEqual(mean, 0.304, delta=2e-4)

    def test_nothing_there(self):
        time = numpy.arange(0, 1.2, 0.002)
        with self.assertRaises(ValueError):
            damped_signal.mean_and_mode(time, numpy.cos(2 * math.pi * 16.9 * time), 3.4)
        with self.assertRaises(ValueError):
            damped_signal.mean_and_mode(time[:6], time[:6], 3.4)


class OpenFoam(unittest.TestCase):
    def test_output(self):
        times, values = openfoam_beam.parse_tip(TIP)
        self.assertEqual(times, [0.0, 0.001, 0.002])
        self.assertEqual(values, [0.0, 1.5e-4, -6e-4])
        log = ["Iteration: 0.001", "PCG:  Solving for Dx, Initial residual = 1, Final residual = 0.05, No Iterations 3",
               "PCG:  Solving for Dy, Initial residual = 1, Final residual = 0.05, No Iterations 3"]
        self.assertEqual(openfoam_beam.count_corrections(2 * log), 2)

    def test_case_is_that_of_the_parameter_file(self):
        with open(os.path.join(ROOT, "parameter_files", "thesis", "chapter-4", "beam.prm"), encoding="utf-8") as stream:
            beam, reference = equal_error.beam_of(stream.read())
        self.assertEqual(beam, {"length": 20.0, "height": 5.0, "young": 4e9, "poisson": 0.3, "density": 1450.0, "shear": 1e6})
        self.assertEqual(reference, {"frequency": 3.3624, "mean": 0.30395})
        with tempfile.TemporaryDirectory() as folder:
            openfoam_beam.write_case(folder, beam, (40, 10), 1e-4, 1e-8, True, 1.2)
            texts = {}
            for name in ("system/blockMeshDict", "system/controlDict", "system/fvSolution", "constant/mechanicalProperties", "0/D"):
                with open(os.path.join(folder, name), encoding="utf-8") as stream:
                    texts[name] = stream.read()
                self.assertEqual(texts[name].count("{"), texts[name].count("}"), name)
            self.assertIn("(40 10 1)", texts["system/blockMeshDict"])
            self.assertIn("deltaT 0.0001;", texts["system/controlDict"])
            self.assertIn("compactNormalStress yes; nCorrectors 100000; D 1e-08;", texts["system/fvSolution"])
            self.assertIn("value 4000000000.0;", texts["constant/mechanicalProperties"])
            self.assertIn("traction uniform (0 1000000.0 0)", texts["0/D"])


class Choice(unittest.TestCase):
    def test_cheapest(self):
        runs = [run(1.0, 0.02), run(3.0, 0.008, 0.1), run(2.0, 0.009, 0.1), run(5.0, 0.004), run(9.0, math.nan)]
        self.assertIs(equal_error.cheapest(runs, 0.01), runs[2])
        self.assertIs(equal_error.cheapest(runs, 0.01, True), runs[3])
        self.assertIsNone(equal_error.cheapest(runs, 0.001))
        self.assertEqual(equal_error.time_at(runs, 0.001), (runs[3], True))
        self.assertEqual(equal_error.time_at(runs[4:], 0.001), (None, True))

    def test_run_that_was_stopped(self):
        stopped = run(10.0, 0.004, reached=0.5)
        self.assertFalse(stopped.is_whole)
        self.assertEqual(stopped.whole_processor, 20.0)
        self.assertIs(equal_error.cheapest([stopped, run(15.0, 0.004)], 0.01).is_whole, True)
        self.assertIn("stopped at 0.5 s after 10", equal_error.row_of(stopped)[10])

    def test_ratios(self):
        codes = {"ours": [run(0.5, 0.005), run(2.0, 0.0005)], "theirs": [run(20.0, 0.005)], "none": [run(1.0, math.nan)]}
        rows = equal_error.choices(codes, {"ours": 0.4}, (0.01, 0.001))
        self.assertEqual([row[-1] for row in rows], ["1", "40", "-", "1", "> 10", "-"])
        self.assertEqual(rows[4][6], "> 20")
        # A lower bound is nothing to compare with.
        rows = equal_error.choices({"ours": [run(0.5, 0.005)], "theirs": [run(20.0, 0.0005)]}, {}, (0.001, ))
        self.assertEqual([row[-1] for row in rows], ["-", "-"])


class Command(unittest.TestCase):
    def test_without_openfoam(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, os.path.join(ROOT, "scripts", "measure", "equal-error"), "--codes", "openfoam",
                                   "--output", folder], env=dict(os.environ, PATH=folder), capture_output=True, text=True,
                                  check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("left out: OpenFOAM, since blockMesh and solidDisplacementFoam are not installed", done.stdout)
        self.assertIn("no code to run", done.stderr)

    def test_unknown_code(self):
        done = subprocess.run([os.path.join(ROOT, "scripts", "measure", "equal-error"), "--codes", "abaqus"], capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("there are taylor-hood, cell-wise, openfoam", done.stderr)


if __name__ == "__main__":
    unittest.main()
