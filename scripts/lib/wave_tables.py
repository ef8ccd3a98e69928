"""Reads wave.csv and wave-PROBE.csv of a run: fields at stations along a tube, simulated, by theory and measured."""

import glob
import os
import re

import numpy
import tables

SOURCES = ("simulated", "theory", "measured")
COLUMN = re.compile(r"(.*) ([-+.\deE]+) m: (.*), (" + "|".join(SOURCES) + ")")
SEEN = 0.2  # a peak counts as the first from this part of the largest value on
PASSED = 0.5  # a peak has passed when the curve has fallen to this part of it


class Field:
    """One field at all its stations: unit, time (s), positions (m, increasing) and by source an array (station, time)."""

    def __init__(self, unit, time):
        self.unit = unit
        self.time = time
        self.positions = []
        self.sources = {}

    def best(self):
        """What was simulated; without a simulation what theory says; else what was measured."""
        return next(self.sources[source] for source in SOURCES if source in self.sources)


def read_waves(folder):
    """Fields by name; of a field that several probes have, the first probe's. Empty when the run has no such table."""
    fields = {}
    for path in sorted(glob.glob(os.path.join(glob.escape(folder), "wave.csv"))
                       + glob.glob(os.path.join(glob.escape(folder), "wave-*.csv"))):
        table = tables.read_table(path)
        if table is None:
            continue
        columns, data = table
        owners = {}
        for i, (name, unit) in enumerate(columns[1:], 1):
            match = COLUMN.fullmatch(name)
            if not match or not numpy.isfinite(data[:, i]).any():
                continue
            probe, position, name, source = match.groups()
            if name not in fields:
                fields[name] = Field(unit, data[:, 0])
                owners[name] = probe
            if owners.get(name) != probe:
                continue
            field = fields[name]
            position = float(position)
            if position not in field.positions:
                field.positions.append(position)
            field.sources.setdefault(source, {})[position] = data[:, i]
    for field in fields.values():
        field.positions.sort()
        nothing = numpy.full(len(field.time), numpy.nan)
        for source, curves in field.sources.items():
            field.sources[source] = numpy.array([curves.get(position, nothing) for position in field.positions])
    return fields


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
