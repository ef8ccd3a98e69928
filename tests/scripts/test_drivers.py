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

WRONG_KEY = "# expect: status 2\n# expect: case\\.prm:3: .*nearest is 'Cells'\nset Cels = 4\n"
CONVERGENCE = ("# level: Mesh/Cells = 4\n# level: Mesh/Cells = 8\n# level: Mesh/Cells = 16\n"
               "# order: velocity error = 1.99 .. 2.01\n# order: tip: frequency = 1.9 .. 2.1, reference 3\n"
               "# order: tip: frequency = 1.9 .. 2.1, differences\n# bound: velocity error <= 0.0040\nset Cells = 1\n")
RANKS = "# ranks: 1, 2, 3\nset Cells = 4\n"
MESH_CHANGES = ("# changes: 4\n# of equal size: 6\n# ranks: 2, 3\n# pieces: 2, 1\n# stops: 5\nset Cells = 4\nset Relaxation = 1\n"
                "set End time = 10\n")
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
        self.assertRegex(printed, "(?s)FAILED: .*" + reason)

    def test_bad_input(self):
        self.assert_passes("bad_input", WRONG_KEY)
        self.assert_passes("bad_input", WRONG_KEY + "# existing: run/summary.json\n")
        self.assert_fails("bad_input", WRONG_KEY + "# expect: a remedy\n", "nothing printed matches 'a remedy'")
        self.assert_fails("bad_input", WRONG_KEY + "# refuse: Cells\n", "something printed matches")
        self.assert_fails("bad_input", WRONG_KEY + "set Misbehave = crash\n", "exit status -6, expected 2")
        self.assert_fails("bad_input", WRONG_KEY + "set Misbehave = folder\n", "made although the input is wrong")
        self.assert_fails("bad_input", WRONG_KEY + "set Cells = 4\n", "exit status 0, expected 2")
        self.assert_fails("bad_input", "# expect: status 2\n", "at least one")

    def test_bad_input_asks_for_the_line(self):
        without = WRONG_KEY.replace("case\\.prm:3: .*nearest", "nearest")
        self.assert_fails("bad_input", without, "no '# expect:' asks for the file and the line")
        self.assert_fails("bad_input", without + "# no line: the command line is to blame\n", "'no line', but the program printed")
        self.assert_passes("bad_input", without + "# no line: the command line is to blame\nset Misbehave = no line\n")
        self.assert_fails("bad_input", WRONG_KEY + "set Misbehave = no line\n", "nothing printed matches")
        other_line = WRONG_KEY.replace("prm:3", "prm:4") + "set Misbehave = wrong line\n"
        self.assert_fails("bad_input", other_line, "points to the line 'set Misbehave = wrong line', which has no 'Cels'")
        self.assert_fails("bad_input", WRONG_KEY + "# expect: case\n", "shows nothing: the name")
        self.assert_fails("bad_input", WRONG_KEY + "# expect: nearest.*cells|Cells\n", "alternatives outside of brackets")
        self.assert_passes("bad_input", WRONG_KEY + "# expect: nearest.*(cells|Cells|[|])\n")

    def test_convergence(self):
        self.assert_passes("convergence", CONVERGENCE)
        self.assert_fails("convergence", CONVERGENCE + "set Misbehave = order\n", "order 1.000 .*expected 1.99 .. 2.01")
        high = CONVERGENCE.replace("1.99 .. 2.01", "1.7 .. 1.9")
        self.assert_fails("convergence", high, "velocity error: order 2.000 .*expected 1.7 .. 1.9")
        wild = CONVERGENCE.replace("Cells = 4\n", "Cells = 7.9\n")
        self.assert_fails("convergence", wild, "between levels 1 and 2, expected 1.49 .. 2.51")
        self.assert_fails("convergence", CONVERGENCE + "# order: velocity error = 1 .. 3\n", "wider than one order")
        wide = CONVERGENCE + "# order: velocity error = 1.8 .. 2.2\n"
        self.assert_fails("convergence", wide, "'1.8 .. 2.2' is wider than 0.2")
        self.assert_passes("convergence", wide + "# wider because: a test of the test\n")
        self.assert_fails("convergence", CONVERGENCE + "# order: velocity error >= 1\n", "cannot read")
        self.assert_fails("convergence", CONVERGENCE + "# bound: velocity error <= 0.0039\n", "at most 0.0039")
        self.assert_fails("convergence", CONVERGENCE + "# order: drag = 1 .. 2\n", "0 quantities match 'drag'")
        self.assert_fails("convergence", "# order: velocity error = 1 .. 2\n", "two or more lines")
        bound = "# level: Mesh/Cells = 16\nset Cells = 1\n# bound: velocity error <= "
        self.assert_passes("convergence", bound + "0.0040\n")
        self.assert_fails("convergence", bound + "0.0039\n", "at most 0.0039")

    def test_ranks(self):
        self.assert_passes("ranks", RANKS)
        self.assert_fails("ranks", RANKS + "set Misbehave = ranks\n", "'tip: displacement y \\[m\\]': off by")
        self.assert_passes("ranks", RANKS + "# tolerance: 3e-6\nset Misbehave = ranks\n")

        self.assert_fails("ranks", RANKS + "set Misbehave = choices\n", "chose otherwise:.*fluid block: relaxation")
        self.assert_passes("ranks", RANKS + "# others: Cells = 4\nset Misbehave = choices\n")

    def test_mesh_changes(self):
        self.assert_passes("mesh_changes", MESH_CHANGES)
        self.assert_fails("mesh_changes", MESH_CHANGES.replace("changes: 4", "changes: 5"), "changes too seldom")
        self.assert_fails("mesh_changes", MESH_CHANGES + "set Misbehave = still\n", "too few changes keep the number")
        self.assert_fails("mesh_changes", MESH_CHANGES + "set Misbehave = choices\n", "chose otherwise")
        self.assert_fails("mesh_changes", MESH_CHANGES + "set Misbehave = ranks\n", "'tip: displacement y .*off by")
        self.assert_fails("mesh_changes", MESH_CHANGES + "set Misbehave = restart\n", "rows in")
        self.assert_fails("mesh_changes", MESH_CHANGES.replace("# stops: 5\n", ""), "one stop between each piece")

    def test_restart(self):
        self.assert_passes("restart", RESTART)
        self.assert_fails("restart", RESTART + "set Misbehave = restart\n", "line 8 differs")
        self.assert_fails("restart", RESTART.replace("= 5", "= 10"), "nothing is left to restart")
        self.assert_fails("restart", RESTART + "set Misbehave = steps\n", "'steps' of the summary is 10 .* and 4")
        self.assert_fails("restart", RESTART + "# refused: Cells = 5 -> another case\n", "exit status 0 instead of 2")
        self.assert_fails("restart", RESTART + "set Misbehave = field\n", "field 'velocity' at .* the tolerance 0 of it")
        self.assert_passes("restart", RESTART + "# tolerance: 2e-6\nset Misbehave = field\n")
        self.assert_passes("restart", RESTART + "set Misbehave = ascii\n")
        other_order = RESTART + "set Misbehave = order of cells\n"
        self.assert_fails("restart", other_order, "the cell at .* is another one")
        self.assert_passes("restart", other_order + "# cells: in another order\n")

    def test_unchanged(self):
        case = "# run: Amplitude = 0.01\n# run: Amplitude = 0.02\n# tolerance: {}\nset Cells = 4\n"
        self.assert_passes("unchanged", case.format("0.02"))
        self.assert_fails("unchanged", case.format("0.005"), "more than 0.005 of the largest")
        self.assert_passes("unchanged", case.format("0.005\n# tolerance of displacement y: 0.02"))
        self.assert_fails("unchanged", case.format("0.02\n# tolerance of displacement y: 0.005"), "more than 0.005 of the largest")
        self.assert_fails("unchanged", case.format("0.02\n# tolerance of pressure: 0.01"), "no column of this field")
        other_file = case.replace("run: Amplitude = 0.02", "run: case.prm; Amplitude = 0.02")
        self.assert_passes("unchanged", other_file.format("0.02"))
        self.assert_fails("unchanged", other_file.format("0.005"), "more than 0.005 of the largest")
        self.assert_fails("unchanged", case.replace("run: Amplitude = 0.02", "run: missing.prm").format("0.02"), "missing.prm")

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

    def test_balance(self):
        case = "# term: 1 * tip: displacement y\n# term: -{} * tip: {}\n# tolerance: 1e-3\nset Cells = 4\n"
        self.assert_passes("balance", case.format("1.0009", "displacement y"))
        self.assert_fails("balance", case.format("1.0011", "displacement y"), "the terms do not cancel")
        self.assert_fails("balance", case.format("1", "pressure"), "no column 'tip: pressure'")
        self.assert_fails("balance", case.format("0", "displacement y"), "a term is zero at all times")

    def verify(self, files, *options, calls=1):
        """The last of some calls with the same files and the same folder for results."""
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                with open(os.path.join(folder, name), "w", encoding="utf-8") as stream:
                    stream.write(text)
            for _ in range(calls):
                done = subprocess.run([VERIFY, os.path.join(folder, "*.prm"), "--program", FAKE, "--output",
                                       os.path.join(folder, "output"), *options],
                                      capture_output=True, text=True, check=False)
        return done

    def compare_screens(self, reference, printed):
        """Whether screen.py takes what was printed for the reference."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "reference")
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(reference)
            done = subprocess.run(["/usr/bin/python3", "-B", os.path.join(DRIVERS, "screen.py"), path, os.path.join(folder, "work"),
                                   "/usr/bin/printf", "%s", printed], capture_output=True, text=True, check=False)
        return done.returncode == 0

    def test_screen(self):
        """Numbers are compared as numbers whatever stands beside them: blanks, commas of a table, brackets."""
        for separator in (" ", ",", ";"):
            row = separator.join(["a", "{}", "5", "({}"]) + ")\n"
            reference = row.format("123.456", "1e5")
            for first, second in (("123.456000001", "1e5"), ("1.23456e2", "100000.0001")):
                self.assertTrue(self.compare_screens(reference, row.format(first, second)), repr(separator))
            for first, second in (("123.457", "1e5"), ("123.456", "100001"), ("nan", "1e5"), ("", "1e5")):
                self.assertFalse(self.compare_screens(reference, row.format(first, second)), repr(separator))
        self.assertFalse(self.compare_screens("a, 1\n", "b, 1\n"))
        self.assertFalse(self.compare_screens("a, 1\n", "a, 1\na, 1\n"))

    def test_screen_of_a_fit(self):
        """Limits of intervals count to two digits where parameters trade off, and in full elsewhere."""
        row = "modulus 25460 +- 4100 Pa (95 %: {} to 37160 Pa)\n"
        together = "'modulus' and 'angle' trade off: with more of the one the data fit less of the other\n"
        self.assertTrue(self.compare_screens(row.format("17450") + together, row.format("17460") + together))
        self.assertFalse(self.compare_screens(row.format("17450") + together, row.format("18600") + together))
        self.assertFalse(self.compare_screens(row.format("17450"), row.format("17460")))

    def test_verify(self):
        done = self.verify({"case.prm": "set Cells = 4\n"}, "--markdown")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("| frequency (tip) | passed | 3.0625 Hz | 3 Hz +- 10 % | 2.5 s |", done.stdout)
        done = self.verify({"case.prm": "set Cells = 4\nset Misbehave = value\n"})
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, "frequency \\(tip\\) +FAILED")
        done = self.verify({"case.prm": "set Cels = 4\n"})
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, "the run +FAILED +exit status 2")
        done = self.verify({"case.prm": "set Cells = 4\nset Misbehave = nothing\n"})
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, "the run +FAILED +expects nothing")

    def test_verify_expects_a_failure(self):
        fails = "# expect: status 1\n# expect: the loop diverges\nset Cells = 4\nset Fails = the loop diverges\n"
        for calls in 1, 2:
            done = self.verify({"case.prm": fails}, "--keep", calls=calls)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stdout, "failure of the run +passed +exit status 1 ")
            self.assertIn("kept" if calls == 2 else "(run", done.stderr)
        done = self.verify({"case.prm": fails.replace("set Fails = the loop diverges", "set Fails = disk full")})
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, "FAILED +exit status 1 without 'the loop diverges'")
        done = self.verify({"case.prm": fails.replace("set Fails = the loop diverges\n", "")})
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, "FAILED +exit status 0")

    def test_verify_goes_on(self):
        files = {"done.prm": "set Cells = 4\n", "long.prm": "# Cost: 2 min\nset Cells = 4\nset Interrupted = true\n",
                 "short.prm": "# Cost: 3 s on one core.\nset Cells = 4\n"}
        done = self.verify(files, "--keep")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, "long +the run +FAILED +exit status 1")
        order = [done.stderr.index(name) for name in ("short: ", "long: ", "done: ")]
        self.assertEqual(sorted(order), order, "cheap ones first, those of unknown cost last")
        done = self.verify(files, "--keep", "--jobs", "2", calls=2)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stderr, "long: 1 of 1 hold .continued")
        self.assertRegex(done.stderr, "short: 1 of 1 hold .kept")
        self.assertRegex(self.verify(files, calls=2).stderr, "short: 1 of 1 hold .run")

    def test_verify_all(self):
        done = subprocess.run([VERIFY, "--all", "case.prm"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("--all takes no GLOB", done.stderr)


if __name__ == "__main__":
    unittest.main()
