#!/usr/bin/python3
"""The notebooks of python/notebooks: all of their cells run in their order, and show what they claim; and `pip install ./python`."""

import contextlib
import glob
import importlib.util
import io
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
NOTEBOOKS = os.path.join(ROOT, "python", "notebooks")
sys.path.insert(0, os.path.join(ROOT, "python"))


def cells_of(path):
    """[Python] of a notebook. Raises ValueError for outputs, which would be of one machine."""
    with open(path, encoding="utf-8") as stream:
        notebook = json.load(stream)
    if notebook["nbformat"] != 4:
        raise ValueError(f"{path} has the format {notebook['nbformat']}")
    found = []
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            if cell["outputs"] or cell["execution_count"] is not None:
                raise ValueError(f"{path} has outputs: clear them")
            found.append("".join(cell["source"]))
    return found


class Notebooks(unittest.TestCase):
    def setUp(self):
        import matplotlib
        matplotlib.use("Agg")
        program = os.path.abspath(os.environ["CONTINUA_PROGRAM"])
        os.environ["CONTINUA_PROGRAM"] = program
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.symlink(os.path.join(ROOT, "parameter_files"), os.path.join(folder.name, "parameter_files"))
        os.chdir(folder.name)

    def perform(self, name):
        """(the names that the notebook defines, what it printed)."""
        path, names, printed = os.path.join(NOTEBOOKS, name + ".ipynb"), {}, io.StringIO()
        cells = cells_of(path)
        self.assertGreater(len(cells), 2)
        with contextlib.redirect_stdout(printed):
            for number, cell in enumerate(cells, 1):
                exec(compile(cell, f"{path}, cell {number}", "exec"), names)  # noqa: S102
        with open(os.path.join("output", name + ".png"), "rb") as stream:
            self.assertEqual(stream.read(8), b"\x89PNG\r\n\x1a\n")
        return names, printed.getvalue()

    def test_own_tube(self):
        names, _ = self.perform("own-tube")
        # The exact theory of the tube has 10.183 m/s (parameter_files/examples/own-tube.prm); the mesh is coarse.
        self.assertAlmostEqual(names["speed"] / 10.183, 1, delta=0.02)

    def test_artery_under_pressure(self):
        names, _ = self.perform("artery-under-pressure")
        self.assertTrue(names["run"].checks["passed"].all())
        radius = names["loaded"]["inner radius"]
        self.assertTrue((radius.diff().dropna() > 0).all())

    def test_sweep(self):
        names, _ = self.perform("sweep")
        # The equations of a linear body have one time, L sqrt(rho/E).
        self.assertLess(max(names["ratios"]) / min(names["ratios"]) - 1, 1e-6)

    def test_all_are_tested(self):
        tested = {name[len("test_"):].replace("_", "-") for name in dir(self) if name.startswith("test_")}
        self.assertEqual({name[:-len(".ipynb")] for name in os.listdir(NOTEBOOKS) if name.endswith(".ipynb")} - tested, set())


WHEELS = "/usr/share/python-wheels"
WHEELS_OF_BUILD = all(glob.glob(os.path.join(WHEELS, f"{name}-*.whl")) for name in ("setuptools", "wheel"))


@unittest.skipIf(importlib.util.find_spec("pip") is None or importlib.util.find_spec("wheel") is None, "python3-pip and python3-wheel are not there")
class Pip(unittest.TestCase):
    def test_install(self):
        self.install("--no-build-isolation")

    @unittest.skipUnless(WHEELS_OF_BUILD, "python3-setuptools-whl and python3-wheel-whl are not there")
    def test_install_in_isolation(self):
        """What the build asks for comes from Debian's folder of wheels in place of PyPI."""
        self.install("--find-links", WHEELS)

    def install(self, *options):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(os.path.join(ROOT, "python"), os.path.join(folder, "python"), ignore=shutil.ignore_patterns("__pycache__", "build", "*.egg-info"))
            shutil.copy(os.path.join(ROOT, "VERSION"), folder)
            to = os.path.join(folder, "to")
            done = subprocess.run(["/usr/bin/python3", "-m", "pip", "install", *options, "--no-deps", "--no-index", "--quiet", "--target", to,
                                   os.path.join(folder, "python")], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            done = subprocess.run(["/usr/bin/python3", "-B", "-c", "import continua; print(continua.__version__, continua.__file__)"], cwd=folder,
                                  env={**os.environ, "PYTHONPATH": to}, capture_output=True, text=True, check=True)
            with open(os.path.join(ROOT, "VERSION"), encoding="utf-8") as stream:
                self.assertEqual(done.stdout.split(), [stream.read().strip(), os.path.join(to, "continua", "__init__.py")])


if __name__ == "__main__":
    unittest.main()
