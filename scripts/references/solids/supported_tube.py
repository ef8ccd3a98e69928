#!/usr/bin/python3
"""A tube in tissue that pushes its outside back by k times its displacement, over the undeformed area: references of the files
supported-*.prm.

    scripts/references/solids/supported_tube.py

Small deformation, ends held axially (Lame): u = A r + B/r, sigma_r = 2 mu (A/(1 - 2 nu) - B/r^2), sigma_r(a) = -p and
sigma_r(b) = -k u(b).
Incompressible neo-Hookean wall in large deformation: the tissue pushes by k (b - B) on the undeformed area, k (b - B) B/b on the
present one, so that p = mu (ln(a B/(A b)) + (a^2 - A^2)/2 (1/a^2 - 1/b^2)) + k (b - B) B/b, b^2 = a^2 + B^2 - A^2.
A rod of the length L in waves along itself, free at one end, with k at the other: M kappa tan(kappa L) = k, f = c kappa/(2 pi).
A rigid block on a spring and a damper: m u'' + c u' + k u = 0, per area of its base.
"""

import math


def lame(a, b, p, young, nu, k):
    """A [1], B [m^2] and the shear modulus [Pa]."""
    mu = young / (2 * (1 + nu))
    of_volume = 2 * mu / (1 - 2 * nu)
    rows = ((of_volume, -2 * mu / a**2), (of_volume + k * b, -2 * mu / b**2 + k / b))
    determinant = rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0]
    return -p * rows[1][1] / determinant, p * rows[1][0] / determinant, mu


def small():
    a, b, p, young, nu, k = 0.01, 0.02, 1e6, 1e9, 0.3, 5e10
    of_r, of_inverse, mu = lame(a, b, p, young, nu, k)
    bulk = young / (3 * (1 - 2 * nu))

    def hoop(r):
        return 2 * mu * (of_r / (1 - 2 * nu) + of_inverse / r**2)

    def displacement(r):
        return of_r * r + of_inverse / r
    print(f"small: A = {of_r:.16e}, B = {of_inverse:.15e} m^2")
    print(f"  u(a) = {displacement(a):.8e} m, u(b) = {displacement(b):.8e} m, pressure = {-2 * bulk * of_r:.6f} Pa")
    print(f"  at 15 mm sigma_theta = {hoop(0.015):.2f} Pa; sigma_x = {2 * (bulk - 2 * mu / 3) * of_r:.3f} Pa")
    print(f"  energy of the support = {0.5 * k * displacement(b)**2 * 2 * math.pi * b * 0.02:.8e} J")


def finite(inner, outer, a, k, mu=1e5):
    b = math.sqrt(a * a + outer * outer - inner * inner)
    wall = mu * (math.log(a * outer / (inner * b)) + (a * a - inner * inner) / 2 * (1 / a**2 - 1 / b**2))
    tissue = k * (b - outer) * outer / b
    print(f"finite, A {inner} m, B {outer} m, a = {a} m, k = {k:g} Pa/m: p = {wall:.6f} + {tissue:.6f} = {wall + tissue:.6f} Pa,"
          f" b - B = {b - outer:.9f} m")
    print(f"  energy of the support of 0.2 m of the tube = {0.5 * k * (b - outer)**2 * 2 * math.pi * outer * 0.2:.4f} J")


def rod(ratio, length, speed):
    """The first frequencies for k L/M = ratio, by bisection."""
    for n in range(3):
        low, high = n * math.pi, n * math.pi + math.pi / 2
        for _ in range(100):
            middle = (low + high) / 2
            # x sin x - ratio cos x has the sign (-1)^(n + 1) at the lower end.
            if (-1)**n * (middle * math.sin(middle) - ratio * math.cos(middle)) < 0:
                low = middle
            else:
                high = middle
        print(f"rod: mode {n + 1} {low * speed / (2 * math.pi * length):.6f} Hz")


def block(mass, stiffness, damping):
    decay = damping / (2 * mass)
    angular = math.sqrt(stiffness / mass - decay**2)
    print(f"block: {angular / (2 * math.pi):.6f} Hz, decay per oscillation {math.exp(-2 * math.pi * decay / angular):.6f}")


small()
finite(1, 1.2, 1.3, 1e5)
finite(1, 2, 1.5, 1e5)
rod(2, 2, 10)
block(100, 1e6, 1000)
block(100, 0.25e6, 1000)
