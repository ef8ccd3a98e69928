#!/usr/bin/python3
"""One layer with the law of Holzapfel, Gasser and Ogden fitted by scipy to measured pressures and diameters of two pulmonary arteries of mice: the
numbers of tests/runs/laboratory/measured_artery.prm, measured_artery_of_control.prm and measured_artery_dispersed.prm.

    scripts/references/solids/pulmonary_artery.py

The diameters are those of the tables beside these files. The ring without load is not given. Its wall has the area of the walls that were measured under
10, 30 and 40 mmHg, times the axial stretch, since it is incompressible. Its outer diameter is that at 0 mmHg times the root of the axial stretch, as of a
tube that is stretched alone; the fit has this row like all others. The pressure is the integral of (sigma_around - sigma_across)/r, by Gauss's rule.
"""

import math
import os

import numpy
from scipy.optimize import brentq, least_squares

TABLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "tests", "runs", "laboratory")
MMHG = 133.322387415  # Pa
THICKNESSES = {"pulmonary-artery.csv": (45.90, 35.16, 34.13), "pulmonary-artery-of-control.csv": (31.33, 16.18, 15.70)}  # um, under 10, 30 and 40 mmHg
# Of Gauss's rule in many pieces: fibres begin to bear somewhere in the wall, where the stress has a bend.
N_PIECES = 1000
OF_PIECE, WEIGHTS_OF_PIECE = numpy.polynomial.legendre.leggauss(3)
NODES = numpy.concatenate([(OF_PIECE + 1 + 2 * i) / N_PIECES - 1 for i in range(N_PIECES)])
WEIGHTS = numpy.tile(WEIGHTS_OF_PIECE / N_PIECES, N_PIECES)


def pressure(a, inner, thickness, along, dispersion, modulus, k1, k2, angle):
    """[Pa] of the inner radius `a`; `modulus`: of shear; `angle` of both families from the circumference. T. C. Gasser, R. W. Ogden, G. A. Holzapfel,
    J. R. Soc. Interface 3 (2006) 15, for the dispersion; fibres bear where their mean is longer than at rest."""
    b = math.sqrt(a * a + ((inner + thickness) ** 2 - inner**2) / along)
    r = 0.5 * (a + b) + 0.5 * (b - a) * NODES
    around = r / numpy.sqrt(inner**2 + along * (r * r - a * a))
    across = 1 / (around * along)
    aligned = 1 - 3 * dispersion
    fibre = (around * math.cos(angle)) ** 2 + (along * math.sin(angle)) ** 2 - 1
    strain = numpy.maximum(dispersion * (around**2 + across**2 + along**2 - 3) + aligned * fibre, 0)
    of_fibres = dispersion * (around**2 - across**2) + aligned * (around * math.cos(angle)) ** 2
    stress = modulus * (around**2 - across**2) + 4 * k1 * strain * numpy.exp(k2 * strain**2) * of_fibres
    return 0.5 * (b - a) * float(WEIGHTS @ (stress / r))


def fit(name, dispersion):
    along, load, diameter = numpy.loadtxt(os.path.join(TABLES, name), delimiter=",", skiprows=4).T
    along, load = along[0], load * MMHG
    area = numpy.mean([math.pi * thick * (diameter[row] - thick) for row, thick in zip((2, 6, 8), THICKNESSES[name])])
    outer = 0.5 * diameter[0] * math.sqrt(along)
    inner = math.sqrt(outer**2 - along * area / math.pi)
    ring = (inner * 1e-6, (outer - inner) * 1e-6, along, dispersion)

    def residuals(x):
        law = (*numpy.exp(x[:3]), x[3])
        radii = numpy.array([brentq(lambda a: pressure(a, *ring, *law) - p, 0.2 * ring[0], 5 * ring[0], xtol=1e-13) for p in load])
        return 2e6 * numpy.sqrt(radii**2 + ((ring[0] + ring[1]) ** 2 - ring[0] ** 2) / along) - diameter

    found = least_squares(residuals, [math.log(2e4), math.log(2e3), math.log(0.2), math.radians(30)], jac="3-point", x_scale="jac", xtol=1e-12, ftol=1e-14,
                          bounds=([-numpy.inf, -numpy.inf, math.log(0.01), 0], [numpy.inf, numpy.inf, math.log(10), math.pi / 2]))
    modulus, k1, k2 = numpy.exp(found.x[:3])
    print(f"{name}, dispersion {dispersion}: inner radius {inner:.4f} um, thickness {outer - inner:.4f} um; Young's modulus {3 * modulus:.1f} Pa, fibre stiffness {k1:.2f} Pa, fibre "
          f"exponent {k2:.5f}, fibre angle {90 - math.degrees(found.x[3]):.3f} deg from the axis, misfit {math.sqrt(numpy.mean(found.fun**2)):.4f} um, "
          f"largest {abs(found.fun).max():.2f} um")


if __name__ == "__main__":
    for table, of_fibres in (("pulmonary-artery.csv", 0), ("pulmonary-artery-of-control.csv", 0), ("pulmonary-artery.csv", 0.1)):
        fit(table, of_fibres)
