#!/usr/bin/python3
"""Unsteady flow in a rigid tube: references of parameter_files/verification/womersley-rigid.prm and inlet-flow-rate.prm.

An incompressible viscous liquid in a tube of radius R and length L under the pressure difference P cos(omega t)
(J. R. Womersley, J. Physiol. 127, 1955):

    u = Re{P/(i rho omega L) [1 - J0(i^(3/2) a r/R)/J0(i^(3/2) a)] exp(i omega t)},   a = R sqrt(omega rho/eta)

The flow rate is its integral over the section. The profile at t = 0 is printed as a power series of (r/R)^2, since
J0(i^(3/2) a s) = sum_k (i a^2 s^2/4)^k/(k!)^2.

The second part is the flow from rest with the flow rate Q0 sin^2(pi t/T), by numerical inversion of its Laplace transform

    u = 1/(pi R^2) [I0(x) - I0(x r/R)]/I2(x) Q0/2 [1/s - s/(s^2 + (2 pi/T)^2)],   x = R sqrt(s rho/eta).

Needs mpmath.
"""

import mpmath as mp

mp.mp.dps = 40

DENSITY = mp.mpf(1000)
VISCOSITY = mp.mpf("0.004")
RADIUS = mp.mpf("0.005")
LENGTH = mp.mpf("0.02")
PRESSURE = mp.mpf(10)
PERIOD = mp.mpf(1)
FLOW_RATE = mp.mpf("1e-6")
DURATION = mp.mpf("0.05")
TIME = mp.mpf("0.04")
RADII = [mp.mpf(0), mp.mpf("0.0025"), mp.mpf("0.004"), mp.mpf("0.0045")]
N_TERMS = 17


def describe(name, amplitude, unit):
    """One line: the amplitude, when the first maximum comes, and the value after whole periods."""
    time = -mp.arg(amplitude) / (2 * mp.pi) * PERIOD
    print(
        f"{name}: amplitude {mp.nstr(abs(amplitude), 8)} {unit}, first maximum at {mp.nstr(time * 1000, 7)} ms, "
        f"after whole periods {mp.nstr(amplitude.real, 8)} {unit}"
    )


def main():
    omega = 2 * mp.pi / PERIOD
    number = RADIUS * mp.sqrt(omega * DENSITY / VISCOSITY)
    wave = number * mp.expjpi(mp.mpf(3) / 4)
    scale = PRESSURE / (1j * DENSITY * omega * LENGTH)
    print(f"Womersley number {mp.nstr(number, 6)}")
    for radius in RADII:
        profile = 1 - mp.besselj(0, wave * radius / RADIUS) / mp.besselj(0, wave)
        describe(f"r = {mp.nstr(radius * 1000, 4)} mm", scale * profile * 1000, "mm/s")
    mean = 1 - 2 * mp.besselj(1, wave) / (wave * mp.besselj(0, wave))
    describe("flow rate", mp.pi * RADIUS**2 * scale * mean * 10**6, "ml/s")

    print("coefficients of (r/R)^(2 k) of the velocity at t = 0 in m/s:")
    for k in range(N_TERMS):
        term = (1j * number**2 / 4) ** k / mp.factorial(k) ** 2 / mp.besselj(0, wave)
        print(f"  {k}: {mp.nstr((scale * ((1 if k == 0 else 0) - term)).real, 12)}")

    print(f"velocity of a flow rate of 1 ml/s sin^2(pi t/50 ms) from rest, at {mp.nstr(TIME * 1000, 4)} ms:")
    for radius in RADII:
        value = mp.invertlaplace(lambda s: transform(radius, s), TIME, method="talbot", degree=40)
        print(f"  r = {mp.nstr(radius * 1000, 4)} mm: {mp.nstr(value * 1000, 8)} mm/s")


def transform(radius, s):
    x = RADIUS * mp.sqrt(s * DENSITY / VISCOSITY)
    shape = (mp.besseli(0, x) - mp.besseli(0, x * radius / RADIUS)) / mp.besseli(2, x)
    flow = FLOW_RATE / 2 * (1 / s - s / (s**2 + (2 * mp.pi / DURATION) ** 2))
    return shape * flow / (mp.pi * RADIUS**2)


if __name__ == "__main__":
    main()
