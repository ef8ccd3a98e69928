#!/usr/bin/python3
"""Torsion of a Mooney-Rivlin cylinder that keeps its length: the force and the work of finite-strain-torsion.prm.

    scripts/references/solids/finite_strain_torsion.py

With the twist psi of a unit of length, k = psi r and the stress -q I + mu1 b - mu2 b^-1 of an incompressible body, b has the components 1, k, 1 + k^2
along the axis and the circumference. A free lateral surface gives the radial stress -mu1 psi^2 (a^2 - r^2)/2, and integrals over the section give
    the moment M = pi mu psi a^4/2 and the axial force N = -pi psi^2 a^4 (mu1 + 2 mu2)/4
(R. S. Rivlin, Phil. Trans. R. Soc. A 242 (1949) 173-195). This script integrates the stresses and compares. Euler's steps turn the end by h each. The
velocity of a step is the chord over the step, and its part along the circumference is sin(h)/h of the angle's rate; so the work is sum M_n sin(h).
"""

import argparse
import math

RADIUS, LENGTH, MU, SHARE, ANGLE, N_STEPS = 0.05, 0.1, 1e5, 0.3, 1.0, 10  # [m], [m], [Pa], [1], [rad], [1]
MU_1, MU_2 = (1 - SHARE) * MU, SHARE * MU


def stresses(r, twist):
    """Axial stress and shear stress at the radius r [Pa]."""
    k = twist * r
    b = [[1, k], [k, 1 + k * k]]
    inverse = [[1 + k * k, -k], [-k, 1]]  # the determinant is 1
    radial = -MU_1 * twist**2 * (RADIUS**2 - r**2) / 2
    # In the radial direction b is 1: q follows from the radial stress.
    q = MU_1 - MU_2 - radial
    return tuple(-q * (j == 0) + MU_1 * b[0][j] - MU_2 * inverse[0][j] for j in range(2))


def integrals(twist, n=2000):
    """Axial force [N] and moment [N m] by the midpoint rule."""
    force = moment = 0.0
    for i in range(n):
        r = (i + 0.5) * RADIUS / n
        axial, shear = stresses(r, twist)
        ring = 2 * math.pi * r * RADIUS / n
        force, moment = force + axial * ring, moment + shear * r * ring
    return force, moment


def main():
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    twist = ANGLE / LENGTH
    force = -math.pi * twist**2 * RADIUS**4 / 4 * (MU_1 + 2 * MU_2)
    stiffness = math.pi * MU * RADIUS**4 / (2 * LENGTH)
    print(f"axial force {force:.6f} N, moment {stiffness * ANGLE:.6f} N m; integrals {integrals(twist)[0]:.6f} N, {integrals(twist)[1]:.6f} N m")
    h = ANGLE / N_STEPS
    print(f"work of {N_STEPS} steps {sum(stiffness * h * n * math.sin(h) for n in range(1, N_STEPS + 1)):.6f} J")
    shear = stresses(RADIUS / 2, twist)[1]
    print(f"at half of the radius and of the length: shear stress {shear:.3f} Pa, its z component {shear * math.cos(ANGLE / 2):.3f} Pa")


if __name__ == "__main__":
    main()
