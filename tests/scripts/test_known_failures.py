"""scripts/verify tells a check that is known to fail from a new failure, and the manual's page lists the same ones."""

import os
import re
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "..", "..")
sys.path.insert(0, os.path.join(ROOT, "scripts", "lib"))
sys.dont_write_bytecode = True
import case_runs  # noqa: E402

PAGE = os.path.join(ROOT, "doc", "known-failures.md")
PROGRAM = """#!/bin/sh
while [ "$1" != --output ]; do shift; done
mkdir -p "$2"
cat > "$2/summary.json" << 'END'
{"status": "finished", "checks": [
  {"name": "speed", "probe": "", "passed": %s, "value": 3, "unit": "m/s", "criterion": "2 m/s +- 1 %%"},
  {"name": "height", "probe": "tube", "passed": %s, "value": 1, "unit": "Pa", "criterion": "1 Pa +- 1 %%"}]}
END
"""


def shipped():
    """{(short name of a file, check): reason} of all shipped files."""
    return {(case_runs.name_of(path), check): reason for path in case_runs.shipped_files()
            for check, reason in case_runs.KnownFailures(case_runs.texts_of(path)[0][1]).reasons.items()}


class KnownFailures(unittest.TestCase):
    def verify(self, comments, speed, height):
        """(exit status, what verify prints) of a file with these comments and checks."""
        with tempfile.TemporaryDirectory() as place:
            case, program = os.path.join(place, "case.prm"), os.path.join(place, "program")
            with open(case, "w", encoding="utf-8") as stream:
                stream.write(comments)
            with open(program, "w", encoding="utf-8") as stream:
                stream.write(PROGRAM % (speed, height))
            os.chmod(program, 0o755)
            done = subprocess.run([sys.executable, "-B", os.path.join(ROOT, "scripts", "verify"), case, "--program", program, "--output",
                                   os.path.join(place, "out")], check=False, capture_output=True, text=True)
            return done.returncode, done.stdout + done.stderr

    def test_known_failure(self):
        status, text = self.verify("# known to fail: speed: because it is fast\n", "false", "true")
        self.assertEqual(status, 0, text)
        self.assertRegex(text, r"speed +known to fail +3 m/s")
        self.assertIn("1 of 2 checks hold, 1 fail as known", text)

    def test_new_failure(self):
        status, text = self.verify("# known to fail: speed: because it is fast\n", "false", "false")
        self.assertEqual(status, 1)
        self.assertRegex(text, r"height \(tube\) +FAILED")
        self.assertEqual(self.verify("", "false", "true")[0], 1)

    def test_name_with_a_probe(self):
        self.assertEqual(self.verify("# known to fail: height (tube): because it is low\n", "true", "false")[0], 0)

    def test_holds_all_the_same(self):
        status, text = self.verify("# known to fail: speed: because it is fast\n", "true", "true")
        self.assertEqual(status, 1)
        self.assertRegex(text, r"speed +FAILED .*remove this comment")

    def test_no_such_check(self):
        status, text = self.verify("# known to fail: depth: because it is deep\n", "true", "true")
        self.assertEqual(status, 1)
        self.assertRegex(text, r"depth +FAILED +no such check")

    def test_shipped_ones_have_a_reason(self):
        for (name, check), reason in shipped().items():
            self.assertTrue(reason, f"{name}: {check}")

    def test_page_lists_the_shipped_ones(self):
        with open(PAGE, encoding="utf-8") as stream:
            rows = re.findall(r"^\| `([^`|]+)` \| ([^|]+?) \|", stream.read(), re.MULTILINE)
        self.assertEqual(sorted(rows), sorted(shipped()))


if __name__ == "__main__":
    unittest.main()
