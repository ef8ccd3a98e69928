#!/usr/bin/python3
"""scripts/build/clean-root refuses wrong arguments and folders that it did not make, before it changes anything."""

import os
import subprocess
import tempfile
import unittest

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "build", "clean-root")


class CleanRoot(unittest.TestCase):
    def refuses(self, arguments, message):
        done = subprocess.run([SCRIPT, *arguments], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stdout, "")
        self.assertIn(message, done.stderr)

    def test_help(self):
        done = subprocess.run([SCRIPT, "--help"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0)
        self.assertIn("scripts/build/clean-root [OPTION]... bookworm|trixie COMMAND...", done.stdout)

    def test_release(self):
        self.refuses([], "the release is missing: bookworm or trixie")
        self.refuses(["sid", "true"], "unknown release sid (there are bookworm and trixie)")

    def test_command(self):
        self.refuses(["trixie"], "there is no command to run")

    def test_options(self):
        self.refuses(["--new", "trixie", "true"], "unknown option --new")
        self.refuses(["--folder"], "--folder needs a value")
        self.refuses(["--archive"], "--archive needs a value")
        self.refuses(["--archive", "/nowhere.tar.xz", "trixie", "true"], "there is no source archive /nowhere.tar.xz")

    def test_other_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            kept = os.path.join(folder, "kept")
            with open(kept, "w", encoding="utf-8") as stream:
                stream.write("precious\n")
            self.refuses(["--fresh", "--folder", folder, "trixie", "true"], "was not made by this script")
            self.assertTrue(os.path.exists(kept))

    def test_other_release(self):
        with tempfile.TemporaryDirectory() as folder:
            os.mkdir(os.path.join(folder, "etc"))
            with open(os.path.join(folder, "etc", "continua-clean-root"), "w", encoding="utf-8") as stream:
                stream.write("bookworm\n")
            self.refuses(["--folder", folder, "trixie", "true"], "is a root of bookworm")

    def test_other_source(self):
        with tempfile.TemporaryDirectory() as folder:
            os.mkdir(os.path.join(folder, "etc"))
            for name, text in (("continua-clean-root", "bookworm\n"), ("continua-archive", "0123abcd\n")):
                with open(os.path.join(folder, "etc", name), "w", encoding="utf-8") as stream:
                    stream.write(text)
            self.refuses(["--folder", folder, "bookworm", "true"], "has an unpacked archive, not the checkout: --fresh makes it again")
            self.assertTrue(os.path.exists(os.path.join(folder, "etc", "continua-archive")))


if __name__ == "__main__":
    unittest.main()
