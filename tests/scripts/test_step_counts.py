#!/usr/bin/python3
"""What a step counts, so that nobody makes steps slower unseen: corrections, iterations, factors, page faults, and what the program itself
allocates. Nothing is timed. A figure of a step is the difference of two runs of different length; no factor is made in the steps between."""

import json
import os
import resource
import subprocess
import sys
import tempfile
import typing
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))
ALLOCATIONS = os.environ.get("CONTINUA_ALLOCATIONS_LIBRARY", "")
QUIET = {"Output/Field interval": "100 s", "Output/Probe interval": "100 s", "Output/Power interval": "0 s"}
WAKE = {**QUIET, "Finite element/Velocity degree": "2", "Time/Time step": "1 ms", "Flow/Stabilisation viscosity": "0.01 Pa s"}


class Counts(typing.NamedTuple):
    factors: float
    corrections: float
    iterations: float
    faults: float
    allocations: float
    large_allocations: float  # of at least 4 kB, a tenth of a vector of unknowns


def counts_of(file, sets, end):
    """Of a whole run."""
    with tempfile.TemporaryDirectory() as folder:
        output, allocations = os.path.join(folder, "run"), os.path.join(folder, "allocations")
        command = [PROGRAM, os.path.join(ROOT, "parameter_files", file), "--output", output, "--set", f"Time/End time={end}"]
        for key, value in sets.items():
            command += ["--set", f"{key}={value}"]
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_minflt
        # The checks of a run that is cut short need not hold.
        subprocess.run(command, check=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                       env={**os.environ, "LD_PRELOAD": ALLOCATIONS, "CONTINUA_ALLOCATIONS": allocations})
        faults = resource.getrusage(resource.RUSAGE_CHILDREN).ru_minflt - before
        with open(os.path.join(output, "summary.json"), encoding="utf-8") as stream:
            summary = json.load(stream)
        with open(allocations, encoding="utf-8") as stream:
            calls, large = map(int, stream.read().split())
        assert calls > 1000, f"{ALLOCATIONS} has counted {calls} allocations of the program in a whole run"
        return summary["steps"], Counts(summary["matrices factored"], summary.get("corrections", 0), summary.get("linear iterations", 0), faults,
                                        calls, large)


def counts_of_step(file, sets, ends):
    """(factors of the shorter run, Counts of a step after it)"""
    (first, before), (last, after) = (counts_of(file, sets, end) for end in ends)
    steps = last - first
    return before.factors, Counts(*((b - a) / steps for a, b in zip(before, after)))


@unittest.skipIf(os.environ.get("CONTINUA_RUN_TYPE") != "Release" or not ALLOCATIONS, "the counts are those of a Release program, run by ctest")
class StepCounts(unittest.TestCase):
    def check(self, counts, corrections, iterations, allocations):
        """Upper bounds of a step."""
        print(counts, file=sys.stderr)
        self.assertEqual(counts.factors, 0)
        self.assertLessEqual(counts.corrections, corrections)
        self.assertLessEqual(counts.iterations, iterations)
        # Two runs of the same length differ by up to some thousands. Memory that goes back to the system in each correction costs hundreds a step.
        self.assertLessEqual(counts.faults, 100)
        self.assertLessEqual(counts.allocations, allocations)
        # What is written at the end of a run may differ by some.
        self.assertLessEqual(counts.large_allocations, 0.2)

    def test_linear_step(self):
        factors, counts = counts_of_step("thesis/chapter-4/beam.prm", {**QUIET, "Time/Time step": "1 ms"}, ["100 ms", "300 ms"])
        self.assertEqual(factors, 2)
        self.check(counts, 0, 0, 16)

    def test_explicit_step(self):
        factors, counts = counts_of_step("verification/cylinder-wake.prm", {**WAKE, "Flow/Time treatment": "explicit"}, ["50 ms", "100 ms"])
        self.assertEqual(factors, 1)
        self.assertEqual(counts.corrections, 1)
        self.check(counts, 1, 0, 20)

    def test_newton_step(self):
        _, counts = counts_of_step("verification/cylinder-wake.prm", WAKE, ["80 ms", "120 ms"])
        self.assertGreaterEqual(counts.corrections, 2)
        self.check(counts, 4, 0, 20)

    def test_entries_of_a_factor(self):
        """Of an incompressible liquid with convection: 540,000, and 870,000 with the strategy that UMFPACK itself chooses."""
        with tempfile.TemporaryDirectory() as folder:
            output = os.path.join(folder, "run")
            command = [PROGRAM, os.path.join(ROOT, "parameter_files", "verification/cylinder-wake.prm"), "--output", output, "--set", "Time/End time=2 ms"]
            for key, value in WAKE.items():
                command += ["--set", f"{key}={value}"]
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            with open(os.path.join(output, "summary.json"), encoding="utf-8") as stream:
                self.assertLess(json.load(stream)["factor entries"], 650000)


if __name__ == "__main__":
    unittest.main()
