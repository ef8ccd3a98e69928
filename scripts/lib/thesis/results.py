"""What runs have found, for the expressions of chapter_N.toml."""

import ast
import math
import os

import case_runs
import chapter_4
import numpy
import wave_tables

from . import functions
from .reference import ROOT

NOT_THERE = "the run was not made"


class NotThere(Exception):
    """A run that an expression needs was not made, or not from today's files; the text says which."""


class Broken(Exception):
    """A measure gives no value although its runs are there; the text says why."""


def parameter_file(name):
    """The path of 'chapter-4/beam' or 'verification/bar-wave'; none if there is no such file."""
    for folder in ("thesis", ""):
        path = os.path.join(ROOT, "parameter_files", folder, name + ".prm")
        if os.path.exists(path):
            return path
    return None


def files_of(expression):
    """The parameter files that an expression names, or that one of its functions needs, in their order."""
    names = []
    for node in ast.walk(ast.parse(expression, mode="eval")):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and "/" in node.value:
            names.append(node.value)
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            files = getattr(functions.ALL.get(node.func.id), "files", None)
            if files:
                names += files(*(getattr(argument, "value", None) for argument in node.args))
    return list(dict.fromkeys(path for path in map(parameter_file, names) if path))


class Results:
    """Reads what the runs wrote into folder/NAME, NAME as scripts/verify calls a file."""

    def __init__(self, folder, program=None):
        """`program`: runs that are older than it, or than their input, do not count; none: any age."""
        self.folder, self.program = folder, program
        self.runs = {}
        self.waves = {}

    def folder_of(self, name):
        path = parameter_file(name)
        if path is None:
            raise Broken(f"there is no parameter file '{name}'")
        relative = os.path.relpath(path, os.path.join(ROOT, "parameter_files"))
        return os.path.join(self.folder, os.path.splitext(relative)[0])

    def is_old(self, name):
        """Whether a run that is there is older than its input or the program."""
        if not self.program:
            return False
        newest = case_runs.newest_input(case_runs.texts_of(parameter_file(name)), self.program)
        return os.path.getmtime(os.path.join(self.folder_of(name), "summary.json")) < newest

    def is_there(self, path):
        """Whether the run of a parameter file has ended, well or not, and is up to date."""
        name = os.path.splitext(os.path.relpath(path, os.path.join(ROOT, "parameter_files")))[0]
        status = case_runs.read_summary(os.path.join(self.folder, name)).get("status")
        return status in ("finished", "failed") and not self.is_old(name.removeprefix("thesis/"))

    def run(self, name):
        """The chapter_4.Run of a file, finished."""
        if name not in self.runs:
            folder = self.folder_of(name)
            if not os.path.exists(os.path.join(folder, "summary.json")):
                raise NotThere(f"{name}: {NOT_THERE}")
            if self.is_old(name):  # before all else: what went wrong with an old run says nothing
                raise NotThere(f"{name}: the run is older than its input or the program")
            run = chapter_4.Run(*os.path.split(folder))
            if run.problem:
                raise NotThere(f"{name}: {run.problem}")
            if run.summary.get("status") != "finished":
                raise NotThere(f"{name}: the run is not finished")
            for quantity in run.summary.get("quantities", []):
                if quantity["value"] is not None and quantity.get("probe"):
                    run.quantities[f"{quantity['probe']}: {quantity['name']}"] = quantity["value"]
            self.runs[name] = run
        return self.runs[name]

    def quantity(self, name, quantity):
        """A value of a run's summary [SI]; "PROBE: NAME", or "NAME" where one probe alone has it."""
        run = self.run(name)
        if quantity not in run.quantities:
            several = sum(known.endswith(f": {quantity}") for known in run.quantities) > 1
            raise Broken(f"{name}: several probes have '{quantity}'" if several else f"{name}: the run has no '{quantity}'")
        return run.quantities[quantity]

    def column(self, name, file, column):
        """(times, values) of a column of a table, the column named as there without its unit."""
        found = self.run(name).column(file, column)
        if found is None:
            raise Broken(f"{name}: {file} has no '{column}'")
        return found

    def wave(self, name, probe=None):
        """{field: wave_tables.Field} of a run: of one probe, or of all (of a field that several probes have, the first probe's)."""
        if (name, probe) not in self.waves:
            self.run(name)
            self.waves[name, probe] = wave_tables.read_waves(self.folder_of(name), probe)
            if probe is not None and not self.waves[name, probe]:
                raise Broken(f"{name}: there is no probe '{probe}' with waves")
        return self.waves[name, probe]

    def value(self, expression):
        """A finite number. Throws NotThere or Broken."""
        names = {name: getattr(math, name) for name in ("pi", "sqrt", "exp", "log", "sin", "cos", "gamma", "atan")}
        names.update({"np": numpy, "abs": abs, "min": min, "max": max, "sum": sum, "range": range, "len": len, "sorted": sorted})
        names.update({name: getattr(self, name) for name in ("quantity", "column", "run", "wave")})
        for name, function in functions.ALL.items():
            names[name] = lambda *arguments, function=function: function(self, *arguments)
        try:
            value = float(eval(compile(expression, "<measure>", "eval"), {"__builtins__": {}, **names}))  # noqa: S307
        except (NotThere, Broken):
            raise
        except Exception as error:  # one bad measure must not end the report
            raise Broken(f"{type(error).__name__}: {error}") from error
        if not math.isfinite(value):
            raise Broken("the measure gives no finite number")
        return value
