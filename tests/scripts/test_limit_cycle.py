#!/usr/bin/python3
"""scripts/limit-cycle: middles, amplitudes, frequencies and energies of a motion that is known, and what has no cycles."""

import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SCRIPT = os.path.join(ROOT, "scripts", "limit-cycle")
sys.path.insert(0, os.path.join(ROOT, "python"))
import continua  # noqa: E402


def write(folder, amplitude, power):
    """A tip at 1 + amplitude sin(2 pi 2 t) after a start that is larger, and a force of twice its frequency; 5 s in steps of 1 ms."""
    os.makedirs(folder)
    with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as stream:
        json.dump({"version": continua.__version__, "quantities": []}, stream)
    with open(os.path.join(folder, "probes.csv"), "w", encoding="utf-8") as probes, \
         open(os.path.join(folder, "power.csv"), "w", encoding="utf-8") as powers:
        probes.write("time [s],tip: displacement y [m],tip: force x [N]\n")
        powers.write("time [s],balance time [s],external [W],kinetic energy [J]\n")
        for i in range(5001):
            t = 1e-3 * i
            factor = 10. if t < 1. else 1.
            probes.write(f"{t},{1. + factor * amplitude * math.sin(4. * math.pi * t)},{3. + 0.5 * math.cos(8. * math.pi * t)}\n")
            powers.write(f"{t},{t},{power + math.sin(4. * math.pi * t)},7\n")


class LimitCycle(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def run_on(self, *arguments):
        return subprocess.run([sys.executable, SCRIPT, *arguments], capture_output=True, text=True, check=False)

    def rows(self, *arguments):
        result = self.run_on(*arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        cells = [[cell.strip() for cell in line.split("|")[1:-1]] for line in result.stdout.splitlines() if line.startswith("|")]
        return result.stdout, {row[0]: row[1:] for row in cells}

    def numbers(self, row):
        return [float(number) for number in ", ".join(row).split(", ")]

    def test_one_run(self):
        folder = os.path.join(self.folder.name, "fine")
        write(folder, 0.2, 6.)
        text, rows = self.rows(folder, "--clock", "tip: displacement y", "--from", "1.1")
        self.assertIn("6 cycles, 1.5 to 4.5 s", text)
        for number, expected in zip(self.numbers(rows["tip: displacement y [m]"]), (1., 0.2, 2.)):
            self.assertAlmostEqual(number, expected, 4)
        for number, expected in zip(self.numbers(rows["tip: force x [N]"]), (3., 0.5, 4.)):
            self.assertAlmostEqual(number, expected, 4)
        self.assertAlmostEqual(float(rows["external"][0]), 3., 4)
        self.assertNotIn("kinetic energy", rows)
        self.assertNotIn("balance time", rows)

    def test_beside_another(self):
        fine, coarse = (os.path.join(self.folder.name, name) for name in ("fine", "coarse"))
        write(fine, 0.2, 6.)
        write(coarse, 0.25, 5.)
        _, rows = self.rows(fine, coarse, "--clock", "tip: displacement y", "--from", "1.1")
        for number, expected in zip(self.numbers(rows["tip: displacement y [m]"]), (1., 0.2, 2., 0., 0.05, 0.)):
            self.assertAlmostEqual(number, expected, 4)
        self.assertAlmostEqual(float(rows["external"][1]), -0.5, 4)

    def test_without_cycles(self):
        folder = os.path.join(self.folder.name, "fine")
        write(folder, 0.2, 6.)
        for arguments, message in ((["--clock", "tip: displacement y", "--from", "4.3"], "no two whole cycles"),
                                   (["--clock", "tip: displacement z", "--from", "1"], "no column 'tip: displacement z'. There are: tip: disp")):
            result = self.run_on(folder, *arguments)
            self.assertEqual(result.returncode, 1)
            self.assertIn(message, result.stderr)
        self.assertIn("error: ", self.run_on(self.folder.name, "--clock", "a", "--from", "1").stderr)


if __name__ == "__main__":
    unittest.main()
