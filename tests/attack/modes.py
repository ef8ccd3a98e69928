"""Any number of modes of a cube, whose frequencies have up to three shapes each, about any shift and on 1 to 3 ranks: none is missing or there twice."""

import csv
import math
import os
import random
import re

import runs
from program import Verdict, defect

# Another search and other ranks: round-off of the eigenvalue solver.
TOLERANCE = 1e-8
# By how much 4 x 4 x 4 quadratic cells raise a frequency at most. They lower none: the least values of Rayleigh's quotient are those of all shapes.
RAISE = 0.014
SHEAR_SPEED = math.sqrt(4e9 / 2.6 / 1450.)
N_HELD, N_FREE = 30, 26
N_OF_REFERENCE = {"held": 33, "free": 29}
N_RIGID = 6
SHIFTS = ("100", "234", "300")  # [Hz], below the first frequency of the free cube
# Of the shift, what is left of a frequency of 0 Hz.
ROUND_OFF = 1e-4
SIDES = ("left", "right", "bottom", "top", "back", "front")


def frequencies_of(output):
    """Frequencies, and what is wrong with the table of the modes."""
    with open(os.path.join(output, "modes.csv"), encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    frequencies = [float(row["frequency [Hz]"]) for row in rows]
    if [row["mode [1]"] for row in rows] != [str(1 + i) for i in range(len(rows))]:
        return frequencies, "the modes have other numbers than 1, 2, 3, ..."
    if frequencies != sorted(frequencies):
        return frequencies, "the frequencies do not rise"
    residual = max(float(row["residual [1]"]) for row in rows)
    if not residual <= TOLERANCE:
        return frequencies, f"a residual is {residual:.3g}"
    return frequencies, ""


def problem_of_rigid_motions(output):
    """The three motions along the axes have all of the mass along them, and the three turns all of the inertia about them."""
    with open(os.path.join(output, "modes.csv"), encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    names = [f"share of mass along {axis} [1]" for axis in "xyz"] + [f"share of inertia about {axis} [1]" for axis in "xyz"]
    for number, (row, name) in enumerate(zip(rows, names), 1):
        if not abs(float(row[name]) - 1.) <= TOLERANCE:
            return f"mode {number} has {row[name]} as its {name}"
    return ""


class Attack:
    name = "modes"
    summary = "the modes of a cube, held and free: 1 to 30 of them, three shifts, 1 to 3 ranks, beside those of another method"

    def __init__(self, program, options):
        self.program = program

    def prepare(self, folder):
        self.case = os.path.join(os.path.dirname(runs.copy_case(os.path.join(folder, "case"))), "cube.prm")
        self.folder = folder
        self.references = runs.Made(self.make_reference)

    def corpus(self):
        return runs.corpus_lines("modes.txt")

    def trials(self, number, seed):
        """Names: `held NUMBER RANKS`, `free SHIFT NUMBER RANKS`; each once."""
        every = [f"held {n} {ranks}" for n in range(1, N_HELD + 1) for ranks in (1, 2, 3)]
        every += [f"free {shift} {n} {ranks}" for shift in SHIFTS for n in (6, 7, 10, 17, N_FREE) for ranks in (1, 2, 3)]
        random.Random(seed).shuffle(every)
        return every[:number]

    def options(self, support, shift, number):
        overrides = [f"Modal/Number of modes={number}"]
        if support == "free":
            overrides += [f"Modal/Shift={shift} Hz", *(f"Boundaries/{side}/Type=free" for side in SIDES)]
        return [self.case, *runs.as_options(overrides)]

    def make_reference(self, support):
        """Frequencies [Hz] of the program, for more modes on one rank, of which each lies where the other method says."""
        output = os.path.join(self.folder, "reference-" + support)
        done = self.program.run([*self.options(support, SHIFTS[-1], N_OF_REFERENCE[support]), "--output", output], self.folder)
        if done.status != 0:
            raise runs.AttackError(f"the modes on one rank failed\n{done.text()}")
        frequencies, problem = frequencies_of(output)
        with open(os.path.join(os.path.dirname(self.case), "cube-modes.csv"), encoding="utf-8", newline="") as stream:
            rows = list(csv.DictReader(filter(lambda line: not line.startswith("#"), stream), skipinitialspace=True))
        exact = [SHEAR_SPEED * float(row[support]) for row in rows][:len(frequencies)]
        for number, (found, other) in enumerate(zip(frequencies, exact), 1):
            if not problem and other > 0. and not -1e-5 <= found / other - 1. <= RAISE:
                problem = f"mode {number} has {found} Hz; the other method gives {other:.2f} Hz"
        if problem:
            raise runs.AttackError(f"{support}, on one rank: {problem}")
        return frequencies

    def perform(self, trial):
        support, *words = trial.name.split()
        shift = words.pop(0) if support == "free" else ""
        number, ranks = map(int, words)
        expected = self.references[support]
        output = os.path.join(trial.folder, "run")
        done = trial.note(self.program.run([*self.options(support, shift, number), "--output", output], trial.folder, ranks=ranks))
        found = defect(done, ())
        if found:
            return found
        if done.status != 0:
            return Verdict("wrong", f"exit status {done.status}")
        frequencies, problem = frequencies_of(output)
        problem = problem or self.difference(frequencies, expected, number, float(shift) if shift else 0.)
        problem = problem or self.problem_of_cut(done.output, expected, number)
        if not problem and support == "free":
            problem = problem_of_rigid_motions(output)
        return Verdict("wrong", problem) if problem else Verdict("accepted", "")

    @staticmethod
    def difference(frequencies, expected, number, shift):
        if len(frequencies) != number:
            return f"{len(frequencies)} modes instead of {number}"
        for i, (one, other) in enumerate(zip(frequencies, expected), 1):
            if shift and i <= N_RIGID:
                if not one <= ROUND_OFF * shift:
                    return f"mode {i}, without deformation, has {one} Hz"
            elif not abs(one / other - 1.) <= TOLERANCE:
                return f"mode {i} has {one} Hz, with more modes on one rank {other} Hz"
        return ""

    @staticmethod
    def problem_of_cut(text, expected, number):
        """The run says if the last mode is one of several of one frequency, of which others are left out."""
        last = expected[number - 1]
        group = [i for i, value in enumerate(expected) if abs(value - last) <= 1e-7 * max(last, 1.)]
        stated = re.search(r"Mode (\d+) is one of (\d+) of one frequency; Modal/Number of modes = (\d+) shows all", text)
        right = (number, len(group), group[-1] + 1) if group[-1] + 1 > number else None
        found = tuple(map(int, stated.groups())) if stated else None
        return "" if found == right else f"the run says {found} of the modes of the last frequency, where {right} is right"
