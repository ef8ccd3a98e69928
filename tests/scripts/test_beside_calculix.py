#!/usr/bin/python3
"""scripts/measure/beside-calculix: meshes, loads and results of CalculiX without it, and what is refused."""

import os
import subprocess
import sys
import tempfile
import unittest
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
SCRIPT = os.path.join(ROOT, "scripts", "measure", "beside-calculix")
sys.path.insert(0, os.path.join(ROOT, "scripts", "lib"))
sys.dont_write_bytecode = True

import calculix  # noqa: E402
import numpy  # noqa: E402


def corners(layer):
    """The corners of each element, by its connectivity."""
    words = " ".join(layer.connectivity()).replace(",", " ").split()
    length = 1 + (20 if layer.quadratic else 8)
    for start in range(0, len(words), length):
        yield [numpy.array(layer.points[int(node) - 1]) for node in words[start + 1:start + 9]]


def script(name="measure/beside-calculix"):
    loader = SourceFileLoader("script", os.path.join(ROOT, "scripts", name))
    module = module_from_spec(spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


class Meshes(unittest.TestCase):
    def test_elements_are_right_handed(self):
        for place in (calculix.beam((20.0, 5.0)), calculix.cook(1e-3), calculix.quarter_ring(0.01, 0.02)):
            for element in ("C3D8", "C3D20"):
                layer = calculix.Layer(place, (4, 2), element, 0.5)
                found = list(corners(layer))
                self.assertEqual(len(found), 8)
                for points in found:
                    volume = numpy.linalg.det(numpy.array([points[1] - points[0], points[3] - points[0], points[4] - points[0]]))
                    self.assertGreater(volume, 0)

    def test_numbers_of_nodes(self):
        self.assertEqual(len(calculix.Layer(calculix.beam((1, 1)), (3, 2), "C3D8", 1.0).points), 4 * 3 * 2)
        # Per layer of corners (nx+1)(ny+1) and the middles of edges, twice; between them the corners once.
        self.assertEqual(len(calculix.Layer(calculix.beam((1, 1)), (3, 2), "C3D20", 1.0).points), 2 * (12 + 9 + 8) + 12)

    def test_end_forces(self):
        for element in calculix.ELEMENTS:
            layer = calculix.Layer(calculix.beam((2.0, 1.0)), (2, 4), element, 0.5)
            forces = layer.end_forces(3.0)
            self.assertAlmostEqual(sum(forces.values()), 3.0)
            # No moment about the middle of the end, and all of it at the end.
            self.assertAlmostEqual(sum(force * (layer.points[node - 1][1] - 0.5) for node, force in forces.items()), 0.0)
            self.assertEqual({layer.points[node - 1][0] for node in forces}, {2.0})

    def test_forces_on_an_end_with_uneven_cells(self):
        for element in calculix.ELEMENTS:
            layer = calculix.Layer(calculix.beam((2.0, 1.0)), (1, 2), element, 0.5)
            forces = layer.end_forces(8.0, [1.0, 3.0])
            self.assertAlmostEqual(sum(forces.values()), 8.0)
            last = layer.last()[1]
            # The corners of the lower cell get a quarter of its force of 2, or -1/12 of it.
            self.assertAlmostEqual(forces[layer.node(layer.last()[0], 0)], -2 / 12 if layer.quadratic else 2 / 4)
            self.assertAlmostEqual(forces[layer.node(layer.last()[0], last)], -6 / 12 if layer.quadratic else 6 / 4)

    def test_blocks(self):
        for element in calculix.ELEMENTS:
            block = calculix.Block(calculix.box((2.0, 1.0, 3.0)), (2, 1, 3), element)
            found = list(corners(block))
            self.assertEqual(len(found), 6)
            volumes = [numpy.linalg.det(numpy.array([points[1] - points[0], points[3] - points[0], points[4] - points[0]])) for points in found]
            numpy.testing.assert_allclose(volumes, 1.0)
            # Corners, and of twenty-node elements the middles of the edges along x, y and z.
            n_nodes = 3 * 2 * 4 + (2 * 2 * 4 + 3 * 1 * 4 + 3 * 2 * 3 if block.quadratic else 0)
            self.assertEqual(len(block.points), n_nodes)
            self.assertEqual(block.n_dofs, 3 * n_nodes)

    def test_forces_on_the_top(self):
        for element in calculix.ELEMENTS:
            block = calculix.Block(calculix.box((2.0, 1.0, 3.0)), (2, 1, 3), element)
            # Linear in both directions, which the rule integrates exactly: the force and its moments about both edges.
            forces = block.top_forces(lambda x, z: (1 + x) * z)
            points = {node: block.points[node - 1] for node in forces}
            self.assertEqual({y for _, y, _ in points.values()}, {1.0})
            self.assertAlmostEqual(sum(forces.values()), 4 * 4.5)
            self.assertAlmostEqual(sum(force * points[node][0] for node, force in forces.items()), (2 + 8 / 3) * 4.5)
            self.assertAlmostEqual(sum(force * points[node][2] for node, force in forces.items()), 4 * 9)
            even = block.top_forces(lambda x, z: 12.0)
            self.assertAlmostEqual(even[block.node(0, block.last()[1], 0)], -1.0 if block.quadratic else 3.0)

    def test_hyperelastic(self):
        text, _ = calculix.finite_block("C3D8", (1, 1, 1), 0.25, True)
        # G = 0.4 and K = 2/3: CalculiX takes G/2 and 2/K.
        self.assertEqual(text[text.index("*HYPERELASTIC, NEO HOOKE") + 1], "0.2, 3")
        text, _ = calculix.finite_block("C3D8", (1, 1, 1), 0.25, False)
        self.assertEqual(text[text.index("*ELASTIC") + 1], "1, 0.25")
        self.assertIn("*STEP, NLGEOM, INC=1000", text)

    def test_results_of_large_deformation(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "case.dat"), "w", encoding="utf-8") as stream:
                stream.write("")
            with self.assertRaisesRegex(calculix.LoadError, "first increment"):
                calculix.large_displacement(folder)
            text = "\n displacements (vx,vy,vz) for set TIP and time  {}\n\n        11  1.0E-01  3.0E-01  0.0E+00\n"
            with open(os.path.join(folder, "case.dat"), "w", encoding="utf-8") as stream:
                stream.write(text.format("0.25"))
            with self.assertRaisesRegex(calculix.LoadError, "at 0.25 of the load"):
                calculix.large_displacement(folder)
            with open(os.path.join(folder, "case.dat"), "a", encoding="utf-8") as stream:
                stream.write(text.format("0.1000000E+01"))
            self.assertEqual(calculix.large_displacement(folder), (0.1, 0.3))
            with open(os.path.join(folder, "case.sta"), "w", encoding="utf-8") as stream:
                stream.write("SUMMARY OF JOB INFORMATION\n  STEP      INC     ATT  ITRS     TOT TIME     STEP TIME      INC TIME\n"
                             "     1          1     1U    4  0.000000E+00  0.000000E+00  0.100000E+01\n"
                             "     1          1     2     3  0.250000E+00  0.250000E+00  0.250000E+00\n"
                             "     1          2     1     2  0.100000E+01  0.100000E+01  0.750000E+00\n")
            self.assertEqual(calculix.increments(folder), (2, 9))

    def test_results(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "case.dat"), "w", encoding="utf-8") as stream:
                stream.write("\n displacements (vx,vy,vz) for set TIP and time  0.5000000E+00\n\n"
                             "        11  1.0E-16  3.0E-01  0.0E+00\n")
            self.assertEqual(calculix.displacements(folder), [(0.5, 1e-16, 0.3)])
            with self.assertRaises(calculix.CalculixError):
                calculix.frequencies(folder)
            with open(os.path.join(folder, "case.dat"), "w", encoding="utf-8") as stream:
                stream.write("     E I G E N V A L U E   O U T P U T\n\n      1   0.4E+03   0.21E+02   0.3377E+01   0.0E+00\n\n"
                             "     P A R T I C I P A T I O N   F A C T O R S\n      1   0.1E+01   0.1E+01   0.9E+01   0.0E+00\n")
            self.assertEqual(calculix.frequencies(folder), [3.377])


class Tables(unittest.TestCase):
    def test_the_coarsest_mesh_that_fits(self):
        module = script()
        # The time of the coarsest is noise; the first error is small by chance.
        rows = [module.Row("lame-0.3", "a code", (n, 1), 10, error, None, seconds)
                for n, error, seconds in ((2, 1e-4, 0.1), (4, 0.03, 0.1), (8, 0.004, 0.35), (16, 0.002, 0.34), (32, 0.0002, 0.4))]
        line = module.table(rows, ["lame-0.3"])[-1]
        self.assertIn("| 2 x 1, 0.1 | 8 x 1, 0.35 | 32 x 1, 0.4 |", line)


    def test_large_deformation(self):
        module = script()
        rows = [module.Row("block-finite", "a code", (n, n, n), 10, error, None, seconds, (4, 17))
                for n, error, seconds in ((2, 0.02, 0.1), (4, 5e-5, 0.3))]
        self.assertIn("| 2 x 2 x 2, 0.1 | 4 x 4 x 4, 0.3 | 4 x 4 x 4, 0.3 | < 0.01 % (4 x 4 x 4, 0.3 s) | - | 4, 17 |",
                      module.table(rows, ["block-finite"])[-1])

    def test_the_order_of_the_limit(self):
        module = script("references/solids/finite_strain_block.py")
        limit, order = module.limit((6, 8, 10), [2 + 5 * n**-3.0 for n in (6, 8, 10)])
        self.assertAlmostEqual(limit, 2)
        self.assertAlmostEqual(order, 3)


class Calls(unittest.TestCase):
    def test_refusals(self):
        for arguments, text in ((("--cases", "bridge"), "no case 'bridge'"), (("--codes", "nastran"), "no code 'nastran'"),
                                (("--codes", "continua", "--program", "/nowhere"), "no program")):
            done = subprocess.run(["/usr/bin/python3", "-B", SCRIPT, *arguments], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(text, done.stderr)


if __name__ == "__main__":
    unittest.main()
