#!/usr/bin/python3
"""The tables of parameter_files/examples/stretch-tests/, which are synthetic; and how well constants can be found in them.

    scripts/references/tables/stretch_tables.py parameter_files/examples/stretch-tests

Incompressible Mooney-Rivlin rubber, mu1 = 0.32 MPa and mu2 = 0.08 MPa (shear modulus 0.4 MPa, share 0.2), pulled along one and
along two directions. The nominal stresses are those of the textbooks,

    (mu1 + mu2/l) (l - l^-2)   and   (mu1 + mu2 l^2) (l - l^-5),

plus 0.01 g times the largest of the table with normal numbers g of Python's generator, seed 1: noise of 1 %. It prints the
standard errors of the least squares, in which each table has its largest stress as unit.
"""

import os
import random
import sys

import numpy

MU1, MU2 = 0.32e6, 0.08e6  # Pa
NOISE = 0.01

SHAPES = {  # of mu1 and of mu2, over the stretch
    "uniaxial": (lambda l: l - l**-2, lambda l: (l - l**-2) / l, [1 + 0.1 * k for k in range(1, 21)]),
    "equibiaxial": (lambda l: l - l**-5, lambda l: (l - l**-5) * l**2, [1 + 0.05 * k for k in range(1, 21)]),
}


def main():
    generator = random.Random(1)
    rows = []
    for name, (first, second, stretches) in SHAPES.items():
        exact = [MU1 * first(l) + MU2 * second(l) for l in stretches]
        largest = max(exact)
        with open(os.path.join(sys.argv[1], name + ".csv"), "w", encoding="utf-8") as stream:
            stream.write("# Synthetic, not measured: an incompressible Mooney-Rivlin rubber of mu1 = 0.32 MPa and mu2 = 0.08 MPa\n"
                         "# with noise of 1 % of the largest stress; by scripts/references/tables/stretch_tables.py.\n"
                         "stretch [1], stress [kPa]\n")
            for stretch, stress in zip(stretches, exact):
                stream.write(f"{stretch:.2f}, {1e-3 * (stress + NOISE * largest * generator.gauss(0, 1)):.2f}\n")
        rows += [(first(l) / largest, second(l) / largest) for l in stretches]
    matrix = numpy.array(rows)
    covariance = NOISE**2 * numpy.linalg.inv(matrix.T @ matrix)
    mu = MU1 + MU2
    print(f"standard error of the shear modulus: {numpy.sqrt(covariance.sum()) / mu:.2%}")
    gradient = numpy.array([-MU2, MU1]) / mu**2
    print(f"standard error of the share: {numpy.sqrt(gradient @ covariance @ gradient):.4f}")


if __name__ == "__main__":
    main()
