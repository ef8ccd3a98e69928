#!/usr/bin/python3
"""The common carotid artery of a benchmark by linear theory, without Continua: reference of parameter_files/verification/common-carotid.prm.

    scripts/references/waves/carotid.py

The flow rate of the table, linear between its rows and repeated, is a Fourier series. Each harmonic is a forward and a backward pressure wave in a
tube that is held along its axis (J. R. Womersley, 1957), with z = i^(3/2) a sqrt(omega rho/mu) and F = 2 J1(z)/(z J0(z)):

    k^2 = omega^2 rho (C + A/K)/(A (1 - F)),  Z = rho omega/(A k (1 - F)),

where C = 2 pi a u is the compliance of a metre, by the radial displacement u of Lame's thick tube without axial strain. The wall's inertia, a
thousandth of the stiffness at these frequencies, is not here. The windkessel gives the reflection; the mean flow has Poiseuille's pressure drop. Also
prints the Young's modulus with which the thick wall has the compliance of a membrane of 700 kPa. Needs python3-numpy and python3-scipy.
"""

import csv
import os

import numpy
from scipy.special import jv

FLOW = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../parameter_files/verification/common-carotid.csv")
RADIUS, THICKNESS, LENGTH, DENSITY, VISCOSITY, BULK_MODULUS = 3e-3, 0.3e-3, 0.126, 1060.0, 4e-3, 2.2e9
MEMBRANE_MODULUS, POISSON = 700e3, 0.4999
PROXIMAL, DISTAL, COMPLIANCE, BEHIND = 248.75e6, 1869.7e6, 0.17529e-9, -10933.0
STATIONS = (0.01, 0.063, 0.116)
N_HARMONICS, N_SAMPLES = 40, 4096


def displacement(young):
    """Of the inner wall under 1 Pa [m/Pa]."""
    a, b = RADIUS, RADIUS + THICKNESS
    return (1 + POISSON) / young * a * ((1 - 2 * POISSON) * a**2 + b**2) / (b**2 - a**2)


def main():
    of_membrane = RADIUS**2 * (1 - 0.5**2) / (MEMBRANE_MODULUS * THICKNESS)
    young = round(MEMBRANE_MODULUS * displacement(MEMBRANE_MODULUS) / of_membrane, -1)
    print(f"Young's modulus {young / 1e3:.2f} kPa")
    with open(FLOW, encoding="utf-8") as stream:
        rows = [row for row in csv.reader(line for line in stream if not line.startswith("#"))][1:]
    table = numpy.array([[float(cell) for cell in row] for row in rows])
    period = table[-1, 0] - table[0, 0]
    at = numpy.arange(N_SAMPLES) * period / N_SAMPLES
    spectrum = numpy.fft.rfft(numpy.interp(at, table[:, 0] - table[0, 0], table[:, 1])) / N_SAMPLES
    mean_flow = spectrum[0].real
    area = numpy.pi * RADIUS**2
    compliance = 2 * numpy.pi * RADIUS * displacement(young)
    for x in STATIONS:
        pressure = numpy.zeros(N_SAMPLES // 2 + 1, complex)
        flow = pressure.copy()
        drop = 8 * VISCOSITY / (numpy.pi * RADIUS**4) * (LENGTH - x)
        pressure[0], flow[0] = BEHIND + mean_flow * (PROXIMAL + DISTAL + drop), mean_flow
        for m in range(1, N_HARMONICS + 1):
            omega = 2 * numpy.pi * m / period
            z = 1j**1.5 * RADIUS * numpy.sqrt(omega * DENSITY / VISCOSITY)
            slip = 1 - 2 * jv(1, z) / (z * jv(0, z))
            k = numpy.sqrt(omega**2 * DENSITY * (compliance + area / BULK_MODULUS) / (area * slip))
            k = k if k.imag < 0 else -k
            impedance = DENSITY * omega / (area * k * slip)
            load = PROXIMAL + DISTAL / (1 + 1j * omega * DISTAL * COMPLIANCE)
            back = (load - impedance) / (load + impedance) * numpy.exp(-2j * k * LENGTH)
            forward = impedance * spectrum[m] / (1 - back)
            there, returned = numpy.exp(-1j * k * x), back * numpy.exp(1j * k * x)
            pressure[m] = forward * (there + returned)
            flow[m] = forward / impedance * (there - returned)
        print(f"at {x} m")
        for name, harmonics in (("pressure [Pa]", pressure), ("flow rate [ml/s]", 1e6 * flow),
                                ("wall distension [mm]", 2e3 * displacement(young) * pressure)):
            values = numpy.fft.irfft(harmonics, N_SAMPLES) * N_SAMPLES
            print(f"  {name}: largest {values.max():.5g}, smallest {values.min():.5g}, mean {values.mean():.6g}, "
                  f"range {values.max() - values.min():.5g}")


if __name__ == "__main__":
    main()
