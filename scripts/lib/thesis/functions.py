"""Functions of the expressions in chapter_N.toml. Each has the results as its first argument, which the expressions leave out."""

import functools
import glob
import importlib
import math
import os
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader

import chapter_4
import numpy

from .reference import ROOT


@functools.lru_cache
def script(name):
    """A script of the project as a module; `name` is its path in the folder scripts."""
    loader = SourceFileLoader(os.path.basename(name).replace("-", "_"), os.path.join(ROOT, "scripts", name))
    module = module_from_spec(spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


def loss(results, run, end):
    """Part of the first maximum of the tip that the last maximum before `end` [s] has lost [1]."""
    return results.run(run).loss(end)


def loss_by_mode(results, run, end):
    """The same of the first mode alone, by the decay that is fitted to it [1]."""
    return results.run(run).loss_by_mode(end)


def beat(results, run):
    """Frequency of the beats of the tip's maxima [Hz]."""
    return results.run(run).beat()


def residual_rms(results, run):
    """Root mean square of the power residual [W]."""
    return results.run(run).power_residual()


def largest_after(results, run, column, start):
    """Largest magnitude of a column of probes.csv about its mean, after a time [s]."""
    time, values = results.column(run, "probes.csv", column)
    values = values[time >= start]
    return float(numpy.max(numpy.abs(values - values.mean())))


def bernoulli_root(_, mode):
    """Eigenvalue of a cantilever by Euler and Bernoulli: the root of cos(m) cosh(m) = -1."""
    return chapter_4.bernoulli_roots(mode)[-1]


def bernoulli_frequency(_, mode, modulus, height, length, density):
    """Of a cantilever of that height [Hz]; SI."""
    root = chapter_4.bernoulli_roots(mode)[-1]
    return root**2 * math.sqrt(modulus * height**2 / (12 * density * length**4)) / (2 * math.pi)


def effect(results, number, source):
    """The measure of a finding of scripts/manual/thesis-findings, counted from 1, of the six tubes of chapter 5 with the elastic
    wall: `source` "simulated" or "theory"; positive if it holds, but for those that match."""
    findings = script("manual/thesis-findings")
    tubes = {name: findings.Tube(results.wave(file), source) for name, file in zip("ABCDEF", six_tubes())}
    return findings.FINDINGS[number - 1][1][1](tubes)


def six_tubes(*_):
    """The parameter files behind effect()."""
    return [f"chapter-5/tube-{name}" for name in "abcdef"]


# Of a function whose files its arguments do not name: what gives them.
effect.files = six_tubes


def _all():
    """These, and those of the chapters: FUNCTIONS of each functions_N.py."""
    functions = {function.__name__: function for function in (loss, loss_by_mode, beat, residual_rms, largest_after,
                                                              bernoulli_root, bernoulli_frequency, effect)}
    for path in sorted(glob.glob(os.path.join(os.path.dirname(__file__), "functions_*.py"))):
        module = importlib.import_module(f"{__package__}.{os.path.splitext(os.path.basename(path))[0]}")
        functions.update(module.FUNCTIONS)
    return functions


ALL = _all()
