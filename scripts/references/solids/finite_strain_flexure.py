#!/usr/bin/python3
"""Flexure of an incompressible neo-Hookean block to a sector of a ring: the numbers in finite-strain-flexure.prm.

    scripts/references/solids/finite_strain_flexure.py

A block 0 < x < L, 0 < y < h becomes the sector with the angle x/A and the radius r = sqrt(2 A y + r1^2), so that the stretches are r/A and A/r
(R. S. Rivlin, Proc. R. Soc. A 195 (1949) 463-473). Equilibrium gives the stresses
    radial mu/2 (r^2/A^2 + A^2/r^2) - C,   along the block mu/2 (3 r^2/A^2 - A^2/r^2) - C,
and free sides r1 r2 = A^2 with r2^2 = r1^2 + 2 A h, C = mu/2 (r1^2/A^2 + A^2/r1^2). The forces over a section have no resultant, only the moment.
"""

import argparse
import math

LENGTH, HEIGHT, RADIUS, MU = 0.4, 0.04, 0.4, 1e5  # [m], [m], A [m], [Pa]


def main():
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    square = -RADIUS * HEIGHT + math.hypot(RADIUS * HEIGHT, RADIUS**2)
    constant = MU / 2 * (square / RADIUS**2 + RADIUS**2 / square)
    r1, r2 = math.sqrt(square), math.sqrt(square + 2 * RADIUS * HEIGHT)
    print(f"r1^2 = {square:.16g} m^2, r1 = {r1:.16g} m, r2 = {r2:.16g} m, C = {constant:.16g} Pa")

    def along(r):
        return MU / 2 * (3 * (r / RADIUS) ** 2 - (RADIUS / r) ** 2) - constant

    n = 2000
    places = [r1 + (r2 - r1) * (i + 0.5) / n for i in range(n)]
    force = sum(along(r) for r in places) * (r2 - r1) / n
    moment = sum(r * along(r) for r in places) * (r2 - r1) / n
    print(f"stress along the block {along(r1):.2f} Pa inside, {along(r2):.2f} Pa outside; resultant {force:.2e} N/m, moment {moment:.5f} N m/m")
    r = math.sqrt(RADIUS * HEIGHT + square)
    angle = LENGTH / RADIUS
    print(f"middle of the end: displacement {r * math.sin(angle) - LENGTH:.10f}, {r * math.cos(angle) - r1 - HEIGHT / 2:.10f} m")


if __name__ == "__main__":
    main()
