"""--sweep and Analysis = sweep: the same numbers by one run after the other and side by side; a signal, and what goes on after it."""

import json
import os
import shutil
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

MODULUS = "Materials/beam/Young's modulus"


class Sweep(unittest.TestCase):
    def setUp(self):
        self.folder = self.enterContext(tempfile.TemporaryDirectory())
        self.file = os.path.join(self.folder, "beam.prm")
        with open(self.file, "w", encoding="utf-8") as stream:
            stream.write(f"include {BEAM}\n")

    def run_program(self, *arguments, launcher=()):
        return subprocess.run([*launcher, PROGRAM, self.file, *arguments], capture_output=True, text=True, check=False, cwd=self.folder,
                              env=continua.program.environment())

    def table(self, output):
        """Rows of sweep.csv without the wall times."""
        frame = continua.open(os.path.join(self.folder, output)).table("sweep")
        return frame.drop(columns="wall time").astype(str).values.tolist(), list(frame.columns)

    def test_side_by_side(self):
        options = ("--sweep", f"{MODULUS}=1 MPa to 2 MPa in 2", "--sweep", "Boundaries/free end/Traction=(0 Pa, 1 Pa), (0 Pa, 3 Pa)")
        tables = []
        for n_parallel in ("1", "2"):
            done = self.run_program(*options, "--set", f"Sweep/Parallel runs={n_parallel}", "--output", n_parallel)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            tables.append(self.table(n_parallel))
            self.assertEqual(done.stdout.count(": finished\n"), 4)
        self.assertEqual(tables[0], tables[1])
        rows, columns = tables[0]
        self.assertEqual(columns[:3], ["run", MODULUS, "Boundaries/free end/Traction"])
        self.assertEqual([row[1:3] for row in rows], [["1000000", "0 Pa, 1 Pa"], ["1000000", "0 Pa, 3 Pa"], ["2000000", "0 Pa, 1 Pa"],
                                                ["2000000", "0 Pa, 3 Pa"]])
        # It is linear in the traction.
        place = columns.index("tip: final displacement y")
        self.assertAlmostEqual(float(rows[1][place]) / float(rows[0][place]), 3, places=9)
        # A run of its own is the same, by the command that it names.
        with open(os.path.join(self.folder, "2", rows[2][0], "summary.json"), encoding="utf-8") as stream:
            summary = json.load(stream)
        self.assertNotIn("internal", summary["command line"])
        alone = self.run_program("--set", f"{MODULUS}=2 MPa", "--set", "Boundaries/free end/Traction=0 Pa, 1 Pa", "--output", "alone")
        self.assertEqual(alone.returncode, 0, alone.stderr)
        texts = []
        for path in ("alone", os.path.join("2", rows[2][0])):
            with open(os.path.join(self.folder, path, "probes.csv"), encoding="utf-8") as stream:
                texts.append(stream.read())
        self.assertEqual(texts[0], texts[1])

    def test_restart(self):
        """One run is finished when a signal comes, the other is not; it goes on from its checkpoint."""
        options = ("--sweep", "Time/End time=5 ms, 60 s", "--set", "Sweep/Parallel runs=2", "--output", "pieces")
        pieces = os.path.join(self.folder, "pieces")
        record, long_run = os.path.join(pieces, "checkpoint", "finished runs"), os.path.join(pieces, "end-time-60-s")

        def is_between():
            try:
                with open(record, encoding="utf-8") as stream:
                    return "end-time-5-ms" in stream.read() and os.path.exists(os.path.join(long_run, "probes.csv"))
            except OSError:
                return False

        with subprocess.Popen([PROGRAM, self.file, *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=self.folder,
                              env=continua.program.environment()) as process:
            deadline = time.monotonic() + 60
            while time.monotonic() < deadline and not is_between():
                time.sleep(0.002)
            process.send_signal(signal.SIGTERM)
            _, said = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1, said)
        self.assertIn("interrupted by SIGTERM among the runs of the study; --restart goes on", said)
        self.assertTrue(os.listdir(os.path.join(long_run, "checkpoint")))
        written = os.stat(os.path.join(pieces, "end-time-5-ms", "summary.json")).st_mtime_ns
        done = self.run_program(*options, "--restart")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("end-time-5-ms: was finished before", done.stdout)
        self.assertEqual(os.stat(os.path.join(pieces, "end-time-5-ms", "summary.json")).st_mtime_ns, written)
        restarted = continua.open(long_run)
        self.assertEqual(restarted.summary["restarts"], 1)
        # As in one piece.
        whole = self.run_program("--set", "Time/End time=60 s", "--output", "whole")
        self.assertEqual(whole.returncode, 0, whole.stderr)
        name = "final displacement y"
        values = [results.quantity(name, "tip") for results in (restarted, continua.open(os.path.join(self.folder, "whole")))]
        self.assertAlmostEqual(values[0], values[1], delta=1e-9 * abs(values[1]))

    def test_parent_killed(self):
        """The runs end with the process that started them, each with a checkpoint."""
        pieces = [os.path.join(self.folder, "killed", f"end-time-{seconds}-s") for seconds in (30, 40)]
        with subprocess.Popen([PROGRAM, self.file, "--sweep", "Time/End time=30 s, 40 s", "--set", "Sweep/Parallel runs=2", "--output", "killed"],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=self.folder, env=continua.program.environment()) as process:
            deadline = time.monotonic() + 60
            while time.monotonic() < deadline and not all(os.path.exists(os.path.join(piece, "probes.csv")) for piece in pieces):
                time.sleep(0.002)
            runs = [number for number in self.processes() if number != process.pid]
            self.assertEqual(len(runs), 2)
            process.kill()
        while time.monotonic() < deadline and set(runs) & set(self.processes()):
            time.sleep(0.01)
        self.assertFalse(set(runs) & set(self.processes()))
        for piece in pieces:
            self.assertTrue(os.listdir(os.path.join(piece, "checkpoint")))

    def processes(self):
        """Those that work on the file of the test."""
        numbers = []
        for number in os.listdir("/proc"):
            try:
                with open(f"/proc/{number}/cmdline", "rb") as stream:
                    if number.isdigit() and self.file.encode() in stream.read().split(b"\0"):
                        numbers.append(int(number))
            except OSError:
                continue
        return numbers

    def test_on_ranks(self):
        """Under mpirun the runs take all ranks."""
        done = self.run_program("--sweep", f"{MODULUS}=2 MPa", "--set", "Time/End time=1 ms", "--output", "ranks", launcher=("mpiexec", "-n", "2"))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with open(os.path.join(self.folder, "ranks", "young-s-modulus-2-mpa", "summary.json"), encoding="utf-8") as stream:
            self.assertEqual(json.load(stream)["ranks"], 2)

    def test_large_grid(self):
        """What is wrong with a value of an entry is found before the first of 90 runs, also in the middle of a list."""
        done = self.run_program("--validate", "--sweep", f"{MODULUS}=1 MPa to 9 MPa in 9",
                                "--sweep", "Materials/beam/Poisson's ratio=0, 0.1, 0.2, 0.3, 0.31, 0.32, 0.33, 0.34, 0.6, 0.4")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn("with young's modulus 1 MPa, poisson's ratio 0.6 the input is refused", done.stderr)

    def test_long_list(self):
        """Of a long list of numbers some are read before the runs, and each that the entry does not accept."""
        long_list = [f"{number / 1000}" for number in range(400)]
        done = self.run_program("--validate", "--sweep", "Materials/beam/Poisson's ratio=" + ", ".join([*long_list[:-1], "0.6", "0.399"]))
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn("with poisson's ratio 0.6 the input is refused", done.stderr)

    def test_whole_list(self):
        """A list of which the file gives one number takes several of them as a whole."""
        done = self.run_program("--validate", "--set", "Time/Jump times=1 ms", "--sweep", "Time/Jump times=(1 ms, 2 ms), 3 ms")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("Time/Jump times: 1 ms, 2 ms, 3 ms", done.stdout)

    def test_input_files(self):
        """Input files among the values are relative to the file that names them, and those of --sweep to the working directory."""
        cases = os.path.join(self.folder, "cases")
        os.mkdir(cases)
        for name in ("soft.csv", "a#b, c.csv"):
            shutil.copyfile(os.path.join(ROOT, "tests", "runs", "laboratory", "glass-to-rubber.csv"), os.path.join(cases, name))
        self.file = os.path.join("cases", "relaxation.prm")
        entry = "Materials/wall/Relaxation table"
        with open(os.path.join(self.folder, self.file), "w", encoding="utf-8") as stream:
            stream.write(f"""include {os.path.join(ROOT, "tests", "runs", "laboratory", "relaxation_far_from_power_law.prm")}
unset subsection Expected
set Analysis = sweep
subsection Sweep
  set Parallel runs = 1
  subsection Entries
    set {entry} = soft.csv, "a#b, c.csv"
  end
end
""")
        done = self.run_program("--output", "tables")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        rows, _ = self.table("tables")
        self.assertEqual([row[1] for row in rows], ["soft.csv", "a#b, c.csv"])
        self.assertTrue(os.path.isfile(os.path.join(self.folder, "tables", "relaxation-table-a-b-c-csv", "input", "a#b, c.csv")))
        done = self.run_program("--validate", "--sweep", f"{entry}=soft.csv")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn("'soft.csv'", done.stderr)
        done = self.run_program("--validate", "--sweep", f"{entry}=cases/soft.csv")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
