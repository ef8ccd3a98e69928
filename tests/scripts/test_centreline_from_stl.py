#!/usr/bin/python3
"""scripts/centreline-from-stl: tubes whose line and radius are known, ends of every kind, and what is no single vessel."""

import os
import struct
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy
except ImportError:
    numpy = None

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "centreline-from-stl")
N_AROUND = 64
# A regular polygon in the circle of radius 1 has the area of a circle of this radius.
POLYGON = None if numpy is None else numpy.sqrt(numpy.sin(2 * numpy.pi / N_AROUND) / (2 * numpy.pi / N_AROUND))


def tube(line, tangent, radius, n_along=160, begin=0., end=1., caps=False, slant=0.):
    """The triangles of a tube around line(u) with sections across tangent(u); its first ring stands at a slant."""
    corners = []
    normal = None
    for i, u in enumerate(numpy.linspace(begin, end, n_along + 1)):
        along = tangent(u) / numpy.linalg.norm(tangent(u))
        if normal is None:
            normal = numpy.cross(along, [0.3, 0.5, 0.8])
        normal = normal - (normal @ along) * along
        normal /= numpy.linalg.norm(normal)
        angle = 2 * numpy.pi * numpy.arange(N_AROUND) / N_AROUND
        ring = line(u) + radius(u) * (numpy.outer(numpy.cos(angle), normal) + numpy.outer(numpy.sin(angle), numpy.cross(along, normal)))
        if slant:
            # The first rings share the slant, less and less.
            share = max(0., 1. - 4. * i / n_along)
            ring += share * slant * radius(u) * numpy.outer(numpy.cos(angle), along)
        corners.append(ring)
    triangles = []
    for a, b in zip(corners, corners[1:]):
        for k in range(N_AROUND):
            m = (k + 1) % N_AROUND
            triangles += [(a[k], a[m], b[m]), (a[k], b[m], b[k])]
    if caps:
        for ring, u in ((corners[0], begin), (corners[-1], end)):
            triangles += [(line(u), ring[k], ring[(k + 1) % N_AROUND]) for k in range(N_AROUND)]
    return numpy.array(triangles)


def straight(length, first, last, **keywords):
    return tube(lambda u: numpy.array([length * u, 0., 0.]), lambda u: numpy.array([1., 0., 0.]),
                lambda u: first + (last - first) * u, **keywords)


def arc(bend, radius, angle, **keywords):
    return tube(lambda u: bend * numpy.array([numpy.sin(angle * u), 1 - numpy.cos(angle * u), 0.]),
                lambda u: numpy.array([numpy.cos(angle * u), numpy.sin(angle * u), 0.]), lambda u: radius, **keywords)


def write_stl(path, triangles, as_text=False):
    if as_text:
        with open(path, "w", encoding="ascii") as stream:
            stream.write("solid vessel\n")
            for triangle in triangles:
                stream.write("facet normal 0 0 0\n outer loop\n")
                for corner in triangle:
                    stream.write("  vertex " + " ".join(f"{value:.9e}" for value in corner) + "\n")
                stream.write(" endloop\nendfacet\n")
            stream.write("endsolid vessel\n")
        return
    with open(path, "wb") as stream:
        stream.write(b"vessel".ljust(80) + struct.pack("<I", len(triangles)))
        for triangle in triangles:
            stream.write(struct.pack("<12fH", 0., 0., 0., *triangle.reshape(-1), 0))


@unittest.skipIf(numpy is None, "numpy is missing (python3-numpy)")
class Centreline(unittest.TestCase):
    def run_on(self, triangles, *arguments, as_text=False, wall=("--wall-thickness", "0.5 mm")):
        """(the process, the table)"""
        with tempfile.TemporaryDirectory() as folder:
            surface, table = os.path.join(folder, "vessel.stl"), os.path.join(folder, "vessel.csv")
            if isinstance(triangles, bytes):
                with open(surface, "wb") as stream:
                    stream.write(triangles)
            else:
                write_stl(surface, triangles, as_text)
            done = subprocess.run([sys.executable, "-B", SCRIPT, surface, table, *wall, *arguments],
                                  capture_output=True, text=True, check=False)
            if not os.path.exists(table):
                return done, None
            with open(table, encoding="utf-8") as stream:
                self.assertEqual(stream.readline(), "x [mm], y [mm], z [mm], inner radius [mm], wall thickness [mm]\n")
                return done, numpy.loadtxt(stream, delimiter=",")

    def table(self, triangles, *arguments, **keywords):
        done, table = self.run_on(triangles, *arguments, **keywords)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        return done.stdout, table

    def refused(self, triangles, pattern, *arguments, **keywords):
        done, table = self.run_on(triangles, *arguments, **keywords)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertRegex(done.stderr, "^error: .*" + pattern)
        self.assertNotIn("Traceback", done.stderr)
        self.assertIsNone(table)

    def check_arc(self, table, bend, radius, angle, tolerance):
        """The points lie on the arc at equal angles, in their order."""
        reached = numpy.arctan2(table[:, 0], bend - table[:, 1])
        wanted = numpy.linspace(0, angle, len(table))
        self.assertLess(numpy.abs(numpy.hypot(table[:, 0], table[:, 1] - bend) - bend).max(), tolerance * radius)
        self.assertLess(numpy.abs(table[:, 2]).max(), tolerance * radius)
        self.assertLess(numpy.abs((reached - wanted) * bend).max(), tolerance * radius)

    def test_arc(self):
        output, table = self.table(arc(30., 5., 2.5), "--points", "21")
        self.assertEqual(table.shape, (21, 5))
        self.check_arc(table, 30., 5., 2.5, 5e-3)
        self.assertLess(numpy.abs(table[:, 3] / (5. * POLYGON) - 1).max(), 1e-3)
        self.assertTrue((table[:, 4] == 0.5).all())
        self.assertRegex(output, r"length (74\.9|75\.0|75 )")
        self.assertRegex(output, r"tightest bend: .* 0\.18[0-9]")
        self.assertRegex(output, r"largest over least diameter of a section: 1\.00")

    def test_tight_arc(self):
        _, table = self.table(arc(10., 5., 3.))
        self.check_arc(table, 10., 5., 3., 5e-3)
        # The sections nearly meet: with the line of the march alone the radius is off by 1e-3.
        _, table = self.table(arc(7., 5., 3.))
        self.check_arc(table, 7., 5., 3., 1e-2)
        self.assertLess(numpy.abs(table[:, 3] / (5. * POLYGON) - 1).max(), 5e-4)

    def test_caps(self):
        _, table = self.table(arc(30., 5., 2.5, caps=True), "--points", "21")
        self.check_arc(table, 30., 5., 2.5, 5e-3)

    def test_taper(self):
        _, table = self.table(straight(100., 6., 3.), "--points", "11", as_text=True, wall=("--wall-ratio", "0.1"))
        self.assertLess(numpy.abs(table[:, 0] - numpy.linspace(0, 100, 11)).max(), 1e-3)
        self.assertLess(numpy.abs(table[:, 1:3]).max(), 1e-3)
        self.assertLess(numpy.abs(table[:, 3] / (POLYGON * numpy.linspace(6, 3, 11)) - 1).max(), 1e-4)
        self.assertLess(numpy.abs(table[:, 4] / table[:, 3] - 0.1).max(), 1e-6)

    def test_helix(self):
        turn, bend, pitch = 2 * numpy.pi, 20., 24.  # one and a half turns
        _, table = self.table(tube(lambda u: numpy.array([bend * numpy.cos(1.5 * turn * u), bend * numpy.sin(1.5 * turn * u),
                                                          1.5 * pitch * u]),
                                   lambda u: numpy.array([-bend * turn * numpy.sin(1.5 * turn * u), bend * turn * numpy.cos(1.5 * turn * u),
                                                          pitch]),
                                   lambda u: 4., n_along=400), "--points", "41", "--inlet", "20", "0", "0")
        u = numpy.linspace(0, 1, 41)
        exact = numpy.array([bend * numpy.cos(1.5 * turn * u), bend * numpy.sin(1.5 * turn * u), 1.5 * pitch * u]).T
        self.assertLess(numpy.linalg.norm(table[:, :3] - exact, axis=1).max(), 0.01 * 4.)
        self.assertLess(numpy.abs(table[:, 3] / (4. * POLYGON) - 1).max(), 1e-3)

    def test_slanted_inlet(self):
        _, table = self.table(straight(100., 5., 5., slant=0.5), "--points", "11")
        self.assertLess(numpy.abs(table[:, 1:3]).max(), 5e-2)
        self.assertLess(numpy.abs(table[:, 3] / (5. * POLYGON) - 1).max(), 5e-3)

    def test_direction_and_unit(self):
        surface = straight(0.1, 0.006, 0.003)
        _, forward = self.table(surface, "--unit", "m", "--points", "5")
        self.assertLess(numpy.abs(forward[[0, -1], 0] - [0., 100.]).max(), 1e-3)
        for option in (("--inlet", "0.1", "0", "0"), ("--outlet", "0", "0", "0")):
            _, backward = self.table(surface, "--unit", "m", "--points", "5", *option)
            self.assertLess(numpy.abs(backward[:, :4] - forward[::-1, :4]).max(), 1e-2)

    def test_oval(self):
        surface = straight(100., 5., 5.) * [1., 1.2, 1 / 1.2]
        output, table = self.table(surface)
        self.assertLess(numpy.abs(table[:, 3] / (5. * POLYGON) - 1).max(), 1e-3)
        self.assertRegex(output, r"least diameter of a section: 1\.4[34]")

    def test_rough_surface(self):
        generator = numpy.random.default_rng(1)
        surface = arc(30., 5., 2.5)
        places, numbers = numpy.unique(numpy.round(surface.reshape(-1, 3), 9), axis=0, return_inverse=True)
        moved = places + generator.normal(0, 0.1, places.shape)
        output, table = self.table(moved[numbers.reshape(-1, 3)], "--points", "21")
        self.check_arc(table, 30., 5., 2.5, 5e-2)
        # 5.5/30, not that of the ripples.
        self.assertRegex(output, r"tightest bend: .* 0\.2[0-4]")

    def test_branches(self):
        main, side = straight(100., 5., 5.), straight(40., 3., 3.)
        turned = side[:, :, [1, 0, 2]] + [50., 0., 0.]
        self.refused(numpy.concatenate([main, turned]), "several parts")
        # A window in the wall, and on it a tube with as many corners: open, and closed by a cap.
        self.refused(self.with_branch(6, False), "open at 3 places.*one table for each")
        self.refused(self.with_branch(6, True), "jumps.*remove side branches")
        self.refused(self.with_branch(1, True, 12.), "radii away.*remove side branches")

    @staticmethod
    def with_branch(half_width, is_closed, length=30.):
        """A straight tube of which a square of facets of the wall is drawn out to a branch."""
        first, last = 80 - half_width, 80 + half_width
        rings = []
        angle = 2 * numpy.pi * numpy.arange(N_AROUND) / N_AROUND
        for x in numpy.linspace(0., 100., 161):
            rings.append(numpy.array([numpy.full(N_AROUND, x), 5. * numpy.cos(angle), 5. * numpy.sin(angle)]).T)
        triangles = []
        for i, (a, b) in enumerate(zip(rings, rings[1:])):
            for k in range(N_AROUND):
                m = (k + 1) % N_AROUND
                if first <= i < last and (k < half_width or k >= N_AROUND - half_width):
                    continue
                triangles += [(a[k], a[m], b[m]), (a[k], b[m], b[k])]
        around = [N_AROUND - half_width + k for k in range(2 * half_width)]
        window = ([rings[first][k % N_AROUND] for k in around] + [rings[i][half_width] for i in range(first, last)]
                  + [rings[last][(k + 1) % N_AROUND] for k in reversed(around)]
                  + [rings[i][N_AROUND - half_width] for i in range(last, first, -1)])
        window = numpy.array(window)
        for lift in range(10):
            a, b = window + [0., 0.1 * length * lift, 0.], window + [0., 0.1 * length * (lift + 1), 0.]
            for k in range(len(window)):
                m = (k + 1) % len(window)
                triangles += [(a[k], a[m], b[m]), (a[k], b[m], b[k])]
        if is_closed:
            top = window + [0., length, 0.]
            triangles += [(top.mean(axis=0), top[k], top[(k + 1) % len(top)]) for k in range(len(top))]
        return numpy.array(triangles)

    @staticmethod
    def closed_ring():
        around, along = (2 * numpy.pi * numpy.arange(n) / n for n in (N_AROUND, 160))
        distance = 30. + 5. * numpy.cos(around)
        rings = [numpy.array([distance * numpy.cos(u), distance * numpy.sin(u), 5. * numpy.sin(around)]).T for u in along]
        return numpy.array([triangle for a, b in zip(rings, rings[1:] + rings[:1]) for k in range(N_AROUND)
                            for triangle in ((a[k], a[k - 1], b[k - 1]), (a[k], b[k - 1], b[k]))])

    def test_no_vessel(self):
        surface = straight(100., 5., 5.)
        hole = numpy.delete(surface, slice(7000, 7002), axis=0)
        self.refused(hole, "open at 3 places.*holes")
        one_cap = straight(100., 5., 5., caps=True)[:-N_AROUND]
        self.refused(one_cap, "open at one end and closed at the other")
        self.refused(numpy.concatenate([surface, surface[:1]]), "more than two triangles.*doubled")
        self.refused(self.closed_ring(), "closed and has a hole through it.*cut the vessel open")
        self.refused(b"solid nothing\nendsolid nothing\n", "no triangles")
        self.refused(b"\x00\xff" * 200, "no STL file")
        self.refused(b"solid a\nvertex 1 2\nvertex 1 2 3\n", "corner without three numbers.*cut off")
        self.refused(b"vessel".ljust(80) + struct.pack("<I", 3) + bytes(100), "cut off")

    def test_files_of_other_programs(self):
        """Names in any letters, keywords in capitals, and bytes behind those that a binary file counts."""
        sys.path.insert(0, os.path.join(os.path.dirname(SCRIPT), "lib"))
        from vessel_surface import read_stl
        triangles = straight(10., 5., 5., n_along=2)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "vessel.stl")
            write_stl(path, triangles, as_text=True)
            with open(path, "rb") as stream:
                content = stream.read()
            write_stl(path, triangles)
            with open(path, "rb") as stream:
                binary = stream.read()
            for written in (content, content.upper(), content.replace(b"\n", b"\r\n"), content.replace(b"vessel", "Gefäß Å".encode()),
                            content.replace(b"vessel", "Gefäß".encode("latin-1")), binary, b"solid " + binary[6:]):
                with open(path, "wb") as stream:
                    stream.write(written)
                corners, n_left_out = read_stl(path)
                self.assertEqual(n_left_out, 0)
                self.assertLess(numpy.abs(corners - triangles).max(), 1e-5)
        done, _ = self.run_on(binary + b"\n\0x")
        self.assertRegex(done.stderr, r"^warning: .* has 3 bytes behind the 256 triangles")

    def test_wall_as_a_body(self):
        """Its message, followed to the letter, gives the lumen."""
        inner, outer = straight(100., 5., 5., n_along=20), straight(100., 6., 6., n_along=20)[:, [1, 0, 2]]
        rings = []
        for x in (0., 100.):
            first, second = (numpy.unique(surface.reshape(-1, 3)[surface.reshape(-1, 3)[:, 0] == x], axis=0) for surface in (inner, outer))
            order = [numpy.argsort(numpy.arctan2(ring[:, 2], ring[:, 1])) for ring in (first, second)]
            a, b = first[order[0]], second[order[1]]
            for k in range(N_AROUND):
                m = (k + 1) % N_AROUND
                rings += [(a[k], a[m], b[m]), (a[k], b[m], b[k])]
        self.refused(numpy.concatenate([inner, outer, numpy.array(rings)]), "hole through it, as a wall has.*keep its inner side alone")
        self.refused(numpy.concatenate([inner, outer]), "several parts.*of a wall its inner side")
        _, table = self.table(inner, "--points", "5")
        self.assertLess(numpy.abs(table[:, 3] / (5. * POLYGON) - 1).max(), 1e-3)

    def test_arguments(self):
        surface = straight(100., 5., 5.)
        for arguments, pattern in ((("--wall-thickness", "1"), "is no length.*mm"), (("--wall-thickness", "-1 mm"), "not positive"),
                                   (("--wall-ratio", "0"), "no positive number"), ((), "required"),
                                   (("--wall-ratio", "0.1", "--points", "2"), "whole number from 3")):
            done, table = self.run_on(surface, wall=arguments)
            self.assertEqual(done.returncode, 2)
            self.assertRegex(done.stderr, pattern)
            self.assertIsNone(table)
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, "-B", SCRIPT, os.path.join(folder, "none.stl"), os.path.join(folder, "a.csv"),
                                   "--wall-ratio", "0.1"], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, "^error: .*none.stl")


if __name__ == "__main__":
    unittest.main()
