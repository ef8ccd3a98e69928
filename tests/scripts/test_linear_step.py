#!/usr/bin/python3
"""scripts/measure/linear-step: the table of two programs, and what it refuses."""

import os
import re
import stat
import subprocess
import tempfile
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SCRIPT = os.path.join(ROOT, "scripts", "measure", "linear-step")
# Works for SECONDS a step, and for a fiftieth of a second at each start.
PROGRAM = """#!/usr/bin/python3
import re, sys, time
text = " ".join(sys.argv)
end = re.search(r"Time/End time=([0-9.e+-]+) s", text)
size = re.search(r"Time/Time step=([0-9.e+-]+) s", text)
until = time.process_time() + 0.02 + (float(end[1]) / float(size[1]) * SECONDS if end else 0.0)
while time.process_time() < until:
    sum(range(1000))
print("checks: 0 of 1 passed" if end else "version")
sys.exit(1 if end else 0)
"""


def run(*arguments):
    return subprocess.run([SCRIPT, *arguments], capture_output=True, text=True, check=False)


class LinearStep(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def program(self, name, seconds):
        folder = os.path.join(self.folder.name, name)
        os.makedirs(folder)
        path = os.path.join(folder, "continua")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(PROGRAM.replace("SECONDS", repr(seconds)))
        os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)
        return path

    def test_step(self):
        """One program works in its steps, the other one does not; both start equally fast."""
        other, this = self.program("other", 50e-6), self.program("this", 0.0)
        result = run(os.path.dirname(other), "--program", this, "--repeat", "1", "--rows", "beam", "--output", os.path.join(self.folder.name, "output"))
        self.assertEqual(result.returncode, 0, result.stderr)
        row = re.search(r"\| beam \| ([0-9.e-]+) ms \| (-?[0-9.e-]+) ms \| (-?[0-9.]+) \|", result.stdout)
        self.assertIsNotNone(row, result.stdout)
        times = [float(number) for number in row.groups()]
        self.assertLess(times[1], times[0])
        self.assertAlmostEqual(times[2], times[1] / times[0], delta=0.01)

    def test_refused(self):
        this = self.program("this", 0.0)
        result = run(os.path.join(self.folder.name, "nowhere"), "--program", this)
        self.assertEqual(result.returncode, 1)
        self.assertIn("there is no program", result.stderr)
        result = run(this, "--program", this, "--rows", "beams")
        self.assertEqual(result.returncode, 1)
        self.assertIn("there is no row 'beams'; there are beam, beam-euler", result.stderr)


if __name__ == "__main__":
    unittest.main()
