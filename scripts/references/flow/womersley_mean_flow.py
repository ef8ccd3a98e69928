#!/usr/bin/python3
"""A periodic flow on a mean flow in a rigid pipe: reference of parameter_files/verification/womersley-mean-flow.prm.

The convective terms vanish in a developed flow, so that Poiseuille's and Womersley's solutions (J. R. Womersley, J. Physiol. 127 (1955))
add up. The amplitude of the velocity over that of its mean is (I0(x) - I0(x r/R))/I2(x), x^2 = i omega R^2/nu, and the amplitude of the
pressure's gradient over that of the mean velocity -rho i omega I0(x)/I2(x). Needs mpmath.
"""

import mpmath as mp

mp.mp.dps = 20
RADIUS, DENSITY, VISCOSITY, PERIOD = mp.mpf("0.005"), mp.mpf(1060), mp.mpf("0.004"), mp.mpf("0.8")
MEAN, AMPLITUDE, TIME, LENGTH = mp.mpf("0.1"), mp.mpf("0.1"), mp.mpf("3.3"), mp.mpf("0.01")

if __name__ == "__main__":
    omega = 2 * mp.pi / PERIOD
    x = mp.sqrt(1j * omega * RADIUS**2 * DENSITY / VISCOSITY)
    phase = -1j * AMPLITUDE * mp.exp(1j * omega * TIME)  # of a sine
    print("Womersley number            ", mp.nstr(abs(x), 6))
    for part in (0, mp.mpf("0.5")):
        swing = phase * (mp.besseli(0, x) - mp.besseli(0, x * part)) / mp.besseli(2, x)
        print(f"velocity at {mp.nstr(part, 2)} R            ", mp.nstr(2 * MEAN * (1 - part**2) + swing.real, 12), "m/s")
    gradient = (-DENSITY * 1j * omega * phase * mp.besseli(0, x) / mp.besseli(2, x)).real - 8 * VISCOSITY * MEAN / RADIUS**2
    print("pressure drop over 10 mm    ", mp.nstr(-gradient * LENGTH, 12), "Pa")
