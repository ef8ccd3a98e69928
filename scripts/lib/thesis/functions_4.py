"""Functions of the expressions in chapter_4.toml: beam theory, Euler's damping, and what histories of the tip and of the power show."""

import math

import numpy

TIP = "tip: displacement y"


def static_deflection(_, shear, modulus, poisson, length, height):
    """Deflection [m] of the end of a cantilever under a shear [Pa] by Timoshenko and Goodier, (4.6); SI."""
    bending = 4 * shear * length**3 / (modulus * height**2)
    return bending * (1 + 0.75 * (1 + poisson) * (height / length)**2)


def euler_left(_, form, frequency, step, time):
    """Part of the amplitude of a mode [1] that Euler's method leaves after a time: exact amplification of the `form` "displacement" or
    "velocity" with trapezoidal update; frequency [Hz], step and time [s]."""
    angle = 2 * math.pi * frequency * step
    return (1 + angle**2 / {"displacement": 1, "velocity": 2}[form])**(-0.5 * time / step)


def distance(_, values, references):
    """Largest relative difference [1] of some values from their references, both lists."""
    return max(abs(value / reference - 1) for value, reference in zip(values, references, strict=True))


def alternating_part(results, run):
    """Part of the power residual that changes its sign from one row of power.csv to the next, over its root mean square [1]. 1 if all
    of it does, 0.61 of noise, 0 of a smooth curve."""
    _, residual = results.column(run, "power.csv", "residual")
    part = (residual[2:] - 2 * residual[1:-1] + residual[:-2]) / 4
    return math.sqrt(numpy.mean(part**2) / numpy.mean(residual**2))


def beat_height(results, run, frequency, end):
    """Amplitude [m] of the sine of a frequency [Hz] in the tip's maxima before `end` [s], beside an offset and a trend."""
    times, values = results.run(run).maxima()
    times, values = times[times <= end], values[times <= end]
    angle = 2 * math.pi * frequency * times
    basis = numpy.stack([numpy.ones_like(times), times, numpy.cos(angle), numpy.sin(angle)], axis=1)
    fit = numpy.linalg.lstsq(basis, values, rcond=None)[0]
    return float(numpy.hypot(fit[2], fit[3]))


def end_of_motion(results, run, part):
    """Time [s] after which the tip is nearer to its last position than a part of its first maximum's distance from it."""
    times, values = results.column(run, "probes.csv", TIP)
    away = numpy.abs(values - values[-1])
    first = results.run(run).maxima()[1][0] - values[-1]
    return float(times[numpy.nonzero(away > part * first)[0][-1]])


def step_time(results, run):
    """Seconds of a step on the clock: right-hand side, solve and update, without set-up, power and output."""
    summary = results.run(run).summary
    return sum(summary["wall time [s]"][section] for section in ("right-hand side", "solve", "update")) / summary["steps"]


FUNCTIONS = {function.__name__: function for function in (static_deflection, euler_left, distance, alternating_part, beat_height,
                                                          end_of_motion, step_time)}
