#!/usr/bin/python3
"""Deflections of Cook's membrane, plane strain, by another way than Continua's: displacements alone, in elements of high degree.

    scripts/references/cook_membrane.py

The panel (0, 0), (48, 44), (48, 60), (0, 44) is one bilinear patch, cut into elements whose edges get shorter by a constant factor
toward all edges, since the stress is singular or steep in the corners. The elements
have the degree p in each direction, with nodes at the points of Gauss and Lobatto; with p = 8 and more displacements alone do not
lock. Printed for some degrees and numbers of layers, so that the digits that count can be seen. Needs python3-scipy.
"""

import numpy as np
import scipy.sparse
import scipy.sparse.linalg
from numpy.polynomial import legendre

CORNERS = np.array([[0., 0.], [48., 44.], [48., 60.], [0., 44.]])
FACTOR = 0.25


def lobatto(p):
    """Nodes on [-1, 1]: the ends and the zeros of the derivative of the Legendre polynomial."""
    return np.concatenate([[-1.], np.sort(legendre.Legendre.basis(p).deriv().roots().real), [1.]])


def shape(nodes, points):
    """Values and derivatives of Lagrange's polynomials, [point, node]."""
    p = len(nodes) - 1
    vandermonde = legendre.legvander(nodes, p)
    derivative = np.stack([legendre.legval(points, legendre.legder(unit)) for unit in np.eye(p + 1)], axis=1)
    inverse = np.linalg.inv(vandermonde)
    return legendre.legvander(points, p) @ inverse, derivative @ inverse


def graded(n):
    """Edges on [0, 1]: n layers toward either end."""
    toward_zero = [0.] + [FACTOR**(n - i) for i in range(1, n)]
    half = [0.5 * x for x in toward_zero]
    return np.array(half + [0.35, 0.5, 0.65] + [1. - x for x in reversed(half)])


def place(s, t):
    """Point and derivatives of the bilinear patch."""
    weights = np.array([(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t])
    along_s = np.array([-(1 - t), 1 - t, t, -t])
    along_t = np.array([-(1 - s), -s, s, 1 - s])
    return weights @ CORNERS, np.stack([along_s @ CORNERS, along_t @ CORNERS], axis=1)


def solve(young, poisson, stress, p, n_layers):
    """u_y at (48, 52) and (48, 60)."""
    mu, lame = young / (2 * (1 + poisson)), young * poisson / ((1 + poisson) * (1 - 2 * poisson))
    elasticity = np.array([[lame + 2 * mu, lame, 0.], [lame, lame + 2 * mu, 0.], [0., 0., mu]])
    s_edges, t_edges = graded(n_layers), graded(n_layers)
    nodes = lobatto(p)
    points, weights = legendre.leggauss(p + 2)
    values, slopes = shape(nodes, points)
    n_s, n_t = p * (len(s_edges) - 1) + 1, p * (len(t_edges) - 1) + 1
    rows, columns, entries = [], [], []
    load = np.zeros(2 * n_s * n_t)
    for i in range(len(s_edges) - 1):
        for j in range(len(t_edges) - 1):
            numbers = np.array([(p * i + a) * n_t + p * j + b for a in range(p + 1) for b in range(p + 1)])
            dofs = np.stack([2 * numbers, 2 * numbers + 1], axis=1).ravel()
            h_s, h_t = s_edges[i + 1] - s_edges[i], t_edges[j + 1] - t_edges[j]
            strains, stresses = [], []
            for a, weight_a in enumerate(weights):
                for b, weight_b in enumerate(weights):
                    s = s_edges[i] + h_s * (points[a] + 1) / 2
                    t = t_edges[j] + h_t * (points[b] + 1) / 2
                    jacobian = place(s, t)[1] * np.array([h_s / 2, h_t / 2])
                    gradient = np.stack([np.outer(slopes[a], values[b]).ravel(), np.outer(values[a], slopes[b]).ravel()],
                                        axis=1) @ np.linalg.inv(jacobian)
                    strain = np.zeros((3, 2 * len(numbers)))
                    strain[0, 0::2] = strain[2, 1::2] = gradient[:, 0]
                    strain[1, 1::2] = strain[2, 0::2] = gradient[:, 1]
                    strains.append(strain)
                    stresses.append(weight_a * weight_b * np.linalg.det(jacobian) * elasticity @ strain)
            matrix = np.concatenate(strains).T @ np.concatenate(stresses)
            rows.append(np.repeat(dofs, len(dofs)))
            columns.append(np.tile(dofs, len(dofs)))
            entries.append(matrix.ravel())
    # The loaded end is 16 long.
    for j in range(len(t_edges) - 1):
        for b, weight in enumerate(weights):
            for node in range(p + 1):
                number = (n_s - 1) * n_t + p * j + node
                load[2 * number + 1] += stress * 16 * weight * values[b, node] * (t_edges[j + 1] - t_edges[j]) / 2
    size = len(load)
    matrix = scipy.sparse.csr_matrix((np.concatenate(entries), (np.concatenate(rows), np.concatenate(columns))), shape=(size, size))
    free = np.arange(2 * n_t, size)
    displacement = np.zeros(size)
    displacement[free] = scipy.sparse.linalg.spsolve(matrix[free][:, free].tocsc(), load[free])
    end = displacement[2 * (n_s - 1) * n_t + 1::2]
    # t = 1/2 is the middle of the middle elements' common edge.
    middle = p * int(np.argmin(abs(t_edges - 0.5)))
    return end[middle], end[-1]


def main():
    young = 0.375 * (3 * 7500 + 2 * 0.375) / (7500 + 0.375)
    cases = (("nearly incompressible, total shear 1", young, 7500 / (2 * (7500 + 0.375)), 1 / 16),
             ("70 MPa, 1/3, 6.25 MPa", 70., 1 / 3, 6.25))
    for name, modulus, poisson, stress in cases:
        for p, n_layers in ((6, 5), (8, 5), (8, 7), (10, 7)):
            middle, corner = solve(modulus, poisson, stress, p, n_layers)
            print(f"{name}: degree {p}, {n_layers} layers: (48, 52) {middle:.6f}, (48, 60) {corner:.6f}", flush=True)


if __name__ == "__main__":
    main()
