#!/usr/bin/python3
"""scripts/check/layers finds an include against the layers, an unknown folder, a cycle, and what is made outside its maker."""

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

    def test_drawing(self):
        """doc/inside.md shows the drawing that the script makes of the includes."""
        drawing = subprocess.run([SCRIPT, "--draw"], capture_output=True, text=True, check=True).stdout
        with open(os.path.join(os.path.dirname(SCRIPT), "..", "..", "doc", "inside.md"), encoding="utf-8") as stream:
            page = stream.read()
        self.assertIn("scripts/check/layers --draw -->\n```\n" + drawing + "```\n<!-- end", page,
                      "copy what scripts/check/layers --draw prints into doc/inside.md")

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

    def test_makers(self):
        status, text = self.check({
            "source/finite_element/space/space.cc": "FE_Q<dim> element(2);\nQGauss<dim> rule(3);\n",
            "source/finite_element/terms/faces.cc":
                "void f(const MappingQ<dim> &mapping, const FE_Q<dim> &element); // MappingQ<dim> mapping\n"
                "const dealii::FESystem<dim> copy;\n"
                "const QGauss<dim - 1> rule(3);\n"
                "  FEFaceValues<dim> values(dealii::MappingQ<dim>(4), FE_DGQArbitraryNodes<dim>(QGauss<1>(2)));\n",
            "source/theory/integral.cc": "QIterated<1> rule(QGauss<1>(3), 4);\n",
            "include/continua/postprocess/fields.h": "/**\n * FE_Q<dim>\n */\nFESystem<dim> element(FE_DGQ<dim>(0), 2);\n",
            "source/mesh/round_section.cc": "const MappingQ<dim> mapping(6);\n",
            "source/mesh/plane_section.cc": "const MappingQ<dim> &mapping;\n",
        })
        self.assertEqual(status, 1)
        found = [line.split(";")[0] for line in text.splitlines()]
        by_space = "finite_element/space/space makes every"
        self.assertEqual(sorted(found), [
            f"include/continua/postprocess/fields.h:4: {by_space} FESystem",
            f"include/continua/postprocess/fields.h:4: {by_space} FE_DGQ",
            "scripts/check/layers: mesh/plane_section makes nothing, and is in OTHER_MAKERS",
            f"source/finite_element/terms/faces.cc:3: {by_space} QGauss",
            f"source/finite_element/terms/faces.cc:4: {by_space} FE_DGQArbitraryNodes",
            f"source/finite_element/terms/faces.cc:4: {by_space} MappingQ",
            f"source/finite_element/terms/faces.cc:4: {by_space} QGauss",
        ])

    def test_empty(self):
        self.assertEqual(self.check({})[0], 1)


if __name__ == "__main__":
    unittest.main()
