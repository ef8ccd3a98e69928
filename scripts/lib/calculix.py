"""Inputs and results of CalculiX (ccx) for plane bodies of structured cells: one layer of solid elements, held across its plane."""

import math
import os
import re

# Nodes on an edge beside its ends, and what ccx calls the elements.
LINEAR, QUADRATIC = ("C3D8", "C3D8I", "C3D8R"), ("C3D20", "C3D20R")
ELEMENTS = (*LINEAR, *QUADRATIC)


class CalculixError(Exception):
    """A result cannot be read; the text says why."""


class Layer:
    """Nodes and elements of a mapped rectangle of nx x ny cells, with one layer of the given thickness along z."""

    def __init__(self, place, cells, element, thickness):
        """`place`: (s, t) in the unit square -> (x, y)."""
        self.element, self.cells = element, cells
        self.quadratic = element in QUADRATIC
        nx, ny = cells
        self.step = 2 if self.quadratic else 1
        self.numbers, self.points = {}, []
        for k in range(self.step + 1):
            for j in range(self.step * ny + 1):
                for i in range(self.step * nx + 1):
                    # A serendipity element has nodes at its corners and in the middle of its edges.
                    if self.quadratic and (i % 2) + (j % 2) + (k % 2) > 1:
                        continue
                    self.numbers[i, j, k] = len(self.points) + 1
                    x, y = place(i / (self.step * nx), j / (self.step * ny))
                    self.points.append((x, y, thickness * k / self.step))

    @property
    def n_dofs(self):
        """Displacements in the plane of all nodes, those that are held included."""
        return 2 * len(self.points)

    def node(self, i, j, k=0):
        return self.numbers[i, j, k]

    def nodes_at(self, i=None, j=None):
        """The numbers of all nodes with these indices, in units of the nodes' own grid."""
        return [number for (a, b, _), number in self.numbers.items() if i in (None, a) and j in (None, b)]

    def last(self):
        """The largest indices (i, j)."""
        return self.step * self.cells[0], self.step * self.cells[1]

    def connectivity(self):
        """Lines of *ELEMENT, numbered along x first."""
        lines, s = [], self.step
        corners = ((0, 0, 0), (s, 0, 0), (s, s, 0), (0, s, 0), (0, 0, s), (s, 0, s), (s, s, s), (0, s, s))
        edges = ((1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2), (0, 0, 1), (2, 0, 1),
                 (2, 2, 1), (0, 2, 1))
        for j in range(self.cells[1]):
            for i in range(self.cells[0]):
                offsets = (*corners, *(edges if self.quadratic else ()))
                nodes = [str(self.node(s * i + a, s * j + b, c)) for a, b, c in offsets]
                number = j * self.cells[0] + i + 1
                words = [str(number), *nodes]
                lines += [", ".join(words[n:n + 10]) + ("," if n + 10 < len(words) else "") for n in range(0, len(words), 10)]
        return lines

    def end_forces(self, force):
        """{node: force} of a uniform traction on the end s = 1, whose cells are of equal length: the consistent ones."""
        i, ny = self.last()[0], self.cells[1]
        forces = {}
        # Of a face with eight nodes the corners get -1/12 and the middles of edges 1/3.
        weights = {(0, 0): -1 / 12, (2, 0): -1 / 12, (0, 2): -1 / 12, (2, 2): -1 / 12, (1, 0): 1 / 3, (0, 1): 1 / 3, (2, 1): 1 / 3,
                   (1, 2): 1 / 3} if self.quadratic else {(b, c): 1 / 4 for b in (0, 1) for c in (0, 1)}
        for cell in range(ny):
            for (b, c), weight in weights.items():
                node = self.node(i, self.step * cell + b, c)
                forces[node] = forces.get(node, 0.0) + weight * force / ny
        return forces


def model_text(layer, material):
    """Nodes, elements, material; every node is held along z, which makes a plane strain."""
    lines = ["*NODE, NSET=ALL"] + [f"{n}, {x:.12g}, {y:.12g}, {z:.12g}" for n, (x, y, z) in enumerate(layer.points, 1)]
    lines += [f"*ELEMENT, TYPE={layer.element}, ELSET=BODY", *layer.connectivity()]
    lines += ["*MATERIAL, NAME=M", "*ELASTIC", f"{material['young']:.12g}, {material['poisson']:.12g}", "*DENSITY",
              f"{material.get('density', 1.0):.12g}", "*SOLID SECTION, ELSET=BODY, MATERIAL=M", "*BOUNDARY", "ALL, 3, 3"]
    return lines


def held(nodes, direction):
    """Lines of *BOUNDARY for a displacement of zero; direction 1 or 2."""
    return ["*BOUNDARY"] + [f"{node}, {direction}, {direction}" for node in nodes]


def loads(forces, direction, amplitude=""):
    """Lines of *CLOAD."""
    name = f", AMPLITUDE={amplitude}" if amplitude else ""
    return [f"*CLOAD{name}"] + [f"{node}, {direction}, {force:.12g}" for node, force in forces.items() if force]


def watch():
    """Lines that print the displacement of the node of node_set() into the .dat file."""
    return ["*NODE PRINT, NSET=TIP", "U"]


def node_set(node):
    return ["*NSET, NSET=TIP", str(node)]


def displacements(folder):
    """[(time, x, y)] of the node that was watched."""
    path = os.path.join(folder, "case.dat")
    found, time = [], None
    with open(path, encoding="utf-8") as stream:
        for line in stream:
            match = re.search(r"displacements .* and time\s+(\S+)", line)
            if match:
                time = float(match.group(1))
                continue
            words = line.split()
            if time is not None and len(words) == 4:
                found.append((time, float(words[1]), float(words[2])))
                time = None
    if not found:
        raise CalculixError(f"{path} has no displacement")
    return found


def frequencies(folder):
    """[Hz] of *FREQUENCY, the lowest first."""
    path = os.path.join(folder, "case.dat")
    found, inside = [], False
    with open(path, encoding="utf-8") as stream:
        for line in stream:
            if "E I G E N V A L U E" in line:
                inside = True
            elif "P A R T I C I P A T I O N" in line:
                break
            words = line.split()
            if inside and len(words) >= 4 and words[0].isdigit():
                found.append(float(words[3]))
    if not found:
        raise CalculixError(f"{path} has no frequency")
    return found


def beam(size):
    """The `place` of a box from the origin."""
    return lambda s, t: (size[0] * s, size[1] * t)


def cook(unit):
    """Cook's membrane of 48 x 44 to 60 units: its left end is 44 high, its right end from 44 to 60."""
    return lambda s, t: (48 * unit * s, unit * (44 * s + t * (44 - 28 * s)))


def quarter_ring(inner, outer):
    """s goes round from the y axis to the x axis, t outward."""
    def place(s, t):
        radius, angle = inner + (outer - inner) * t, 0.5 * math.pi * (1 - s)
        return radius * math.cos(angle), radius * math.sin(angle)

    return place
