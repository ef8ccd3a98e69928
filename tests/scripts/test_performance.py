#!/usr/bin/python3
"""scripts/measure/performance: its table of a measurement that is given, and what it refuses. Nothing is timed."""

import contextlib
import importlib.machinery
import importlib.util
import io
import os
import subprocess
import sys
import unittest
import unittest.mock

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCRIPT = os.path.join(ROOT, "scripts", "measure", "performance")
PROGRAM = os.environ["CONTINUA_PROGRAM"]


def script():
    """The script as a module."""
    loader = importlib.machinery.SourceFileLoader("performance", SCRIPT)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("performance", loader))
    loader.exec_module(module)
    return module


class Table(unittest.TestCase):
    def test_least_of_each_program(self):
        module = script()
        # Two programs in turns, twice.
        found = iter([[3., 1.], [7., 9.], [2., 4.], [8., 5.]])
        module.ROWS = {"2": ("factor", ["s", "kB"], "1.0 s, 20 kB", "2.7 s, 43 kB", "0.67 s", lambda program: next(found))}
        arguments = ["performance", "--program", PROGRAM, "--other", PROGRAM, "--repeat", "2", "--rows", "2"]
        with unittest.mock.patch.object(sys, "argv", arguments), unittest.mock.patch.dict(os.environ), contextlib.redirect_stdout(io.StringIO()) as text:
            module.main()
        self.assertEqual(text.getvalue().splitlines()[-1], "| 2 | factor | 1.0 s, 20 kB | 2.7 s, 43 kB | 2 s, 1 kB | 7 s, 5 kB | 0.67 s |")

    def test_step_is_the_difference_of_two_runs(self):
        module = script()
        runs = {"1 s": (5., {"steps": 10}), "3 s": (5.8, {"steps": 50})}
        module.run = lambda program, file, entries: runs[entries["Time/End time"]]
        self.assertAlmostEqual(module.step("file", {}, ("1 s", "3 s"))(PROGRAM)[0], 20.)

    def test_part_of_a_run_beside_other_work(self):
        # A run that had half of a core.
        walls = {"wall time [s]": {"total": 40., "factor": 10.}}
        self.assertAlmostEqual(script().time_of("factor", 20., walls), 5.)
        self.assertAlmostEqual(script().time_of("factor", 44., walls), 10.)

    def test_refusals(self):
        for arguments, message in ((["--program", ROOT], "is no program"), (["--rows", "12"], "there is no row '12'"), (["--repeat", "0"], "at least 1")):
            result = subprocess.run([sys.executable, SCRIPT, *arguments], capture_output=True, text=True, check=False)
            self.assertEqual(result.returncode, 1)
            self.assertIn(message, result.stderr)


if __name__ == "__main__":
    unittest.main()
