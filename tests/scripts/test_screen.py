"""drivers/screen.py: round-off may decide how many corrections a search for a steady state needs, and nothing else."""

import os
import subprocess
import sys
import tempfile
import unittest

SCREEN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "drivers", "screen.py")
PRINTED = "Mesh: 8 cells\nAt rest after 20 steps of 1 s to 512 s with 80 corrections; the loads came in 4 of them\nload: 2.5 Pa\n"


class Screen(unittest.TestCase):
    def compare(self, printed, wanted=PRINTED):
        """(whether the screen agrees with what is wanted, what the driver says)."""
        with tempfile.TemporaryDirectory() as folder:
            reference = os.path.join(folder, "case.output")
            with open(reference, "w", encoding="utf-8") as stream:
                stream.write(wanted)
            done = subprocess.run([sys.executable, "-B", SCREEN, reference, os.path.join(folder, "work"), "printf", "%s", printed],
                                  capture_output=True, text=True, check=False)
        return done.returncode == 0, done.stdout + done.stderr

    def test_counts(self):
        self.assertEqual(self.compare(PRINTED), (True, ""))
        self.assertEqual(self.compare(PRINTED.replace("20 steps of 1 s to 512 s", "21 steps of 1 s to 1024 s").replace("80 ", "97 ")), (True, ""))
        for found, wanted in (("80 corrections", "101 corrections"), ("20 steps", "14 steps")):
            passed, text = self.compare(PRINTED.replace(found, wanted))
            self.assertFalse(passed)
            self.assertIn("expected [20, 80] within a quarter or two", text)

    def test_a_body_that_is_at_rest(self):
        at_once = PRINTED.replace("20 steps of 1 s to 512 s with 80 corrections; the loads came in 4 of them", "1 steps")
        self.assertEqual(self.compare(at_once.replace("1 steps", "3 steps of 1 s to 4 s with 1 corrections"), at_once)[1], "")
        self.assertIn("are [4, 1], expected [1, 0]", self.compare(at_once.replace("1 steps", "4 steps of 1 s to 8 s with 1 corrections"), at_once)[1])

    def test_the_rest(self):
        for found, wanted in (("4 of them", "5 of them"), ("2.5 Pa", "2.5001 Pa"), ("At rest after", "Found after"), ("8 cells", "9 cells")):
            passed, text = self.compare(PRINTED.replace(found, wanted))
            self.assertFalse(passed, wanted)
            self.assertIn("differs from", text)
        self.assertFalse(self.compare(PRINTED.split("At rest")[0])[0])


if __name__ == "__main__":
    unittest.main()
