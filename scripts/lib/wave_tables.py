"""Waves of a run as the figures need them, and the first peaks of curves."""

import numpy
import tables
from continua.waves import read_waves as waves_of_probes

SEEN = 0.2  # a peak counts as the first from this part of the largest value on
PASSED = 0.5  # a peak has passed when the curve has fallen to this part of it


class Field:
    """One field at all stations that have it: unit, time (s), positions (m, increasing) and by source an array (station, time)."""

    def __init__(self, array):
        """Of a variable of continua.waves.read_waves."""
        array = array.dropna("position", how="all").dropna("source", how="all")
        self.unit = array.attrs["units"]
        self.time = array["time"].to_numpy()
        self.positions = array["position"].to_numpy().tolist()
        self.sources = {source: array.sel(source=source).to_numpy() for source in array["source"].to_numpy()}

    def best(self):
        """What was simulated; without a simulation what theory says; else what was measured."""
        return next(iter(self.sources.values()))


def read_waves(folder, probe=None):
    """Fields by name of one probe, or of all: of a field that several probes have, the first probe's. Empty when the run has no such table."""
    fields = {}
    for name, dataset in waves_of_probes(folder).items():
        if probe in (None, name):
            for field, array in dataset.items():
                if field not in fields and array.notnull().any():
                    fields[field] = Field(array)
    return fields


def read_waves_of_probes(folder):
    """{probe: {name: Field}} of all probes with stations that have values."""
    found = {name: read_waves(folder, name) for name in waves_of_probes(folder)}
    return {name: fields for name, fields in found.items() if fields}


def first_peak(time, values):
    """(time, magnitude) of the first peak of |values|: the highest before they have fallen to half of it, if that is
    above a fifth of the largest."""
    magnitude = numpy.abs(numpy.nan_to_num(values))
    largest = magnitude.max()
    if not largest > 0:
        return numpy.nan, numpy.nan
    highest = numpy.maximum.accumulate(magnitude)
    passed = numpy.flatnonzero((highest > SEEN * largest) & (magnitude < PASSED * highest))
    end = passed[0] if len(passed) else len(magnitude)
    return tables.peak(time, magnitude, int(numpy.argmax(magnitude[:end])))


def travel_time(pressure, curves):
    """Seconds between the first peaks at the first and last station: to a closed end and its reflection. Or nan."""
    return first_peak(pressure.time, curves[-1])[0] - first_peak(pressure.time, curves[0])[0]
