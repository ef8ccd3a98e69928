#!/usr/bin/python3
"""What the pages of the manual tell a reader to write: each entry of a parameter file exists, each formula is accepted by the program, and each
file and script of a command is there."""

import glob
import json
import os
import re
import subprocess
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))
TUBE = os.path.join(ROOT, "parameter_files", "new", "tube.prm")
# Names of users: any text.
NAME = re.compile(r"<[^>]*>")
# Sections whose keys are quantities of the run, not entries.
FREE = ("Expected",)
# Spans that are a part of a formula, or are there to be refused.
NO_FORMULA = {"if(y < 1 + t^3*x^2/2, ...)"}


def pages():
    return sorted(glob.glob(os.path.join(ROOT, "doc", "**", "*.md"), recursive=True)) + [os.path.join(ROOT, "README.md")]


def read(path):
    with open(path, encoding="utf-8") as stream:
        return stream.read()


def blocks_of_entries(text):
    """[(line, lines)] of the blocks of a page that are pieces of a parameter file: indented, with `subsection` or `set`."""
    found, block, start = [], [], 0
    for number, line in enumerate([*text.splitlines(), ""], 1):
        if line.startswith("    ") or (block and not line.strip() and number < len(text.splitlines())):
            if not block:
                start = number
            block.append(line[4:])
            continue
        if any(re.match(r"\s*(subsection \S|set \S[^=]*=)", one) for one in block):
            found.append((start, block))
        block = []
    return found


def entries_of(block):
    """[(sections, key)] of such a block."""
    names, found = [], []
    for line in block:
        text = line.split("#")[0].strip()
        if text.startswith("subsection "):
            names.append(text[len("subsection "):].strip())
        elif text == "end" and names:
            names.pop()
        elif text.startswith("set ") and "=" in text:
            found.append((tuple(names), text[4:].partition("=")[0].strip()))
    return found


class Entries(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        listing = json.loads(subprocess.run([PROGRAM, "--print-parameters=json"], capture_output=True, text=True, check=True).stdout)
        cls.paths = {entry["path"] for entry in listing}
        cls.patterns = [re.compile("/".join(".+" if NAME.fullmatch(part) else re.escape(part) for part in path.split("/"))) for path in cls.paths]

    def exists(self, sections, key):
        """A block may begin inside of its section, so that the path may go on to the left."""
        path = "/".join((*sections, key))
        return any(pattern.fullmatch(path) for pattern in self.patterns) or any(
            re.search(rf"(^|/){'/'.join(['[^/]+'] * len(sections) + [re.escape(key)])}$", known)
            and all(self.same(part, other) for part, other in zip(reversed((*sections, key)), reversed(known.split("/")))) for known in self.paths)

    @staticmethod
    def same(part, known):
        return part == known or NAME.fullmatch(known) is not None

    def test_blocks(self):
        n_checked = 0
        for path in pages():
            for line, block in blocks_of_entries(read(path)):
                for sections, key in entries_of(block):
                    if sections[:1] and sections[0] in FREE:
                        continue
                    n_checked += 1
                    with self.subTest(page=os.path.relpath(path, ROOT), line=line):
                        self.assertTrue(self.exists(sections, key), f"there is no entry '{'/'.join((*sections, key))}'")
        self.assertGreater(n_checked, 200)

    def test_commands(self):
        for path in pages():
            for option in re.findall(r'--set "?([A-Z][^="`\n]*)=', read(path)):
                *sections, key = option.replace("\\'", "'").split("/")
                if sections[:1] == ["Section"] or sections[:1] and sections[0] in FREE or key in ("Key", "..."):
                    continue
                with self.subTest(page=os.path.relpath(path, ROOT)):
                    self.assertTrue(self.exists(tuple(sections), key), f"there is no entry '{option}' of --set")

    def test_files(self):
        for path in pages():
            text = read(path)
            for name in set(re.findall(r"(?<![\w/-])(?:parameter_files|scripts|tests)/[\w./-]+[\w]", text)):
                if re.search(r"[A-Z]{3}|_N\b|^tests/bits/", name) and not name.endswith("README.md"):
                    continue  # which stands for others
                with self.subTest(page=os.path.relpath(path, ROOT)):
                    there = os.path.exists(os.path.join(ROOT, name)) or glob.glob(os.path.join(ROOT, name + "*"))
                    self.assertTrue(there, f"there is no {name}")

    def test_formulas(self):
        n_tried = 0
        for path in pages():
            for span in re.findall(r"`([^`\n]+)`", read(path)):
                formula = re.sub(r"^[\w/' ]+=(?!=)", "", span) if re.match(r"^[A-Z][\w/' ]*=", span) else span
                if not re.search(r"\b(sin|cos|exp|if|tanh|sqrt)\(", formula) or formula in NO_FORMULA:
                    continue
                n_tried += 1
                with self.subTest(page=os.path.relpath(path, ROOT), formula=formula):
                    self.assertEqual(self.refusal(formula), "")
        self.assertGreater(n_tried, 3)

    @staticmethod
    def refusal(formula):
        """What the program says of the formula as a pressure, or as a flow rate; empty if it takes it."""
        kind = "flow rate" if re.search(r"ml/s|l/min|m\^3/s", formula) else "pressure"
        command = [PROGRAM, TUBE, "--unset", "Boundaries/inlet", "--set", f"Boundaries/inlet/Type={kind}", "--set", f"Boundaries/inlet/{kind.capitalize()}={formula}",
                   "--validate"]
        return subprocess.run(command, capture_output=True, text=True, check=False).stderr


if __name__ == "__main__":
    unittest.main()
