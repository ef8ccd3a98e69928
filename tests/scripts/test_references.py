"""scripts/references/README.md: it has each script and each file that names one, and no other file."""

import os
import re
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
REFERENCES = os.path.join(ROOT, "scripts", "references")
TAKERS = ("parameter_files", "tests", "doc")
ENDS = (".prm", ".csv", ".toml", ".cc", ".md")
NAMED = re.compile(r"scripts/references/(\w+/\w+\.py)")


def files_below(folder):
    for path, _, names in os.walk(folder):
        yield from (os.path.join(path, name) for name in names)


def table():
    """The files of each script, by the page."""
    files = {}
    with open(os.path.join(REFERENCES, "README.md"), encoding="utf-8") as stream:
        for line in stream:
            row = re.fullmatch(r"\| `([\w/]+\.py)[^`]*` \|[^|]*\| (.*) \|\n", line)
            if row:
                files.setdefault(row[1], set()).update(re.findall(r"`([^`]+)`", row[2]))
    return files


def takers():
    """The files that name each script."""
    files = {}
    for folder in TAKERS:
        for path in files_below(os.path.join(ROOT, folder)):
            if path.endswith(ENDS):
                with open(path, encoding="utf-8", errors="replace") as stream:
                    for script in set(NAMED.findall(stream.read())):
                        files.setdefault(script, set()).add(os.path.relpath(path, ROOT))
    return files


class References(unittest.TestCase):
    def test_scripts(self):
        there = {os.path.relpath(path, REFERENCES) for path in files_below(REFERENCES) if path.endswith(".py")}
        self.assertEqual(set(table()), there)

    def test_files(self):
        named = takers()
        for script, files in table().items():
            with self.subTest(script):
                self.assertEqual(files, named.get(script, set()))


if __name__ == "__main__":
    unittest.main()
