#!/usr/bin/python3
"""scripts/plot of an identification: a figure for each table, the interval of a profile, and what is not there."""

import json
import os
import subprocess
import sys
import tempfile
import unittest

import numpy

SCRIPTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts")
sys.path.insert(0, os.path.join(SCRIPTS, "lib"))
import plot_identification  # noqa: E402
import plot_style  # noqa: E402


def plot(*arguments):
    return subprocess.run([os.path.join(SCRIPTS, "plot"), *arguments], capture_output=True, text=True, check=False)


def write(folder, name, header, rows):
    with open(os.path.join(folder, name), "w", encoding="utf-8") as stream:
        stream.write(header + "\n" + "".join(",".join(row) + "\n" for row in rows))


def identify(folder, pairs=False, test=False):
    """As an identification writes it, with candidates of one station or of two, and with a material test as one of them."""
    with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as stream:
        json.dump({"version": "0.2.0", "status": "finished", "title": "Tube", "quantities": [], "checks": []}, stream)
    write(folder, "identification.csv", "parameter,entry,unit,estimate", [['"modulus"', '"Materials/wall/Young\'s modulus"', '"Pa"', "1.4e6"]])
    write(folder, "fit.csv", "record,unit,time [s],measured,fitted,residual,noise",
          [[f'"stations {place} m: pressure"', '"Pa"', repr(0.01 * i), repr(100.0 * i + 1), repr(100.0 * i), "1", "2"]
           for place in (0.1, 0.3) for i in range(100)])
    write(folder, "correlation.csv", 'parameter,"modulus","thickness"', [['"modulus"', "1", "-0.9987"], ['"thickness"', "-0.9987", "1"]])
    write(folder, "profiles.csv", "parameter,unit,value,misfit [1],threshold [1]",
          [['"modulus"', '"Pa"', repr(1e6 + 1e5 * i), repr((i - 4) ** 2), "3.841"] for i in range(9)])
    rows = [["0", '""', "", '""', "", '""', "1", "3e4"]]
    for i in range(4):
        second = [repr(0.1 * i + 0.2), '"pressure"'] if pairs else ["", '""']
        rows.append([str(i + 1), f'"{i}"', repr(0.1 * i), '"pressure"', *second, "1", repr(2e4 - 1e3 * i)])
    if test:
        rows[1:1] = [["0", '"waves alone"', "", '""', "", '""', "1", "9e4"], ["9", '"strip: relaxation"', "", '"strip: relaxation"', "", '""', "1", "5e3"],
                     ["8", '"0; strip: relaxation"', "0.1", '"pressure"', "", '"strip: relaxation"', "1", "4e3"]]
    write(folder, "expected-errors.csv", "rank [1],added,position [m],field,second position [m],second field,log determinant [1],"
          '"modulus: standard error [Pa]"', rows)


class Plot(unittest.TestCase):
    def test_all(self):
        with tempfile.TemporaryDirectory() as folder:
            identify(folder)
            done = plot(folder)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            there = sorted(name for name in os.listdir(os.path.join(folder, "plots")) if name.endswith(".png"))
            self.assertEqual(there, ["correlation.png", "expected-errors-modulus.png", "fit-stations-0-1-m-pressure.png",
                                     "fit-stations-0-3-m-pressure.png", "profile-modulus.png"])

    def test_pairs(self):
        with tempfile.TemporaryDirectory() as folder:
            identify(folder, pairs=True)
            os.remove(os.path.join(folder, "profiles.csv"))
            sheet = plot_style.Sheet(os.path.join(folder, "plots"), 6.3, False)
            sheet.formats = ["png"]
            plot_identification.draw(sheet, folder)
            there, said = [os.path.basename(name) for name in sheet.written], "\n".join(sheet.notes)
            self.assertIn("expected-errors-modulus-pressure-and-pressure.png", there)
            self.assertNotIn("profile-modulus.png", there)
            self.assertIn("profiles (no rows in profiles.csv)", said)


    def test_material_test(self):
        """A test has no place: it is a line across the picture. A station with a test is no station alone."""
        with tempfile.TemporaryDirectory() as folder:
            identify(folder, test=True)
            sheet = plot_style.Sheet(os.path.join(folder, "plots"), 6.3, False)
            drawn = []
            sheet.save = lambda figure, name: drawn.append((name, figure))
            plot_identification.draw_expected_errors(sheet, plot_identification.table(folder, "expected-errors"))
            (name, figure), = drawn
            self.assertEqual(name, "expected-errors-modulus")
            lines = {line.get_label(): line.get_ydata() for line in figure.axes[0].lines}
            self.assertEqual(set(lines), {"pressure", "with strip: relaxation", "records of the file alone"})
            self.assertEqual(list(lines["pressure"]), [20, 19, 18, 17])
            self.assertEqual(list(lines["with strip: relaxation"]), [5, 5])
            self.assertEqual(list(lines["records of the file alone"]), [30, 30])


class Interval(unittest.TestCase):
    def test_parabola(self):
        value = numpy.linspace(-5, 5, 2001)
        low, high = plot_identification.interval(value, value**2, 3.841)
        self.assertAlmostEqual(low, -(3.841**0.5), places=4)
        self.assertAlmostEqual(high, 3.841**0.5, places=4)

    def test_open_end(self):
        value = numpy.linspace(-1, 5, 601)
        low, high = plot_identification.interval(value, value**2, 3.841)
        self.assertEqual(low, -1)
        self.assertAlmostEqual(high, 3.841**0.5, places=3)


if __name__ == "__main__":
    unittest.main()
