#!/usr/bin/python3
"""Modes of the cantilever of chapter 4 as a plate: why the thesis's table 4.2 has 5.0791 Hz for the torsion.

The beam, 20 m x 5 m x 1 m, bends across its thickness of 1 m as a plate that is clamped on its short side. Printed are the
first three frequencies of that motion (bending, bending, torsion)

- of thin plates (Kirchhoff) and of plates that shear (Mindlin, factor 5/6) by Rayleigh and Ritz: polynomials over the whole
  plate, so many that the digits shown stand but for the last;
- of Mindlin plates cut into four-node elements whose shear is interpolated from the edges (K.-J. Bathe, E. N. Dvorkin,
  Int. J. Numer. Meth. Engng 21, 1985), the usual shell element of commercial programs, on several meshes.

The twisting moment of a Mindlin plate falls to zero at a free edge within a distance of about the thickness. Elements as
long as that do not see it, and make the plate stiffer in torsion. Needs numpy and scipy.
"""

import numpy as np
import scipy.linalg
import scipy.sparse
import scipy.sparse.linalg
from numpy.polynomial import legendre

LENGTH, HEIGHT, WIDTH = 20.0, 5.0, 1.0
MODULUS, RATIO, DENSITY = 4e9, 0.3, 1450.0
BENDING = MODULUS * WIDTH**3 / 12 / (1 - RATIO**2)
SHEAR = 5 / 6 * MODULUS / 2 / (1 + RATIO) * WIDTH
INERTIA = DENSITY * WIDTH**3 / 12


def functions(number, length, power):
    """x^power times Legendre polynomials: values and first and second derivatives at Gauss points, and their weights."""
    points, weights = legendre.leggauss(40)
    x = (points + 1) / 2
    values = ([], [], [])
    for i in range(number):
        polynomial = np.polynomial.Polynomial([0] * power + [1]) * legendre.Legendre.basis(i, [0, 1]).convert(
            kind=np.polynomial.Polynomial
        )
        for order in range(3):
            values[order].append(polynomial.deriv(order)(x) / length**order if order else polynomial(x))
    return [np.array(v) for v in values] + [weights * length / 2]


def frequencies(stiffness, mass):
    squares = scipy.linalg.eigh(stiffness, mass, eigvals_only=True, subset_by_index=[0, 2])
    return np.sqrt(squares) / 2 / np.pi


def ritz(n_along, n_across, shears):
    """Kirchhoff's plate, or Mindlin's with rotations of their own."""
    along, across = functions(n_along, LENGTH, 1 if shears else 2), functions(n_across, HEIGHT, 0)

    def product(a, b, c, d):
        """int d^a/dx^a d^c/dy^c f d^b/dx^b d^d/dy^d g."""
        return np.kron(along[a] * along[3] @ along[b].T, across[c] * across[3] @ across[d].T)

    one, xx, yy = product(0, 0, 0, 0), product(1, 1, 0, 0), product(0, 0, 1, 1)
    if not shears:
        cross = product(2, 0, 0, 2)
        stiffness = product(2, 2, 0, 0) + product(0, 0, 2, 2) + RATIO * (cross + cross.T)
        stiffness += 2 * (1 - RATIO) * product(1, 1, 1, 1)
        return frequencies(BENDING * stiffness, DENSITY * WIDTH * one + INERTIA * (xx + yy))
    twist = BENDING * (1 - RATIO) / 2
    w_x, w_y = -SHEAR * product(1, 0, 0, 0), -SHEAR * product(0, 0, 1, 0)
    x_y = BENDING * RATIO * product(1, 0, 0, 1) + twist * product(0, 1, 1, 0)
    stiffness = np.block(
        [
            [SHEAR * (xx + yy), w_x, w_y],
            [w_x.T, BENDING * xx + twist * yy + SHEAR * one, x_y],
            [w_y.T, x_y.T, BENDING * yy + twist * xx + SHEAR * one],
        ]
    )
    return frequencies(stiffness, scipy.linalg.block_diag(DENSITY * WIDTH * one, INERTIA * one, INERTIA * one))


def four_node_elements(n_x, n_y):
    """Mindlin's plate on n_x x n_y elements; unknowns w and two rotations a node."""
    d_x, d_y = LENGTH / n_x, HEIGHT / n_y
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])

    def shapes(r, s):
        along, across = 1 + r * corners[:, 0], 1 + s * corners[:, 1]
        return along * across / 4, corners[:, 0] * across / 2 / d_x, corners[:, 1] * along / 2 / d_y

    def shear(direction, r, s):
        n, *gradient = shapes(r, s)
        row = np.zeros(12)
        row[0::3], row[1 + direction :: 3] = gradient[direction], -n
        return row

    moments = BENDING * np.array([[1, RATIO, 0], [RATIO, 1, 0], [0, 0, (1 - RATIO) / 2]])
    stiffness, mass = np.zeros((12, 12)), np.zeros((12, 12))
    for r in (-(3**-0.5), 3**-0.5):
        for s in (-(3**-0.5), 3**-0.5):
            n, n_dx, n_dy = shapes(r, s)
            bend, values = np.zeros((3, 12)), np.zeros((3, 12))
            bend[0, 1::3], bend[1, 2::3], bend[2, 1::3], bend[2, 2::3] = n_dx, n_dy, n_dy, n_dx
            # Each shear strain from the middles of two edges.
            strains = np.array(
                [
                    (1 - s) / 2 * shear(0, 0, -1) + (1 + s) / 2 * shear(0, 0, 1),
                    (1 - r) / 2 * shear(1, -1, 0) + (1 + r) / 2 * shear(1, 1, 0),
                ]
            )
            for unknown in range(3):
                values[unknown, unknown::3] = n
            stiffness += d_x * d_y / 4 * (bend.T @ moments @ bend + SHEAR * strains.T @ strains)
            mass += d_x * d_y / 4 * values.T @ np.diag([DENSITY * WIDTH, INERTIA, INERTIA]) @ values
    rows, columns = [], []
    for i in range(n_x):
        for j in range(n_y):
            first, second = i * (n_y + 1) + j, (i + 1) * (n_y + 1) + j
            unknowns = (3 * np.array([first, second, second + 1, first + 1])[:, None] + np.arange(3)).ravel()
            rows.append(np.repeat(unknowns, 12))
            columns.append(np.tile(unknowns, 12))
    places = (np.concatenate(rows), np.concatenate(columns))
    free = slice(3 * (n_y + 1), None)
    matrices = [
        scipy.sparse.coo_matrix((np.tile(matrix.ravel(), n_x * n_y), places)).tocsc()[free, free]
        for matrix in (stiffness, mass)
    ]
    squares = scipy.sparse.linalg.eigsh(matrices[0], 3, matrices[1], sigma=0, return_eigenvectors=False)
    return np.sqrt(np.sort(squares)) / 2 / np.pi


def main():
    rows = [("thin plate", ritz(16, 10, False)), ("Mindlin plate", ritz(16, 12, True))]
    for n_x, n_y in ((20, 5), (40, 10), (80, 20), (160, 40)):
        rows.append((f"its four-node elements, {n_x} x {n_y}", four_node_elements(n_x, n_y)))
    for name, values in rows:
        print(f"{name:34s}" + "".join(f" {value:8.4f}" for value in values) + " Hz")


if __name__ == "__main__":
    main()
