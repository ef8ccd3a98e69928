#!/usr/bin/python3
"""Peaks of a pressure pulse that runs along an elastic tube, without Continua: reference of the tubes A and B of chapter 6.

    scripts/references/waves/pulse_in_tube.py [A] [B]

The wave numbers of the pressure wave are those of exact_dispersion.py (differential equations over the radius, 50 digits). The
inlet pulse 1000 Pa sin^2(pi t/50 ms) is a Fourier series over a period of 1.6 s; each of its harmonics, up to 60 Hz, travels as exp(-i k z).
A peak is the vertex of the parabola through the three largest samples, 0.2 ms apart; the speed is the slope of a straight line
through distances over times of the peaks at the stations k L/10, k = 1 ... 8, by least squares.

Only the pressure wave is here. The axial wave of the wall and the bending at its clamped ends, which the program has, too, change
a height by some per cent near the inlet and a time by 0.1 ms at most; the speed between distant stations hardly. Needs
python3-numpy and python3-mpmath.
"""

import os
import sys

import numpy
from mpmath import mp, mpc, mpf, pi

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import exact_dispersion  # noqa: E402

LENGTH, PERIOD, DURATION, STEP = 0.446, 1.6, 0.05, 0.2e-3
HIGHEST = 60.0
WALLS = {"A": "0.1e-3", "B": "0.05e-3"}


def basis(frequencies):
    """What k/f is made of: powers of 1/sqrt(f), from the layer at the wall, and of f^2, from dispersion."""
    root = numpy.sqrt(frequencies)
    return numpy.stack([root**power for power in (0, -1, -2, -3, 1, 2, 4, 6, 8)], axis=1)


def wave_numbers(thickness):
    """A function that gives k of the pressure wave at frequencies up to the highest; a fit through 16 roots."""
    case = dict(exact_dispersion.THIN, layers=[(thickness, exact_dispersion.solid("880", "1.72e6", "0.49"))])
    frequencies = numpy.array([0.6, 1, 1.6, 2.5, 4, 6, 8, 11, 14, 18, 22, 27, 33, 40, 50, HIGHEST])
    roots = []
    for frequency in frequencies:
        omega = mpc(2 * pi * mpf(float(frequency)))
        exact_dispersion.set_digits(case, omega)
        roots.append(complex(exact_dispersion.root(case, omega, exact_dispersion.starts(case, omega)[0][1])))
    ratio = numpy.array(roots) / frequencies
    coefficients = numpy.linalg.lstsq(basis(frequencies), ratio, rcond=None)[0]
    misfit = numpy.max(abs(basis(frequencies) @ coefficients / ratio - 1))
    print(f"wave numbers fitted within {misfit:.1e}", flush=True)
    return lambda f: f * (basis(f) @ coefficients)


def pulse_at(stations, wave_number):
    """(times, one column of pressures a station)."""
    times = numpy.arange(0.0, PERIOD, STEP)
    inlet = numpy.where(times < DURATION, 1000.0 * numpy.sin(numpy.pi * times / DURATION)**2, 0.0)
    harmonics = numpy.fft.rfft(inlet)
    f = numpy.fft.rfftfreq(len(times), STEP)
    inside = (f > 0) & (f <= HIGHEST)
    k = numpy.zeros(len(f), dtype=complex)
    k[inside] = wave_number(f[inside])
    harmonics = numpy.where(f <= HIGHEST, harmonics, 0.0)
    return times, [numpy.fft.irfft(harmonics * numpy.exp(-1j * k * z), len(times)) for z in stations]


def peak(times, values):
    i = int(numpy.argmax(values))
    before, at, after = values[i - 1:i + 2]
    shift = 0.5 * (before - after) / (before - 2 * at + after)
    return times[i] + shift * STEP, at - 0.25 * (before - after) * shift


def main():
    stations = [LENGTH * i / 10 for i in range(1, 9)]
    for tube in sys.argv[1:] or sorted(WALLS):
        times, pressures = pulse_at(stations, wave_numbers(WALLS[tube]))
        peaks = [peak(times, values) for values in pressures]
        print(f"tube {tube}: peaks at", ", ".join(f"{1e3 * time:.2f}" for time, _ in peaks), "ms;",
              ", ".join(f"{height:.1f}" for _, height in peaks), "Pa")
        slope = numpy.polyfit([time for time, _ in peaks], stations, 1)[0]
        print(f"    speed of the peak {slope:.4f} m/s; between the second and the last "
              f"{(stations[-1] - stations[1]) / (peaks[-1][0] - peaks[1][0]):.4f} m/s")


if __name__ == "__main__":
    mp.dps = 50
    main()
