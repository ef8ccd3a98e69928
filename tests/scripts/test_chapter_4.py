#!/usr/bin/python3
"""scripts/manual/chapter-4: the numbers of histories whose loss, beats and power residual are known, and what is missing."""

import json
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest

import numpy

SCRIPTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts")
sys.path.insert(0, os.path.join(SCRIPTS, "lib"))
import chapter_4  # noqa: E402
import continua  # noqa: E402

CASES = os.path.join("thesis", "chapter-4")


def write_run(folder, name, time, tip, residual=None, quantities=None):
    folder = os.path.join(folder, CASES, name)
    os.makedirs(folder)
    with open(os.path.join(folder, "probes.csv"), "w", encoding="utf-8") as stream:
        stream.write("time [s],tip: displacement y [m]\n")
        stream.writelines(f"{t!r},{value!r}\n" for t, value in zip(time.tolist(), tip.tolist()))
    if residual is not None:
        with open(os.path.join(folder, "power.csv"), "w", encoding="utf-8") as stream:
            stream.write("time [s],balance time [s],residual [W]\n")
            stream.writelines(f"{t!r},{t!r},{value!r}\n" for t, value in zip(time.tolist(), residual.tolist()))
    with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as stream:
        json.dump({"version": continua.__version__, "status": "finished",
                   "quantities": [{"name": key, "value": value, "unit": "", "probe": "tip"} for key, value in (quantities or {}).items()]},
                  stream)


def draw(folder, *arguments):
    return subprocess.run([os.path.join(SCRIPTS, "manual", "chapter-4"), "--draw", "--output", folder, *arguments],
                          capture_output=True, text=True, check=False)


class Numbers(unittest.TestCase):
    def test_loss_and_beats(self):
        time = numpy.arange(0, 30.0005, 0.002)
        frequency, rate, beat = 3.362, 0.0112, 0.2369
        # A mode that decays, and one at five times its frequency and the beat's more.
        damped = 0.3 - 0.3 * numpy.exp(-rate * time) * numpy.cos(2 * math.pi * frequency * time)
        beating = damped - 0.01 * numpy.cos(2 * math.pi * (5 * frequency + beat) * time)
        with tempfile.TemporaryDirectory() as folder:
            write_run(folder, "damped", time, damped, None,
                      {"mode 1 frequency": frequency, "mode 1 decay per oscillation": math.exp(-rate / frequency)})
            write_run(folder, "beating", time, beating)
            runs = os.path.join(folder, CASES)
            maxima = chapter_4.Run(runs, "damped").maxima()[0]
            exact = 1 - (1 + math.exp(-rate * maxima[-1])) / (1 + math.exp(-rate * maxima[0]))
            self.assertAlmostEqual(chapter_4.Run(runs, "damped").loss(30.0), exact, delta=1e-6)
            self.assertAlmostEqual(chapter_4.Run(runs, "damped").loss_by_mode(30.0), (1 - math.exp(-30 * rate)) / 2)
            self.assertLess(chapter_4.Run(runs, "damped").loss(17.0), exact)
            self.assertAlmostEqual(chapter_4.Run(runs, "beating").beat(), beat, delta=0.001)

    def test_eigenvalues(self):
        # Of a cantilever, to the four digits in every table of them.
        for root, known in zip(chapter_4.bernoulli_roots(3), (1.8751, 4.6941, 7.8548)):
            self.assertAlmostEqual(root, known, delta=5e-5)

    def test_every_figure(self):
        self.assertEqual(list(chapter_4.figures([])), [f"4.{n}" for n in range(2, 16)])
        self.assertIn("fv-pressure-momentum", chapter_4.figures(["fv-pressure-momentum"])["4.12"].runs)


class Drawing(unittest.TestCase):
    def test_some_runs(self):
        time = numpy.arange(0, 2, 0.001)
        tip = 0.31 - 0.31 * numpy.cos(2 * math.pi * 3.32 * time)
        with tempfile.TemporaryDirectory() as folder:
            write_run(folder, "fv-displacement", time, tip, None,
                      {"first maximum displacement y": 0.6241, "mode 1 frequency": 3.315, "maximum displacement y": 0.625})
            write_run(folder, "fv-velocity", time, tip, 3 * numpy.sin(20 * math.pi * time))
            write_run(folder, "fv-pressure-definition", time, tip)
            done = draw(folder)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            there = set(os.listdir(os.path.join(folder, "chapter-4")))
            for number in ("4.2", "4.3", "4.5", "4.12"):
                self.assertIn(f"figure-{number}.png", there)
                self.assertIn(f"figure-{number}.csv", there)
            for number in ("4.7", "4.13"):
                self.assertNotIn(f"figure-{number}.png", there)
            self.assertIn("left out: fv-velocity-pressure-longitudinal-30s in figure 4.7, 4.8, 4.9 (no such run)", done.stdout)
            self.assertIn("| 4.3 | first maximum | 0.62 m | 0.6241 m | fv-displacement |", done.stdout)
            self.assertIn("| 20 m x 5 m, 1 MPa | 0.68 m | 0.62 m | 0.6241 m | 3.35 Hz | 3.32 Hz | 3.315 Hz |", done.stdout)
            # Of a sine: its amplitude over the square root of 2.
            rms = re.search(r"consistent \| around 0 \| ([\d.]+) W", done.stdout)
            self.assertAlmostEqual(float(rms.group(1)), 3 / math.sqrt(2), delta=0.001)

    def test_one_figure(self):
        with tempfile.TemporaryDirectory() as folder:
            done = draw(folder, "--figures", "4.2")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertIn("| 4.2 | mode 1 | 3.354 Hz | - |", done.stdout)

    def test_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            done = draw(folder, "--figures", "4.3")
            self.assertEqual(done.returncode, 1)
            self.assertIn("nothing to draw", done.stderr)
            self.assertIn("there is no figure 4.1", draw(folder, "--figures", "4.1").stderr)

    def test_runs(self):
        # A program that is not there: the script says so and fails.
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([os.path.join(SCRIPTS, "manual", "chapter-4"), "--figures", "4.2", "--output", folder,
                                   "--program", os.path.join(folder, "none")], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 1)


if __name__ == "__main__":
    unittest.main()
