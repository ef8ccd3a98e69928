"""A run that the command line changes: what it expects and can no longer state is not compared, and its parameters run again."""

import json
import os
import subprocess
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))
BEAM = os.path.join(ROOT, "tests", "bad_input", "common", "beam.prm")
TUBE = os.path.join(ROOT, "parameter_files", "new", "tube.prm")


class ChangedRun(unittest.TestCase):
    def setUp(self):
        self.folder = self.enterContext(tempfile.TemporaryDirectory())

    def write(self, included, expected):
        path = os.path.join(self.folder, "case.prm")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(f"include {included}\nsubsection Expected\n{expected}end\n")
        return path

    def run_program(self, *arguments):
        return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=False, cwd=self.folder)

    def test_run(self):
        case = self.write(BEAM, "set tip: frequency = 1 Hz +- 1 %\n")
        output = os.path.join(self.folder, "run")
        done = self.run_program(case, "--output", output, "--unset", "Probes/tip")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("check: frequency (tip): not compared: changed by --unset Probes/tip\n", done.stdout)
        with open(os.path.join(output, "summary.json"), encoding="utf-8") as stream:
            check, = json.load(stream)["checks"]
        self.assertIsNone(check["passed"])
        self.assertEqual(check["not compared: changed by"], "--unset Probes/tip")
        # What a run writes, runs.
        again = self.run_program(os.path.join(output, "parameters.prm"), "--validate")
        self.assertEqual(again.returncode, 0, again.stdout + again.stderr)

    def test_theory(self):
        case = self.write(TUBE, "set stations: theoretical wave speed = 9 m/s +- 90 %\n")
        done = self.run_program(case, "--validate", "--set", "Wave theory/Overlay=false")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        # A misspelt name stays a mistake, until it is taken out.
        case = self.write(TUBE, "set stations: theoretical wave sped = 9 m/s +- 90 %\n")
        done = self.run_program(case, "--validate", "--set", "Wave theory/Overlay=false")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn("Did you mean 'stations: theoretical wave speed'", done.stderr)
        for taken_out in ("Expected", "Expected/stations: theoretical wave sped"):
            done = self.run_program(case, "--validate", "--unset", taken_out)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
