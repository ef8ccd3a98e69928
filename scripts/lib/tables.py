"""Reads the tables (csv) of a run."""

import csv
import os
import re

import numpy


class TableError(Exception):
    """A table that is there cannot be read."""


def read_table(path):
    """(list of (name, unit), array with one column each), or None when the file is not there or has no rows."""
    if not os.path.exists(path):
        return None
    with open(path, encoding="utf-8", newline="") as stream:
        header = next(csv.reader(stream), None)
        if not header:
            raise TableError(f"{path} is empty")
        lines = [line for line in stream if line.strip()]
    if not lines:
        return None
    try:
        data = numpy.loadtxt(lines, delimiter=",", ndmin=2)
    except ValueError as error:
        raise TableError(f"cannot read {path}: {error}") from error
    if data.shape[1] != len(header):
        raise TableError(f"{path}: {len(header)} names for {data.shape[1]} columns")
    return [split_unit(text) for text in header], data


def split_unit(text):
    match = re.fullmatch(r"\s*(.*?)\s*(?:\[(.*)\])?\s*", text)
    return match.group(1), match.group(2) or "1"


def peak(time, values, i):
    """The vertex of the parabola through a sample and its two neighbours, which need not be evenly spaced."""
    if 0 < i < len(values) - 1:
        a, b, c = numpy.polyfit(time[i - 1:i + 2] - time[i], values[i - 1:i + 2] - values[i], 2)
        if a != 0 and time[i - 1] <= time[i] - b / (2 * a) <= time[i + 1]:
            return time[i] - b / (2 * a), values[i] + c - b * b / (4 * a)
    return time[i], values[i]
