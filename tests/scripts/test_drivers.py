#!/usr/bin/python3
"""The drivers accept what is right and notice what is wrong, and so does scripts/verify."""

import os
import subprocess
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
FAKE = os.path.join(HERE, "fake_continua.py")
DRIVERS = os.path.join(HERE, "..", "drivers")
VERIFY = os.path.join(HERE, "..", "..", "scripts", "verify")

WRONG_KEY = "# expect: status 2\n# expect: line 3: .*nearest is 'Cells'\nset Cels = 4\n"
CONVERGENCE = ("# level: Mesh/Cells = 4\n# level: Mesh/Cells = 8\n# level: Mesh/Cells = 16\n"
               "# order: velocity error >= 1.99\n# order: tip: frequency >= 1.99, reference 3\n"
               "# order: tip: frequency >= 1.99, differences\n# bound: velocity error <= 0.0040\nset Cells = 1\n")
RANKS = "# ranks: 1, 2, 3\nset Cells = 4\n"
RINGING = "# run: Amplitude = 0.01\n# rings: tip: displacement y <= 0.02\nset Cells = 4\nset End time = 20\n"
LEDGER = "# relaxes: wall >= 0.3\nset Cells = 4\nset Relaxation = 1\n"
RESTART = "# stop: Time/End time = 5\nset Cells = 4\nset End time = 10\n"


class Drivers(unittest.TestCase):
    def drive(self, driver, text):
        """(whether it passed, what it printed)."""
        with tempfile.TemporaryDirectory() as folder:
            case = os.path.join(folder, "case.prm")
            with open(case, "w", encoding="utf-8") as stream:
                stream.write(text)
            done = subprocess.run(["/usr/bin/python3", "-B", os.path.join(DRIVERS, driver + ".py"), FAKE, case,
                                   os.path.join(folder, "work")], capture_output=True, text=True, check=False)
        return done.returncode == 0, done.stdout + done.stderr

    def assert_passes(self, driver, text):
        passed, printed = self.drive(driver, text)
        self.assertTrue(passed, printed)

    def assert_fails(self, driver, text, reason):
        passed, printed = self.drive(driver, text)
        self.assertFalse(passed, printed)
        self.assertRegex(printed, "FAILED: .*" + reason)

    def test_bad_input(self):
        self.assert_passes("bad_input", WRONG_KEY)
        self.assert_passes("bad_input", WRONG_KEY + "# existing: run/summary.json\n")
        self.assert_fails("bad_input", WRONG_KEY + "# expect: a remedy\n", "nothing printed matches 'a remedy'")
        self.assert_fails("bad_input", WRONG_KEY + "# refuse: Cells\n", "something printed matches")
        self.assert_fails("bad_input", WRONG_KEY + "set Misbehave = crash\n", "exit status -6, expected 2")
        self.assert_fails("bad_input", WRONG_KEY + "set Misbehave = folder\n", "made although the input is wrong")
        self.assert_fails("bad_input", WRONG_KEY + "set Cells = 4\n", "exit status 0, expected 2")
        self.assert_fails("bad_input", "# expect: status 2\n", "at least one")

    def test_convergence(self):
        self.assert_passes("convergence", CONVERGENCE)
        self.assert_fails("convergence", CONVERGENCE + "set Misbehave = order\n", "order 1.000 .*at least 1.99")
        self.assert_fails("convergence", CONVERGENCE + "# bound: velocity error <= 0.0039\n", "at most 0.0039")
        self.assert_fails("convergence", CONVERGENCE + "# order: drag >= 1\n", "0 quantities match 'drag'")
        self.assert_fails("convergence", "# order: velocity error >= 1\n", "two or more lines")
        bound = "# level: Mesh/Cells = 16\nset Cells = 1\n# bound: velocity error <= "
        self.assert_passes("convergence", bound + "0.0040\n")
        self.assert_fails("convergence", bound + "0.0039\n", "at most 0.0039")

    def test_ranks(self):
        self.assert_passes("ranks", RANKS)
        self.assert_fails("ranks", RANKS + "set Misbehave = ranks\n", "'tip: displacement y \\[m\\]': off by")
        self.assert_passes("ranks", RANKS + "# tolerance: 3e-6\nset Misbehave = ranks\n")

    def test_restart(self):
        self.assert_passes("restart", RESTART)
        self.assert_fails("restart", RESTART + "set Misbehave = restart\n", "line 8 differs")
        self.assert_fails("restart", RESTART.replace("= 5", "= 10"), "nothing is left to restart")
        self.assert_fails("restart", RESTART + "set Misbehave = steps\n", "'steps' of the summary is 10 .* and 4")
        self.assert_fails("restart", RESTART + "# refused: Cells = 5 -> another case\n", "exit status 0 instead of 2")

    def test_ringing(self):
        loud = "# ringing run: Amplitude = 0.1\n"
        self.assert_passes("ringing", RINGING + loud + "# bound: velocity error <= 0.0626\n")
        self.assert_fails("ringing", RINGING.replace("0.01", "0.1"), "rings with 0.0909, expected at most 0.02")
        self.assert_fails("ringing", RINGING + loud.replace("0.1", "0.01"), "nothing rings, and should")
        self.assert_fails("ringing", RINGING + "# bound: velocity error <= 0.0624\n", "expected at most 0.0624")
        self.assert_fails("ringing", RINGING.replace("displacement y", "pressure"), "no column 'tip: pressure'")

    def test_ledger(self):
        self.assert_passes("ledger", LEDGER)
        self.assert_fails("ledger", LEDGER.replace("n = 1", "n = 0.9"), "relaxed in wall: .* differ")
        self.assert_fails("ledger", LEDGER + "set Misbehave = stored\n", "held, turned into heat and left: .* differ")
        self.assert_fails("ledger", LEDGER + "set Misbehave = balance\n", "not balanced in its middle")
        self.assert_fails("ledger", LEDGER.replace("0.3", "0.4"), "wall turns 0.333 of the work into heat")

    def verify(self, text, *options):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "case.prm"), "w", encoding="utf-8") as stream:
                stream.write(text)
            return subprocess.run([VERIFY, os.path.join(folder, "*.prm"), "--program", FAKE, "--output",
                                   os.path.join(folder, "output"), *options],
                                  capture_output=True, text=True, check=False)

    def test_verify(self):
        done = self.verify("set Cells = 4\n", "--markdown")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("| frequency (tip) | passed | 3.0625 Hz | 3 Hz +- 10 % |", done.stdout)
        done = self.verify("set Cells = 4\nset Misbehave = value\n")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, "frequency \\(tip\\) +FAILED")
        done = self.verify("set Cels = 4\n")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, "the run +FAILED +exit status 2")


if __name__ == "__main__":
    unittest.main()
