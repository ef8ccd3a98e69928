#!/usr/bin/python3
"""Resonances exp(s t) of bodies whose matrix is one equation for s.

column:     a column of height 0.1 m that is sheared, held at its foot: s^2 + mu*(s) k^2/rho = 0 with k = (2 n - 1) pi/(2 H). Of a
            Kelvin-Voigt solid mu* = mu + s eta, a quadratic equation; of a power law 3 mu* = c Gamma(1 - m) s^m (incompressible).
pipe:       a compressible viscous liquid in a rigid pipe that is closed at one end and open at the other: k^2 = -s^2/c^2/(1 - F(s)) with
            Womersley's F = 2 I1(a)/(a I0(a)), a = R sqrt(s/nu), c^2 = (K + 4/3 eta s)/rho and k = (2 n - 1) pi/(2 L), by Newton's
            method with differences.

    scripts/references/frequency/resonances.py

Printed are the natural frequency |s|/(2 pi) [Hz], the frequency Im s/(2 pi) [Hz] and the damping ratio -Re s/|s|. Needs scipy.
"""

import cmath
import math

from scipy import special


def newton(function, s):
    """The zero of an analytic function next to s."""
    for _ in range(80):
        step = 1e-5 * abs(s)
        change = function(s) * 2 * step / (function(s + step) - function(s - step))
        s -= change
        if abs(change) < 1e-13 * abs(s):
            return s
    raise SystemExit("Newton's method does not converge")


def print_resonance(name, number, s):
    print(f"{name} {number}: natural {abs(s) / (2 * math.pi):.6f} Hz, {s.imag / (2 * math.pi):.6f} Hz, damping ratio {-s.real / abs(s):.7f}")


def column():
    height, density, shear, viscosity = 0.1, 1000.0, 1e6, 400.0
    modulus, exponent = 1.3e6, 0.2
    for n in range(1, 7):
        k = (2 * n - 1) * math.pi / (2 * height)
        half = viscosity * k**2 / (2 * density)
        s = -half + cmath.sqrt(half**2 - shear * k**2 / density)
        print_resonance("kelvin-voigt", n, s)
    for n in range(1, 5):
        k = (2 * n - 1) * math.pi / (2 * height)
        start = 1j * k * math.sqrt(modulus * 3 / (3 * density))
        print_resonance("power law", n, newton(lambda s, k=k: s**2 + modulus * math.gamma(1 - exponent) / 3 * s**exponent * k**2 / density, start))


def pipe():
    length, radius, density, bulk, viscosity = 1.0, 5e-3, 998.0, 2.2e9, 1.0
    for n in range(1, 6):
        k = (2 * n - 1) * math.pi / (2 * length)

        def equation(s, k=k):
            a = radius * cmath.sqrt(s * density / viscosity)
            womersley = 2 * special.ive(1, a) / (a * special.ive(0, a))
            return s**2 * density / (bulk + 4 / 3 * viscosity * s) / (1 - womersley) + k**2

        print_resonance("pipe", n, newton(equation, 1j * k * math.sqrt(bulk / density)))


if __name__ == "__main__":
    column()
    pipe()
