"""Each name of ten shipped files, misspelt: the message is about this name, whatever else its default makes wrong."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))
FOLDER = os.path.join(ROOT, "parameter_files", "new")
FILES = ("amplification", "beam", "channel-with-cylinder", "cook-membrane", "curved-vessel", "layered-channel", "material", "modal",
         "spin-coating", "tube")
OF_A_CASE = ("Expected", "Materials", "Boundaries", "Probes")  # whose names a file gives itself


def misspelt(name):
    """Without the letter in the middle."""
    middle = len(name) // 2
    return name[:middle] + name[middle + 1:]


def mutants(text):
    """(path of the misspelt name, text)."""
    lines, sections = text.splitlines(), []
    for number, line in enumerate(lines):
        found = re.match(r"(\s*)(set|subsection)\s+([^=#]*[^=#\s])(.*)", line)
        if re.match(r"\s*end\b", line):
            sections.pop()
        if not found:
            continue
        indent, keyword, name, rest = found.groups()
        parent = sections[-1] if sections else ""
        if (keyword == "set" and parent != "Expected") or parent not in OF_A_CASE:
            wrong = misspelt(name)
            changed = [*lines[:number], f"{indent}{keyword} {wrong}{rest}", *lines[number + 1:]]
            yield "/".join([*sections, wrong]), "\n".join(changed) + "\n"
        if keyword == "subsection":
            sections.append(name)


class MisspeltNames(unittest.TestCase):
    def test_each(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in os.listdir(FOLDER):
                if not name.endswith(".prm"):
                    shutil.copy(os.path.join(FOLDER, name), folder)
            paths = {}
            for name in FILES:
                with open(os.path.join(FOLDER, f"{name}.prm"), encoding="utf-8") as stream:
                    text = stream.read()
                for number, (wrong, changed) in enumerate(mutants(text)):
                    path = os.path.join(folder, f"{name}-{number}.prm")
                    with open(path, "w", encoding="utf-8") as stream:
                        stream.write(changed)
                    paths[path] = wrong
            self.assertGreater(len(paths), 150)
            done = subprocess.run([PROGRAM, "--validate", *paths], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
            for path, wrong in paths.items():
                messages = [line for line in done.stderr.splitlines() if line.startswith(f"error: {path}:")]
                self.assertEqual(len(messages), 1, f"{wrong}: {messages}")
                self.assertRegex(messages[0], rf"'{re.escape(wrong)}': unknown (entry|subsection)")


if __name__ == "__main__":
    unittest.main()
