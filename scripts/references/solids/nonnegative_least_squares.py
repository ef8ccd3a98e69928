#!/usr/bin/python3
"""Least squares without negative values, by scipy: the numbers of tests/base/nonnegative_least_squares.cc.

    scripts/references/solids/nonnegative_least_squares.py

The first problem is a matrix of small whole numbers. The second one is a sum of exponentials, whose columns are nearly dependent.
"""

import numpy
import scipy.optimize


def main():
    numpy.set_printoptions(precision=15)
    # A[i][j] = (7 i + 3 j + i j) mod 11 - 4, b[i] = (5 i + 2) mod 13 - 5.
    matrix = numpy.array([[(7 * i + 3 * j + i * j) % 11 - 4 for j in range(6)] for i in range(9)], dtype=float)
    right_side = numpy.array([(5 * i + 2) % 13 - 5 for i in range(9)], dtype=float)
    print("whole numbers:", *scipy.optimize.nnls(matrix, right_side))
    times = 0.1 * 1.25 ** numpy.arange(32)
    relaxation_times = 10.0 ** (-1 + 0.25 * numpy.arange(13))
    columns = numpy.column_stack([numpy.ones_like(times)] + [numpy.exp(-times / tau) for tau in relaxation_times])
    # A spring, two branches between the times of the columns, and a small wave in place of noise.
    values = 4 + 1.5 * numpy.exp(-times / 0.5) + 0.8 * numpy.exp(-times / 10) + 0.02 * numpy.cos(5 * numpy.arange(32))
    print("exponentials:", *scipy.optimize.nnls(columns, values))


if __name__ == "__main__":
    main()
