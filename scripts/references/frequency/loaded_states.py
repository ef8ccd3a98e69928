#!/usr/bin/python3
"""Small motions exp(s t) about bodies that rest under loads, in closed form; all solids are incompressible and neo-Hookean.

bar:        a bar that is held at one end and that a pressure has stretched by l, free at its sides: rho U'' L^2 = N' with the nominal stress
            N = mu (l - l^-3) in plane strain and mu (l - l^-2) of a bar with three equal axes. A branch of the wall that has relaxed adds
            4 m/l^2 in plane strain, and 3 m/l^2 otherwise, to dN/dl, m = mu_k s tau/(1 + s tau). Resonances of the plane one, without
            the inertia across the bar; the amplitude of the end of the other one, which a support holds, over a pressure there.
tube:       a thick tube of rubber that is held along its axis and full of liquid, closed at one end: k^2 = rho D s^2/(1 - F(s)) with
            Womersley's F = 2 I1(x)/(x I0(x)) and the distensibility D of the loaded tube, k = i (2 n - 1) pi/(2 L).
ring:       a tube of rubber (tests/tiny_runs/harmonic_loaded_rubber.prm): the hoop stress at its inner surface over a pressure there.

    scripts/references/frequency/loaded_states.py

Needs scipy.
"""

import cmath
import math

from resonances import newton, print_resonance
from scipy import special


def branch(s, modulus, time):
    return modulus * s * time / (1 + s * time)


def plane_bar(stretch=1.3, shear=1e5, length=0.5, density=1000.0, modulus=3e4, time=0.05):
    print(f"plane bar: pressure {-shear * (stretch**2 - stretch**-2):.6f} Pa")
    for n in (1, 2, 3):
        k = (2 * n - 1) * math.pi / (2 * length)

        def equation(s, k=k):
            return density * s**2 + k**2 * (shear * (1 + 3 * stretch**-4) + 4 * branch(s, modulus, time) / stretch**2)

        print_resonance("plane bar", n, newton(equation, 1j * k * math.sqrt(2.5 * shear / density) * (1 + 0.1j)))


def supported_bar(stretch=1.25, shear=1e5, length=0.5, density=1000.0, modulus=3e4, time=0.05, spring=1e5, damping=2e3):
    end = spring * (stretch - 1) * length  # of the support, over the undeformed area
    print(f"supported bar: pressure {-(shear * (stretch**2 - 1 / stretch) + end * stretch):.6f} Pa")
    for frequency in (0.0, 1.0, 3.0):
        s = 2j * math.pi * frequency
        slope = shear * (1 + 2 * stretch**-3) + 3 * branch(s, modulus, time) / stretch**2
        k = cmath.sqrt(-density * s**2 / slope)
        per_amplitude = (k / cmath.tan(k * length) if frequency else 1 / length)  # u'(L)/u(L)
        # The pressure p follows the end: its force a unit of undeformed area is p/l.
        end_slope = slope + (shear * (stretch**2 - 1 / stretch) + end * stretch) / stretch**2
        amplitude = -1 / stretch / (end_slope * per_amplitude + spring + s * damping)
        print(f"supported bar at {frequency} Hz: {abs(amplitude):.9e} m/Pa, {cmath.phase(amplitude):.7f} rad")


def tube(length=0.4, density=1060.0, viscosity=4e-3, distensibility=6.86442e-5, diameter=25.18560e-3):
    for n in (1, 2):
        k = (2 * n - 1) * math.pi / (2 * length)

        def equation(s, k=k):
            x = diameter / 2 * cmath.sqrt(s * density / viscosity)
            return density * distensibility * s**2 / (1 - 2 * special.ive(1, x) / (x * special.ive(0, x))) + k**2

        print_resonance("tube", n, newton(equation, 1j * k / math.sqrt(density * distensibility)))


def ring(inner=1.0, outer=1.2, present=1.3, shear=1e5, modulus=5e4, time=1.0):
    b2 = present**2 + outer**2 - inner**2
    slope = shear * (1 / present - present / b2 + present * (present**-2 - 1 / b2)
                     + (present**2 - inner**2) / 2 * (-2 / present**3 + 2 * present / b2**2))
    stretch = present / inner
    pressure = shear * (math.log(present * outer / (inner * math.sqrt(b2))) + (present**2 - inner**2) / 2 * (present**-2 - 1 / b2))
    print(f"ring: pressure {pressure:.6f} Pa, hoop stress {shear * (stretch**2 - stretch**-2) - pressure:.6f} Pa")
    for frequency in (0.0, 0.1, 0.2, 1.0):
        m = branch(2j * math.pi * frequency, modulus, time)
        amplitude = 1 / (slope + 2 * present * (present**-2 - 1 / b2) * m)
        stress = -1 + (2 * shear * (stretch**2 + stretch**-2) + 4 * m) * amplitude / present
        print(f"ring at {frequency} Hz: {abs(amplitude):.9e} m/Pa, {cmath.phase(amplitude):.7f} rad; "
              f"hoop stress {abs(stress):.7f} Pa/Pa, {cmath.phase(stress):.7f} rad")


if __name__ == "__main__":
    plane_bar()
    supported_bar()
    tube()
    ring()
