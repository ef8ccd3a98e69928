"""Functions of the expressions in chapter_6.toml: closed solutions that the program does not use, and what runs ahead of a pulse."""

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
    """J_1(z)/J_0(z) by the continued fraction of the recurrence."""
    ratio = 0
    for n in range(int(abs(z)) + 200, 0, -1):
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


FUNCTIONS = {function.__name__: function for function in (lame_psi, womersley_error, ahead, damping_of_wall)}
