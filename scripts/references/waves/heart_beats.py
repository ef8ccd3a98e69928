#!/usr/bin/python3
"""Several heart beats into a windkessel, without Continua: references of parameter_files/examples/heart-beats.prm,
parameter_files/verification/heart-beats-windkessel.prm and the tests of beats.

    scripts/references/waves/heart_beats.py [windkessel] [tube]

windkessel: the flow of a table, linear between its rows and repeated, into a resistance R_p before a compliance C beside a
resistance R_d. The compliance's volume x obeys dx/dt = Q - x/tau, tau = R_d C. In a row interval of length h, with Q = a + b s,

    x(h) = x(0) e^(-h/tau) + a tau (1 - e^(-h/tau)) + b tau (h - tau (1 - e^(-h/tau))),

so that a beat of length T leads from x to x e^(-T/tau) + X, and the periodic state has x = X/(1 - e^(-T/tau)). The pressure is
p = R_p Q + x/C. Beat n differs from the one before by |x_n - x_(n-1)|/C at its start, where the difference is largest. Given for
the start from an empty compliance, and from the mean, x = C R_d times the mean flow. The periodic state is checked by the mean of
its pressure, which is (R_p + R_d) times the mean flow.

tube: the periodic state of a flexible tube with such a windkessel behind it. The flow of the table at the inlet is a Fourier series;
each harmonic is a forward and a backward pressure wave with the wave number of exact_dispersion.py (differential equations over
the radius, 50 digits). The momentum of a section gives the impedance Z = p/Q = (rho omega^2 + 2 tau/R)/(k omega A), with the shear
stress tau of a unit of mean axial displacement; the windkessel gives the reflection. The mean flow has Poiseuille's pressure drop.
Bending of the wall at its ends is not here. Needs python3-numpy and python3-mpmath.
"""

import csv
import os
import sys

import numpy
from mpmath import mp, mpc, mpf, pi

sys.dont_write_bytecode = True
here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, here)

import exact_dispersion  # noqa: E402

FLOW = os.path.join(here, "../../../parameter_files/examples/heart-flow.csv")
N_SAMPLES = 20  # in an interval of the table


def table():
    """Times [s] and flow rates [m^3/s]."""
    with open(FLOW, encoding="utf-8") as stream:
        rows = [row for row in csv.reader(line for line in stream if not line.startswith("#"))]
    numbers = numpy.array([[float(cell) for cell in row] for row in rows[1:]])
    return numbers[:, 0] * 1e-3, numbers[:, 1] * 1e-6


class Windkessel:
    """In SI."""

    def __init__(self, proximal, distal, compliance):
        self.proximal, self.distal, self.compliance = proximal, distal, compliance
        self.times, self.flow = table()
        self.period = self.times[-1] - self.times[0]
        self.tau = distal * compliance
        self.mean_flow = numpy.sum(numpy.diff(self.times) * (self.flow[1:] + self.flow[:-1]) / 2) / self.period

    def beat(self, volume):
        """(times, pressures) of a beat that begins with this volume, and the volume at its end."""
        times, pressures = [0.0], [self.proximal * self.flow[0] + volume / self.compliance]
        for i in range(len(self.times) - 1):
            length = self.times[i + 1] - self.times[i]
            slope = (self.flow[i + 1] - self.flow[i]) / length
            for j in range(1, N_SAMPLES + 1):
                s = length * j / N_SAMPLES
                filling = self.tau * -numpy.expm1(-s / self.tau)
                x = volume * numpy.exp(-s / self.tau) + self.flow[i] * filling + slope * self.tau * (s - filling)
                times.append(self.times[i] + s)
                pressures.append(self.proximal * (self.flow[i] + slope * s) + x / self.compliance)
            volume = x
        return numpy.array(times), numpy.array(pressures), volume

    def periodic_volume(self):
        return self.beat(0.0)[2] / -numpy.expm1(-self.period / self.tau)

    def show(self, name, volume, tolerance, most=40):
        print(name)
        last = None
        for number in range(1, most):
            times, pressures, end = self.beat(volume)
            largest, smallest = pressures.max(), pressures.min()
            mean = numpy.sum(numpy.diff(times) * (pressures[1:] + pressures[:-1]) / 2) / self.period
            difference = None if last is None else numpy.max(abs(pressures - last)) / (largest - smallest)
            print(f"  beat {number}: largest {largest:.2f} Pa, smallest {smallest:.2f}, mean {mean:.2f}, range {largest - smallest:.2f}"
                  + ("" if difference is None else f", difference {difference:.6f}"))
            if difference is not None and difference <= tolerance:
                return
            last, volume = pressures, end


def show_windkessel():
    model = Windkessel(8e6, 120e6, 10e-9)
    print(f"mean flow {model.mean_flow * 1e6:.6f} ml/s, mean pressure {(model.proximal + model.distal) * model.mean_flow:.3f} Pa")
    volume = model.periodic_volume()
    times, pressures, _ = model.beat(volume)
    mean = numpy.sum(numpy.diff(times) * (pressures[1:] + pressures[:-1]) / 2) / model.period
    assert abs(mean / ((model.proximal + model.distal) * model.mean_flow) - 1) < 1e-5, mean
    model.show("periodic", volume, 1.0, 2)
    model.show("from an empty compliance, to 1 %", 0.0, 0.01)
    model.show("from the mean pressure, to 1 %", model.compliance * model.distal * model.mean_flow, 0.01)
    slow = Windkessel(8e6, 120e6, 1000e-9)
    slow.show("from the mean pressure, a compliance of 1000 mm^3/Pa, two beats", slow.compliance * slow.distal * slow.mean_flow, 0.0, 3)


RADIUS, LENGTH, DENSITY, VISCOSITY = 10e-3, 0.4, 1060.0, 4e-3
TUBE = {"radius": "10e-3", "fluid": exact_dispersion.BLOOD, "tethered": True,
        "layers": [("2e-3", exact_dispersion.solid("1100", "1.2e6", "0.49"))]}
LOAD = (25e6, 95e6, 7e-9)
STATIONS = (0.05, 0.2, 0.35)
N_HARMONICS = 32


def cubic(times, values, at):
    """The interpolation of the run, Interpolation = cubic: that of Fritsch and Butland, which does not overshoot, of a periodic table
    with rows at equal distances: the slope at a row is the harmonic mean of those beside it."""
    h, s = numpy.diff(times), numpy.diff(values) / numpy.diff(times)
    before = numpy.roll(s, 1)
    same_sign = before * s > 0
    slopes = numpy.where(same_sign, 2 * before * s / numpy.where(same_sign, before + s, 1.0), 0.0)
    slopes = numpy.append(slopes, slopes[0])
    i = numpy.minimum(numpy.searchsorted(times, at, side="right") - 1, len(h) - 1)
    u = at - times[i]
    a = (slopes[i] + slopes[i + 1] - 2 * s[i]) / h[i]**2
    b = (3 * s[i] - 2 * slopes[i] - slopes[i + 1]) / h[i]
    return ((a * u + b) * u + slopes[i]) * u + values[i]


def harmonic(frequency):
    """k [1/m], Z [Pa s/m^3] and the radial displacement [m] of a pressure of 1 Pa at the inner wall."""
    omega = mpc(2 * pi * mpf(frequency))
    case = exact_dispersion.at_frequency(TUBE, omega)
    exact_dispersion.set_digits(case, omega)
    k = exact_dispersion.root(case, omega, exact_dispersion.starts(case, omega)[0][1])
    displacement, shear = exact_dispersion.quantities(case, omega, k)[:2]
    pressure = (mpf(DENSITY) * omega**2 + 2 * shear / mpf(RADIUS)) / k * mpc(0, 1)
    flow = mpc(0, 1) * omega * pi * mpf(RADIUS)**2
    return complex(k), complex(pressure / flow), complex(displacement / pressure)


def static_displacement():
    """Of the inner wall under 1 Pa: Lame's thick tube without axial strain."""
    young, nu, a, b = 1.2e6, 0.49, RADIUS, RADIUS + 2e-3
    return (1 + nu) / young * a * ((1 - 2 * nu) * a**2 + b**2) / (b**2 - a**2)


def show_tube():
    times, flow = table()
    period = times[-1]
    n = 4096
    at = numpy.arange(n) * period / n
    spectrum = numpy.fft.rfft(cubic(times, flow, at)) / n
    mean_flow = spectrum[0].real
    proximal, distal, compliance = LOAD
    waves = {x: {"pressure": [], "flow rate": [], "displacement": []} for x in STATIONS}
    for number in range(1, N_HARMONICS + 1):
        k, impedance, displacement = harmonic(number / period)
        omega = 2 * numpy.pi * number / period
        load = proximal + distal / (1 + 1j * omega * distal * compliance)
        reflection = (load - impedance) / (load + impedance)
        # p = f (e^(-ikx) + r e^(-ik(2L - x))), Q = f/Z (e^(-ikx) - r e^(-ik(2L - x)))
        back = reflection * numpy.exp(-2j * k * LENGTH)
        forward = impedance * spectrum[number] / (1 - back)
        for x, of_station in waves.items():
            there, returned = numpy.exp(-1j * k * x), back * numpy.exp(1j * k * x)
            of_station["pressure"].append(forward * (there + returned))
            of_station["flow rate"].append(forward / impedance * (there - returned))
            of_station["displacement"].append(displacement * forward * (there + returned))
    drop = 8 * VISCOSITY / (numpy.pi * RADIUS**4)
    print(f"mean flow {mean_flow * 1e6:.4f} ml/s, mean pressure at the outlet {(proximal + distal) * mean_flow:.1f} Pa")
    for x, of_station in waves.items():
        pressure = mean_flow * (proximal + distal + drop * (LENGTH - x))
        means = {"pressure": pressure, "flow rate": mean_flow, "displacement": pressure * static_displacement()}
        print(f"at {x} m")
        for field, harmonics in of_station.items():
            full = numpy.zeros(n // 2 + 1, complex)
            full[0] = means[field]
            full[1:N_HARMONICS + 1] = harmonics
            values = numpy.fft.irfft(full, n) * n
            if field == "displacement":
                field, values = "wall distension", 2 * values
            print(f"  {field}: largest {values.max():.6g}, smallest {values.min():.6g}, mean {values.mean():.6g}, "
                  f"range {values.max() - values.min():.6g}; last harmonic {abs(harmonics[-1]) / max(abs(h) for h in harmonics):.1e} of the first")


if __name__ == "__main__":
    wanted = sys.argv[1:] or ["windkessel", "tube"]
    for name in wanted:
        if name not in ("windkessel", "tube"):
            sys.exit(f"no part '{name}'; there are windkessel and tube")
        {"windkessel": show_windkessel, "tube": show_tube}[name]()
