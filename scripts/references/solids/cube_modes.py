#!/usr/bin/python3
"""Natural frequencies of an elastic cube whose faces are all held, and of one without supports.

By Rayleigh and Ritz: Legendre polynomials along each edge, for the held cube times (1 - x^2), sorted by their symmetry about the three middle
planes, so that each class is a small problem of its own. Printed are f L/c_s with the speed c_s of shear waves, for Poisson's ratio 0.3, one
line each, the lowest first: a frequency of several shapes comes several times. The same with two polynomials fewer along each edge shows how
many digits stand. Needs numpy and scipy.
"""

import itertools
import sys

import numpy as np
import scipy.linalg
from numpy.polynomial import legendre

RATIO = 0.3
SHEAR, DENSITY = 1.0, 1.0
LAME = 2 * SHEAR * RATIO / (1 - 2 * RATIO)


def products(number, held):
    """Integrals over an edge from -1/2 to 1/2 of f g, f' g and f' g' of all functions."""
    points, weights = legendre.leggauss(number + 4)
    bubble = np.polynomial.Polynomial([1, 0, -1] if held else [1])
    functions = [bubble * legendre.Legendre.basis(i).convert(kind=np.polynomial.Polynomial) for i in range(number)]
    values = np.array([function(points) for function in functions])
    slopes = 2 * np.array([function.deriv()(points) for function in functions])
    weights = weights / 2
    return [(a * weights) @ b.T for a, b in ((values, values), (slopes, values), (slopes, slopes))]


def frequencies(number, held, count):
    mass, mixed, stiffness = products(number, held)
    of_parity = (np.arange(0, number, 2), np.arange(1, number, 2))
    found = []
    for parity in itertools.product((0, 1), repeat=3):
        # The parity of the displacement along an axis differs from the others' along this axis alone.
        indices = [[of_parity[parity[axis] ^ (axis == component)] for axis in range(3)] for component in range(3)]

        def product(one, other, kinds):
            """The integral over the cube of two components' functions, one kind of integral for each axis."""
            result = np.ones((1, 1))
            for axis, kind in enumerate(kinds):
                result = np.kron(result, kind[np.ix_(indices[one][axis], indices[other][axis])])
            return result

        blocks, masses = [], []
        for one in range(3):
            row = []
            for other in range(3):
                if one == other:
                    block = sum(((LAME + 2 * SHEAR) if axis == one else SHEAR)
                                * product(one, one, [stiffness if axis == k else mass for k in range(3)]) for axis in range(3))
                    masses.append(DENSITY * product(one, one, [mass] * 3))
                else:
                    # Lame's modulus takes d(one)/d(its axis), the shear modulus d(one)/d(the other axis).
                    kinds = [mass] * 3
                    kinds[one], kinds[other] = mixed, mixed.T
                    block = LAME * product(one, other, kinds)
                    kinds[one], kinds[other] = mixed.T, mixed
                    block = block + SHEAR * product(one, other, kinds)
                row.append(block)
            blocks.append(row)
        found += list(scipy.linalg.eigh(np.block(blocks), scipy.linalg.block_diag(*masses), eigvals_only=True))
    return np.sqrt(np.maximum(np.sort(found)[:count], 0)) / (2 * np.pi)


def main():
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 12
    for held, name in ((True, "all faces held"), (False, "without supports")):
        fine, coarse = (frequencies(n, held, 45) for n in (number, number - 2))
        print(f"{name}; {number - 2} polynomials change no value by more than {np.max(np.abs(coarse[6:] / fine[6:] - 1)):.0e}")
        for value in fine:
            print(f"{value:.6f}")


if __name__ == "__main__":
    main()
