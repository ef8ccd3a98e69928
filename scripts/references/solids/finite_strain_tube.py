#!/usr/bin/python3
"""Inflation of a neo-Hookean tube whose ends are held axially: the pressures and radii of the files finite-strain-*tube*.prm.

    scripts/references/solids/finite_strain_tube.py

Incompressible: the closed solution p = mu (ln(a B/(A b)) + (a^2 - A^2)/2 (1/a^2 - 1/b^2)), b^2 = a^2 + B^2 - A^2.
Compressible: sigma = mu J^(-5/3) dev(F F^T) + K ln J, by Runge-Kutta steps along the radius from the inner face, whose radius and stretch
are found by Newton's iteration so that the radial stress is -p inside and 0 outside. No finite elements are in it.
"""

import math

MU = 1e5  # [Pa]


def closed_pressure(inner, outer, a):
    b = math.sqrt(a * a + outer * outer - inner * inner)
    return MU * (math.log(a * outer / (inner * b)) + (a * a - inner * inner) / 2 * (1 / a**2 - 1 / b**2))


def stresses(radial, hoop, bulk_modulus):
    """Radial and hoop stress of the stretches [Pa]; the axial stretch is 1."""
    volume = radial * hoop
    third = (radial**2 + hoop**2 + 1) / 3
    factor = MU * volume ** (-5 / 3)
    spherical = bulk_modulus * math.log(volume)
    return factor * (radial**2 - third) + spherical, factor * (hoop**2 - third) + spherical


def rates(place, r, radial, bulk_modulus):
    """d r/dR and d(radial stretch)/dR: d sigma_r/dR = (sigma_h - sigma_r) r'/r."""
    hoop = r / place
    step = 1e-6
    by_radial = (stresses(radial + step, hoop, bulk_modulus)[0] - stresses(radial - step, hoop, bulk_modulus)[0]) / (2 * step)
    by_hoop = (stresses(radial, hoop + step, bulk_modulus)[0] - stresses(radial, hoop - step, bulk_modulus)[0]) / (2 * step)
    sigma_r, sigma_h = stresses(radial, hoop, bulk_modulus)
    return radial, ((sigma_h - sigma_r) * radial / r - by_hoop * (radial - hoop) / place) / by_radial


def shoot(inner, outer, a, radial, bulk_modulus, n_steps=400):
    """Radial stresses inside and outside [Pa]."""
    inside = stresses(radial, a / inner, bulk_modulus)[0]
    place, r, h = inner, a, (outer - inner) / n_steps
    for _ in range(n_steps):
        k1 = rates(place, r, radial, bulk_modulus)
        k2 = rates(place + h / 2, r + h / 2 * k1[0], radial + h / 2 * k1[1], bulk_modulus)
        k3 = rates(place + h / 2, r + h / 2 * k2[0], radial + h / 2 * k2[1], bulk_modulus)
        k4 = rates(place + h, r + h * k3[0], radial + h * k3[1], bulk_modulus)
        r += h / 6 * (k1[0] + 2 * k2[0] + 2 * k3[0] + k4[0])
        radial += h / 6 * (k1[1] + 2 * k2[1] + 2 * k3[1] + k4[1])
        place += h
    return inside, stresses(radial, r / place, bulk_modulus)[0]


def inner_radius(inner, outer, pressure, bulk_modulus):
    a, radial = 1.1 * inner, 1 / 1.1
    for _ in range(50):
        f = shoot(inner, outer, a, radial, bulk_modulus)
        residual = (f[0] + pressure, f[1])
        step = 1e-7
        by_a = shoot(inner, outer, a + step, radial, bulk_modulus)
        by_radial = shoot(inner, outer, a, radial + step, bulk_modulus)
        m = [[(by_a[i] - f[i]) / step, (by_radial[i] - f[i]) / step] for i in range(2)]
        det = m[0][0] * m[1][1] - m[0][1] * m[1][0]
        change = ((m[1][1] * residual[0] - m[0][1] * residual[1]) / det, (m[0][0] * residual[1] - m[1][0] * residual[0]) / det)
        a, radial = a - change[0], radial - change[1]
        if abs(change[0]) + abs(change[1]) < 1e-12:
            break
    return a


print(f"A 1 m, B 1.2 m, incompressible, a = 1.3 m: p = {closed_pressure(1, 1.2, 1.3):.6f} Pa")
print(f"A 1 m, B 2 m, incompressible, a = 1.5 m: p = {closed_pressure(1, 2, 1.5):.6f} Pa")
NU = 0.49
print(f"A 1 m, B 1.2 m, nu 0.49, p = 8703.60098 Pa: a = {inner_radius(1, 1.2, 8703.60098, 2 * MU * (1 + NU) / (3 * (1 - 2 * NU))):.8f} m")
