"""Bash completion of continua: what it offers for a line that is begun."""

import json
import os
import subprocess
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))


def offered(*words, program=PROGRAM):
    """The completions of the last of the words of a line."""
    line = 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _continua "$1"; printf "%s\\n" "${COMPREPLY[@]}"'
    done = subprocess.run(["bash", "-c", line, "bash", os.path.join(ROOT, "scripts", "completion", "continua"), program, *words],
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
        self.assertEqual(offered("--print-rules", "="), ["markdown", "json"])
        self.assertEqual(offered("--print-rules=j"), ["--print-rules=json"])

    def test_files(self):
        self.assertEqual(offered("tu"), ["tube.prm"])
        self.assertEqual(offered("gmsh.g"), [])

    def test_templates(self):
        self.assertEqual(offered("--new", "channel"), ["channel-with-cylinder"])
        self.assertEqual(offered("--new", "t"), ["transient", "tube"])
        self.assertEqual(offered("--new", '"linear w'), ["linear-wave-theory"])

    def test_keys(self):
        self.assertEqual(offered("tube.prm", "--set", "Time/End"), ["Time/End\\ time="])
        self.assertEqual(offered("tube.prm", "--sweep", "Time/End"), ["Time/End\\ time="])
        self.assertEqual(offered("tube.prm", "--set", '"Time/End'), ["Time/End time="])
        self.assertEqual(offered("tube.prm", "--set", "'Materials/wall/You"), ["Materials/wall/Young'\\''s modulus="])
        self.assertEqual(offered("tube.prm", "--set", "Materials/wall/You"), ["Materials/wall/Young\\'s\\ modulus="])
        self.assertIn("Materials/wall/Density=", offered("tube.prm", "--set", "Materials/w"))
        # Without a file the keys of all that exists.
        self.assertIn("Materials/<region>/Density=", offered("--set", '"Materials/<region>/D'))

    def test_hostile_names(self):
        """A name is a text for the shell, in each way of quoting, whatever it contains."""
        names = ["$(echo run)", "`echo run`", "${HOME}", 'a"b', "a\\b", "a'b", "!!", "a;echo run", "a b", "*", "~", "a&b", "#a"]
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(folder, "program")
            with open(program, "w", encoding="utf-8") as stream:
                stream.write("#!/bin/sh\ncat <<'END'\n" + "".join(f'  "path": {json.dumps(f"Materials/{name}/Density")},\n' for name in names)
                             + "END\n")
            os.chmod(program, 0o755)
            for quote in ("", "'", '"'):
                completed = offered("--set", f"{quote}Materials/", program=program)
                self.assertEqual(len(completed), len(names))
                # As the shell reads the line, the history of commands included.
                lines = "".join(f"printf '<%s>\\n' {quote}{text}{quote}\n" for text in completed)
                done = subprocess.run(["bash", "--norc", "-i"], input="set -o history -o histexpand\n" + lines, capture_output=True, text=True,
                                      check=False, env={"PATH": os.environ["PATH"], "HISTFILE": "/dev/null", "PS1": "", "PS2": ""})
                read = [line[1:-1] for line in done.stdout.splitlines() if line.startswith("<")]
                self.assertEqual(sorted(read), sorted(f"Materials/{name}/Density=" for name in names), quote)
            self.assertEqual(offered("--set", '"Materials/\\$(e', program=program), ["Materials/\\$(echo run)/Density="])


if __name__ == "__main__":
    unittest.main()
