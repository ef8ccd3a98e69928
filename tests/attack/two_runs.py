"""Two runs in one folder: one of them is refused, and the other has the results of a run alone."""

import os
import random
import shutil
import signal
import time

import runs
from program import Verdict, defect

LONG = ("Output/Checkpoint steps=20",)
PARTLY = "Time/End time=20 ms"
WAYS = {"run": (), "restart": ("--restart",), "overwrite": ("--overwrite",)}


class Attack:
    name = "two-runs"
    summary = "two runs or restarts in one folder: one is refused"

    def __init__(self, program, options):
        self.program = program

    def prepare(self, folder):
        self.references = runs.Made(lambda run: runs.Reference(self.program, os.path.join(folder, run), runs.longer(run, LONG), run)
                                    .make_partly(PARTLY))

    def corpus(self):
        return runs.corpus_lines("two-runs.txt")

    def trials(self, number, seed):
        """Names: [RUN: ]`stopped FIRST SECOND`, where the first is stopped while it steps until the second has ended, and
        [RUN: ]`race FIRST SECOND SECONDS`."""
        chance = random.Random(seed)
        firsts, seconds = ("run", "restart"), ("run", "restart", "overwrite")
        names = []
        for run in runs.runs_of_trials(number, seed):
            how, pair = chance.choice(("stopped", "race", "race")), f"{chance.choice(firsts)} {chance.choice(seconds)}"
            later = f" {chance.random() * self.references[run].seconds:.4f}" if how == "race" else ""
            names.append(runs.joined_name(run, f"{how} {pair}{later}"))
        return names

    def perform(self, trial):
        run, rest = runs.split_name(trial.name)
        how, first, second, *seconds = rest.split()
        reference = self.references[run]
        output = os.path.join(trial.folder, "run")
        if first == "restart":
            shutil.copytree(reference.partly, output)
        arguments = reference.arguments(output, *WAYS[first])
        one = reference.start(arguments, trial.folder)
        if how == "stopped":
            if not runs.wait_until_open(one, os.path.join(output, "power.csv"), self.program.time_limit, self.program.path):
                return Verdict("wrong", f"the first run ended too early: {self.program.finish(one, arguments).text()}")
            # The ranks, and not mpiexec.
            ranks = runs.processes_of_program(one, self.program.path)
            for pid in ranks:
                os.kill(pid, signal.SIGSTOP)
        else:
            time.sleep(float(seconds[0]))
        other = trial.note(reference.perform(reference.arguments(output, *WAYS[second]), trial.folder))
        if how == "stopped":
            for pid in ranks:
                os.kill(pid, signal.SIGCONT)
        alone = trial.note(self.program.finish(one, arguments))
        for done in (alone, other):
            found = defect(done, {"/run"})
            if found:
                return found
        if how == "stopped" and (alone.status, other.status) != (0, 2):
            return Verdict("wrong", f"the first ends with {alone.status}, the second beside it with {other.status}")
        statuses = sorted((alone.status, other.status))
        # One after the other both may end well.
        if statuses not in ([0, 0], [0, 2]):
            return Verdict("wrong", f"the two end with {statuses[0]} and {statuses[1]}")
        found = reference.difference(output)
        if found:
            return Verdict("wrong", found)
        return Verdict("refused" if 2 in statuses else "accepted", "")
