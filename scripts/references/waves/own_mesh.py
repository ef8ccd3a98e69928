#!/usr/bin/python3
"""Expected values of parameter_files/examples/own-mesh.prm, by a theory of one dimension.

    scripts/references/waves/own_mesh.py

The artery is a line of short uniform pieces, each with the radius and the modulus at its middle. For exp(i omega t) the
flow follows Womersley's profile in a rigid tube, and the section opens as Lame's cylinder does under a pressure that
changes slowly, free to move along the axis:

    dp/dx = - i omega rho / (pi a^2 F) q,    F = 1 - 2 J1(z) / (z J0(z)),  z = i^(3/2) a sqrt(omega rho / eta),
    dq/dx = - i omega D p,                   D = 2 pi a^2 / E ((b^2 + a^2) / (b^2 - a^2) + nu),

with the inner radius a, the outer one b and Young's modulus E. The pressure is given at the inlet, the far end is
closed. Not in it: the inertia of the wall, its bending and its axial waves, which the run has; hence the bands in the
parameter file. Needs python3-numpy and python3-mpmath.
"""

import mpmath
import numpy

LENGTH, RADIUS, WALL = 0.5, 5e-3, 0.5e-3
MIDDLE, EXTENT, HEIGHT = 0.23, 0.06, 3e-3
DENSITY, VISCOSITY, POISSON = 1050.0, 4e-3, 0.49
MODULUS_ARTERY, MODULUS_ANEURYSM = 1e6, 3e6
PULSE = 0.02  # s
STATIONS = {"before": 0.1, "inside": 0.23, "behind": 0.33}
END, RECORD, N_TIMES = 0.075, 2.0, 8192  # s; the record is long enough for all to die out
PIECE = 1e-3  # m


def inner_radius(x):
    if abs(x - MIDDLE) > EXTENT / 2:
        return RADIUS, MODULUS_ARTERY
    return RADIUS + HEIGHT / 2 * (1 + numpy.cos(2 * numpy.pi * (x - MIDDLE) / EXTENT)), MODULUS_ANEURYSM


def womersley(a, omega):
    """F of the equations above."""
    z = mpmath.mpc(0, 1) ** 1.5 * a * mpmath.sqrt(omega * DENSITY / VISCOSITY)
    return complex(1 - 2 * mpmath.besselj(1, z) / (z * mpmath.besselj(0, z)))


def histories():
    """Times and the pressure [Pa] at the stations."""
    times = numpy.arange(N_TIMES) * RECORD / N_TIMES
    inlet = numpy.where(times < PULSE, 1000 * numpy.sin(numpy.pi * times / PULSE) ** 2, 0)
    spectrum = numpy.fft.rfft(inlet)
    omegas = 2 * numpy.pi * numpy.fft.rfftfreq(N_TIMES, RECORD / N_TIMES)
    n_used = numpy.searchsorted(omegas, 2 * numpy.pi * 400)  # beyond 400 Hz the pulse has nothing
    middles = (numpy.arange(round(LENGTH / PIECE)) + 0.5) * PIECE
    transfer = {name: numpy.zeros(len(omegas), complex) for name in STATIONS}
    for name in STATIONS:
        transfer[name][0] = 1
    for k in range(1, n_used):
        omega = omegas[k]
        profile = {}
        p, q = 1.0 + 0j, 0j  # at the closed end
        pressures = {LENGTH: p}
        for x in middles[::-1]:
            a, modulus = inner_radius(x)
            b = a + WALL
            if a not in profile:
                profile[a] = womersley(a, omega)
            series = 1j * omega * DENSITY / (numpy.pi * a**2 * profile[a])
            shunt = 1j * omega * 2 * numpy.pi * a**2 / modulus * ((b**2 + a**2) / (b**2 - a**2) + POISSON)
            gamma, impedance = numpy.sqrt(series * shunt), numpy.sqrt(series / shunt)
            c, s = numpy.cosh(gamma * PIECE), numpy.sinh(gamma * PIECE)
            p, q = p * c + q * impedance * s, q * c + p / impedance * s
            pressures[round(x - PIECE / 2, 9)] = p
        for name, x in STATIONS.items():
            transfer[name][k] = pressures[x] / p
    return times, {name: numpy.fft.irfft(spectrum * values, N_TIMES) for name, values in transfer.items()}


def extremum(times, values, sign):
    """Time and value of the largest of sign * values before END, by a parabola through three points."""
    values = sign * values[times <= END]
    k = int(numpy.argmax(values))
    if k in (0, len(values) - 1):
        return times[k], sign * values[k]
    left, middle, right = values[k - 1 : k + 2]
    shift = 0.5 * (left - right) / (left - 2 * middle + right)
    return times[k] + shift * (times[1] - times[0]), sign * (middle - 0.25 * (left - right) * shift)


def main():
    times, pressures = histories()
    for name, values in pressures.items():
        for what, sign in (("maximum", 1), ("minimum", -1)):
            time, value = extremum(times, values, sign)
            print(f"{name}: {what} pressure {value:.1f} Pa at {1e3 * time:.2f} ms")


if __name__ == "__main__":
    main()
