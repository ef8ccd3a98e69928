"""The table of what tests take: kinds, the slowest, growth; and measured, which keeps the times of a test and its exit status."""

import os
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SUITE = os.path.join(ROOT, "scripts", "measure", "suite")


def times_in(folder, tests):
    for name, text in tests.items():
        path = os.path.join(folder, "debug", "test_times", name + ("" if name.endswith(".served") else ".time"))
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)


class Suite(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = place.name

    def suite(self, *options):
        return subprocess.run([sys.executable, "-B", SUITE, "--build", self.folder, *options], capture_output=True, text=True, check=False)

    def test_table(self):
        times_in(self.folder, {"runs/waves/tube.release": "3 0.5 7\n", "runs/beam.release": "1 0 1\n", "mesh/cells.debug": "2 0 2\n",
                               "base/units.debug": "0.25 0 1\n", "unit_tests/build": "9 1 5\n",
                               "base/version.debug.time.served": "1 1\n"})
        with open(os.path.join(self.folder, "phases.csv"), "w", encoding="utf-8") as stream:
            stream.write('"packages",9,9\n"compiled, twice",100,150\n"packages",1,2\n')
        done = self.suite("--slowest", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"(?m)^runs +2 +4\.5 +8\.0$")
        self.assertRegex(done.stdout, r"(?m)^unit tests +2 +2\.2 +3\.0$")
        self.assertRegex(done.stdout, r"(?m)^compilation of unit tests +1 +10\.0 +5\.0$")
        self.assertRegex(done.stdout, r"(?m)^all tests +5 +16\.8 +16\.0$")
        self.assertRegex(done.stdout, r"(?m)^compiled, twice +150\.0 +100\.0$")
        self.assertRegex(done.stdout, r"(?m)^packages +2\.0 +1\.0$")
        slowest = [line.split()[-1] for line in done.stdout.splitlines() if "of the clock" in line]
        self.assertEqual(slowest, ["unit_tests/build", "runs/waves/tube.release"])

    def test_growth(self):
        record = os.path.join(self.folder, "record.csv")
        times_in(self.folder, {"runs/a": "3 0 3\n"})
        self.assertIn("Nothing is recorded", self.suite("--before", record).stdout)
        times_in(self.folder, {"runs/a": "3 0 3\n", "mesh/a": "1 0 1\n"})
        self.assertEqual(self.suite("--record", record).returncode, 0)
        times_in(self.folder, {"runs/b": "2 0 3\n", "ledger/a": "5 0 1\n"})
        done = self.suite("--before", record)
        self.assertRegex(done.stdout, r"Growth since \d{4}-\d\d-\d\d, revision \w+")
        self.assertRegex(done.stdout, r"(?m)^runs .* 2\.0$")
        self.assertRegex(done.stdout, r"(?m)^unit tests .* 0\.0$")
        self.assertRegex(done.stdout, r"(?m)^ledger .* new$")
        self.assertRegex(done.stdout, r"(?m)^all tests .* 7\.0$")

    def test_nothing(self):
        done = self.suite()
        self.assertEqual(done.returncode, 1)
        self.assertIn("run scripts/test first", done.stderr)

    def test_phases(self):
        """announce of common.sh keeps what each phase took, the processor time of the programs that the shell has started included."""
        script = f"""set -euo pipefail
            export CONTINUA_BUILD_ROOT={self.folder}
            source {ROOT}/scripts/lib/common.sh
            announce "a busy one"
            {sys.executable} -c 'import time
while time.process_time() < 1.5: pass'
            announce "an idle one"
            sleep 1
            announce"""
        subprocess.run(["bash", "-c", script], check=True, capture_output=True)
        with open(os.path.join(self.folder, "phases.csv"), encoding="utf-8") as stream:
            phases = [line.strip().split(",") for line in stream]
        self.assertEqual([phase[0] for phase in phases], ['"a busy one"', '"an idle one"'])
        self.assertGreaterEqual(int(phases[0][2]), 1)
        self.assertEqual(int(phases[1][2]), 0)
        self.assertGreaterEqual(int(phases[1][1]), 1)

    def test_measured(self):
        program, times = os.path.join(self.folder, "measured"), os.path.join(self.folder, "times", "folder", "test")
        subprocess.run(["cc", "-o", program, os.path.join(ROOT, "tests", "measured.c")], check=True)

        def measured(*command):
            status = subprocess.run([program, times, *command], check=False, stderr=subprocess.DEVNULL).returncode
            with open(times, encoding="utf-8") as stream:
                return status, *map(float, stream.read().split())

        self.assertEqual(measured("sh", "-c", "exit 3")[0], 3)
        self.assertEqual(measured("/no/such/program")[0], 127)
        self.assertEqual(measured("sh", "-c", "kill -9 $$")[0], 137)
        # A served command is no child: its client writes what it took.
        status, user, system, clock = measured("sh", "-c", 'echo "20 3" >>$CONTINUA_SERVED_TIMES; echo "1 1" >>$CONTINUA_SERVED_TIMES; sleep 0.2')
        self.assertEqual(status, 0)
        self.assertTrue(21.0 <= user < 22.0 and 4.0 <= system < 5.0 and 0.2 <= clock < 20.0, (user, system, clock))


if __name__ == "__main__":
    unittest.main()
