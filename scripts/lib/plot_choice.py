"""What scripts/plot is asked to draw: --fields, --region and --times. Wrong names and times are refused before anything is drawn."""

import argparse
import csv
import glob
import math
import os
import re
import xml.etree.ElementTree

import continua
import continua.tables
import tables


class ChoiceError(Exception):
    """An option asks for what the run does not have."""


def read_names(text):
    """What --fields and --region take: NAME,NAME."""
    names = [name.strip() for name in text.split(",")]
    if not all(names):
        raise argparse.ArgumentTypeError(f"'{text}' has an empty name")
    return names


def read_section(text):
    """What --section takes: x=20mm."""
    match = re.fullmatch(r"\s*([xyz])\s*=\s*([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s*(m|cm|mm|um)\s*", text)
    try:
        at = float(match.group(2)) if match else math.nan
    except ValueError:
        at = math.nan
    if not math.isfinite(at):
        raise argparse.ArgumentTypeError(f"'{text}' is not a plane such as x=20mm")
    return {"axis": "xyz".index(match.group(1)), "at": at * {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6}[match.group(3)]}


def words_of(name):
    return name.lower().replace("_", " ").split()


class Choice:
    """Fields, regions: lists of names, times: a list of [s] (of modes: numbers); None where all are wanted, or the last time.

    section   {"axis": 0, 1 or 2, "at": [m]} of a body in space; None: the body
    mesh      whether the lines of the mesh are drawn; None: where they leave room for the colours
    arrows    "vectors" or "streamlines" of the velocity, or None
    """

    def __init__(self, fields=None, regions=None, times=None, section=None, mesh=None, arrows=None):
        self.fields, self.regions, self.times = fields, regions, times
        self.section, self.mesh, self.arrows = section, mesh, arrows

    def fields_of(self, available):
        """Those of the available fields that --fields wants. 'stress' means stress_xx and all others; 'pressure' is the pressure
        alone where there is one, though 'axis pressure' has the word, too."""
        if self.fields is None:
            return list(available)
        chosen = []
        for name in self.fields:
            words = words_of(name)
            same = [field for field in available if words_of(field) == words]
            chosen += same or [field for field in available if set(words) <= set(words_of(field))]
        return list(dict.fromkeys(chosen))


def entries_of(path):
    """[(time, files)] of a .pvd file, in the order of time. Without VTK, which continua.fields needs: a run may have no picture of it."""
    entries = {}
    try:
        for element in xml.etree.ElementTree.parse(path).iter("DataSet"):
            at = float(element.attrib["timestep"])
            entries.setdefault(at, []).append(os.path.join(os.path.dirname(path), element.attrib["file"]))
    except (xml.etree.ElementTree.ParseError, KeyError, ValueError) as error:
        raise continua.ResultsError(path, f"cannot be read: {error}", "The file is damaged: copy it again, or repeat the run") from error
    return sorted(entries.items())


def header(path):
    try:
        with open(path, encoding="utf-8", newline="") as stream:
            return next(csv.reader(stream), [])
    except OSError:
        return []


def columns(path):
    """Names of the columns of a table, without their units; none if there is no table."""
    return [continua.tables.split_unit(column)[0] for column in header(path)]


def fields_of_tables(run):
    """The fields of probes.csv, of the responses and of the waves' tables."""
    found = []
    for column in columns(os.path.join(run["folder"], "response.csv")):
        if column.endswith(" amplitude"):
            found.append(column.rpartition(": ")[2][: -len(" amplitude")])
    for path in [os.path.join(run["folder"], "probes.csv"),
                 *sorted(glob.glob(os.path.join(glob.escape(run["folder"]), "wave*.csv")))]:
        for column in header(path)[1:]:
            found.append(re.sub(r", (simulated|theory|nonlinear theory|measured)\b.*", "", continua.tables.split_unit(column)[0].rpartition(": ")[2]))
    return list(dict.fromkeys(found))


def fields_of_states(run):
    """The fields of the run's states."""
    path = os.path.join(run["folder"], "fields.pvd")
    if not os.path.exists(path):
        return []
    there = run["summary"].get("field units")
    if there:
        return list(there)
    entries = entries_of(path)
    text = ""
    if entries and os.path.exists(entries[0][1][0]):
        with open(entries[0][1][0], "rb") as stream:
            text = stream.read().decode("utf-8", "replace")
    names = re.findall(r'<P?DataArray [^>]*Name="([^"]*)"', text)
    return [name for name in dict.fromkeys(names) if name not in ("TIME", "CYCLE", "connectivity", "offsets", "types")]


def last_time(run, entries):
    """The end of the run [s], as far as it came: states need not be written up to it."""
    end = entries[-1][0]
    for name in ("probes.csv", "power.csv"):
        table = tables.read_table(os.path.join(run["folder"], name))
        if table is not None and table[0][0][0] == "time":
            end = max(end, table[1][-1, 0])
    return end


def check_fields(choice, runs, others):
    there = list(dict.fromkeys([name for run in runs for name in fields_of_tables(run) + fields_of_states(run)] + others))
    for name in choice.fields:
        if not Choice([name]).fields_of(there):
            raise ChoiceError(f"--fields {name}: there is no such field; there are {', '.join(there) or 'none'}")


def check_times(choice, run):
    path = os.path.join(run["folder"], "fields.pvd")
    entries = entries_of(path) if os.path.exists(path) else []
    if not entries:
        raise ChoiceError(f"--times: {run['folder']} has no states of fields (no entries in fields.pvd): "
                          "the run needs `Output/Field interval`")
    modes = run["summary"].get("modes", [])
    if run["summary"].get("analysis") == "modal" and modes:
        for number in choice.times:
            if number != round(number) or not 1 <= number <= len(modes):
                raise ChoiceError(f"--times {number:g}: there are the modes 1 to {len(modes)}")
        return
    first, last = entries[0][0], last_time(run, entries)
    for time in choice.times:
        if not first - 1e-9 * last <= time <= last * (1 + 1e-9):
            raise ChoiceError(f"--times {time:g} s: this is outside of the run, which goes from {first:g} s to {last:g} s")


def regions_of(run):
    """{name: material_id}, empty if the summary has none."""
    return {name: number for number, name in enumerate(run["summary"].get("regions", []))}


def numbers_of_regions(choice, run):
    """The material_ids that --region wants; None for all."""
    if choice.regions is None:
        return None
    there = regions_of(run)
    numbers = []
    for name in choice.regions:
        if name in there:
            numbers.append(there[name])
        elif not there and name.isdigit():
            numbers.append(int(name))
        elif not there:
            raise ChoiceError(f"--region {name}: {run['folder']}/summary.json has no names of regions; give their numbers, "
                              "which are the field material_id (--region 0)")
        else:
            raise ChoiceError(f"--region {name}: there is no such region; there are {', '.join(there)}")
    return numbers


def check(choice, runs, others=()):
    """Throws ChoiceError if there is nothing of what an option asks for. `others`: fields that are computed from the runs'."""
    if choice.fields is not None:
        check_fields(choice, runs, list(others))
    if choice.regions is not None:
        for run in runs:
            numbers_of_regions(choice, run)
    if choice.times is not None:
        check_times(choice, runs[0])


def nearest(entries, time):
    """The entry of the time, or the last one without a time."""
    if time is None:
        return entries[-1]
    return min(entries, key=lambda entry: abs(entry[0] - time))
