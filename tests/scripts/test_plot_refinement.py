#!/usr/bin/python3
"""scripts/plot-refinement: a figure for each quantity that has an error."""

import os
import subprocess
import tempfile
import unittest

SCRIPTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts")
HEADER = ("way,cycle [1],run,cells [1],unknowns [1],cell size [m],time step [s],steps [1],iterations [1],wall time [s],quantity,"
          "unit,value,reference,error,relative error [1],order [1],failure\n")


def plot(*arguments):
    return subprocess.run([os.path.join(SCRIPTS, "plot-refinement"), *arguments], capture_output=True, text=True, check=False)


def write(folder):
    """As a study writes it: one quantity with errors, one that the two runs have alike, and a run that failed."""
    with open(os.path.join(folder, "refinement.csv"), "w", encoding="utf-8") as stream:
        stream.write(HEADER)
        for way, power in (("uniform", 4), ("adaptive", 2)):
            for cycle in range(2):
                run = f'"{way}",{cycle},"{way}-{cycle}",{power**cycle},{100 * power**cycle},0.5,,,,0.5'
                stream.write(f'{run},"tip: displacement y","m",{2 + 0.1**cycle},2,{0.1**cycle},{0.05**cycle},,\n')
                stream.write(f'{run},"mass","kg",5,5,0,0,,\n')
        stream.write('"adaptive",2,"adaptive-2",,,,,,,,,,,,,,,"the run diverges, ""badly"""\n')


class Plot(unittest.TestCase):
    def test_all(self):
        with tempfile.TemporaryDirectory() as folder:
            write(folder)
            done = plot(folder)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertEqual(set(os.listdir(os.path.join(folder, "plots"))),
                             {"refinement-tip-displacement-y.png", "refinement-tip-displacement-y.svg"})
            self.assertIn("left out: mass: no run has an error", done.stdout)

    def test_nothing_to_draw(self):
        with tempfile.TemporaryDirectory() as folder:
            write(folder)
            done = plot(folder, "--quantity", "mass")
            self.assertEqual(done.returncode, 1)
            self.assertIn("nothing to draw", done.stderr)

    def test_another_table(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "refinement.csv"), "w", encoding="utf-8") as stream:
                stream.write("cycle [1],cells [1]\n0,16\n")  # as a steady run with Adaptivity/Cycles writes
            done = plot(folder)
            self.assertEqual(done.returncode, 1)
            self.assertIn("no table of a refinement study", done.stderr)


if __name__ == "__main__":
    unittest.main()
