#!/usr/bin/python3
"""scripts/plot-comparison: a figure for each quantity and field, with what converges and what does not."""

import os
import subprocess
import tempfile
import unittest

SCRIPTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts")
WAYS = (("taylor hood", "taylor-hood"), ("cell-wise", "cell-wise"))


def plot(*arguments):
    return subprocess.run([os.path.join(SCRIPTS, "plot-comparison"), *arguments], capture_output=True, text=True,
                          check=False)


def write(folder):
    """As a comparison writes it: one quantity with orders 4 and 2, one without; the finest cell-wise run has failed."""
    with open(os.path.join(folder, "runs.csv"), "w", encoding="utf-8") as stream:
        stream.write("run,way,mesh [1],cells [1],cell size [m],time step [s],steps [1],unknowns [1],wall time [s],failure\n")
        for mesh in range(3):
            for way, name in WAYS:
                failure = "the run diverges, \"\"badly\"\"" if (way, mesh) == ("cell-wise", 2) else ""
                stream.write(f'"{name}-{mesh}","{way}",{mesh},{100 * 4**mesh},{0.5**(mesh + 1)},0.1,2,{1000 * 4**mesh},'
                             f'{0.1 * 6**mesh},"{failure}"\n')
                run = os.path.join(folder, f"{name}-{mesh}")
                os.makedirs(run)
                with open(os.path.join(run, "probes.csv"), "w", encoding="utf-8") as probes:
                    probes.write("time [s],tip: displacement y [m]\n0,0\n0.1,0.2\n0.2,0.3\n")
    header = ["quantity [unit]"]
    for way, _ in WAYS:
        header += [f"{way}, {what}" for what in ("mesh 0", "mesh 1", "mesh 2", "extrapolated", "estimated error", "order [1]",
                                                 "sequence")]
    header += ["difference", "difference over errors [1]", "verdict"]
    with open(os.path.join(folder, "comparison.csv"), "w", encoding="utf-8") as stream:
        stream.write(",".join(f'"{name}"' for name in header) + "\n")
        stream.write('"tip: final displacement y [m]",0.306,0.304125,0.3040078125,0.304,1e-05,4,"4.00",'
                     '0.324,0.309,,0.304,0.015,,"two meshes",0,0.1,"agree"\n')
        stream.write('"bottom, left: frequency [Hz]",1,2,3,,,,"diverges",3,3.1,,3.1,0.1,,"two meshes",,,"not judged"\n')


class Plot(unittest.TestCase):
    def test_all(self):
        with tempfile.TemporaryDirectory() as folder:
            write(folder)
            done = plot(folder)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            there = set(os.listdir(os.path.join(folder, "plots")))
            self.assertLessEqual({"comparison-tip-final-displacement-y.png", "comparison-bottom-left-frequency.png",
                                  "history-displacement-y.png", "history-displacement-y.csv"}, there)
            with open(os.path.join(folder, "plots", "history-displacement-y.csv"), encoding="utf-8") as stream:
                header = stream.readline()
            # The finest run of either way that finished.
            self.assertIn("taylor hood, mesh 2", header)
            self.assertIn("cell-wise, mesh 1", header)

    def test_one_quantity(self):
        with tempfile.TemporaryDirectory() as folder:
            write(folder)
            plots = os.path.join(folder, "elsewhere")
            done = plot(folder, "--quantity", "frequency", "--output", plots)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertNotIn("comparison-tip-final-displacement-y.png", os.listdir(plots))

    def test_no_comparison(self):
        with tempfile.TemporaryDirectory() as folder:
            done = plot(folder)
            self.assertEqual(done.returncode, 1)
            self.assertIn("none of the files that a run of Continua writes", done.stderr)


if __name__ == "__main__":
    unittest.main()
