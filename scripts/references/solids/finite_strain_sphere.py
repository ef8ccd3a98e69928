#!/usr/bin/python3
"""Inflation of a neo-Hookean hollow sphere: the pressures and radii of the files finite-strain-*sphere.prm.

    scripts/references/solids/finite_strain_sphere.py

Incompressible: the closed solution p = mu/2 (4 A/b' + (A/b')^4 - 4 A/a - (A/a)^4) with b' = A b/B and b^3 = a^3 + B^3 - A^3.
Compressible: sigma = mu J^(-5/3) dev(F F^T) + K ln J, by Runge-Kutta steps along the radius from the inner face, whose radius and stretch
are found by Newton's iteration so that the radial stress is -p inside and 0 outside. No finite elements are in it.
"""

import argparse
import math

MU = 1e5  # [Pa]


def closed_pressure(inner, outer, a):
    b = (a**3 + outer**3 - inner**3) ** (1 / 3)
    return MU / 2 * (4 * outer / b + (outer / b) ** 4 - 4 * inner / a - (inner / a) ** 4)


def stresses(radial, hoop, bulk_modulus):
    """Radial and hoop stress of the stretches [Pa]; the hoop stretch acts twice."""
    volume = radial * hoop**2
    third = (radial**2 + 2 * hoop**2) / 3
    factor = MU * volume ** (-5 / 3)
    spherical = bulk_modulus * math.log(volume)
    return factor * (radial**2 - third) + spherical, factor * (hoop**2 - third) + spherical


def rates(place, r, radial, bulk_modulus):
    """d r/dR and d(radial stretch)/dR: d sigma_r/dR = 2 (sigma_h - sigma_r) r'/r."""
    hoop = r / place
    step = 1e-6
    by_radial = (stresses(radial + step, hoop, bulk_modulus)[0] - stresses(radial - step, hoop, bulk_modulus)[0]) / (2 * step)
    by_hoop = (stresses(radial, hoop + step, bulk_modulus)[0] - stresses(radial, hoop - step, bulk_modulus)[0]) / (2 * step)
    sigma_r, sigma_h = stresses(radial, hoop, bulk_modulus)
    return radial, (2 * (sigma_h - sigma_r) * radial / r - by_hoop * (radial - hoop) / place) / by_radial


def shoot(inner, outer, a, radial, bulk_modulus, n_steps):
    """Radial stresses inside and outside [Pa], and the outer radius [m]."""
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
    return inside, stresses(radial, r / place, bulk_modulus)[0], r


def radii(inner, outer, pressure, bulk_modulus, a, n_steps=400):
    """Inner and outer radius under the pressure [m]; Newton's iteration starts at the inner radius a."""
    radial = (inner / a) ** 2
    for _ in range(50):
        f = shoot(inner, outer, a, radial, bulk_modulus, n_steps)
        residual = (f[0] + pressure, f[1])
        step = 1e-7
        by_a = shoot(inner, outer, a + step, radial, bulk_modulus, n_steps)
        by_radial = shoot(inner, outer, a, radial + step, bulk_modulus, n_steps)
        m = [[(by_a[i] - f[i]) / step, (by_radial[i] - f[i]) / step] for i in range(2)]
        det = m[0][0] * m[1][1] - m[0][1] * m[1][0]
        change = ((m[1][1] * residual[0] - m[0][1] * residual[1]) / det, (m[0][0] * residual[1] - m[1][0] * residual[0]) / det)
        a, radial = a - change[0], radial - change[1]
        if abs(change[0]) + abs(change[1]) < 1e-12:
            break
    return a, shoot(inner, outer, a, radial, bulk_modulus, n_steps)[2]


def bulk_modulus(nu):
    return 2 * MU * (1 + nu) / (3 * (1 - 2 * nu))


def main():
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    pressure = closed_pressure(1, 1.2, 1.25)
    print(f"A 1 m, B 1.2 m, incompressible, a = 1.25 m: p = {pressure:.6f} Pa, b = {(1.25**3 + 1.2**3 - 1) ** (1 / 3):.8f} m")
    for nu in (0.49, 0.4999):
        a, b = radii(1, 1.2, 0.8 * pressure, bulk_modulus(nu), 1.15)
        print(f"A 1 m, B 1.2 m, nu {nu}, p = {0.8 * pressure:.6f} Pa: a = {a:.8f} m, b = {b:.8f} m")
    print(f"A 1 m, B 1.2 m, incompressible, a = {a:.8f} m: p = {closed_pressure(1, 1.2, a):.3f} Pa")


if __name__ == "__main__":
    main()
