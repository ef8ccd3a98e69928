#!/usr/bin/python3
"""scripts/measure/newton-step: its table, and what Newton's iteration needs in a few short runs. No time is checked, but counts, which do
not depend on the machine: each is the one found (2026-11-29) and some more, since round-off decides a correction in places."""

import importlib.machinery
import importlib.util
import os
import subprocess
import sys
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCRIPT = os.path.join(ROOT, "scripts", "measure", "newton-step")
PROGRAM = os.environ["CONTINUA_PROGRAM"]
COARSE = {"Finite element/Velocity degree": "2", "Time/Time step": "10 ms"}


def script():
    """The script as a module."""
    loader = importlib.machinery.SourceFileLoader("newton_step", SCRIPT)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("newton_step", loader))
    loader.exec_module(module)
    return module


class Counts(unittest.TestCase):
    def check_counts(self, file, entries, corrections, iterations, factors):
        """Corrections and iterations of GMRES a step, and factors, at most."""
        _, summary = script().run(PROGRAM, file, entries)
        found = summary["corrections"] / summary["steps"], summary.get("linear iterations", 0) / summary["steps"], summary["matrices factored"]
        for name, value, most in zip(("corrections a step", "iterations of GMRES a step", "factors"), found, (corrections, iterations, factors)):
            self.assertLessEqual(value, most, f"{file}: {name}")
        self.assertGreater(found[0], 1)

    def test_flow(self):
        self.check_counts("cylinder-wake", {**COARSE, "Time/End time": "600 ms"}, 6.6, 2.6, 7)

    def test_swinging_beam(self):
        self.check_counts("turek-hron-csm3", {"Time/End time": "300 ms"}, 4.8, 3.1, 8)

    def test_beam_in_a_flow(self):
        self.check_counts("turek-hron-fsi2", {**COARSE, "Time/End time": "150 ms"}, 3.6, 0.2, 3)


class Table(unittest.TestCase):
    def run_script(self, *arguments):
        return subprocess.run([sys.executable, SCRIPT, *arguments], capture_output=True, text=True, check=False)

    def test_rows_and_builds_that_are_not_there(self):
        for arguments, message in (((ROOT,), "is no program"), ((PROGRAM, "--program", PROGRAM, "--rows", "nothing"),
                                   "no row begins with nothing")):
            result = self.run_script(*arguments)
            self.assertEqual(result.returncode, 1)
            self.assertIn(message, result.stderr)

    def test_counts(self):
        summary = {"steps": 4, "degrees of freedom": {"velocity": 90, "pressure": 10}, "corrections": 10, "matrices factored": 2,
                   "peak memory of the first rank [bytes]": 3e6}
        self.assertEqual(script().counts_of(summary), ("2.50", "0.00", "2", "30.0"))


if __name__ == "__main__":
    unittest.main()
