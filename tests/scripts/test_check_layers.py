#!/usr/bin/python3
"""scripts/check/layers finds an include against the layers, an unknown folder and a cycle."""

import os
import subprocess
import tempfile
import unittest

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "check", "layers")


class CheckLayers(unittest.TestCase):
    def check(self, files):
        """(exit status, what it printed) for a tree of files."""
        with tempfile.TemporaryDirectory() as root:
            for name, text in files.items():
                path = os.path.join(root, name)
                os.makedirs(os.path.dirname(path), exist_ok=True)
                with open(path, "w", encoding="utf-8") as stream:
                    stream.write(text)
            done = subprocess.run([SCRIPT, root], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout

    def test_allowed(self):
        status, text = self.check({
            "include/continua/base/units.h": "#include <string>\n",
            "include/continua/materials/material.h": "#include <continua/base/units.h>\n",
            "source/materials/material.cc": "#include <continua/materials/material.h>\n",
            "source/main.cc": "#include <continua/materials/material.h>\n",
        })
        self.assertEqual((status, text), (0, "layers: ok\n"))

    def test_upwards(self):
        status, text = self.check({
            "include/continua/base/units.h": "// nothing\n\n  #  include <continua/materials/material.h>\n",
            "include/continua/materials/material.h": "",
        })
        self.assertEqual(status, 1)
        self.assertIn("include/continua/base/units.h:3: base may not include materials", text)

    def test_discretisations_apart(self):
        status, text = self.check({
            "source/finite_volume/a.cc": '#include "../finite_element/b.h"\n',
            "source/finite_element/b.h": "",
        })
        self.assertEqual(status, 1)
        self.assertIn("finite_volume may not include finite_element", text)

    def test_unknown_folder(self):
        status, text = self.check({"source/utilities/a.cc": ""})
        self.assertEqual(status, 1)
        self.assertIn("the folder utilities is not in the list", text)

    def test_rooms(self):
        status, text = self.check({
            "include/continua/finite_element/space/space.h": "#include <continua/finite_element/terms/tested.h>\n",
            "include/continua/finite_element/terms/tested.h": "",
            "include/continua/finite_element/taylor_hood.h": "#include <continua/finite_element/terms/tested.h>\n",
            "source/finite_element/attic/a.cc": "#include <continua/finite_element/terms/tested.h>\n",
        })
        self.assertEqual(status, 1)
        self.assertIn("space/space.h:1: the room space may not include terms", text)
        self.assertIn("source/finite_element/attic/a.cc: the room attic is not in the list", text)
        self.assertNotIn("taylor_hood", text)

    def test_cycle(self):
        status, text = self.check({
            "include/continua/base/a.h": "#include <continua/base/b.h>\n",
            "include/continua/base/b.h": "#include <continua/base/c.h>\n",
            "include/continua/base/c.h": "#include <continua/base/a.h>\n",
        })
        self.assertEqual(status, 1)
        self.assertIn("include cycle: ", text)

    def test_empty(self):
        self.assertEqual(self.check({})[0], 1)


if __name__ == "__main__":
    unittest.main()
