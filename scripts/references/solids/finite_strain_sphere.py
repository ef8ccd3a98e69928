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


class InflatedWall:
    """A compressible wall. `n_hoops`: the directions around, 2 of a sphere and 1 of a tube, whose axial stretch is 1. `modulus`: mu [Pa]."""

    def __init__(self, n_hoops, modulus, bulk_modulus, inner, outer, n_steps=400):
        self.n_hoops, self.modulus, self.bulk_modulus = n_hoops, modulus, bulk_modulus
        self.inner, self.outer, self.n_steps = inner, outer, n_steps

    def stresses(self, radial, hoop):
        """Radial and hoop stress of the stretches [Pa]."""
        volume = radial * hoop**self.n_hoops
        third = (radial**2 + self.n_hoops * hoop**2 + 2 - self.n_hoops) / 3
        factor = self.modulus * volume ** (-5 / 3)
        spherical = self.bulk_modulus * math.log(volume)
        return factor * (radial**2 - third) + spherical, factor * (hoop**2 - third) + spherical

    def rates(self, place, r, radial):
        """d r/dR and d(radial stretch)/dR: d sigma_r/dR = n (sigma_h - sigma_r) r'/r."""
        hoop = r / place
        step = 1e-6
        by_radial = (self.stresses(radial + step, hoop)[0] - self.stresses(radial - step, hoop)[0]) / (2 * step)
        by_hoop = (self.stresses(radial, hoop + step)[0] - self.stresses(radial, hoop - step)[0]) / (2 * step)
        sigma_r, sigma_h = self.stresses(radial, hoop)
        return radial, (self.n_hoops * (sigma_h - sigma_r) * radial / r - by_hoop * (radial - hoop) / place) / by_radial

    def shoot(self, a, radial):
        """Radial stresses inside and outside [Pa], and the outer radius [m]."""
        inside = self.stresses(radial, a / self.inner)[0]
        place, r, h = self.inner, a, (self.outer - self.inner) / self.n_steps
        for _ in range(self.n_steps):
            k1 = self.rates(place, r, radial)
            k2 = self.rates(place + h / 2, r + h / 2 * k1[0], radial + h / 2 * k1[1])
            k3 = self.rates(place + h / 2, r + h / 2 * k2[0], radial + h / 2 * k2[1])
            k4 = self.rates(place + h, r + h * k3[0], radial + h * k3[1])
            r += h / 6 * (k1[0] + 2 * k2[0] + 2 * k3[0] + k4[0])
            radial += h / 6 * (k1[1] + 2 * k2[1] + 2 * k3[1] + k4[1])
            place += h
        return inside, self.stresses(radial, r / place)[0], r

    def radii(self, pressure, a, radial):
        """Inner and outer radius under the pressure [m]; Newton's iteration starts at the inner radius a and the radial stretch there."""
        for _ in range(50):
            f = self.shoot(a, radial)
            residual = (f[0] + pressure, f[1])
            step = 1e-7
            by_a, by_radial = self.shoot(a + step, radial), self.shoot(a, radial + step)
            m = [[(by_a[i] - f[i]) / step, (by_radial[i] - f[i]) / step] for i in range(2)]
            det = m[0][0] * m[1][1] - m[0][1] * m[1][0]
            change = ((m[1][1] * residual[0] - m[0][1] * residual[1]) / det, (m[0][0] * residual[1] - m[1][0] * residual[0]) / det)
            a, radial = a - change[0], radial - change[1]
            if abs(change[0]) + abs(change[1]) < 1e-12:
                break
        return a, self.shoot(a, radial)[2]


def radii(inner, outer, pressure, bulk_modulus, a, n_steps=400):
    """Inner and outer radius under the pressure [m]; Newton's iteration starts at the inner radius a."""
    return InflatedWall(2, MU, bulk_modulus, inner, outer, n_steps).radii(pressure, a, (inner / a) ** 2)


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
