#!/usr/bin/python3
"""scripts/build/package-test refuses wrong arguments, and packages of a Debian that it does not know, before it makes anything."""

import os
import subprocess
import tempfile
import unittest

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "build", "package-test")


class PackageTest(unittest.TestCase):
    def refuses(self, arguments, message):
        done = subprocess.run([SCRIPT, *arguments], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stdout, "")
        self.assertIn(message, done.stderr)

    def test_options(self):
        self.refuses(["--new"], "unknown option --new (there are --debian RELEASE")
        self.refuses(["--debian"], "--debian needs a value")
        self.refuses(["--debian", "sid"], "unknown release sid (there are bookworm and trixie)")
        self.refuses(["--package", "nowhere.deb"], "there is no package nowhere.deb")
        self.refuses(["--package", "nowhere.deb", "--debian", "trixie"], "give --package or --debian")
        self.refuses(["--package", "nowhere.deb", "--container"], "--container takes no package")

    def test_package_of_no_debian(self):
        with tempfile.TemporaryDirectory() as folder:
            os.makedirs(os.path.join(folder, "continua", "DEBIAN"))
            with open(os.path.join(folder, "continua", "DEBIAN", "control"), "w", encoding="utf-8") as stream:
                stream.write("Package: continua\nVersion: 0.1.0\nArchitecture: all\nMaintainer: A <a@localhost>\nDescription: none\n")
            subprocess.run(["dpkg-deb", "--build", "continua"], cwd=folder, capture_output=True, check=True)
            self.refuses(["--package", os.path.join(folder, "continua.deb")], "of version 0.1.0 is for no Debian that is known here")


if __name__ == "__main__":
    unittest.main()
