#!/usr/bin/python3
"""scripts/measure/amplitude-and-speed: made-up runs whose crests have known speeds, heights and widenings, and a theory that ended."""

import csv
import os
import subprocess
import tempfile
import unittest

import numpy

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCRIPT = os.path.join(ROOT, "scripts", "measure", "amplitude-and-speed")
SPEEDS = {"simulated": 2.9, "theory": 3.0, "nonlinear theory": 2.8}  # m/s


def write_run(folder, law, widening, ended=False):
    """A crest that widens the tube at 0.05 m by this part, and is half as high again at the last station."""
    os.makedirs(folder)
    with open(os.path.join(folder, "parameters.prm"), "w", encoding="utf-8") as stream:
        stream.write(f"subsection Geometry\n  set Law = {law} # tube\nend\nsubsection Materials\n  set Strain law = neo hookean\nend\n")
    time, header, columns = numpy.arange(0, 0.3, 1e-3), ["time [s]"], []
    diameter = 25e-3 if law in "ABC" else 25e-3 - 12.5e-3 * 0.05 / 0.446
    for place, height in ((0.05, 100.0), (0.15, 120.0), (0.2, 150.0), (0.3, 50.0)):
        for field, factor, unit in (("pressure", height, "Pa"), ("wall distension", widening * diameter, "m")):
            for source, speed in SPEEDS.items():
                header.append(f'"tube {place:g} m: {field}, {source} [{unit}]"')
                columns.append(factor * numpy.exp(-((time - 0.08 - place / speed) / 0.02)**2))
                if ended and source == "nonlinear theory":
                    columns[-1][150:] = numpy.nan
    with open(os.path.join(folder, "wave.csv"), "w", encoding="utf-8") as stream:
        stream.write(",".join(header) + "\n")
        for row in zip(time, *columns):
            stream.write(",".join(f"{value:.9g}" for value in row) + "\n")


class AmplitudeAndSpeed(unittest.TestCase):
    def test_rows(self):
        with tempfile.TemporaryDirectory() as folder:
            write_run(os.path.join(folder, "sweep", "one"), "A", 0.1)
            write_run(os.path.join(folder, "sweep", "two"), "D", 0.2, ended=True)
            output = os.path.join(folder, "figure")
            done = subprocess.run([SCRIPT, os.path.join(folder, "sweep"), "--output", output], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue(os.path.getsize(os.path.join(output, "amplitude-and-speed.png")) > 0)
            with open(os.path.join(output, "amplitude-and-speed.csv"), encoding="utf-8") as stream:
                straight, tapered = list(csv.reader(stream))[1:]
        self.assertEqual((straight[:2], tapered[:2]), (["neo hookean", "A"], ["neo hookean", "D"]))
        for value, expected in zip(straight[2:], (0.1, 2.9, 2.8, 3.0, 2.9, 2.8, 1.5, 1.5)):
            self.assertAlmostEqual(float(value), expected, delta=2e-3 * expected)
        self.assertAlmostEqual(float(tapered[2]), 0.2, delta=4e-4)
        self.assertEqual((tapered[4], tapered[9]), ("nan", "nan"))

    def test_no_run(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([SCRIPT, folder], capture_output=True, text=True, check=False)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn("pulse-amplitude-", done.stderr)


if __name__ == "__main__":
    unittest.main()
