#!/usr/bin/python3
"""Speeds of the pulse in the thesis's tubes A and B with its pre-strain (parameter_files/thesis/chapter-6/experiment-*-theory.prm).

    scripts/references/waves/experiment_speeds.py

The wave numbers of the pressure wave come from exact_dispersion.py (needs mpmath). The valve lets 100 ml/s sin^2 in for 50 ms; the pulse
is a Fourier series. A long-wave impedance turns flow into pressure: it shapes the pulse, and the speed hardly depends on it. The axial
wave of the wall is left out. Prints times and heights of the peak at ten stations, and the speed from the third to the eighth. Takes minutes.
"""

import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(HERE)), "lib"))
sys.path.insert(0, HERE)
sys.dont_write_bytecode = True

import exact_dispersion  # noqa: E402
import numpy  # noqa: E402
import pulse_in_tube  # noqa: E402
from mpmath import mpc, mpf, pi, sqrt  # noqa: E402

STRETCH = 1.03
RADIUS, THICKNESSES = 12.5e-3, {"A": 0.1e-3, "B": 0.05e-3}
MODULUS, POWER, EXPONENT = 1.72e6, 1.3e6, 0.065
FREQUENCIES = numpy.array([0.3, 0.6, 1, 1.6, 2.5, 4, 6, 8, 11, 14, 18, 22, 27, 33, 40, 50, 60.0])  # [Hz]
LARGEST_FLOW, OPENING, END, STEP = 1e-4, 0.05, 3.0, 0.2e-3  # [m^3/s], [s]
STATIONS = [0.005 + 0.05 * i for i in range(10)]


def basis(frequency):
    logarithm = numpy.log(frequency)
    return numpy.concatenate([pulse_in_tube.basis(frequency), numpy.stack([logarithm, logarithm**2], axis=1)], axis=1)


def wave_number(thickness, wall):
    """A function of the frequency [Hz], through the exact roots."""
    root = sqrt(mpf(str(STRETCH)))
    case = dict(exact_dispersion.THIN, radius=mpf(str(RADIUS)) / root, layers=[(mpf(str(thickness)) / root, wall)])
    roots = []
    for frequency in FREQUENCIES:
        omega = mpc(2 * pi * mpf(float(frequency)))
        exact_dispersion.set_digits(case, omega)
        roots.append(complex(exact_dispersion.root(case, omega, exact_dispersion.starts(case, omega)[0][1])))
    ratios = numpy.array(roots) / FREQUENCIES
    weights = numpy.linalg.lstsq(basis(FREQUENCIES), ratios, rcond=None)[0]
    misfit = numpy.max(abs(basis(FREQUENCIES) @ weights / ratios - 1))
    return lambda frequency: frequency * (basis(frequency) @ weights), misfit


def peaks(k, thickness, modulus):
    """[(time, height)] of the pressure at the stations; `modulus`: of the wall over frequency [Pa]."""
    radius, thickness = RADIUS / math.sqrt(STRETCH), thickness / math.sqrt(STRETCH)
    times = numpy.arange(0, END, STEP)
    flow = numpy.fft.rfft(numpy.where(times < OPENING, LARGEST_FLOW * numpy.sin(math.pi * times / OPENING) ** 2, 0))
    frequency = numpy.fft.rfftfreq(len(times), STEP)
    inside = (frequency >= FREQUENCIES[0]) & (frequency <= FREQUENCIES[-1])
    numbers, impedance = numpy.zeros(len(frequency), complex), numpy.zeros(len(frequency), complex)
    numbers[inside] = k(frequency[inside])
    compliance = 2 * math.pi * radius**3 / (modulus(frequency[inside]) * thickness)
    impedance[inside] = numbers[inside] / (2 * math.pi * frequency[inside] * compliance)
    found = []
    for station in STATIONS:
        pressure = numpy.fft.irfft(numpy.where(inside, flow * impedance * numpy.exp(-1j * numbers * station), 0), len(times))
        found.append(pulse_in_tube.peak(times, pressure - pressure[-1]))
    return found


def main():
    elastic = ("elastic", exact_dispersion.solid("880", "1.72e6", "0.5"), lambda f: MODULUS + 0 * f)
    viscoelastic = ("viscoelastic", exact_dispersion.power_law("880", 0, "1.3e6", "0.065"),
                    lambda f: POWER * math.gamma(1 - EXPONENT) * (2j * math.pi * f) ** EXPONENT)
    for tube, thickness in THICKNESSES.items():
        for name, wall, modulus in (elastic, viscoelastic):
            k, misfit = wave_number(thickness, wall)
            found = peaks(k, thickness, modulus)
            speed = 1 / numpy.polyfit(STATIONS[2:8], [time for time, _ in found[2:8]], 1)[0]
            print(f"tube {tube}, {name}: speed {speed:.4f} m/s; peaks", ", ".join(f"{1e3 * time:.2f} ms {height:.1f} Pa"
                                                                                  for time, height in found),
                  f"(fit of the wave numbers: {misfit:.1e})", flush=True)


if __name__ == "__main__":
    main()
