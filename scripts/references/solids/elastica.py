#!/usr/bin/python3
"""A thin cantilever under a dead load at its end, across its first direction: the place of the tip of finite-strain-elastica.prm.

    scripts/references/solids/elastica.py

Elastica (thin, inextensible; K. E. Bisshopp, D. C. Drucker, Quart. Appl. Math. 3 (1945) 272-275): with beta = P L^2/(E' I), the angle a of the tip,
k^2 = (1 + sin a)/2 and sin f = 1/(k sqrt 2), the equation sqrt(beta) = K(k) - F(f, k) has the root a, and
    x/L = sqrt(2 sin a/beta),   y/L = 1 - 2/sqrt(beta) (E(k) - E(f, k)).
In plane strain E' = Y/(1 - nu^2).

A beam of the thickness h differs from it by terms of (h/L)^2, for which the second part is:
  * it lengthens by N/(E' h) and shears by Q/(5/6 G h) (E. Reissner, J. Appl. Math. Phys. 23 (1972) 795-804);
  * the law of the material is not linear: with the curvature k, M = E' I k (1 - c (h k)^2), and the middle lengthens by a (h k)^2. The numbers c and a
    come from a strip in pure bending, whose equation across the thickness, dP_rr/dY = k P_tt with P_rr = 0 on both faces, is solved here with the
    neo-Hookean stress tau = mu J^(-2/3) dev(F F^T) + K J ln J.
What a clamp does that also holds the contraction across the beam is not in it: a term of nu^2 h/L. No finite elements are in it. Needs numpy and scipy.
"""

import argparse
import math

import numpy as np
from scipy.integrate import solve_bvp, solve_ivp
from scipy.optimize import brentq
from scipy.special import ellipe, ellipeinc, ellipk, ellipkinc

BETA = 4.0


def elastica(beta):
    """Tip (x, y) over the length, and its angle."""
    def parameters(angle):
        m = (1 + math.sin(angle)) / 2
        return m, math.asin(min(1.0, 1 / math.sqrt(2 * m)))

    def residual(angle):
        m, f = parameters(angle)
        return ellipk(m) - ellipkinc(f, m) - math.sqrt(beta)

    angle = brentq(residual, 1e-6, math.pi / 2 - 1e-9, xtol=1e-14)
    m, f = parameters(angle)
    return math.sqrt(2 * math.sin(angle) / beta), 1 - 2 / math.sqrt(beta) * (ellipe(m) - ellipeinc(f, m)), angle


def strip(curvature, nu):
    """Numbers c and a of a strip of thickness 1 and E' = 1 in pure bending."""
    shear, bulk = (1 - nu) / 2, (1 - nu**2) / (3 * (1 - 2 * nu))

    def stresses(radial, hoop):
        """First Piola-Kirchhoff stresses of two stretches; the third one is 1."""
        volume = radial * hoop
        factor, third = shear * volume ** (-2 / 3), (radial**2 + hoop**2 + 1) / 3
        spherical = bulk * volume * np.log(volume)
        return (factor * (radial**2 - third) + spherical) / radial, (factor * (hoop**2 - third) + spherical) / hoop

    def radial_stretch(stress, hoop):
        radial = 1 - nu / (1 - nu) * (hoop - 1)
        for _ in range(30):
            slope = (stresses(radial + 1e-6, hoop)[0] - stresses(radial - 1e-6, hoop)[0]) / 2e-6
            radial = radial - (stresses(radial, hoop)[0] - stress) / slope
        return radial

    def rates(_, state):
        hoop = curvature * state[0]
        radial = radial_stretch(state[1], hoop)
        return np.vstack([radial, curvature * stresses(radial, hoop)[1]])

    across = np.linspace(-0.5, 0.5, 41)
    found = solve_bvp(rates, lambda one, other: np.array([one[1], other[1]]), across, np.vstack([1 / curvature + across, 0 * across]), tol=1e-10,
                      max_nodes=20000)
    points, weights = np.polynomial.legendre.leggauss(20)
    r, stress = found.sol(points / 2)
    moment = np.sum(weights / 2 * r * stresses(radial_stretch(stress, curvature * r), curvature * r)[1])
    return (1 - 12 * moment / curvature) / curvature**2, (curvature * found.sol(0.0)[0] - 1) / curvature**2


def beam(beta, thinness, nu, c=0.0, a=0.0):
    """Tip (x, y) over the length of a beam with thinness = h/L. The load is along y; lengths are over L, moments over E' I/L."""
    axial = 12 / thinness**2
    shear = 5 / 6 * (1 - nu) / 2 * axial
    c, a = c * thinness**2, a * thinness**2

    # The energy k^2/2 - c k^4/4 + axial (e - a k^2)^2/2 of a unit of length gives the moment and the force along the beam.
    def rates(_, state):
        angle, moment = state[:2]
        along, across = beta * math.sin(angle), beta * math.cos(angle)
        curvature = moment
        for _ in range(20):
            curvature = moment / (1 - c * curvature**2 - 2 * a * along)
        stretch, slide = 1 + along / axial + a * curvature**2, across / shear
        x_rate = stretch * math.cos(angle) - slide * math.sin(angle)
        y_rate = stretch * math.sin(angle) + slide * math.cos(angle)
        return [curvature, -x_rate * beta, x_rate, y_rate]

    def end(moment):
        return solve_ivp(rates, (0, 1), [0, moment, 0, 0], rtol=1e-11, atol=1e-12).y[:, -1]

    return end(brentq(lambda moment: end(moment)[1], 0.1, beta, xtol=1e-12))[2:]


def main():
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    x, y, angle = elastica(BETA)
    print(f"beta = {BETA:g}: elastica, displacement of the tip {x - 1:.8f}, {y:.8f} of the length; its angle {math.degrees(angle):.4f} degrees")
    for nu in (0.0, 0.3):
        c, a = strip(0.05, nu)
        print(f"nu = {nu:g}: c = {c:.4f}, a = {a:.4f}; differences from the elastica over (h/L)^2:")
        for thinness in (1e-3, 0.01, 0.02, 0.04):
            differences = [f"{(u - x) / thinness**2:.4f}, {(v - y) / thinness**2:.4f}"
                           for u, v in (beam(BETA, thinness, nu), beam(BETA, thinness, nu, c, a))]
            print(f"  h/L = {thinness:<5g}: length and shear {differences[0]};  with the law {differences[1]}")


if __name__ == "__main__":
    main()
