"""Tables of a run as the figures need them, and the vertex of a peak."""

import os

import continua.tables
import numpy


def read_table(path):
    """(list of (name, unit), array with one column each), or None when the file is not there or has no rows."""
    if not os.path.exists(path):
        return None
    frame = continua.tables.read_table(path)
    return None if frame.empty else (list(frame.attrs["units"].items()), frame.to_numpy())


def peak(time, values, i):
    """The vertex of the parabola through a sample and its two neighbours, which need not be evenly spaced."""
    if 0 < i < len(values) - 1:
        a, b, c = numpy.polyfit(time[i - 1:i + 2] - time[i], values[i - 1:i + 2] - values[i], 2)
        if a != 0 and time[i - 1] <= time[i] - b / (2 * a) <= time[i + 1]:
            return time[i] - b / (2 * a), values[i] + c - b * b / (4 * a)
    return time[i], values[i]
