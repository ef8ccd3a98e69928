#!/usr/bin/python3
"""scripts/plot of a sweep: curves, families, maps and words, runs that failed, and the histories of the runs."""

import json
import os
import subprocess
import sys
import tempfile
import unittest

import numpy

SCRIPTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts")
sys.path.insert(0, os.path.join(SCRIPTS, "lib"))
import continua  # noqa: E402
import plot_style  # noqa: E402
import plot_sweep  # noqa: E402

MODULUS, THICKNESS = "Materials/wall/Young's modulus", "Geometry/Wall thickness"


def plot(*arguments):
    return subprocess.run([os.path.join(SCRIPTS, "plot"), *arguments], capture_output=True, text=True, check=False)


def sweep(folder, axes, failed=()):
    """As a sweep writes it: a grid of the axes, [(path, unit, values)], and a quantity that is the product of the numbers."""
    columns = [f"{path} [{unit}]" if unit else path for path, unit, _ in axes]
    with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as stream:
        json.dump({"version": "0.2.0", "status": "finished", "title": "Tube", "quantities": [], "checks": [], "swept": columns}, stream)
    rows = [[]]
    for _, _, values in axes:
        rows = [[*row, value] for row in rows for value in values]
    with open(os.path.join(folder, "sweep.csv"), "w", encoding="utf-8") as stream:
        stream.write("run," + ",".join(f'"{column}"' for column in columns) + ',"tip: frequency [Hz]",wall time [s],failure\n')
        for number, row in enumerate(rows):
            product = numpy.prod([value for value in row if not isinstance(value, str)])
            cells = [f'"{value}"' if isinstance(value, str) else repr(value) for value in row]
            has_failed = number in failed
            stream.write(f'"run-{number}",' + ",".join(cells) + f',{"" if has_failed else repr(float(product))},1,'
                         f'"{"it diverges" if has_failed else ""}"\n')
            run = os.path.join(folder, f"run-{number}")
            os.makedirs(run)
            with open(os.path.join(run, "probes.csv"), "w", encoding="utf-8") as probes:
                probes.write(f"time [s],tip: displacement y [m]\n0,0\n0.1,{number}\n0.2,0.3\n")


def table(folder, name):
    with open(os.path.join(folder, "plots", name), encoding="utf-8") as stream:
        return [line.rstrip("\n") for line in stream]


class Plot(unittest.TestCase):
    def pictures(self, folder):
        """What the script writes, and what it leaves out."""
        sheet = plot_style.Sheet(os.path.join(folder, "plots"), 6.3, False)
        sheet.formats = ["png"]
        plot_sweep.draw(sheet, folder, False)
        return [os.path.basename(name) for name in sheet.written], "\n".join(sheet.notes)

    def test_curve(self):
        with tempfile.TemporaryDirectory() as folder:
            sweep(folder, [(MODULUS, "Pa", [3e6, 1e6, 2e6])], failed=(1,))
            done = plot(folder)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            there = os.listdir(os.path.join(folder, "plots"))
            self.assertLessEqual({"sweep-tip-frequency.png", "history-displacement-y.png", "history-displacement-y.csv"}, set(there))
            self.assertEqual(table(folder, "sweep-tip-frequency.csv"), ["Young's modulus [Pa],tip: frequency [Hz]", "2000000.0,2000000.0",
                                                                        "3000000.0,3000000.0"])
            header = table(folder, "history-displacement-y.csv")[0]
            self.assertIn("Young's modulus 3 MPa", header)
            self.assertNotIn("Young's modulus 1 MPa", header)  # it failed

    def test_family(self):
        with tempfile.TemporaryDirectory() as folder:
            sweep(folder, [(MODULUS, "Pa", [1e6, 2e6]), (THICKNESS, "m", [0.001, 0.002, 0.003])])
            self.pictures(folder)
            header = table(folder, "sweep-tip-frequency.csv")[0]
            self.assertIn("Young's modulus 2 MPa: Wall thickness [m]", header)  # over the entry with the most values

    def test_map(self):
        with tempfile.TemporaryDirectory() as folder:
            sweep(folder, [(MODULUS, "Pa", [1e6 * i for i in range(1, 9)]), (THICKNESS, "m", [0.001 * i for i in range(1, 8)])], failed=(3,))
            there, said = self.pictures(folder)
            self.assertIn("sweep-tip-frequency.png", there)
            self.assertNotIn("sweep-tip-frequency.csv", there)  # sweep.csv has it
            self.assertIn("histories of 47 of the 55 runs", said)

    def test_words(self):
        with tempfile.TemporaryDirectory() as folder:
            sweep(folder, [("Time/Scheme", "", ["crank nicolson", "euler"]), (MODULUS, "Pa", [1e6, 2e6])])
            self.pictures(folder)
            self.assertIn("Scheme euler: Young's modulus [Pa]", table(folder, "sweep-tip-frequency.csv")[0])

    def test_words_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            sweep(folder, [("Time/Scheme", "", ["crank nicolson", "euler"])])
            there, _ = self.pictures(folder)
            self.assertIn("sweep-tip-frequency.png", there)

    def test_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            sweep(folder, [(MODULUS, "Pa", [1e6, 2e6])])
            done = plot(os.path.join(folder, "run-0"), folder)
            self.assertEqual(done.returncode, 2)
            self.assertIn("is of a sweep, which is drawn by itself", done.stderr)
            os.remove(os.path.join(folder, "summary.json"))
            with self.assertRaises(continua.ResultsError):
                self.pictures(folder)


class Axes(unittest.TestCase):
    def test_names(self):
        names = ["Materials/inner/Density", "Materials/outer/Density", "Geometry/Length"]
        self.assertEqual([plot_sweep.Axis(name, "kg/m^3", [1.0], names).name for name in names],
                         ["inner/Density", "outer/Density", "Length"])

    def test_logarithmic(self):
        self.assertTrue(plot_sweep.Axis("Frequency", "Hz", [1.0, 10.0, 100.0], []).is_logarithmic())
        self.assertFalse(plot_sweep.Axis("Frequency", "Hz", [1.0, 50.0, 100.0], []).is_logarithmic())
        self.assertFalse(plot_sweep.Axis("Frequency", "Hz", [1.0, 2.0, 4.0], []).is_logarithmic())

    def test_borders(self):
        self.assertEqual(plot_sweep.borders(numpy.array([1.0, 2.0, 4.0])), [0.5, 1.5, 3.0, 5.0])


if __name__ == "__main__":
    unittest.main()
