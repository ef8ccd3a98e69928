"""One to three ranks, either partitioner, more ranks than cells: the same results. A rank that is killed, or that sees another file, ends all."""

import os
import random
import shutil
import signal
import time

import runs
from program import Verdict, defect

# The number of ranks changes the order of sums, and the linear solver.
TOLERANCE = 1e-8
# What a case needs besides its file, and whether its mesh can be cut by METIS.
CASES = {"channel": ("channel.prm", (), True), "adaptive": ("adaptive.prm", (), False), "beats": ("beats.prm", (), True),
         "finite": ("finite.prm", ("Newton/Tolerance=1e-11",), True),
         "convection": ("convection.prm", ("Newton/Tolerance=1e-11",), True),
         "cell-wise": ("channel.prm", ("Discretisation=cell-wise",), True),
         "steady": ("block-of-one.prm", ("Analysis=steady",), True),
         "steady-cell-wise": ("block-of-one.prm", ("Analysis=steady", "Discretisation=cell-wise", "Mesh/Cells=2, 1"), True),
         "steady-adaptive": ("block-of-one.prm", ("Analysis=steady", "Adaptivity/Cycles=1", "Adaptivity/Refine fraction=0.6"), False),
         "modal": ("block-of-one.prm", ("Analysis=modal", "Modal/Number of modes=2"), True),
         "one": ("block-of-one.prm", ("Time/Time step=1 ms", "Time/End time=4 ms"), True),
         "one-cell-wise": ("block-of-one.prm", ("Time/Time step=1 ms", "Time/End time=4 ms", "Discretisation=cell-wise"), True)}
# A rank with a working folder of its own, in which a file is another one.
FOLDER_OF_RANK = 'cd "$1/rank-${OMPI_COMM_WORLD_RANK:-${PMIX_RANK:-0}}" && shift && exec "$@"'
FILES = {"pulse.csv": "in a table", "wall.prm": "in an included file", "channel.prm": "in the parameter file"}
DAMAGES = ("half", "missing", "digit", "line")


class Attack:
    name = "ranks"
    summary = "1 to 3 ranks, p4est and METIS, more ranks than cells; a rank that is killed, stopped, or sees another file"

    def __init__(self, program, options):
        self.program = program

    def prepare(self, folder):
        self.case = os.path.dirname(runs.copy_case(os.path.join(folder, "case")))
        self.folder = folder
        self.wholes = runs.Made(self.make_whole)

    def corpus(self):
        return runs.corpus_lines("ranks.txt")

    def trials(self, number, seed):
        """Names: `same CASE RANKS PARTITIONER`, `file NAME DAMAGE RANK RANKS`, `kill SIGNAL RANK RANKS SECONDS`."""
        chance = random.Random(seed)
        names = []
        for _ in range(number):
            kind, ranks = chance.choice(("same", "same", "file", "kill")), chance.choice((2, 3))
            if kind == "same":
                case = chance.choice(sorted(CASES))
                names.append(f"same {case} {ranks} {chance.choice(('p4est', 'metis')) if CASES[case][2] else 'p4est'}")
            elif kind == "file":
                names.append(f"file {chance.choice(sorted(FILES))} {chance.choice(DAMAGES)} {chance.randrange(ranks)} {ranks}")
            else:
                names.append(f"kill {chance.choice(('KILL', 'SEGV', 'TERM'))} {chance.randrange(ranks)} {ranks} "
                             f"{chance.random():.3f}")
        return names

    def perform(self, trial):
        kind, *words = trial.name.split()
        return getattr(self, kind)(trial, *words)

    def options(self, case, partitioner):
        file, overrides, _ = CASES[case]
        return [os.path.join(self.case, file), *runs.as_options([*overrides, f"Mesh/Partitioner={partitioner}"])]

    def make_whole(self, case):
        output = os.path.join(self.folder, "whole-" + case)
        done = self.program.run([*self.options(case, "p4est"), "--output", output], self.folder)
        if done.status != 0:
            raise runs.AttackError(f"the run on one rank failed\n{done.text()}")
        return output, runs.results(output)

    def same(self, trial, case, ranks, partitioner):
        whole, expected = self.wholes[case]
        output = os.path.join(trial.folder, "run")
        done = trial.note(self.program.run([*self.options(case, partitioner), "--output", output], trial.folder,
                                           ranks=int(ranks)))
        found = defect(done, ())
        if found:
            return found
        if done.status != 0:
            return Verdict("wrong", f"exit status {done.status}")
        # The pieces of fields have other names; their states are compared.
        problem = runs.near_difference(expected, whole, output, TOLERANCE, files=False)
        return Verdict("wrong", problem) if problem else Verdict("accepted", "")

    def file(self, trial, name, damage, rank, ranks):
        """One rank sees another file: all end with 2, and nothing is written."""
        for i in range(int(ranks)):
            shutil.copytree(self.case, os.path.join(trial.folder, f"rank-{i}"))
        path = os.path.join(trial.folder, f"rank-{rank}", name)
        self.damage(path, damage)
        output = os.path.join(trial.folder, "run")
        launcher = ("mpiexec", "--bind-to", "none", "-n", ranks, "sh", "-c", FOLDER_OF_RANK, "sh", trial.folder)
        done = trial.note(self.program.run(["channel.prm", "--output", output], trial.folder, wrapper=launcher))
        found = defect(done, {name})
        if found:
            return found
        if done.status != 2:
            return Verdict("wrong", f"one rank sees another file, and the exit status is {done.status}")
        if os.path.exists(output):
            return Verdict("wrong", "the input is wrong, but there is an output folder")
        return Verdict("refused", "")

    @staticmethod
    def damage(path, how):
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
        os.remove(path)
        if how == "missing":
            return
        if how == "half":
            text = text[:len(text) // 2]
        elif how == "digit":
            place = max(i for i, letter in enumerate(text) if letter.isdigit())
            text = text[:place] + str((int(text[place]) + 1) % 10) + text[place + 1:]
        else:
            text += "# a line more\n"
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)

    def kill(self, trial, number, rank, ranks, seconds):
        """One rank dies: the others end, too, and a restart goes on to the same results."""
        whole, expected = self.wholes["channel"]
        output = os.path.join(trial.folder, "run")
        arguments = [*self.options("channel", "p4est"), *runs.as_options(["Output/Checkpoint steps=1"]), "--output", output]
        process = self.program.start(arguments, trial.folder, ranks=int(ranks))
        runs.wait_until_open(process, os.path.join(output, "log.txt"), self.program.time_limit, self.program.path)
        time.sleep(0.3 * float(seconds))
        pids = runs.processes_of_program(process, self.program.path)
        for pid in pids[int(rank):int(rank) + 1]:
            try:
                os.kill(pid, getattr(signal, "SIG" + number))
            except ProcessLookupError:
                pass
        done = trial.note(self.program.finish(process, arguments))
        if done.hung:
            return defect(done, ())
        more = ["--restart"] if os.path.exists(os.path.join(output, "checkpoint", "current")) else ["--overwrite"]
        # A run that had ended goes on to nothing.
        again = trial.note(self.program.run([*arguments, *more], trial.folder, ranks=int(ranks)))
        if again.status != 0:
            return defect(again, ()) or Verdict("lost", f"the run after it ends with {again.status}")
        problem = runs.near_difference(expected, whole, output, TOLERANCE, files=False)
        return Verdict("lost", problem) if problem else Verdict("accepted" if done.status == 0 else "refused", "")
