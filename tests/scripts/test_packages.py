#!/usr/bin/python3
"""scripts/packages.txt is read by release: what only one release has, and what an unknown one gets."""

import os
import subprocess
import tempfile
import unittest

SCRIPTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts")


class Packages(unittest.TestCase):
    def packages(self, os_release, *groups):
        """(the packages, the note on standard error) on a system with that file os-release."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "os-release")
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(os_release)
            done = subprocess.run(
                ["bash", "-c", 'set -euo pipefail; source "$0"; list_packages "$@"',
                 os.path.join(SCRIPTS, "lib", "common.sh"), *groups],
                env={**os.environ, "CONTINUA_OS_RELEASE": path}, capture_output=True, text=True, check=True)
        return done.stdout.split(), done.stderr

    def test_bookworm(self):
        packages, note = self.packages("ID=debian\nVERSION_CODENAME=bookworm\n", "build")
        self.assertIn("libdeal.ii-dev", packages)
        self.assertIn("libflint-arb-dev", packages)
        self.assertNotIn("mold", packages)
        self.assertEqual(note, "")

    def test_trixie(self):
        packages, note = self.packages("ID=debian\nVERSION_CODENAME=trixie\n", "build", "test")
        self.assertIn("libdeal.ii-dev", packages)
        self.assertIn("libflint-dev", packages)
        self.assertIn("mold", packages)
        self.assertIn("numdiff", packages)
        self.assertNotIn("libflint-arb-dev", packages)
        self.assertNotIn("clang-format", packages)
        self.assertEqual(packages, sorted(set(packages)))
        self.assertEqual(note, "")

    def test_others_get_those_of_trixie(self):
        trixie, _ = self.packages("ID=debian\nVERSION_CODENAME=trixie\n", "build")
        for other in ('ID=debian\nVERSION_CODENAME=forky\nPRETTY_NAME="Debian forky"\n',
                      'ID=another\nVERSION_CODENAME=bookworm\nPRETTY_NAME="Another one"\n', ""):
            packages, note = self.packages(other, "build")
            self.assertEqual(packages, trixie)
            self.assertIn("the packages are those of Debian 13 (trixie)", note)

    def test_group_of_another_name(self):
        everything, _ = self.packages("ID=debian\nVERSION_CODENAME=trixie\n", "build", "run", "plot", "test", "doc")
        self.assertEqual(self.packages("ID=debian\nVERSION_CODENAME=trixie\n", "buil")[0], [])
        self.assertNotIn("ccache", everything)


if __name__ == "__main__":
    unittest.main()
