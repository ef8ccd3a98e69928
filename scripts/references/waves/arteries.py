#!/usr/bin/python3
"""Arteries of a benchmark by linear theory, without Continua: references of parameter_files/verification/common-carotid.prm, thoracic-aorta.prm and
aortic-bifurcation.prm.

    scripts/references/waves/arteries.py common-carotid|thoracic-aorta|aortic-bifurcation

The flow rate of the table, linear between its rows and repeated, is a Fourier series. Each harmonic is a forward and a backward pressure wave in a
tube that is held along its axis (J. R. Womersley, 1957), with z = i^(3/2) a sqrt(omega rho/mu) and F = 2 J1(z)/(z J0(z)):

    k^2 = omega^2 rho (C + A/K)/(A (1 - F)),  Z = rho omega/(A k (1 - F)),

where C = 2 pi a u is the compliance of a metre, by the radial displacement u of Lame's thick tube without axial strain. The wall's inertia, a
thousandth of the stiffness at these frequencies, is not here. The windkessel gives the reflection; the mean flow has Poiseuille's pressure drop. Also
prints the Young's modulus with which the thick wall has the compliance of the benchmark's membrane.

The bifurcation has two equal daughters, each with a windkessel. They meet the parent in a point, where the pressure is common and the flow divides.
Its wall has one Young's modulus, that of the parent. The script prints the thickness with which the daughters' wall then has the compliance of
their membrane. Needs python3-numpy and python3-scipy.
"""

import csv
import dataclasses
import os
import sys

import numpy
from scipy.optimize import brentq
from scipy.special import jv

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../parameter_files/verification")
DENSITY, VISCOSITY, BULK_MODULUS, POISSON = 1060.0, 4e-3, 2.2e9, 0.4999
N_HARMONICS, N_SAMPLES = 40, 4096


@dataclasses.dataclass
class Tube:
    """In SI: at its diastolic pressure. The membrane is that of the benchmark; of several equal tubes each carries its part of the flow."""

    name: str
    radius: float
    thickness: float
    length: float
    membrane_modulus: float
    stations: tuple
    number: int = 1


@dataclasses.dataclass
class Artery:
    """The tubes from the inlet on, and the windkessel of each end. Its far end has the diastolic pressure with the other sign."""

    tubes: tuple
    proximal: float
    distal: float
    compliance: float
    behind: float


ARTERIES = {
    "common-carotid": Artery((Tube("tube", 3e-3, 0.3e-3, 0.126, 700e3, (0.01, 0.063, 0.116)),), 248.75e6, 1869.7e6, 0.17529e-9, -10933.0),
    "thoracic-aorta": Artery((Tube("tube", 12e-3, 1.2e-3, 0.24137, 400e3, (0.02, 0.12, 0.22)),), 11.752e6, 111.67e6, 10.163e-9, -9460.0),
    "aortic-bifurcation": Artery((Tube("parent", 8.6e-3, 1.032e-3, 0.086, 500e3, (0.02, 0.043, 0.07)),
                                  Tube("daughter", 6e-3, 0.72e-3, 0.085, 700e3, (0.0425, 0.075), 2)), 68.123e6, 3101.3e6, 0.36664e-9, -9470.0),
}


def displacement(radius, thickness, young):
    """Of the inner wall under 1 Pa [m/Pa]."""
    a, b = radius, radius + thickness
    return (1 + POISSON) / young * a * ((1 - 2 * POISSON) * a**2 + b**2) / (b**2 - a**2)


def of_membrane(tube):
    return tube.radius**2 * (1 - 0.5**2) / (tube.membrane_modulus * tube.thickness)


def walls(artery):
    """Young's modulus, and for each tube the thickness and the displacement under 1 Pa."""
    first = artery.tubes[0]
    young = round(first.membrane_modulus * displacement(first.radius, first.thickness, first.membrane_modulus) / of_membrane(first), -1)
    print(f"Young's modulus {young / 1e3:.2f} kPa")
    thicknesses = [first.thickness]
    for tube in artery.tubes[1:]:
        thickness = brentq(lambda h, tube=tube: displacement(tube.radius, h, young) - of_membrane(tube), 1e-5, tube.radius)
        thicknesses.append(round(thickness, 7))
        print(f"{tube.name}: wall thickness {thicknesses[-1] * 1e3:.4f} mm")
    return [displacement(tube.radius, thickness, young) for tube, thickness in zip(artery.tubes, thicknesses)]


def wave(tube, displaced, omega):
    """Wave number and impedance."""
    area = numpy.pi * tube.radius**2
    compliance = 2 * numpy.pi * tube.radius * displaced
    z = 1j**1.5 * tube.radius * numpy.sqrt(omega * DENSITY / VISCOSITY)
    slip = 1 - 2 * jv(1, z) / (z * jv(0, z))
    k = numpy.sqrt(omega**2 * DENSITY * (compliance + area / BULK_MODULUS) / (area * slip))
    k = k if k.imag < 0 else -k
    return k, DENSITY * omega / (area * k * slip)


def main():
    if len(sys.argv) != 2 or sys.argv[1] not in ARTERIES:
        sys.exit(__doc__)
    name_of_artery = sys.argv[1]
    artery = ARTERIES[name_of_artery]
    tubes = artery.tubes
    displaced = walls(artery)
    with open(os.path.join(FOLDER, name_of_artery + ".csv"), encoding="utf-8") as stream:
        rows = [row for row in csv.reader(line for line in stream if not line.startswith("#"))][1:]
    table = numpy.array([[float(cell) for cell in row] for row in rows])
    period = table[-1, 0] - table[0, 0]
    at = numpy.arange(N_SAMPLES) * period / N_SAMPLES
    spectrum = numpy.fft.rfft(numpy.interp(at, table[:, 0] - table[0, 0], table[:, 1])) / N_SAMPLES
    pressures = [[numpy.zeros(N_SAMPLES // 2 + 1, complex) for x in tube.stations] for tube in tubes]
    flows = [[numpy.zeros(N_SAMPLES // 2 + 1, complex) for x in tube.stations] for tube in tubes]
    # The mean, from the outlets to the inlet
    end = artery.behind + spectrum[0].real / tubes[-1].number * (artery.proximal + artery.distal)
    for i, tube in reversed(list(enumerate(tubes))):
        flow = spectrum[0].real / tube.number
        drop = 8 * VISCOSITY / (numpy.pi * tube.radius**4) * flow
        for j, x in enumerate(tube.stations):
            pressures[i][j][0], flows[i][j][0] = end + drop * (tube.length - x), flow
        end += drop * tube.length
    for m in range(1, N_HARMONICS + 1):
        omega = 2 * numpy.pi * m / period
        # What each tube throws back, from the outlets to the inlet
        load = artery.proximal + artery.distal / (1 + 1j * omega * artery.distal * artery.compliance)
        waves, number = [], tubes[-1].number
        for tube, u in reversed(list(zip(tubes, displaced))):
            load *= tube.number / number  # of the tubes behind, side by side
            number = tube.number
            k, impedance = wave(tube, u, omega)
            back = (load - impedance) / (load + impedance) * numpy.exp(-2j * k * tube.length)
            load = impedance * (1 + back) / (1 - back)
            waves.insert(0, (k, impedance, back))
        flow = spectrum[m]
        for i, (tube, (k, impedance, back)) in enumerate(zip(tubes, waves)):
            flow /= tube.number
            forward = impedance * flow / (1 - back)
            for j, x in enumerate(tube.stations):
                there, returned = numpy.exp(-1j * k * x), back * numpy.exp(1j * k * x)
                pressures[i][j][m] = forward * (there + returned)
                flows[i][j][m] = forward / impedance * (there - returned)
            flow = forward / impedance * (numpy.exp(-1j * k * tube.length) - back * numpy.exp(1j * k * tube.length))
    for i, tube in enumerate(tubes):
        for j, x in enumerate(tube.stations):
            print(f"{tube.name}, at {x} m")
            for name, harmonics in (("pressure [Pa]", pressures[i][j]), ("flow rate [ml/s]", 1e6 * flows[i][j]),
                                    ("wall distension [mm]", 2e3 * displaced[i] * pressures[i][j])):
                values = numpy.fft.irfft(harmonics, N_SAMPLES) * N_SAMPLES
                print(f"  {name}: largest {values.max():.5g}, smallest {values.min():.5g}, mean {values.mean():.6g}, "
                      f"range {values.max() - values.min():.5g}")


if __name__ == "__main__":
    main()
