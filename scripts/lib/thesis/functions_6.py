"""Functions of the expressions in chapter_6.toml: closed solutions that the program does not use, the thesis's own calculation of figures 6.4 to
6.15, and what runs ahead of a pulse."""

import cmath
import math

import numpy
import wave_tables


def lame_psi(_, anchoring, radius, thickness, poisson):
    """Coefficient psi of Korteweg's speed [1], by Lame's cylinder solved for its constants: u Y h/(R^2 p) under an inner pressure p. The wall is
    held "upstream" (a closed end pulls it), "throughout" (no axial strain) or by "joints" (no axial stress). Lengths in m."""
    inner, outer = radius, radius + thickness
    # Radial displacement a r + b/r, axial strain e; modulus and pressure are 1. sigma = l (2 a + e) 1 + 2 m strain.
    shear, first = 1 / (2 * (1 + poisson)), poisson / ((1 + poisson) * (1 - 2 * poisson))
    radial = [[2 * (first + shear), -2 * shear / r**2, first] for r in (inner, outer)]
    axial = [2 * first, 0, first + 2 * shear]
    pull = inner**2 / (outer**2 - inner**2)
    last, value = {"upstream": (axial, pull), "throughout": ([0, 0, 1], 0), "joints": (axial, 0)}[anchoring]
    a, b, _axial_strain = numpy.linalg.solve([*radial, last], [-1, 0, value])
    return float((a * inner + b / inner) * thickness / radius**2)


def _ratio(z):
    """J_1(z)/J_0(z) by the continued fraction of the recurrence; of a number or an array."""
    ratio = 0
    for n in range(int(numpy.max(abs(z))) + 200, 0, -1):
        ratio = 1 / (2 * n / z - ratio)
    return ratio


def womersley_error(results, run, radius, thickness, modulus, density, viscosity, bulk):
    """Largest relative difference of the wave numbers of level womersley in dispersion.csv of a run from (6.9) to (6.13), an axially free
    wall; SI."""
    frequencies, speeds = results.column(run, "dispersion.csv", "womersley: phase speed")
    _, attenuations = results.column(run, "dispersion.csv", "womersley: attenuation")
    slowness = math.sqrt(density * (1 / bulk + 2 * radius / (modulus * thickness)))
    worst = 0.0
    for frequency, speed, attenuation in zip(frequencies, speeds, attenuations):
        omega = 2 * math.pi * frequency
        z = cmath.exp(0.75j * math.pi) * radius * math.sqrt(omega * density / viscosity)
        number = omega * slowness * cmath.sqrt(1 / (1 - 2 * _ratio(z) / z))
        worst = max(worst, abs(omega / speed - 1j * attenuation - number) / abs(number))
    return worst


def ahead(results, run, source):
    """Largest pressure at the last station until half of the time of its first peak, over that peak [1]."""
    pressure = results.wave(run)["pressure"]
    values = pressure.sources[source][-1]
    time, height = wave_tables.first_peak(pressure.time, values)
    return float(numpy.max(numpy.abs(values[pressure.time < time / 2])) / height)


def damping_of_wall(results, run):
    """Part of the lost energy that the wall has lost [1]."""
    quantities = results.run(run).quantities
    wall, fluid = (sum(quantities.get(f"{region}: {name}", 0.0) for name in ("energy dissipated", "energy relaxed"))
                   for region in ("wall", "fluid"))
    return wall / (wall + fluid)


# Figures 6.4 to 6.15 as the thesis calculates them: table 6.3, and the tubes A and B of its section 6.3 with their pre-strain.
DENSITY, VISCOSITY, BULK, ELASTIC, RELAXATION, EXPONENT = 998.0, 1e-3, 2.2e9, 1.72e6, 1.3e6, 0.065
RADIUS, LENGTH, PRE_STRAIN, THICKNESS = 12.5e-3, 0.446, 0.03, {"a": 0.1e-3, "b": 0.05e-3}
PERIOD, STEP = 20.0, 1e-3  # of the Fourier series [s]; within the period a wave that runs to and fro dies out


class Calculation:
    """Waves in tube "a" or "b" with an "elastic" or "viscoelastic" wall, by (6.9) to (6.13), (6.18) with psi = 1 and (6.22) to (6.26): `time`
    [s], and by field a (station, time) array [SI], those of the forward and backward wave among them. The incoming wave is the first `part`
    [s] of a pressure at the first station. Both ends reflect fully. The sum over their reflections is the closed one: (6.25) and (6.26) grow as
    printed."""

    def __init__(self, tube, wall, stations, time, pressure, part):
        self.positions = stations
        radius, thickness = (length / math.sqrt(1 + PRE_STRAIN) for length in (RADIUS, THICKNESS[tube]))
        length = (1 + PRE_STRAIN) * LENGTH
        times = numpy.arange(0, PERIOD, STEP)
        omega = 2 * math.pi * numpy.fft.rfftfreq(len(times), STEP)
        incoming = numpy.fft.rfft(numpy.where(times < part, numpy.interp(times, time, pressure), 0.0))[1:]
        omega = omega[1:]  # the mean follows from the state at rest
        modulus = ELASTIC if wall == "elastic" else RELAXATION * math.gamma(1 - EXPONENT) * (1j * omega)**EXPONENT
        z = cmath.exp(0.75j * math.pi) * radius * numpy.sqrt(omega * DENSITY / VISCOSITY)
        mobile = 1 - 2 * _ratio(z) / z  # 1 - F_10
        number = omega * numpy.sqrt(DENSITY * (1 / BULK + 2 * radius / (modulus * thickness)) / mobile)
        number = numpy.where(number.imag > 0, -number, number)

        def travelled(distance):
            return incoming * numpy.exp(-1j * number * (distance - stations[0])) / (1 - numpy.exp(-2j * number * length))

        def in_time(harmonics):
            values = numpy.fft.irfft(numpy.concatenate(([0], harmonics)), len(times))
            return values - values[0]

        forward, backward = ([travelled(distance(x)) for x in stations] for distance in (lambda x: x, lambda x: 2 * length - x))
        admittance = math.pi * radius**2 * number * mobile / (DENSITY * omega)
        softness = 2 * radius**2 / (modulus * thickness)  # change of the diameter by pressure
        self.time = times
        self.fields = {name: numpy.array([in_time(harmonics(f, b)) for f, b in zip(forward, backward)]) for name, harmonics in (
            ("pressure", lambda f, b: f + b), ("flow rate", lambda f, b: admittance * (f - b)),
            ("wall distension", lambda f, b: softness * (f + b)), ("forward wave", lambda f, b: f), ("backward wave", lambda f, b: b))}


def calculation(results, run, tube, wall, part=0.08):
    """The Calculation whose incoming wave is the first `part` [s] of the simulated pressure at the first station of a run."""
    pressure = results.wave(run)["pressure"]
    return Calculation(tube, wall, numpy.array(pressure.positions), pressure.time, pressure.sources["simulated"][0], part)


def speed_of_peaks(positions, time, pressures):
    """Slope of a line through the first peaks of the pressure from the third to the eighth station [m/s]: far from both ends."""
    times = [wave_tables.first_peak(time, values)[0] for values in pressures[2:8]]
    return float(1 / numpy.polyfit(positions[2:8], times, 1)[0])


def pulse_speed(results, run, source):
    """The same of a run with the ten stations, "simulated" or "theory"."""
    pressure = results.wave(run)["pressure"]
    return speed_of_peaks(pressure.positions, pressure.time, pressure.sources[source])


def pulse_attenuation(results, run, source):
    """Of the heights of these peaks, by which exp(-attenuation position) falls [1/m]."""
    pressure = results.wave(run)["pressure"]
    heights = [wave_tables.first_peak(pressure.time, values)[1] for values in pressure.sources[source][2:8]]
    return float(-numpy.polyfit(pressure.positions[2:8], numpy.log(heights), 1)[0])


def calculated(results, quantity, run, tube, wall, station=0):
    """Of a calculation: "speed" of the pressure peak as pulse_speed() has it [m/s], "time" [s] or "height" [Pa] of the reflected
    pulse at a station, counted from 0."""
    waves = calculation(results, run, tube, wall)
    if quantity == "speed":
        return speed_of_peaks(waves.positions, waves.time, waves.fields["pressure"])
    return wave_tables.first_peak(waves.time, waves.fields["backward wave"][station])[quantity == "height"]


def calculated_difference(results, run, tube, wall, fields):
    """Largest difference of a calculation from the simulation over the largest simulated value of the field, over all stations and times; the
    largest of some fields [1]."""
    waves, found = calculation(results, run, tube, wall), results.wave(run)
    worst = 0.0
    for name in fields:
        time, values = found[name].time, found[name].sources["simulated"]
        differences = [numpy.interp(time, waves.time, ours) - theirs for ours, theirs in zip(waves.fields[name], values)]
        worst = max(worst, numpy.max(numpy.abs(differences)) / numpy.max(numpy.abs(values)))
    return float(worst)


def passed(results, run, source, part):
    """Time [s] at which the forward wave at the first station has fallen to a part of its first peak."""
    wave = results.wave(run)["forward wave"]
    values = numpy.abs(wave.sources[source][0])
    peak, height = wave_tables.first_peak(wave.time, values)
    after = wave.time > peak
    return float(wave.time[after][numpy.argmax(values[after] < part * height)])


FUNCTIONS = {function.__name__: function for function in (lame_psi, womersley_error, ahead, damping_of_wall, pulse_speed,
                                                          pulse_attenuation, calculated, calculated_difference, passed)}
