#!/usr/bin/python3
"""Arteries of a benchmark by linear theory, without Continua: references of parameter_files/verification/common-carotid.prm and thoracic-aorta.prm.

    scripts/references/waves/arteries.py common-carotid|thoracic-aorta

The flow rate of the table, linear between its rows and repeated, is a Fourier series. Each harmonic is a forward and a backward pressure wave in a
tube that is held along its axis (J. R. Womersley, 1957), with z = i^(3/2) a sqrt(omega rho/mu) and F = 2 J1(z)/(z J0(z)):

    k^2 = omega^2 rho (C + A/K)/(A (1 - F)),  Z = rho omega/(A k (1 - F)),

where C = 2 pi a u is the compliance of a metre, by the radial displacement u of Lame's thick tube without axial strain. The wall's inertia, a
thousandth of the stiffness at these frequencies, is not here. The windkessel gives the reflection; the mean flow has Poiseuille's pressure drop. Also
prints the Young's modulus with which the thick wall has the compliance of the benchmark's membrane. Needs python3-numpy and python3-scipy.
"""

import csv
import dataclasses
import os
import sys

import numpy
from scipy.special import jv

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../parameter_files/verification")
DENSITY, VISCOSITY, BULK_MODULUS, POISSON = 1060.0, 4e-3, 2.2e9, 0.4999
N_HARMONICS, N_SAMPLES = 40, 4096


@dataclasses.dataclass
class Artery:
    """In SI: at its diastolic pressure, which is that of the windkessel's far end with the other sign."""

    radius: float
    thickness: float
    length: float
    membrane_modulus: float
    proximal: float
    distal: float
    compliance: float
    behind: float
    stations: tuple


ARTERIES = {
    "common-carotid": Artery(3e-3, 0.3e-3, 0.126, 700e3, 248.75e6, 1869.7e6, 0.17529e-9, -10933.0, (0.01, 0.063, 0.116)),
    "thoracic-aorta": Artery(12e-3, 1.2e-3, 0.24137, 400e3, 11.752e6, 111.67e6, 10.163e-9, -9460.0, (0.02, 0.12, 0.22)),
}


def displacement(artery, young):
    """Of the inner wall under 1 Pa [m/Pa]."""
    a, b = artery.radius, artery.radius + artery.thickness
    return (1 + POISSON) / young * a * ((1 - 2 * POISSON) * a**2 + b**2) / (b**2 - a**2)


def main():
    if len(sys.argv) != 2 or sys.argv[1] not in ARTERIES:
        sys.exit(__doc__)
    name_of_artery = sys.argv[1]
    artery = ARTERIES[name_of_artery]
    of_membrane = artery.radius**2 * (1 - 0.5**2) / (artery.membrane_modulus * artery.thickness)
    young = round(artery.membrane_modulus * displacement(artery, artery.membrane_modulus) / of_membrane, -1)
    print(f"Young's modulus {young / 1e3:.2f} kPa")
    with open(os.path.join(FOLDER, name_of_artery + ".csv"), encoding="utf-8") as stream:
        rows = [row for row in csv.reader(line for line in stream if not line.startswith("#"))][1:]
    table = numpy.array([[float(cell) for cell in row] for row in rows])
    period = table[-1, 0] - table[0, 0]
    at = numpy.arange(N_SAMPLES) * period / N_SAMPLES
    spectrum = numpy.fft.rfft(numpy.interp(at, table[:, 0] - table[0, 0], table[:, 1])) / N_SAMPLES
    mean_flow = spectrum[0].real
    area = numpy.pi * artery.radius**2
    compliance = 2 * numpy.pi * artery.radius * displacement(artery, young)
    for x in artery.stations:
        pressure = numpy.zeros(N_SAMPLES // 2 + 1, complex)
        flow = pressure.copy()
        drop = 8 * VISCOSITY / (numpy.pi * artery.radius**4) * (artery.length - x)
        pressure[0], flow[0] = artery.behind + mean_flow * (artery.proximal + artery.distal + drop), mean_flow
        for m in range(1, N_HARMONICS + 1):
            omega = 2 * numpy.pi * m / period
            z = 1j**1.5 * artery.radius * numpy.sqrt(omega * DENSITY / VISCOSITY)
            slip = 1 - 2 * jv(1, z) / (z * jv(0, z))
            k = numpy.sqrt(omega**2 * DENSITY * (compliance + area / BULK_MODULUS) / (area * slip))
            k = k if k.imag < 0 else -k
            impedance = DENSITY * omega / (area * k * slip)
            load = artery.proximal + artery.distal / (1 + 1j * omega * artery.distal * artery.compliance)
            back = (load - impedance) / (load + impedance) * numpy.exp(-2j * k * artery.length)
            forward = impedance * spectrum[m] / (1 - back)
            there, returned = numpy.exp(-1j * k * x), back * numpy.exp(1j * k * x)
            pressure[m] = forward * (there + returned)
            flow[m] = forward / impedance * (there - returned)
        print(f"at {x} m")
        for name, harmonics in (("pressure [Pa]", pressure), ("flow rate [ml/s]", 1e6 * flow),
                                ("wall distension [mm]", 2e3 * displacement(artery, young) * pressure)):
            values = numpy.fft.irfft(harmonics, N_SAMPLES) * N_SAMPLES
            print(f"  {name}: largest {values.max():.5g}, smallest {values.min():.5g}, mean {values.mean():.6g}, "
                  f"range {values.max() - values.min():.5g}")


if __name__ == "__main__":
    main()
