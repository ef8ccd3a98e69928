#!/usr/bin/python3
"""scripts/check/manual: what a page of the manual may load, and that its links find their files."""

import os
import subprocess
import tempfile
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


def check(files):
    """(exit status, lines of the output) for a manual of these files, path -> text."""
    with tempfile.TemporaryDirectory() as folder:
        for path, text in files.items():
            full = os.path.join(folder, path)
            os.makedirs(os.path.dirname(full), exist_ok=True)
            with open(full, "w", encoding="utf-8") as stream:
                stream.write(text)
        result = subprocess.run([os.path.join(ROOT, "scripts", "check", "manual"), folder], capture_output=True, text=True, check=False)
    return result.returncode, (result.stdout + result.stderr).splitlines()


class CheckManual(unittest.TestCase):
    def refused(self, page, line, **files):
        status, lines = check({"index.html": page, **files})
        self.assertEqual(status, 1)
        self.assertEqual(lines, [line])

    def test_accepted(self):
        page = """<link rel="stylesheet" href="s/a.css"><link rel="canonical" href="https://example.org/">
<script src="s/a.js?v=1"></script><img src="data:image/png;base64,AA"><a href="https://example.org/x">other page</a>
<a href="how/b.html#part">page</a> <a href="#here">here</a> <a href="mailto:a@example.org">mail</a>"""
        status, lines = check({"index.html": page, "how/b.html": '<a href="../index.html">back</a>',
                               "s/a.css": "a { background: url(b%20c.png) } /* http://example.org */", "s/a.js": "1"})
        self.assertEqual((status, lines), (0, []))

    def test_script(self):
        self.refused('<html>\n<script async src="https://cdn.example.org/MathJax.js?config=x"></script>',
                     "index.html:2: is loaded from a host: https://cdn.example.org/MathJax.js?config=x")

    def test_host_without_scheme(self):
        self.refused('<img src="//example.org/a.png">', "index.html:1: is loaded from a host: //example.org/a.png")

    def test_style(self):
        self.refused('<link rel="preload stylesheet" href="http://example.org/a.css">',
                     "index.html:1: is loaded from a host: http://example.org/a.css")

    def test_font_in_a_style(self):
        self.refused('<link rel="stylesheet" href="a.css">', "a.css: is loaded from a host: https://example.org/a.woff2",
                     **{"a.css": '@font-face { src: url( "https://example.org/a.woff2") }'})

    def test_import_in_a_page(self):
        self.refused('<style>\n@import "https://example.org/a.css";</style>',
                     "index.html:1: is loaded from a host: https://example.org/a.css")

    def test_missing_file(self):
        self.refused('<a href="reference/index.html">classes</a>', "index.html:1: there is no reference/index.html")

    def test_file_outside(self):
        self.refused('<script src="../a.js"></script>', "index.html:1: there is no ../a.js (outside of the manual)")

    def test_no_manual(self):
        status, lines = check({"a.html": ""})
        self.assertEqual(status, 1)
        self.assertIn("has no index.html", lines[0])


if __name__ == "__main__":
    unittest.main()
