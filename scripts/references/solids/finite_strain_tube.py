#!/usr/bin/python3
"""Inflation of a neo-Hookean tube whose ends are held axially: the pressures and radii of the files finite-strain-*tube*.prm.

    scripts/references/solids/finite_strain_tube.py

Incompressible: the closed solution p = mu (ln(a B/(A b)) + (a^2 - A^2)/2 (1/a^2 - 1/b^2)), b^2 = a^2 + B^2 - A^2.
Compressible: sigma = mu J^(-5/3) dev(F F^T) + K ln J, by Runge-Kutta steps along the radius from the inner face, whose radius and stretch
are found by Newton's iteration so that the radial stress is -p inside and 0 outside. No finite elements are in it.
"""

import math

from finite_strain_sphere import MU, InflatedWall


def closed_pressure(inner, outer, a):
    b = math.sqrt(a * a + outer * outer - inner * inner)
    return MU * (math.log(a * outer / (inner * b)) + (a * a - inner * inner) / 2 * (1 / a**2 - 1 / b**2))


def inner_radius(inner, outer, pressure, bulk_modulus):
    return InflatedWall(1, MU, bulk_modulus, inner, outer).radii(pressure, 1.1 * inner, 1 / 1.1)[0]


print(f"A 1 m, B 1.2 m, incompressible, a = 1.3 m: p = {closed_pressure(1, 1.2, 1.3):.6f} Pa")
print(f"A 1 m, B 2 m, incompressible, a = 1.5 m: p = {closed_pressure(1, 2, 1.5):.6f} Pa")
NU = 0.49
print(f"A 1 m, B 1.2 m, nu 0.49, p = 8703.60098 Pa: a = {inner_radius(1, 1.2, 8703.60098, 2 * MU * (1 + NU) / (3 * (1 - 2 * NU))):.8f} m")
