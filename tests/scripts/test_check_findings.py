#!/usr/bin/python3
"""scripts/check/findings reports each end of a finding, and every finding has its row and the parts of its form. Runs no finding."""

import glob
import os
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SCRIPTS = ["scripts/check/findings", "scripts/lib/common.sh", "scripts/lib/findings.sh"]
PARTS = ["Library", "Version", "Sentence", "Guessed", "Seen", "Output", "Matters", "To do"]
START = 'set -euo pipefail\nsource "$(dirname "${BASH_SOURCE[0]}")/../scripts/lib/findings.sh"\n'


class CheckFindings(unittest.TestCase):
    def check(self, findings, *arguments):
        """(exit status, lines of the table, folders left behind) of a tree with these findings."""
        with tempfile.TemporaryDirectory() as root:
            for name in SCRIPTS:
                os.makedirs(os.path.dirname(os.path.join(root, name)), exist_ok=True)
                shutil.copy(os.path.join(ROOT, name), os.path.join(root, name))
            for folder in ("findings", "temporary"):
                os.mkdir(os.path.join(root, folder))
            for name, text in findings.items():
                with open(os.path.join(root, "findings", name + ".sh"), "w", encoding="utf-8") as stream:
                    stream.write(START + text + "\n")
            done = subprocess.run([os.path.join(root, SCRIPTS[0]), *arguments], capture_output=True, text=True, check=False,
                                  env={**os.environ, "TMPDIR": os.path.join(root, "temporary")})
            left = os.listdir(os.path.join(root, "temporary"))
        table = re.split(r"^finding +verdict\n", done.stdout, flags=re.MULTILINE)[-1]
        return done.returncode, [line.split(None, 1) for line in table.splitlines()], left

    def test_still_so(self):
        self.assertEqual(self.check({"a": "judge true", "b": "judge true"}), (0, [["a", "still so"], ["b", "still so"]], []))

    def test_changed(self):
        self.assertEqual(self.check({"a": "judge bash -c 'exit 3'", "b": "judge true"}),
                         (1, [["a", "changed"], ["b", "still so"]], []))

    def test_a_failure_is_no_verdict(self):
        self.assertEqual(self.check({"a": "judge false"}), (1, [["a", "not judged (status 2)"]], []))

    def test_skipped(self):
        status, table, left = self.check({"a": "need_installed no-such-package 1\njudge true"})
        self.assertEqual((status, left), (0, []))
        self.assertEqual(table, [["a", "skipped: no-such-package is not installed: apt-get install no-such-package"]])

    @unittest.skipUnless(shutil.which("dpkg-query"), "not Debian")
    def test_another_version(self):
        finding = {"a": "need_installed dpkg 0.0.no\njudge true"}
        status, table, _ = self.check(finding)
        self.assertEqual(status, 0)
        self.assertRegex(table[0][1], r"^skipped: the finding is one of dpkg 0\.0\.no, and \S+ is installed$")
        self.assertEqual(self.check(finding, "--any-version")[:2], (0, [["a", "still so"]]))

    def test_names(self):
        self.assertEqual(self.check({"a": "judge true", "b": "judge false"}, "a"), (0, [["a", "still so"]], []))
        self.assertEqual(self.check({"a": "judge true"}, "c")[0], 1)


class Findings(unittest.TestCase):
    def test_form(self):
        with open(os.path.join(ROOT, "findings", "README.md"), encoding="utf-8") as stream:
            rows = re.findall(r"^\| \[([^\]]+)\]\(\1\.sh\) \|", stream.read(), re.MULTILINE)
        paths = sorted(glob.glob(os.path.join(ROOT, "findings", "*.sh")))
        self.assertEqual(rows, [os.path.basename(path)[:-3] for path in paths])
        for path in paths:
            with self.subTest(path=path), open(path, encoding="utf-8") as stream:
                self.assertEqual(re.findall(r"^# ([A-Z][\w ]*?): ", stream.read().partition("set -euo")[0], re.MULTILINE), PARTS)
                self.assertTrue(os.access(path, os.X_OK))


if __name__ == "__main__":
    unittest.main()
