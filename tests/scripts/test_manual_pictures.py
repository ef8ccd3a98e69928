#!/usr/bin/python3
"""The pictures of the manual: each file of doc/pictures has its commands in doc/pictures.toml or gallery.toml, each page shows it and has the command
that draws it; and scripts/manual/pictures makes one by its commands."""

import glob
import importlib.machinery
import importlib.util
import os
import re
import stat
import subprocess
import sys
import tempfile
import tomllib
import unittest
from unittest import mock

import PIL.Image

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCRIPT = os.path.join(ROOT, "scripts", "manual", "pictures")
MOST_BYTES = 150e3  # of a picture; movies have their own


def load():
    sys.dont_write_bytecode = True
    loader = importlib.machinery.SourceFileLoader("pictures", SCRIPT)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("pictures", loader))
    loader.exec_module(module)
    return module


def read(*path):
    with open(os.path.join(ROOT, *path), encoding="utf-8") as stream:
        return stream.read()


def of_gallery():
    with open(os.path.join(ROOT, "doc", "gallery.toml"), "rb") as stream:
        examples = tomllib.load(stream)["example"]
    return {f"gallery-{os.path.splitext(os.path.basename(one['file']))[0]}{os.path.splitext(one['picture'])[1]}" for one in examples}


class List(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.pictures = load().read_list()

    def test_every_picture(self):
        there = {os.path.basename(path) for path in glob.glob(os.path.join(ROOT, "doc", "pictures", "*"))}
        listed = of_gallery()
        for picture in self.pictures:
            listed |= {os.path.basename(path) for path in glob.glob(os.path.join(ROOT, "doc", "pictures", picture["file"]))} or {picture["file"]}
        self.assertEqual(there - listed, set(), "these have no commands in doc/pictures.toml")
        self.assertEqual(listed - there, set(), "these are in doc/pictures.toml or gallery.toml alone")

    def test_pages(self):
        for picture in self.pictures:
            page = read("doc", picture["page"])
            with self.subTest(picture=picture["file"]):
                self.assertIn("pictures/" + picture["file"].split("*")[0], page)
                if "blocks" in picture:
                    self.assertIn(f"```{picture['blocks']}\n", page)
                    self.assertIn(os.path.basename(picture["made"]), page)
                    continue
                self.assertRegex(page, re.escape(picture["commands"][-1]) + r"[`)\n ]", "the page has another command that draws it")
                for command in picture["commands"][:-1]:
                    file = next(word for word in command.split() if word.endswith(".prm"))
                    # A page may have one line for several files.
                    loop = re.sub(r"-[a-z]\.prm$", "-$t.prm", file)
                    self.assertTrue(command in page or loop in page or os.path.basename(file) in page, f"the page does not name {file}")

    def test_sizes(self):
        for path in glob.glob(os.path.join(ROOT, "doc", "pictures", "*.png")):
            with self.subTest(picture=os.path.basename(path)):
                self.assertLess(os.path.getsize(path), MOST_BYTES, "scripts/manual/pictures reduces its colours")


class Make(unittest.TestCase):
    """With a program and a script that draw nothing but a square, in a folder for the checkout."""

    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.root, self.made = os.path.join(place.name, "root"), os.path.join(place.name, "made")
        self.pictures = load()
        for folder in ("doc/pictures", "build/release", "scripts", "parameter_files", "python"):
            os.makedirs(os.path.join(self.root, folder))
        self.write("VERSION", "1\n")
        self.write("parameter_files/a.prm", "\n")
        self.write("build/release/continua", '#!/bin/sh\necho "$*" >>calls\nmkdir -p output/a && echo {} >output/a/summary.json\n')
        self.write("scripts/plot", "#!/usr/bin/python3\nimport sys, PIL.Image\nprint(sys.argv)\nPIL.Image.new('RGB', (20, 10), 'red').save(sys.argv[1] + '/p.png')\n")
        for name in ("ROOT", "PICTURES"):
            patch = mock.patch.object(self.pictures, name, self.root if name == "ROOT" else os.path.join(self.root, "doc", "pictures"))
            patch.start()
            self.addCleanup(patch.stop)
        self.picture = {"file": "x.png", "page": "x.md", "commands": ["continua parameter_files/a.prm", "scripts/plot output/a"], "made": "output/a/p.png"}

    def write(self, name, text):
        path = os.path.join(self.root, name)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)
        os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)

    def calls(self):
        with open(os.path.join(self.made, "calls"), encoding="utf-8") as stream:
            return stream.read().splitlines()

    def test_make(self):
        with mock.patch("builtins.print"):
            self.pictures.Maker(self.made, False).make(self.picture)
        with PIL.Image.open(os.path.join(self.root, "doc", "pictures", "x.png")) as picture:
            self.assertEqual((picture.size, picture.convert("RGB").getpixel((0, 0))), ((20, 10), (255, 0, 0)))
        with mock.patch("builtins.print"):
            self.pictures.Maker(self.made, True).make(self.picture)  # the run is kept
            self.assertEqual(self.calls(), ["parameter_files/a.prm"])
            maker = self.pictures.Maker(self.made, False)
            maker.make(self.picture)
            maker.make({**self.picture, "file": "y.png"})  # one run for both
        self.assertEqual(len(self.calls()), 2)

    def test_colours(self):
        """White stays white beside many shades, and no shade is far from what it was."""
        shades = PIL.Image.new("RGB", (300, 200), "white")
        for x in range(300):
            for y in range(100):
                shades.putpixel((x, y), (255 - x // 2, 250 - y // 3, 200 + x // 6))
        found = self.pictures.manual_picture.fewer_colours(shades, 64).convert("RGB")
        self.assertEqual({found.getpixel((x, 150)) for x in range(300)}, {(255, 255, 255)})
        for x in range(10, 300, 30):
            mean = [sum(found.getpixel((x + i, 50 + j))[c] for i in range(-4, 5) for j in range(-4, 5)) / 81 for c in range(3)]
            self.assertLess(max(abs(one - other) for one, other in zip(mean, shades.getpixel((x, 50)))), 6)

    def test_failures(self):
        maker = self.pictures.Maker(self.made, False)
        with mock.patch("builtins.print"):
            with self.assertRaisesRegex(self.pictures.Failed, "made no output/a/q.png"):
                maker.make({**self.picture, "made": "output/a/q.png"})
            self.write("scripts/plot", "#!/bin/sh\necho no such field >&2\nexit 2\n")
            with self.assertRaisesRegex(self.pictures.Failed, "exit status 2\nno such field"):
                self.pictures.Maker(self.made, False).make(self.picture)

    def test_sheet(self):
        for i in range(5):
            PIL.Image.new("RGB", (600, 300), (50 * i, 0, 0)).save(os.path.join(self.root, "doc", "pictures", f"{i}.png"))
        os.makedirs(self.made)
        with mock.patch("builtins.print"):
            self.pictures.write_sheet(self.made)
        with PIL.Image.open(os.path.join(self.made, "sheet.png")) as sheet:
            self.assertEqual(sheet.size, (4 * self.pictures.TILE, 2 * (self.pictures.TILE + self.pictures.LABEL)))
            self.assertEqual(sheet.getpixel((40, self.pictures.TILE + 2 * self.pictures.LABEL + 40)), (200, 0, 0))  # the fifth, in the second row

    def test_unknown_name(self):
        done = subprocess.run([sys.executable, "-B", SCRIPT, "no-such-picture"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("doc/pictures.toml has no no-such-picture", done.stderr)


if __name__ == "__main__":
    unittest.main()
