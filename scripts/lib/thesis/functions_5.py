"""Functions of the expressions in chapter_5.toml and chapter_6.toml: tubes as designed, entries of a run, and how unlike the curves of two
tubes are."""

import itertools
import math
import os

import numpy
import wave_tables

# Of the entries that the expressions ask for.
UNITS = {"": 1.0, "1": 1.0, "%": 0.01, "kg/m^3": 1.0, "Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "GPa": 1e9, "Pa s": 1.0, "mPa s": 1e-3, "m": 1.0,
         "mm": 1e-3, "mm^2": 1e-6, "s": 1.0, "ms": 1e-3}


def _not_there(text):
    from .results import NotThere  # results.py imports this file
    return NotThere(text)


def section(results, run, name, end):
    """Of a tube as made, from spin-coating.csv of a run: "position", "diameter" or "wall thickness" [m] at its "inlet" or "outlet"."""
    positions, values = results.column(run, "spin-coating.csv", name)
    row = {"inlet": numpy.argmin, "outlet": numpy.argmax}[end](positions)
    return float(values[row])


def stiffness(results, run, end, modulus):
    """Y h/D [Pa] of a tube as made at its "inlet" or "outlet", of a spin coating; the modulus in Pa."""
    return modulus * section(results, run, "wall thickness", end) / section(results, run, "diameter", end)


def design_speed(results, run, end, modulus, density):
    """Wave speed of Moens and Korteweg [m/s] of a tube as made, of a spin coating; SI."""
    return math.sqrt(stiffness(results, run, end, modulus) / density)


def slope(results, run):
    """Of the inner radius of a tube as made over its length [1], of a spin coating."""
    wide, narrow = (section(results, run, "diameter", end) for end in ("inlet", "outlet"))
    return (narrow - wide) / (2 * section(results, run, "position", "outlet"))


def preflight(results, run, line):
    """A value of the pre-flight report of a run [SI]. The line is named as in summary.json, without its unit."""
    for name, value in results.run(run).summary.get("pre-flight report", {}).items():
        if name.rpartition(" [")[0] == line:
            return value
    raise _not_there(f"{run}: the pre-flight report has no '{line}'")


def entry(results, run, name, component=0):
    """The value [SI] of an entry of a run, given or by default, "Section/.../Entry", from its parameters.prm; of a list that component,
    counted from 0."""
    path, sections = os.path.join(results.run(run).folder, "parameters.prm"), []
    with open(path, encoding="utf-8") as stream:
        for line in stream:
            # What has its default is a comment "# set KEY = VALUE"; behind what was given stands "# default: VALUE".
            words = line.strip().removeprefix("# ").split("#")[0].split(None, 1)
            if line.lstrip().startswith("subsection "):
                sections.append(words[1].strip())
            elif line.strip() == "end":
                sections.pop()
            elif words[:1] == ["set"] and "=" in words[1]:
                key, _, value = words[1].partition("=")
                if "/".join([*sections, key.strip()]) == name:
                    number, _, unit = value.split(",")[component].strip().partition(" ")
                    return float(number) * UNITS[unit.strip()]
    raise _not_there(f"{run}: its parameters have no '{name}'")


def rise(results, run, source):
    """Growth of the normalised pressure at the last station per travel time, as scripts/manual/thesis-findings has it [1]."""
    from .functions import script  # functions.py imports this file
    return float(script("manual/thesis-findings").Tube(results.wave(run), source).rise())


def unlike(results, field, source, begin, end, stations, *runs):
    """How unlike the curves of several runs are [1]: the root mean square of the difference of two curves over that of the first one, the
    largest of all pairs and stations. Each curve is divided by its first peak at the station, and its time counts from that peak:
    `begin` to `end` [s]. `source` "simulated" or "theory"; `stations` counted from 0."""
    fields = [results.wave(run)[field] for run in runs]
    time = numpy.linspace(begin, end, 1001)

    def curve(of, station):
        values = of.sources[source][station]
        peak, height = wave_tables.first_peak(of.time, values)
        return numpy.interp(peak + time, of.time, values / height, right=numpy.nan)

    def rms(values):
        return numpy.sqrt(numpy.mean(values**2))

    found = [rms(first - second) / rms(first) for station in stations
             for first, second in itertools.combinations([curve(of, station) for of in fields], 2)]
    return float(numpy.max(found))


FUNCTIONS = {function.__name__: function for function in (section, stiffness, design_speed, slope, preflight, entry, rise, unlike)}
