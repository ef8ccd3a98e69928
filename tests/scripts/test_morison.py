#!/usr/bin/python3
"""scripts/morison: the coefficients of a force that is made of them, and what has no whole period."""

import json
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SCRIPT = os.path.join(ROOT, "scripts", "morison")
sys.path.insert(0, os.path.join(ROOT, "python"))
import continua  # noqa: E402

DRAG, MASS = 2.1, 1.4
SPEED, PERIOD, DIAMETER, DENSITY, PHASE = 0.7, 2.0, 0.3, 900.0, 40.0


def write(folder, end):
    """The force of Morison's formula, and a third harmonic that it does not have."""
    os.makedirs(folder)
    with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as stream:
        json.dump({"version": continua.__version__, "quantities": []}, stream)
    with open(os.path.join(folder, "probes.csv"), "w", encoding="utf-8") as probes:
        probes.write("time [s],body: force x [N]\n")
        frequency = 2.0 * math.pi / PERIOD
        for i in range(round(end / 5e-3) + 1):
            t = 5e-3 * i
            angle = frequency * t + math.radians(PHASE)
            velocity, acceleration = SPEED * math.cos(angle), -SPEED * frequency * math.sin(angle)
            force = -0.5 * DENSITY * DIAMETER * DRAG * abs(velocity) * velocity - 0.25 * math.pi * DENSITY * DIAMETER**2 * MASS * acceleration
            probes.write(f"{t},{force + 5.0 * math.cos(3.0 * angle)}\n")


class Morison(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def run_on(self, end, **others):
        output = os.path.join(self.folder.name, "run")
        write(output, end)
        options = {"column": "body: force x", "period": PERIOD, "speed": SPEED, "diameter": DIAMETER, "density": DENSITY, "phase": PHASE, **others}
        command = [sys.executable, SCRIPT, output]
        for name, value in options.items():
            command += ["--" + name, str(value)]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    def test_coefficients(self):
        result = self.run_on(4.5)
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = [[float(x) for x in row] for row in re.findall(r"\| (\d+) \| (-?[0-9.]+) \| (-?[0-9.]+) \|", result.stdout)]
        self.assertEqual([row[0] for row in rows], [1, 2])
        for _, drag, mass in rows:
            self.assertAlmostEqual(drag, DRAG, delta=1e-3)
            self.assertAlmostEqual(mass, MASS, delta=1e-3)

    def test_what_is_missing(self):
        result = self.run_on(1.9)
        self.assertEqual(result.returncode, 1)
        self.assertIn("has no whole period of 2 s", result.stderr)

    def test_wrong_options(self):
        result = self.run_on(2.0, column="body: force y")
        self.assertEqual(result.returncode, 1)
        self.assertIn("There are: body: force x", result.stderr)
        self.folder = tempfile.TemporaryDirectory()
        result = self.run_on(2.0, speed=0)
        self.assertEqual(result.returncode, 2)
        self.assertIn("--speed is 0", result.stderr)


if __name__ == "__main__":
    unittest.main()
