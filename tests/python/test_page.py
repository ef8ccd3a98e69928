#!/usr/bin/python3
"""The page doc/python.md: each block of Python runs, in their order, and prints what the page shows below it."""

import contextlib
import io
import os
import re
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "python"))
PAGE = os.path.join(ROOT, "doc", "python.md")
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def examples(text):
    """[(line, Python, what it prints)]: a block `text` right below a block `python` is what this prints; without one it prints nothing."""
    found, end = [], None
    for match in BLOCK.finditer(text):
        kind, content = match.groups()
        line = text.count("\n", 0, match.start()) + 2
        if kind == "python":
            found.append([line, content, ""])
        elif kind == "text" and found and not text[end:match.start()].strip():
            found[-1][2] = content
        else:
            raise ValueError(f"{PAGE}:{line - 1}: a block that is neither Python nor what the Python above it prints")
        end = match.end()
    return found


class Page(unittest.TestCase):
    def test_blocks(self):
        with open(PAGE, encoding="utf-8") as stream:
            found = examples(stream.read())
        self.assertGreater(len(found), 5)
        start, namespace = os.getcwd(), {}
        self.addCleanup(os.chdir, start)
        with tempfile.TemporaryDirectory() as folder:
            os.environ["CONTINUA_PROGRAM"] = os.path.abspath(os.environ["CONTINUA_PROGRAM"])
            os.symlink(os.path.join(ROOT, "parameter_files"), os.path.join(folder, "parameter_files"))
            os.chdir(folder)
            for line, code, expected in found:
                printed = io.StringIO()
                with contextlib.redirect_stdout(printed):
                    # The lines of a traceback are those of the page.
                    exec(compile("\n" * (line - 1) + code, PAGE, "exec"), namespace)  # noqa: S102
                self.assertEqual(printed.getvalue(), expected, f"{PAGE}:{line}")
            with open("stiffness.png", "rb") as stream:
                self.assertEqual(stream.read(8), b"\x89PNG\r\n\x1a\n")
            os.chdir(start)


class Examples(unittest.TestCase):
    def test_extraction(self):
        text = "A\n```python\na = 1\n```\nwords\n```python\nprint(a)\n```\n\n```text\n1\n```\n"
        self.assertEqual(examples(text), [[3, "a = 1\n", ""], [7, "print(a)\n", "1\n"]])
        with self.assertRaises(ValueError):
            examples("```python\na = 1\n```\nwords\n\n```text\n1\n```\n")


if __name__ == "__main__":
    unittest.main()
