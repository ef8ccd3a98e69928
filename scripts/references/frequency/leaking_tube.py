#!/usr/bin/python3
"""Resonance of a liquid in a tapered elastic tube that is closed at its wide end and goes on without an end behind its narrow one, by a
theory of one dimension: what oscillates leaks into the tube behind.

    scripts/references/frequency/leaking_tube.py

    s C p = -Q',   rho s/(A (1 - F)) Q = -p',   Q = 0 at the closed end,   p = sqrt(Z' / Y') Q at the other

with the compliance C of a thick wall that is held axially (plane strain) and Womersley's F = 2 I1(x)/(x I0(x)), x = R sqrt(s rho/eta).
Newton's method with differences finds s; Runge and Kutta's fourth-order steps go along the tube. Left out are the inertia of the wall
and of radial motion. Needs scipy.
"""

import cmath
import math

from scipy.special import ive

LENGTH, DENSITY, VISCOSITY, YOUNG, POISSON = 0.3, 1060.0, 4e-3, 1.2e6, 0.49
THICKNESS = (2e-3, 2e-3)


def section(s, place, diameters):
    part = place / LENGTH
    radius = 0.5 * (diameters[0] + part * (diameters[1] - diameters[0]))
    thickness = THICKNESS[0] + part * (THICKNESS[1] - THICKNESS[0])
    outer = radius + thickness
    per_pressure = radius * (1 + POISSON) / YOUNG * ((1 - 2 * POISSON) * radius**2 + outer**2) / (outer**2 - radius**2)
    compliance = 2 * math.pi * radius * per_pressure
    x = radius * cmath.sqrt(s * DENSITY / VISCOSITY)
    friction = 2 * ive(1, x) / (x * ive(0, x))
    return DENSITY * s / (math.pi * radius**2 * (1 - friction)), s * compliance


def mismatch(s, diameters, steps=400):
    """p less that of the tube behind, at the end, of p = 1 and Q = 0 at the start."""
    pressure, flow, h = 1.0 + 0j, 0j, LENGTH / steps

    def slopes(place, p, q):
        series, shunt = section(s, place, diameters)
        return -series * q, -shunt * p

    for k in range(steps):
        x = k * h
        a = slopes(x, pressure, flow)
        b = slopes(x + h / 2, pressure + h / 2 * a[0], flow + h / 2 * a[1])
        c = slopes(x + h / 2, pressure + h / 2 * b[0], flow + h / 2 * b[1])
        d = slopes(x + h, pressure + h * c[0], flow + h * c[1])
        pressure += h / 6 * (a[0] + 2 * b[0] + 2 * c[0] + d[0])
        flow += h / 6 * (a[1] + 2 * b[1] + 2 * c[1] + d[1])
    series, shunt = section(s, LENGTH, diameters)
    return pressure - cmath.sqrt(series / shunt) * flow


def main():
    diameters = (30e-3, 6e-3)
    for start in (-40 + 60j, -60 + 150j, -60 + 250j):
        s = start
        for _ in range(60):
            step = 1e-5 * abs(s)
            change = mismatch(s, diameters) * 2 * step / (mismatch(s + step, diameters) - mismatch(s - step, diameters))
            s -= change
            if abs(change) < 1e-11 * abs(s):
                break
        print(f"start {start}: natural {abs(s) / (2 * math.pi):.4f} Hz, {s.imag / (2 * math.pi):.4f} Hz, damping ratio {-s.real / abs(s):.5f}")


if __name__ == "__main__":
    main()
