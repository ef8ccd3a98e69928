#!/usr/bin/python3
"""scripts/manual/draw-geometries: a sketch shows the name of each region and boundary of its mesh once, and no name covers another."""

import importlib.machinery
import importlib.util
import os
import subprocess
import sys
import tempfile
import unittest

from matplotlib.text import Text
from mpl_toolkits.mplot3d.art3d import Text3D

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))
sys.dont_write_bytecode = True


def load_script():
    loader = importlib.machinery.SourceFileLoader("draw_geometries", os.path.join(ROOT, "scripts", "manual", "draw-geometries"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


def texts_of(figure):
    """[(text, its box in pixels)] of all that is written in the figure."""
    figure.canvas.draw()
    renderer = figure.canvas.get_renderer()
    # Of an annotation without its line; Text3D, the names of the axes in space, has its place only while it is drawn.
    return [(text.get_text(), Text.get_window_extent(text, renderer)) for axes in figure.axes for text in axes.texts
            if text.get_text() and not isinstance(text, Text3D)]


class Sketches(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.script = load_script()
        listing = subprocess.run([PROGRAM, "--print-parameters"], capture_output=True, text=True, check=True).stdout
        names = [os.path.splitext(file)[0] for file in sorted(os.listdir(cls.script.TEMPLATES)) if file.endswith(".prm")]
        cls.geometries = [name for name in names if f"\n# Geometry and mesh, Type = {name.replace('-', ' ')}:" in listing]

    def test_all_names(self):
        self.assertGreater(len(self.geometries), 7)
        for name in self.geometries:
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                self.check(name, folder)

    def check(self, name, folder):
        script = self.script
        template, mesh_file = os.path.join(script.TEMPLATES, name + ".prm"), os.path.join(folder, "mesh.vtu")
        subprocess.run([PROGRAM, template, "--mesh", mesh_file], capture_output=True, check=True)
        mesh = script.draw_mesh.Mesh(mesh_file)
        figure = script.draw(mesh, template)
        texts = texts_of(figure)
        script.draw_mesh.plt.close(figure)
        written = [text for text, _ in texts]
        filled = {mesh.regions[number] for number in mesh.cell_regions}
        for wanted in [*filled, *mesh.faces]:
            self.assertEqual(written.count(wanted), (wanted in filled) + (wanted in mesh.faces), f"{wanted} in {written}")
        for i, (text, box) in enumerate(texts):
            for other, other_box in texts[:i]:
                # Boxes have the height of the line; letters fill some three quarters.
                across = min(box.x1, other_box.x1) - max(box.x0, other_box.x0)
                above = min(box.y1, other_box.y1) - max(box.y0, other_box.y0)
                self.assertFalse(across > 1 and above > 0.25 * min(box.height, other_box.height), f"'{text}' covers '{other}'")


if __name__ == "__main__":
    unittest.main()
