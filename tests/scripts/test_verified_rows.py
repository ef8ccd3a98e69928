"""scripts/verify keeps what it finds with date and revision, and says what is older than the code."""

import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "scripts", "lib"))
sys.dont_write_bytecode = True
import verified_rows  # noqa: E402

VERIFY = os.path.join(HERE, "..", "..", "scripts", "verify")


class Checkout:
    """A git repository with a file of code and a page, and a program that knows its revision."""

    def __init__(self, folder):
        self.folder, self.program = folder, os.path.join(folder, "program")
        os.makedirs(folder)
        self.git("init", "--quiet")
        self.commit("source/code.cc")

    def git(self, *arguments):
        done = subprocess.run(["git", "-C", self.folder, "-c", "user.name=n", "-c", "user.email=e", *arguments], check=True, capture_output=True, text=True)
        return done.stdout.strip()

    def commit(self, file):
        path = os.path.join(self.folder, file)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "a", encoding="utf-8") as stream:
            stream.write("changed\n")
        self.git("add", file)
        self.git("commit", "--quiet", "-m", "change")

    def build(self):
        with open(self.program, "w", encoding="utf-8") as stream:
            stream.write(f"#!/bin/sh\necho 'Continua 0 ({self.git('rev-parse', '--short', 'HEAD')})'\n")
        os.chmod(self.program, 0o755)


def row(file, value, check="frequency"):
    return (file, check, "passed", value, "3 Hz", "2 s")


class VerifiedRows(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.addCleanup(self.place.cleanup)
        self.checkout = Checkout(os.path.join(self.place.name, "checkout"))
        self.output = os.path.join(self.place.name, "output")

    def keep(self, rows, performed):
        self.checkout.build()
        verified_rows.keep(self.output, rows, performed, self.checkout.program)

    def ages(self):
        rows = verified_rows.with_age(verified_rows.read(self.output).values(), self.checkout.folder)
        return {row[0]: (row[3], row[-1]) for row in rows}

    def test_age(self):
        self.keep([row("beam", "1"), row("tube", "2")], {"beam", "tube"})
        self.checkout.commit("doc/page.md")
        self.assertEqual(self.ages(), {"beam": ("1", "the same code"), "tube": ("2", "the same code")})
        self.checkout.commit("source/code.cc")
        self.assertEqual(self.ages()["beam"], ("1", "older than the code by 1 change"))
        # A run of one file leaves the other as it was; a run that was kept has the age of its run.
        self.keep([row("beam", "3")], {"beam"})
        self.assertEqual(self.ages(), {"beam": ("3", "the same code"), "tube": ("2", "older than the code by 1 change")})
        self.keep([row("tube", "2")], set())
        self.assertEqual(self.ages()["tube"], ("2", "older than the code by 1 change"))

    def test_checks_that_are_gone(self):
        self.keep([row("beam", "1", "old check"), row("beam", "1")], {"beam"})
        self.keep([row("beam", "1")], {"beam"})
        self.assertEqual(list(verified_rows.read(self.output)), [("beam", "frequency")])

    def test_unknown_revision(self):
        self.keep([row("beam", "1")], {"beam"})
        rows = list(verified_rows.read(self.output).values())
        rows[0]["revision"] = "0123456789"
        self.assertEqual(verified_rows.with_age(rows, self.checkout.folder)[0][-1], "unknown revision")

    def test_command(self):
        done = subprocess.run([VERIFY, "--rows", "--output", self.output], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("nothing was verified", done.stderr)
        self.keep([row("beam", "1")], {"beam"})
        done = subprocess.run([VERIFY, "--rows", "--markdown", "--output", self.output], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"\| beam \| frequency \| passed \| 1 \| 3 Hz \| 2 s \| \d{4}-\d\d-\d\d \| \w+ \| unknown revision \|")
        self.assertIn("1 of 1 rows are older", done.stderr)


if __name__ == "__main__":
    unittest.main()
