"""Bash completion of continua: what it offers for a line that is begun."""

import os
import subprocess
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))


def offered(*words):
    """The completions of the last of the words of a line."""
    line = 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _continua "$1"; printf "%s\\n" "${COMPREPLY[@]}"'
    done = subprocess.run(["bash", "-c", line, "bash", os.path.join(ROOT, "scripts", "completion", "continua"), PROGRAM, *words],
                          capture_output=True, text=True, check=True, cwd=os.path.join(ROOT, "parameter_files", "new"))
    return [line for line in done.stdout.split("\n") if line]


class Completion(unittest.TestCase):
    def test_options(self):
        self.assertEqual(offered("--val"), ["--validate"])
        self.assertIn("--restart", offered("tube.prm", "--"))

    def test_styles(self):
        """The equals sign is a word of its own, or not: COMP_WORDBREAKS says so."""
        self.assertEqual(offered("--print-parameters", "="), ["prm", "json", "markdown"])
        self.assertEqual(offered("tube.prm", "--print-parameters", "=", "j"), ["json"])
        self.assertEqual(offered("--print-parameters=m"), ["--print-parameters=markdown"])
        self.assertEqual(offered("--print-parameters", "tu"), ["tube.prm"])

    def test_files(self):
        self.assertEqual(offered("tu"), ["tube.prm"])
        self.assertEqual(offered("gmsh.g"), [])

    def test_templates(self):
        self.assertEqual(offered("--new", "channel"), ["channel-with-cylinder"])
        self.assertEqual(offered("--new", "t"), ["transient", "tube"])
        self.assertEqual(offered("--new", '"linear w'), ["linear-wave-theory"])

    def test_keys(self):
        self.assertEqual(offered("tube.prm", "--set", "Time/End"), ["Time/End\\ time="])
        self.assertEqual(offered("tube.prm", "--set", '"Time/End'), ["Time/End time="])
        self.assertEqual(offered("tube.prm", "--set", "'Materials/wall/You"), ["Materials/wall/Young'\\''s modulus="])
        self.assertEqual(offered("tube.prm", "--set", "Materials/wall/You"), ["Materials/wall/Young\\'s\\ modulus="])
        self.assertIn("Materials/wall/Density=", offered("tube.prm", "--set", "Materials/w"))
        # Without a file the keys of all that exists.
        self.assertIn("Materials/<region>/Density=", offered("--set", '"Materials/<region>/D'))


if __name__ == "__main__":
    unittest.main()
