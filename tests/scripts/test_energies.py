#!/usr/bin/python3
"""scripts/energies: the table of a summary, and what has no energies."""

import json
import os
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SCRIPT = os.path.join(ROOT, "scripts", "energies")
sys.path.insert(0, os.path.join(ROOT, "python"))
import continua  # noqa: E402


def summary():
    """A fluid that took 3 J and lost 1 J, a wall that took 4 J, half of which relaxed, in 100 steps of 2 ms."""
    values = [("energy residual", "", 1e-12), ("work of the loads", "", 8.),
              ("kinetic energy taken", "fluid", 2.5), ("strain energy taken", "fluid", 0.),
              ("compressive energy taken", "fluid", 0.5), ("energy dissipated", "fluid", 1.),
              ("kinetic energy taken", "wall", 1.), ("strain energy taken", "wall", 1.),
              ("compressive energy taken", "wall", 0.), ("energy dissipated", "wall", 0.),
              ("energy relaxed", "wall", 2.)]
    return {"version": continua.__version__, "quantities": [{"name": name, "probe": probe, "value": value} for name, probe, value in values],
            "degrees of freedom": {"velocity": 100, "pressure": 20}, "steps": 100,
            "wall time [s]": {"solve": 0.15, "update": 0.05, "fields": 7.}}


class Energies(unittest.TestCase):
    def run_on(self, content):
        with tempfile.TemporaryDirectory() as folder:
            if content is not None:
                with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as stream:
                    json.dump(content, stream)
            return subprocess.run([sys.executable, SCRIPT, folder], capture_output=True, text=True, check=False)

    def test_table(self):
        result = self.run_on(summary())
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in result.stdout.splitlines()]
        self.assertEqual(rows[0][1], "work of the loads")
        self.assertEqual(rows[2][1:], ["8", "fluid", "2.5", "0", "0.5", "1", "0", "1.0e-12", "120", "2.00"])
        self.assertEqual(rows[3], ["", "", "wall", "1", "1", "0", "0", "2", "", "", ""])
        self.assertEqual(len(rows[1]), len(rows[0]))

    def test_support(self):
        content = summary()
        content["quantities"] += [{"name": "support energy taken", "probe": "wall", "value": 0.5},
                                  {"name": "energy damped by the support", "probe": "wall", "value": 0.25}]
        rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in self.run_on(content).stdout.splitlines()]
        self.assertEqual(rows[3], ["", "", "wall", "1", "1.5", "0", "0.25", "2", "", "", ""])

    def test_outlet(self):
        content = summary()
        content["quantities"] += [{"name": "energy left", "probe": "outlet", "value": 0.5},
                                  {"name": "energy dissipated", "probe": "outlet", "value": 0.25}]
        rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in self.run_on(content).stdout.splitlines()]
        self.assertEqual(rows[4], ["", "", "outlet", "0", "0.25", "0", "0.25", "0", "", "", ""])

    def test_without_energies(self):
        steady = summary()
        steady["quantities"] = []
        self.assertEqual(self.run_on(steady).returncode, 1)
        self.assertEqual(self.run_on(None).returncode, 1)


if __name__ == "__main__":
    unittest.main()
