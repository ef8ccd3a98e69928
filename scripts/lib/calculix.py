"""Inputs and results of CalculiX (ccx) for bodies of structured cells: blocks, and plane bodies as one layer of solid elements that is held
across its plane."""

import math
import os
import re

# Nodes on an edge beside its ends, and what ccx calls the elements.
LINEAR, QUADRATIC = ("C3D8", "C3D8I", "C3D8R"), ("C3D20", "C3D20R")
ELEMENTS = (*LINEAR, *QUADRATIC)


class CalculixError(Exception):
    """A result cannot be read; the text says why."""


class LoadError(CalculixError):
    """CalculiX gave up before the whole load; the text says where."""


class Block:
    """Nodes and elements of a mapped box of nx x ny x nz cells."""

    n_directions = 3  # in which it moves

    def __init__(self, place, cells, element):
        """`place`: (s, t, u) in the unit cube -> (x, y, z)."""
        self.element, self.cells = element, cells
        self.quadratic = element in QUADRATIC
        nx, ny, nz = cells
        self.step = 2 if self.quadratic else 1
        self.numbers, self.points = {}, []
        for k in range(self.step * nz + 1):
            for j in range(self.step * ny + 1):
                for i in range(self.step * nx + 1):
                    # A serendipity element has nodes at its corners and in the middle of its edges.
                    if self.quadratic and (i % 2) + (j % 2) + (k % 2) > 1:
                        continue
                    self.numbers[i, j, k] = len(self.points) + 1
                    self.points.append(place(i / (self.step * nx), j / (self.step * ny), k / (self.step * nz)))

    @property
    def n_dofs(self):
        """Displacements of all nodes, those that are held by boundaries included."""
        return self.n_directions * len(self.points)

    def node(self, i, j, k=0):
        return self.numbers[i, j, k]

    def nodes_at(self, i=None, j=None, k=None):
        """The numbers of all nodes with these indices, in units of the nodes' own grid."""
        return [number for (a, b, c), number in self.numbers.items() if i in (None, a) and j in (None, b) and k in (None, c)]

    def last(self):
        """The largest indices (i, j)."""
        return self.step * self.cells[0], self.step * self.cells[1]

    def connectivity(self):
        """Lines of *ELEMENT, numbered along x first, then along y."""
        lines, s, number = [], self.step, 0
        corners = ((0, 0, 0), (s, 0, 0), (s, s, 0), (0, s, 0), (0, 0, s), (s, 0, s), (s, s, s), (0, s, s))
        edges = ((1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2), (0, 0, 1), (2, 0, 1),
                 (2, 2, 1), (0, 2, 1))
        offsets = (*corners, *(edges if self.quadratic else ()))
        for k in range(self.cells[2]):
            for j in range(self.cells[1]):
                for i in range(self.cells[0]):
                    number += 1
                    words = [str(number), *(str(self.node(s * i + a, s * j + b, s * k + c)) for a, b, c in offsets)]
                    lines += [", ".join(words[n:n + 10]) + ("," if n + 10 < len(words) else "") for n in range(0, len(words), 10)]
        return lines

    def end_forces(self, force, heights=None):
        """{node: force} of a uniform traction on the end s = 1: the consistent ones. `heights`: of its cells along t, if not equal."""
        i, ny, nz = self.last()[0], self.cells[1], self.cells[2]
        heights = heights or [1.0] * ny
        forces = {}
        # Of a face with eight nodes the corners get -1/12 and the middles of edges 1/3.
        weights = {(0, 0): -1 / 12, (2, 0): -1 / 12, (0, 2): -1 / 12, (2, 2): -1 / 12, (1, 0): 1 / 3, (0, 1): 1 / 3, (2, 1): 1 / 3,
                   (1, 2): 1 / 3} if self.quadratic else {(b, c): 1 / 4 for b in (0, 1) for c in (0, 1)}
        for k in range(nz):
            for j in range(ny):
                for (b, c), weight in weights.items():
                    node = self.node(i, self.step * j + b, self.step * k + c)
                    forces[node] = forces.get(node, 0.0) + weight * force * heights[j] / sum(heights) / nz
        return forces


    def top_forces(self, traction):
        """{node: force} of a traction on the top t = 1 of a straight block: the consistent ones. `traction`: (x, z) -> force for an area."""
        j, (nx, _, nz), step = self.last()[1], self.cells, self.step
        gauss = [(0.5 * (1 + root), 0.5 * weight) for root, weight in ((-(0.6**0.5), 5 / 9), (0.0, 8 / 9), (0.6**0.5, 5 / 9))]
        forces = {}
        for i in range(nx):
            for k in range(nz):
                first, last = (self.points[self.node(step * (i + n), j, step * (k + n)) - 1] for n in (0, 1))
                size_x, size_z = last[0] - first[0], last[2] - first[2]
                for a, weight_a in gauss:
                    for b, weight_b in gauss:
                        force = traction(first[0] + a * size_x, first[2] + b * size_z) * weight_a * weight_b * size_x * size_z
                        for (p, q), value in face_functions(self.quadratic, a, b).items():
                            node = self.node(step * i + p, j, step * k + q)
                            forces[node] = forces.get(node, 0.0) + value * force
        return forces


def face_functions(quadratic, a, b):
    """{(p, q): value} at the place (a, b) of the unit square, of the nodes at the indices (p, q): bilinear, or with nodes on the edges."""
    along, across = (1 - a, a), (1 - b, b)
    if not quadratic:
        return {(p, q): along[p] * across[q] for p in (0, 1) for q in (0, 1)}
    found = {(2 * p, 2 * q): along[p] * across[q] * (2 * along[p] + 2 * across[q] - 3) for p in (0, 1) for q in (0, 1)}
    found.update({(1, 2 * q): 4 * a * (1 - a) * across[q] for q in (0, 1)})
    found.update({(2 * p, 1): 4 * b * (1 - b) * along[p] for p in (0, 1)})
    return found


class Layer(Block):
    """One layer of the given thickness along z, of a mapped rectangle of nx x ny cells: a body in plane strain."""

    n_directions = 2

    def __init__(self, place, cells, element, thickness):
        """`place`: (s, t) in the unit square -> (x, y)."""
        super().__init__(lambda s, t, u: (*place(s, t), thickness * u), (*cells, 1), element)


def model_text(body, material):
    """Nodes, elements, material: linear elastic by `young` and `poisson`, or neo-Hookean by `shear` and `bulk`, with the energy
    shear/2 (tr b J^(-2/3) - 3) + bulk/2 (J - 1)^2. All nodes of a layer are held along z, which makes a plane strain."""
    lines = ["*NODE, NSET=ALL"] + [f"{n}, {x:.12g}, {y:.12g}, {z:.12g}" for n, (x, y, z) in enumerate(body.points, 1)]
    lines += [f"*ELEMENT, TYPE={body.element}, ELSET=BODY", *body.connectivity(), "*MATERIAL, NAME=M"]
    if "shear" in material:
        lines += ["*HYPERELASTIC, NEO HOOKE", f"{material['shear'] / 2:.12g}, {2 / material['bulk']:.12g}"]
    else:
        lines += ["*ELASTIC", f"{material['young']:.12g}, {material['poisson']:.12g}"]
    lines += ["*DENSITY", f"{material.get('density', 1.0):.12g}", "*SOLID SECTION, ELSET=BODY, MATERIAL=M"]
    return lines + (["*BOUNDARY", "ALL, 3, 3"] if body.n_directions == 2 else [])


def held(nodes, direction):
    """Lines of *BOUNDARY for a displacement of zero; direction 1, 2 or 3."""
    return ["*BOUNDARY"] + [f"{node}, {direction}, {direction}" for node in nodes]


def loads(forces, direction, amplitude=""):
    """Lines of *CLOAD."""
    name = f", AMPLITUDE={amplitude}" if amplitude else ""
    return [f"*CLOAD{name}"] + [f"{node}, {direction}, {force:.12g}" for node, force in forces.items() if force]


def large_deformation(forces, direction, first=1.0, largest=1.0):
    """The step of a static load in large deformation. `first`, `largest`: part of the load in the first increment, and in any."""
    return ["*STEP, NLGEOM, INC=1000", "*STATIC", f"{first:g}, 1., 1e-6, {largest:g}", *loads(forces, direction), *watch(), "*END STEP"]


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


def large_displacement(folder):
    """(x, y) of the node that was watched, under the whole load of large_deformation()."""
    try:
        time, x, y = displacements(folder)[-1]
    except CalculixError as error:
        raise LoadError("CalculiX stopped in the first increment of the load") from error
    if abs(time - 1) > 1e-9:
        raise LoadError(f"CalculiX stopped at {time:.2g} of the load")
    return x, y


def increments(folder):
    """(increments of the load, iterations), those of attempts that were given up included in the iterations."""
    path = os.path.join(folder, "case.sta")
    found, n_iterations = set(), 0
    with open(path, encoding="utf-8") as stream:
        for line in stream:
            words = line.split()
            # step, increment, attempt (with U: given up), iterations, total time, step's time, size
            if len(words) == 7 and words[0].isdigit():
                n_iterations += int(words[3])
                if not words[2].endswith("U"):
                    found.add((words[0], words[1]))
    if not found:
        raise CalculixError(f"{path} has no increment")
    return len(found), n_iterations


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


def box(size):
    """The `place` of a Block from the origin."""
    return lambda s, t, u: (size[0] * s, size[1] * t, size[2] * u)


# Cook's membrane in large deformation, as finite-strain-cook.prm has it: neo-Hookean [MPa], a shear [MPa] on the end; lengths in mm.
COOK_SHEAR, COOK_BULK, COOK_TRACTION = 80.1938, 40.0942e4, 6.25


def finite_cook(element, cells, along=None, across=None, **load):
    """(text, layer) of Cook's membrane in large deformation, 1 mm thick [MPa, mm]; the upper corner is watched. `along`, `across`: places of
    the cells' corners between 0 and 1, if not even. `load`: of large_deformation()."""
    along, across = along or even(cells[0]), across or even(cells[1])
    membrane = cook(1.0)
    layer = Layer(lambda s, t: membrane(between(along, s), between(across, t)), cells, element, 1.0)
    clamped = layer.nodes_at(i=0)
    text = model_text(layer, {"shear": COOK_SHEAR, "bulk": COOK_BULK})
    text += held(clamped, 1) + held(clamped, 2) + node_set(layer.node(*layer.last()))
    forces = layer.end_forces(COOK_TRACTION * 16, [b - a for a, b in zip(across, across[1:])])
    return text + large_deformation(forces, 2, **load), layer


# The pulled cube, as finite-strain-block.prm has it [MPa, mm]: an octant with planes of symmetry at x, y, z = 0.
BLOCK_SIZE, BLOCK_YOUNG, BLOCK_TRACTION = 10.0, 1.0, 0.5


def finite_block(element, cells, poisson, is_neo_hookean, **load):
    """(text, block) of the pulled cube of neo-Hookean rubber, or by the law of St. Venant and Kirchhoff (*ELASTIC in large deformation); the
    middle of the pulled face is watched. `load`: of large_deformation()."""
    block = Block(box(3 * (BLOCK_SIZE,)), cells, element)
    material = {"young": BLOCK_YOUNG, "poisson": poisson}
    if is_neo_hookean:
        material = {"shear": BLOCK_YOUNG / (2 * (1 + poisson)), "bulk": BLOCK_YOUNG / (3 * (1 - 2 * poisson))}
    text = model_text(block, material)
    text += held(block.nodes_at(i=0), 1) + held(block.nodes_at(j=0), 2) + held(block.nodes_at(k=0), 3)
    text += node_set(block.node(0, block.last()[1], 0))

    def traction(x, z):
        return 0.25 * BLOCK_TRACTION * (1 + math.cos(math.pi * x / BLOCK_SIZE)) * (1 + math.cos(math.pi * z / BLOCK_SIZE))

    return text + large_deformation(block.top_forces(traction), 2, **load), block


def even(cells):
    return [i / cells for i in range(cells + 1)]


def between(places, value):
    """Piecewise linear, so that the nodes in the middle of edges are there."""
    cells = len(places) - 1
    i = min(int(value * cells), cells - 1)
    return places[i] + (value * cells - i) * (places[i + 1] - places[i])


def quarter_ring(inner, outer):
    """s goes round from the y axis to the x axis, t outward."""
    def place(s, t):
        radius, angle = inner + (outer - inner) * t, 0.5 * math.pi * (1 - s)
        return radius * math.cos(angle), radius * math.sin(angle)

    return place
