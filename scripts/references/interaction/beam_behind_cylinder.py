#!/usr/bin/python3
"""The first frequency of the beam behind a cylinder in a liquid at rest: reference of
parameter_files/examples/beam-behind-cylinder.prm.

    scripts/references/interaction/beam_behind_cylinder.py [CELLS_ACROSS_THE_BEAM]

A cantilever of Euler and Bernoulli (plane strain) that carries the liquid around it, which has no viscosity: its potential
obeys Laplace's equation with the velocity of the beam on the beam's sides, no normal velocity on the walls, the cylinder and the
closed inlet, and zero at the open outlet. The motion is a sum of the first six modes of the dry cantilever. The potential is found
by finite volumes on square cells, 4 across the beam unless the command line gives another even number; a cell whose centre is in
the cylinder is solid.

The viscosity slows the beam further: the liquid in the boundary layer, sqrt(2 nu/omega) thick, moves with it. In the example it is
1.1 mm, and the part of it that is carried is thinner, since a side of the beam moves along its normal. This is not in the number.

Needs numpy and scipy.
"""

import sys

import numpy as np
from scipy.optimize import brentq
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu

LENGTH, HEIGHT, X, Y, RADIUS = 2.5, 0.41, 0.2, 0.2, 0.05
BEAM, THICKNESS = 0.35, 0.02
DENSITY, MODULUS, POISSON, LIQUID = 1000, 1.4e6, 0.4, 1000
N_MODES = 6


def mode(i, s):
    """The dry cantilever's mode i = 0, 1, ... at s in 0 to 1 from the root, and its wave number."""
    guess = (i + 0.5) * np.pi
    k = brentq(lambda k: np.cos(k) + 1 / np.cosh(k), guess - 0.8, guess + 0.8)
    ratio = (np.sinh(k) - np.sin(k)) / (np.cosh(k) + np.cos(k))
    return np.cosh(k * s) - np.cos(k * s) - ratio * (np.sinh(k * s) - np.sin(k * s)), k


def main():
    n_across = int(sys.argv[1]) if len(sys.argv) > 1 else 4
    h = THICKNESS / n_across
    n_x, n_y = round(LENGTH / h), round(HEIGHT / h)
    x, y = (np.arange(n_x) + 0.5) * h, (np.arange(n_y) + 0.5) * h
    x_grid, y_grid = np.meshgrid(x, y, indexing="ij")
    tip = X + RADIUS + BEAM
    is_beam = (abs(y_grid - Y) < THICKNESS / 2) & (x_grid > X) & (x_grid < tip)
    is_cylinder = (x_grid - X) ** 2 + (y_grid - Y) ** 2 < RADIUS**2
    is_liquid = ~(is_beam | is_cylinder)
    number = np.full((n_x, n_y), -1)
    number[is_liquid] = np.arange(is_liquid.sum())

    rows, columns, values = [], [], []
    diagonal = np.zeros(is_liquid.sum())
    for a, b in ((number[:-1], number[1:]), (number[:, :-1], number[:, 1:])):
        inner = (a >= 0) & (b >= 0)
        for p, q in ((a[inner], b[inner]), (b[inner], a[inner])):
            rows.append(p)
            columns.append(q)
            values.append(np.ones(p.size))
            np.add.at(diagonal, p, -1)
    diagonal[number[-1, number[-1] >= 0]] -= 2  # zero half a cell beyond the last centres
    rows.append(np.arange(diagonal.size))
    columns.append(np.arange(diagonal.size))
    values.append(diagonal)
    factor = splu(coo_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns)))).tocsc())

    # The sides of the beam in touch with liquid, and the motion of its modes there.
    i, j = np.nonzero(is_beam[:, :-1] & is_liquid[:, 1:])
    k, l = np.nonzero(is_liquid[:, :-1] & is_beam[:, 1:])
    above, below = number[i, j + 1], number[k, l]
    root = X + RADIUS
    wave_numbers = np.array([mode(m, 0)[1] for m in range(N_MODES)])
    shapes = [lambda s, m=m: np.where(s > 0, mode(m, np.maximum(s, 0))[0], 0) for m in range(N_MODES)]
    carried = np.zeros((N_MODES, N_MODES))
    upper = [shape((x[i] - root) / BEAM) for shape in shapes]
    lower = [shape((x[k] - root) / BEAM) for shape in shapes]
    for m in range(N_MODES):
        flux = np.zeros(diagonal.size)
        np.add.at(flux, above, h * upper[m])
        np.add.at(flux, below, -h * lower[m])
        potential = factor.solve(flux)
        for n in range(N_MODES):
            # At the side itself, half a cell from the centre.
            carried[m, n] = LIQUID * h * (np.sum((potential[below] + 0.5 * h * lower[m]) * lower[n])
                                          - np.sum((potential[above] - 0.5 * h * upper[m]) * upper[n]))

    s = (np.arange(4000) + 0.5) / 4000
    own = np.array([[np.mean(f(s) * g(s)) for g in shapes] for f in shapes]) * DENSITY * THICKNESS * BEAM
    bending = MODULUS / (1 - POISSON**2) * THICKNESS**3 / 12
    stiffness = np.diag(bending * wave_numbers**4 / BEAM**3 * np.diag(own) / (DENSITY * THICKNESS * BEAM))
    dry = np.sqrt(np.linalg.eigvals(np.linalg.solve(own, stiffness)).real) / (2 * np.pi)
    wet = np.sqrt(np.linalg.eigvals(np.linalg.solve(own + carried, stiffness)).real) / (2 * np.pi)
    print("dry:      " + ", ".join(f"{f:.4f}" for f in sorted(dry)[:3]) + " Hz")
    print("in liquid: " + ", ".join(f"{f:.4f}" for f in sorted(wet)[:3]) + " Hz")


if __name__ == "__main__":
    main()
