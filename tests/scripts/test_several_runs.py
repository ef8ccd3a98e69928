"""Several parameter files in one call: each is run as if alone, and one that fails leaves the others as they are."""

import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))
BEAM = os.path.join(ROOT, "tests", "bad_input", "common", "beam.prm")
sys.path.insert(0, os.path.join(ROOT, "python"))

import continua  # noqa: E402


class SeveralRuns(unittest.TestCase):
    def setUp(self):
        self.folder = self.enterContext(tempfile.TemporaryDirectory())

    def write(self, name, text=""):
        path = os.path.join(self.folder, name + ".prm")
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(f"include {BEAM}\n{text}")
        return path

    def run_program(self, *arguments, launcher=()):
        return subprocess.run([*launcher, PROGRAM, *arguments], capture_output=True, text=True, check=False, cwd=self.folder,
                              env=continua.program.environment())

    def state(self, *names):
        """What a run has found, without what is of the call."""
        with open(os.path.join(self.folder, *names, "probes.csv"), encoding="utf-8") as stream:
            return stream.read()

    def summary(self, *names):
        with open(os.path.join(self.folder, *names, "summary.json"), encoding="utf-8") as stream:
            return json.load(stream)

    def test_each_as_if_alone(self):
        first = self.write("first")
        second = self.write("deeper/second", "set Title = Another\n")
        wrong = self.write("wrong", "set Titel = Another\n")
        failing = self.write("failing", "subsection Time\n  set Velocity limit = 1 nm/s\nend\n")
        alone = self.run_program(first, "--output", "alone", "--set", "Time/End time=20 ms")
        self.assertEqual(alone.returncode, 0, alone.stderr)
        for jobs in (1, 2):
            output = f"together-{jobs}"
            done = self.run_program(first, wrong, failing, second, "--output", output, "--jobs", str(jobs),
                                    "--set", "Time/End time=20 ms")
            self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
            self.assertIn("== 2 of 4 runs done", done.stdout)
            self.assertIn(f"{wrong}: refused\n", done.stderr)
            self.assertIn(f"{failing}: not finished\n", done.stderr)
            screen = done.stdout + done.stderr
            self.assertIn("'Titel': unknown entry", screen)
            # The screens follow each other whole.
            order = [done.stdout.index(f"== {path}") for path in (first, second)]
            self.assertEqual(order, sorted(order))
            self.assertEqual(self.state(output, "first"), self.state("alone"))
            self.assertEqual(self.summary(output, "second")["title"], "Another")
            self.assertFalse(os.path.exists(os.path.join(self.folder, output, "wrong")))
            self.assertEqual(self.summary(output, "failing")["status"], "failed")
        # The command that a run names makes it alone.
        self.assertIn("--output together-2/first", self.summary("together-2", "first")["command line"])
        refused = self.run_program(first, wrong, "--output", "two", "--set", "Time/End time=5 ms")
        self.assertEqual(refused.returncode, 2, refused.stdout + refused.stderr)

    def test_refusals(self):
        first = self.write("first")
        missing = self.run_program(first, "results")
        self.assertEqual(missing.returncode, 2)
        self.assertIn("'results': there is no such parameter file", missing.stderr)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "output")))
        launched = self.run_program(first, self.write("second"), launcher=("mpiexec", "-n", "2"))
        self.assertEqual(launched.returncode, 2)
        self.assertIn("a launcher of its own", launched.stderr)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "output")))

    def test_signal(self):
        """It goes to the run that is at work, and none begins behind it."""
        long = self.write("long", "subsection Time\n  set End time = 1000 s\nend\n")
        with subprocess.Popen([PROGRAM, long, self.write("second")], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              cwd=self.folder) as process:
            log = os.path.join(self.folder, "output", "long", "power.csv")
            end = time.monotonic() + 60
            while not os.path.exists(log) and time.monotonic() < end:
                time.sleep(0.05)
            process.send_signal(signal.SIGTERM)
            _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1, errors)
        self.assertIn("long.prm: not finished\n", errors)
        self.assertIn("second.prm: not begun\n", errors)
        self.assertEqual(self.summary("output", "long")["status"], "interrupted")

    def test_python(self):
        first = self.write("first")
        runs = [{"parameter_file": first, "sets": {"Time/End time": "20 ms", "Title": f"run {i}"},
                 "output": os.path.join(self.folder, f"run {i}")} for i in range(3)]
        runs[1]["sets"]["Titel"] = "wrong"
        results = continua.run_many(runs, jobs=2, program=PROGRAM, keep_failures=True)
        self.assertEqual([results[i].summary["title"] for i in (0, 2)], ["run 0", "run 2"])
        self.assertIsInstance(results[1], continua.RunFailed)
        self.assertEqual(results[1].status, 2)
        self.assertIn("Titel", str(results[1]))
        with self.assertRaisesRegex(continua.RunFailed, "Titel"):
            continua.run_many([{**run, "overwrite": True} for run in runs], program=PROGRAM)
        with self.assertRaisesRegex(ValueError, "two runs have the folder"):
            continua.run_many([runs[0], runs[0]], program=PROGRAM)
        with self.assertRaisesRegex(ValueError, "it needs a parameter_file"):
            continua.run_many([{**runs[0], "ranks": 2}], program=PROGRAM)

    def test_interrupted_python(self):
        """The run at work ends after its present step, and none begins behind it."""
        code = f"""
import sys
sys.path.insert(0, {os.path.join(ROOT, "python")!r})
import continua
runs = [dict(parameter_file={self.write("case")!r}, sets={{"Time/End time": end}}, output=f"run {{i}}", overwrite=True)
        for i, end in enumerate(["5 ms", "1000 s", "1000 s"])]
continua.run_many(runs, program={PROGRAM!r})
"""
        with subprocess.Popen([sys.executable, "-c", code], stderr=subprocess.PIPE, text=True, cwd=self.folder) as process:
            log = os.path.join(self.folder, "run 1", "power.csv")
            end = time.monotonic() + 60
            while not os.path.exists(log) and time.monotonic() < end:
                time.sleep(0.05)
            process.send_signal(signal.SIGINT)
            _, errors = process.communicate(timeout=60)
        self.assertIn("KeyboardInterrupt", errors.splitlines()[-1])
        self.assertEqual(self.summary("run 0")["status"], "finished")
        end = time.monotonic() + 60
        while continua.open(os.path.join(self.folder, "run 1")).status == "running" and time.monotonic() < end:
            time.sleep(0.05)
        self.assertEqual(continua.open(os.path.join(self.folder, "run 1")).status, "interrupted")
        self.assertFalse(os.path.exists(os.path.join(self.folder, "run 2")))


if __name__ == "__main__":
    unittest.main()
