#!/usr/bin/python3
"""scripts/plot: the maxima of a damped cosine, what it does with missing pieces, the same files every time."""

import math
import os
import subprocess
import sys
import tempfile
import unittest

import numpy

SCRIPTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts")
sys.path.insert(0, os.path.join(SCRIPTS, "lib"))
import plot_histories  # noqa: E402
import plot_style  # noqa: E402


def plot(*arguments):
    return subprocess.run([os.path.join(SCRIPTS, "plot"), *arguments], capture_output=True, text=True, check=False)


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)


def contents(folder):
    """What is in the files of a folder, by name."""
    found = {}
    for name in sorted(os.listdir(folder)):
        with open(os.path.join(folder, name), "rb") as stream:
            found[name] = stream.read()
    return found


class Envelope(unittest.TestCase):
    def test_cosine(self):
        time = numpy.linspace(0, 4.2, 1001)
        maxima, minima = plot_histories.turning_points(time, numpy.cos(2 * math.pi * time))
        self.assertTrue(numpy.allclose([t for t, _ in maxima], [1, 2, 3, 4], atol=1e-4))
        self.assertTrue(numpy.allclose([t for t, _ in minima], [0.5, 1.5, 2.5, 3.5], atol=1e-4))
        self.assertTrue(numpy.allclose([v for _, v in maxima], 1, atol=1e-6))

    def test_ripples_do_not_count(self):
        time = numpy.linspace(0, 3.2, 5001)
        maxima, _ = plot_histories.turning_points(time, numpy.cos(2 * math.pi * time)
                                                  + 0.01 * numpy.sin(80 * math.pi * time))
        self.assertEqual(len(maxima), 3)

    def test_constant(self):
        self.assertEqual(plot_histories.turning_points(numpy.arange(5.0), numpy.ones(5)), ([], []))


class Units(unittest.TestCase):
    def test_prefixes(self):
        self.assertEqual(plot_style.readable(0.012, "m"), (1000.0, "mm"))
        self.assertEqual(plot_style.readable(2.5e6, "Pa")[1], "MPa")
        self.assertEqual(plot_style.readable(0.012, "m^3/s"), (1.0, "m^3/s"))
        self.assertEqual(plot_style.axis_label("flow rate", "m^3/s"), "Flow rate [m³/s]")


class Files(unittest.TestCase):
    def test_probes_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            rows = "".join(f"{i * 0.01!r},{math.sin(i * 0.3)!r}\n" for i in range(200))
            write(os.path.join(folder, "probes.csv"), "time [s],tip: displacement y [m]\n" + rows)
            done = plot(folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("no rows in power.csv", done.stdout)
            self.assertIn("no fields.pvd", done.stdout)
            plots = os.path.join(folder, "plots")
            with open(os.path.join(plots, "history-displacement-y.csv"), encoding="utf-8") as stream:
                lines = stream.read().splitlines()
            self.assertEqual(lines[0], "tip: time [s],tip: displacement y [m]")
            self.assertEqual(len(lines), 201)
            first = contents(plots)
            self.assertEqual(list(first), [f"{kind}-displacement-y.{end}" for kind in ("envelope", "history")
                                           for end in ("csv", "png", "svg")])
            self.assertEqual(plot(folder).returncode, 0)
            self.assertEqual(contents(plots), first)

    def test_nothing_there(self):
        with tempfile.TemporaryDirectory() as folder:
            done = plot(folder)
            self.assertEqual(done.returncode, 1)
            self.assertIn("nothing to draw", done.stderr)
            self.assertEqual(plot(os.path.join(folder, "missing")).returncode, 1)

    def test_broken_table(self):
        with tempfile.TemporaryDirectory() as folder:
            write(os.path.join(folder, "probes.csv"), "time [s],tip: pressure [Pa]\n0,1\n1,oops\n")
            done = plot(folder)
            self.assertEqual(done.returncode, 1)
            self.assertIn("cannot read", done.stderr)

    def test_width(self):
        self.assertEqual(plot(".", "--width", "wide").returncode, 2)


if __name__ == "__main__":
    unittest.main()
