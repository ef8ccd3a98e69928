#!/usr/bin/python3
"""Thick incompressible balloons and tubes that are filled to given volumes: the pressures of the files finite-strain-balloon*.prm and
finite-strain-filled-tube.prm.

    scripts/references/solids/balloon.py

A point at the radius R moves to r, where r^3 - R^3 is the same for all points of a sphere and r^2 - R^2 for all points of a tube whose length
is held. With the hoop stretch k = r/R the law W = mu1/2 (I1 - 3) + mu2/2 (I2 - 3) has the differences of the principal stresses
    sphere   hoop - radial = mu1 (k^2 - k^-4) + mu2 (k^4 - k^-2)
    tube     hoop - radial = (mu1 + mu2) (k^2 - k^-2)
and the pressure inside is the integral of 2 (sphere) or 1 (tube) times (hoop - radial)/r over the wall, here by adaptive quadrature. The
volume of the cavity over the undeformed one is (a/A)^3 or (a/A)^2. The neo-Hookean sphere has the closed solution of finite_strain_sphere.py beside it.
No finite elements are in it.
"""

import argparse
import math

from finite_strain_sphere import closed_pressure
from scipy.integrate import quad
from scipy.optimize import minimize_scalar

MU = 1e5  # [Pa]
INNER = 1.0  # A [m]


def sphere_pressure(ratio, outer, share):
    """Of the volume ratio of the cavity, the undeformed outer radius [m] and mu2/mu [Pa]."""
    grown = (ratio - 1) * INNER**3

    def rate(r):
        k = r / (r**3 - grown) ** (1 / 3)
        return 2 * MU * ((1 - share) * (k**2 - k**-4) + share * (k**4 - k**-2)) / r

    return quad(rate, INNER * ratio ** (1 / 3), (outer**3 + grown) ** (1 / 3), epsabs=1e-9, epsrel=1e-12)[0]


def tube_pressure(ratio, outer):
    grown = (ratio - 1) * INNER**2

    def rate(r):
        k = r / math.sqrt(r**2 - grown)
        return MU * (k**2 - k**-2) / r

    return quad(rate, INNER * math.sqrt(ratio), math.sqrt(outer**2 + grown), epsabs=1e-9, epsrel=1e-12)[0]


def extremum(pressure, low, high, sign):
    """The volume ratio of the largest (1) or least (-1) pressure between two ratios."""
    return minimize_scalar(lambda ratio: -sign * pressure(ratio), bounds=(low, high), method="bounded", options={"xatol": 1e-9}).x


def line(ratio, pressure):
    return f"V/V0 {ratio:.4f}: {pressure(ratio):.4f} Pa"


def main():
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    outer = 1.2
    for share in (0.0, 0.15):

        def pressure(ratio, share=share):
            return sphere_pressure(ratio, outer, share)

        print(f"sphere, A 1 m, B {outer} m, mu2/mu = {share}")
        for stretch in (1.1, 1.2, 1.3, 1.4, 1.5, 1.75, 2, 2.5, 3, 3.4):
            print(f"  a = {stretch} m, " + line(stretch**3, pressure))
        top = extremum(pressure, 1.5, 6, 1)
        print(f"  largest at {line(top, pressure)}, where a = {top ** (1 / 3):.6f} m")
        if share > 0:
            print(f"  least behind it at {line(extremum(pressure, top, 40, -1), pressure)}")
        else:
            print(f"  closed solution at a = 2.5 m: {closed_pressure(INNER, outer, 2.5):.4f} Pa")
    thin = 1.0001
    top = extremum(lambda ratio: sphere_pressure(ratio, thin, 0), 1.5, 6, 1)
    print(f"thin sphere, B {thin} m: largest at a/A = {top ** (1 / 3):.5f}; of a membrane 7^(1/6) = {7 ** (1 / 6):.5f}")
    print("tube, A 1 m, B 2 m")
    for ratio in (1.5, 2, 2.25, 4, 9):
        print("  " + line(ratio, lambda ratio: tube_pressure(ratio, 2)))


if __name__ == "__main__":
    main()
