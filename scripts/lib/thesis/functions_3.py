"""Functions of the expressions in chapter_3.toml and chapter_A.toml: schemes in time, runs that diverge, and curves along a rod."""

import math

import numpy

TABLE, COURANT, CELLS = "amplification.csv", "Courant number", "cells in a wavelength"


def amplification(results, run, scheme, quantity):
    """A quantity [1] of a scheme in amplification.csv, "amplitude", "speed ratio", "spectral radius" or one of the first two with
    " of the run" after it: a row for each Courant number, a column for each number of cells in a wavelength, both increasing."""
    courant, values = results.column(run, TABLE, f"{scheme}: {quantity}")
    _, cells = results.column(run, TABLE, CELLS)
    order = numpy.lexsort((cells, courant))
    return values[order].reshape(len(set(courant)), -1)


def amplification_at(results, run, scheme, quantity, courant, cells):
    """One of them [1], at a Courant number and a number of cells in a wavelength."""
    numbers, values = results.column(run, TABLE, f"{scheme}: {quantity}")
    _, waves = results.column(run, TABLE, CELLS)
    row = numpy.flatnonzero((numbers == courant) & (waves == cells))
    if len(row) != 1:
        raise KeyError(f"{run}: {TABLE} has no Courant number {courant:g} with {cells} cells in a wavelength")
    return float(values[row[0]])


def order_in_time(results, run, scheme, cells, coarse, fine, ending=""):
    """Order [1] of the error in damping and speed after a given time, from steps with two Courant numbers, for a wave of so many cells.
    By the formulas, or " of the run" with that ending."""
    def error(courant):
        amplitude, ratio = (amplification_at(results, run, scheme, name + ending, courant, cells)
                            for name in ("amplitude", "speed ratio"))
        angle = 2 * courant * math.sin(math.pi / cells)
        return abs(complex(math.log(amplitude), ratio * 2 * math.pi * courant / cells - angle)) / courant

    return math.log(error(coarse) / error(fine)) / math.log(coarse / fine)


def order_of_difference(_, coefficients, derivative):
    """Order [1] of the truncation error of a difference for the first or second derivative, which has these coefficients of the new value
    and of those before it: by the first term of Taylor's series that it does not remove."""
    for power in range(derivative + 1, len(coefficients) + derivative + 2):
        if abs(sum(factor * (-back)**power for back, factor in enumerate(coefficients))) > 1e-12:
            return float(power - derivative)
    return math.nan


def diverges(results, run):
    """1 if the loop of a run diverges, 0 if the run finishes [1]."""
    from .results import NotThere  # results.py imports this file
    try:
        results.run(run)
    except NotThere as error:
        if "diverges" in str(error):
            return 1.0
        raise
    return 0.0


def scatter(_, values):
    """Largest difference of two of the values over their mean [1]: 0 of a constant."""
    return float(numpy.ptp(values) / abs(numpy.mean(values)))


FUNCTIONS = {function.__name__: function for function in (amplification, amplification_at, order_in_time, order_of_difference, diverges,
                                                          scatter)}
