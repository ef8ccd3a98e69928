#!/usr/bin/python3
"""scripts/measure/building: what it keeps of a compilation, and that the pages and scripts/quickstart say what was measured."""

import importlib.machinery
import importlib.util
import os
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCRIPT = os.path.join(ROOT, "scripts", "measure", "building")


def load():
    loader = importlib.machinery.SourceFileLoader("building", SCRIPT)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("building", loader))
    loader.exec_module(module)
    return module


class Building(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        sys.dont_write_bytecode = True
        cls.building = load()

    def test_compilation(self):
        with tempfile.TemporaryDirectory() as folder:
            log = os.path.join(folder, "log.csv")
            # As much memory as the list of 100 MB needs, and a status of its own.
            code = "import sys; sys.argv; found = bytearray(100000000); found[::4096] = b'1' * len(found[::4096]); sys.exit(3)"
            done = subprocess.run([sys.executable, "-B", SCRIPT, "--compilation", log, sys.executable, "-c", code, "-o", "a/b.o"], check=False)
            self.assertEqual(done.returncode, 3)
            with open(log, encoding="utf-8") as stream:
                name, seconds, memory = stream.read().strip().split(",")
        self.assertEqual(name, "a/b.o")
        self.assertGreater(float(seconds), 0)
        self.assertTrue(100e3 < int(memory) < 200e3, memory)

    def test_pages(self):
        done = subprocess.run([sys.executable, "-B", SCRIPT, "--check"], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (0, ""), "scripts/measure/building --write writes the tables again")

    def test_other_page(self):
        record = {**self.building.read_record(), "processor time": "1200"}
        path = self.building.PAGES[0]
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
        self.assertIn("1200 s, 20 minutes of one core", self.building.with_table(text, path, record))
        with self.assertRaises(SystemExit):
            self.building.with_table(text.replace(self.building.END, ""), path, record)

    def test_quickstart(self):
        said = subprocess.run(["bash", "-c", 'source "$1"; building_minutes', "bash", os.path.join(ROOT, "scripts", "lib", "common.sh")],
                              capture_output=True, text=True, check=True).stdout
        self.assertEqual(round(float(self.building.read_record()["processor time"]) / 60), int(said))
        with open(os.path.join(ROOT, "scripts", "quickstart"), encoding="utf-8") as stream:
            text = stream.read()
        self.assertIn("$(building_minutes) minutes", text)
        self.assertIsNone(re.search(r"(six|\d+) minutes on", text))


if __name__ == "__main__":
    unittest.main()
