#!/usr/bin/python3
"""scripts/lib/comment_beginnings.py finds comments that begin with a word for something else, and no others; the sources have none."""

import os
import subprocess
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCRIPT = os.path.join(ROOT, "scripts", "lib", "comment_beginnings.py")


class CommentBeginnings(unittest.TestCase):
    def lines(self, text):
        """The numbers of the lines that are found in a file with this text."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.h")
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(text)
            done = subprocess.run([SCRIPT, path], capture_output=True, text=True, check=False)
        found = [int(line.split(":")[1]) for line in done.stdout.splitlines()[:-1]]
        self.assertEqual(done.returncode, 1 if found else 0)
        return found

    def test_found(self):
        self.assertEqual(self.lines("/// That of the mesh.\nint a; ///< those with a name\n  // Of whose gradient it is.\n"
                                    "/** Of what is kept. */\nint b;\n// The stress, of whose parts one counts.\n"), [1, 2, 3, 4, 6])

    def test_not_found(self):
        self.assertEqual(self.lines("/// The mass and\n/// that of the mesh.\n/**\n * The shape, beside\n * that of the mesh.\n */\n"
                                    "int a; ///< of the mesh\n// That is all.\nconst char *b = \"// of\";\n"), [])

    def test_sources(self):
        done = subprocess.run([SCRIPT], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)


if __name__ == "__main__":
    unittest.main()
