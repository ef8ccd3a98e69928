"""Waves at the stations of a tube: wave.csv, or wave-PROBE.csv of each probe where several have stations."""

import glob
import os
import re

import numpy
import xarray

from . import tables

SOURCES = ("simulated", "theory", "nonlinear theory", "measured")  # in this order; others stand behind them
# A source has no hyphen in its name, differences have one.
_COLUMN = re.compile(r"(.*) ([-+]?\d+\.?\d*(?:[eE][-+]?\d+)?) m: ([^,]*), ([a-z ]+)")


def paths_of_waves(folder):
    """The files of a folder, sorted."""
    return sorted(glob.glob(os.path.join(glob.escape(folder), "wave.csv")) + glob.glob(os.path.join(glob.escape(folder), "wave-*.csv")))


def read_waves(folder):
    """{probe: xarray.Dataset} of the probes with stations, in the order of the files; empty where no file has a row.

    A variable of a data set is a field, such as "pressure", of shape (sources, stations, times) with the coordinates `source`
    ("simulated", "theory", "nonlinear theory" or "measured"), `position` [m], rising, and `time` [s]. Its unit is in `attrs["units"]`. Values that a source,
    a station or a time does not have are nan. Raises ResultsError as tables.read_table.
    """
    found = {}
    for path in paths_of_waves(folder):
        frame = tables.read_table(path)
        if frame.empty:
            continue
        curves, units = {}, {}
        for column in frame.columns:
            match = _COLUMN.fullmatch(column)
            if match:
                probe, position, field, source = match.groups()
                curves.setdefault(probe, {}).setdefault(field, {})[source, float(position)] = frame[column].to_numpy()
                units[field] = frame.attrs["units"][column]
        for probe, fields in curves.items():
            found[probe] = _dataset(frame.iloc[:, 0].to_numpy(), fields, units)
    return found


def _dataset(time, fields, units):
    keys = [key for curves in fields.values() for key in curves]
    there = list(dict.fromkeys(key[0] for key in keys))
    sources = [source for source in SOURCES if source in there] + [source for source in there if source not in SOURCES]
    positions = sorted({position for _, position in keys})
    variables = {}
    for field, curves in fields.items():
        values = numpy.full((len(sources), len(positions), len(time)), numpy.nan)
        for (source, position), curve in curves.items():
            values[sources.index(source), positions.index(position)] = curve
        variables[field] = (("source", "position", "time"), values, {"units": units[field]})
    return xarray.Dataset(variables, {"source": sources, "position": ("position", positions, {"units": "m"}),
                                      "time": ("time", time, {"units": "s"})})
