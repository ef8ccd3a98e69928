"""Signals at random moments, once and repeated, and a screen that is closed: then a restart gives the same results."""

import os
import random
import signal
import subprocess
import time

import runs
from program import Done, Verdict, defect, end_group

# A run that is long enough to be hit while it steps and writes.
LONG = ("Output/Checkpoint steps=20", "Output/Field interval=20 ms")
NAMES = ("TERM", "INT", "HUP", "XCPU", "USR1", "PIPE")


class Attack:
    name = "signals"
    summary = "TERM, INT, HUP, XCPU, USR1 and PIPE at random moments, once and repeated; a closed screen"

    def __init__(self, program, options):
        self.program = program

    def prepare(self, folder):
        self.references = runs.Made(lambda run: runs.Reference(self.program, os.path.join(folder, run), runs.longer(run, LONG), run))

    def corpus(self):
        return runs.corpus_lines("signals.txt")

    def trials(self, number, seed):
        """Names: [RUN: ]SIGNAL HOW OFTEN ROWS SECONDS: when the table has so many rows, and so much later."""
        chance = random.Random(seed)
        return [runs.joined_name(run, f"{chance.choice(NAMES + ('CLOSED',))} {chance.choice((1, 1, 3, 40))} "
                                      f"{chance.choice((0, 1, 1, 1, 1))} "
                                      f"{chance.random() * 0.6 * self.references[run].seconds:.4f}")
                for run in runs.runs_of_trials(number, seed)]

    def perform(self, trial):
        run, rest = runs.split_name(trial.name)
        name, often, rows, seconds = rest.split()
        reference = self.references[run]
        output = os.path.join(trial.folder, "run")
        arguments = reference.arguments(output)
        process = reference.start(arguments, trial.folder)
        table = os.path.join(output, "probes.csv")
        end = time.monotonic() + self.program.time_limit
        while int(rows) and not os.path.exists(table) and process.poll() is None and time.monotonic() < end:
            time.sleep(0.001)
        time.sleep(float(seconds))
        had_table = os.path.exists(table)
        if name == "CLOSED":
            done = self.close_screen(process, arguments)
        else:
            for _ in range(int(often)):
                if process.poll() is None:
                    self.send(process, reference, getattr(signal, "SIG" + name))
                time.sleep(0.003)
            done = self.program.finish(process, arguments)
        trial.note(done)
        if had_table or not reference.ended_by_signal(done.status):
            found = defect(done, ()) if name != "CLOSED" or done.status < 0 or done.hung else None
            if found:
                return found
        # Before it has anything to keep the program may die of a signal.
        if done.status == 0:
            found = reference.difference(output)
            if found:
                return Verdict("wrong", "exit status 0, but " + found)
        had_checkpoint = os.path.exists(os.path.join(output, "checkpoint", "current"))
        # In the set-up there is nothing to keep.
        has_computed = had_table or "nothing is computed yet" not in done.errors
        if done.status == 1 and not had_checkpoint and has_computed and name != "CLOSED":
            return Verdict("lost", "interrupted, but there is no checkpoint")
        found = reference.go_on(trial, output, had_checkpoint)
        return found or Verdict("accepted" if done.status == 0 else "refused", "")

    def send(self, process, reference, number):
        """To the run, or to each of its ranks, as batch systems do. mpiexec itself ends ranks by signals of its own."""
        one = reference.run.ranks == 1
        for pid in [process.pid] if one else runs.processes_of_program(process, self.program.path):
            try:
                os.kill(pid, number)
            except ProcessLookupError:
                pass

    def close_screen(self, process, arguments):
        """As `| head` does that has seen enough."""
        process.stdout.close()
        process.stderr.close()
        process.stdout = process.stderr = None
        hung = False
        try:
            process.wait(self.program.time_limit)
        except subprocess.TimeoutExpired:
            hung = True
            end_group(process)
            process.wait()
        return Done([self.program.path, *arguments], process.returncode, "", "(the screen was closed)",
                    self.program.time_limit, hung)
