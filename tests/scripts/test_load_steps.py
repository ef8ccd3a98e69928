#!/usr/bin/python3
"""load-steps.csv of a steady analysis: each row is the state at rest under its part of the loads."""

import os
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))
sys.path.insert(0, os.path.join(ROOT, "python"))
sys.dont_write_bytecode = True

import continua  # noqa: E402


class LoadSteps(unittest.TestCase):
    def test_uniaxial_tension(self):
        """A block of Mooney-Rivlin rubber: with the stretch l the force over the undeformed area is 2 (C1 + C2/l) (l - 1/l^2), after Rivlin
        (Phil. Trans. R. Soc. A 241 (1948) 379), with 2 C1 = 70 kPa and 2 C2 = 30 kPa. The whole load is 148.75 kPa."""
        with tempfile.TemporaryDirectory() as folder:
            output = os.path.join(folder, "run")
            file = os.path.join(ROOT, "parameter_files", "verification", "finite-strain-uniaxial.prm")
            subprocess.run([PROGRAM, file, "--set", "Steady/Load steps=8", "--output", output], capture_output=True, check=True)
            table = continua.open(output).table("load-steps")
            self.assertEqual(table["load"].tolist(), [i / 8 for i in range(1, 9)])
            for _, row in table.iterrows():
                stretch = 1 + row["corner: displacement x"] / 0.1
                force = (70e3 + 30e3 / stretch) * (stretch - 1 / stretch**2)
                self.assertAlmostEqual(force / 148.75e3, row["load"], delta=1e-6)
            # What is at rest in the end is the last row.
            last = continua.open(output).probes.iloc[-1]
            for name in last.index:
                self.assertAlmostEqual(last[name], table[name].iloc[-1], delta=1e-12 * max(1, abs(last[name])))

    def test_loads_at_once(self):
        with tempfile.TemporaryDirectory() as folder:
            output = os.path.join(folder, "run")
            subprocess.run([PROGRAM, os.path.join(ROOT, "parameter_files", "new", "steady.prm"), "--output", output], capture_output=True, check=True)
            self.assertFalse(os.path.exists(os.path.join(output, "load-steps.csv")))


if __name__ == "__main__":
    unittest.main()
