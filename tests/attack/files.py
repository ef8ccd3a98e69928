"""Each operation on a file of a run and of a restart fails: once, from there on, short, by a kill, by a loss of
power."""

import os
import random
import shutil
import subprocess

import power
import runs
from program import HERE, Verdict, defect

KINDS = {"open": ("once", "ever", "kill", "power", "names"),
         "write": ("once", "ever", "short", "cut", "kill", "half", "power", "names"),
         "fsync": ("once", "ever", "kill", "power", "names"),
         "read": ("once", "short"),
         "close": ("once", "ever"),
         "flush": ("once", "ever"),
         "flock": ("once",),
         "opendir": ("once",)}
KINDS_OF_NAMES = ("once", "ever", "kill", "power", "names")  # rename, mkdir, unlink, rmdir, truncate


def build_library(folder):
    """The library to preload."""
    library = os.path.join(folder, "faults.so")
    if not os.path.exists(library):
        subprocess.run([os.environ.get("CC", "cc"), "-O1", "-shared", "-fPIC", "-o", library,
                        os.path.join(HERE, "faults.c"), "-ldl", "-lpthread"], check=True)
    return library


def arguments_of(reference, output, phase):
    return reference.arguments(output, *(["--restart"] if phase == "restart" else []))


class Counted:
    """A run, and its operations on files in each phase."""

    def __init__(self, attack, folder, run):
        os.makedirs(folder)
        self.reference = runs.Reference(attack.program, folder, run=run).make_partly()
        self.operations = {}
        for phase in ("run", "restart"):
            at = os.path.join(folder, "count-" + phase)
            os.makedirs(at)
            output, environment = attack.start(self.reference, at, phase)
            done = self.reference.perform(arguments_of(self.reference, output, phase), at, environment=environment)
            if done.status != 0:
                raise runs.AttackError(f"the run whose operations are counted failed\n{done.text()}")
            self.operations[phase] = power.read_log(environment["CONTINUA_FAULT_LOG"])


class Attack:
    name = "files"
    summary = "each operation on a file of a run and of a restart fails, short, by a kill, by a loss of power"

    def __init__(self, program, options):
        self.program = program

    def prepare(self, folder):
        self.library = build_library(folder)
        self.counted = runs.Made(lambda run: Counted(self, os.path.join(folder, run), run))

    def start(self, reference, folder, phase, fault=""):
        """The folder in which the run works, and the environment of its fault."""
        output = os.path.join(folder, "run")
        if phase == "restart":
            shutil.copytree(reference.partly, output)
        shadow = os.path.join(folder, "shadow")
        os.makedirs(shadow)
        environment = {"LD_PRELOAD": self.library, "CONTINUA_FAULT_LOG": os.path.join(folder, "operations.txt"),
                       "CONTINUA_FAULT_FOLDERS": f"out={output}:in={os.path.dirname(reference.case)}"}
        if fault:
            environment["CONTINUA_FAULT"] = fault
        if fault.split(" ")[0] in ("power", "names"):
            environment["CONTINUA_FAULT_SHADOW"] = shadow
        return output, environment

    def corpus(self):
        return [one for name in runs.corpus_lines("files.txt") for one in self.each(name)]

    def each(self, name):
        """A star for the number of the call stands for each of them."""
        run, rest = runs.split_name(name)
        phase, kind, operation, number, file = rest.split(" ", 4)
        if number != "*":
            return [name]
        return [runs.joined_name(run, f"{phase} {kind} {operation} {count} {file}")
                for other, at, count, _ in self.counted[run].operations[phase] if (other, at) == (operation, file)]

    def all_of(self, run):
        """Names: [RUN: ]PHASE KIND OPERATION NUMBER FILE."""
        names = [runs.joined_name(run, f"{phase} {kind} {operation} {count} {file}")
                 for phase, log in self.counted[run].operations.items() for operation, file, count, _ in log
                 for kind in KINDS.get(operation, KINDS_OF_NAMES)
                 # What is read stays as it is when the process dies.
                 if file.startswith("out") or kind in ("once", "ever", "short")]
        return list(dict.fromkeys(names))

    def trials(self, number, seed):
        """All of them if the number is 0."""
        if number == 0:
            return [name for run in runs.RUNS for name in self.all_of(run)]
        chance = random.Random(seed)
        return [chance.choice(self.all_of(run)) for run in runs.runs_of_trials(number, seed)]

    def perform(self, trial):
        run, rest = runs.split_name(trial.name)
        reference = self.counted[run].reference
        phase, fault = rest.split(" ", 1)
        kind, file = fault.split(" ")[0], fault.split(" ", 3)[3]
        output, environment = self.start(reference, trial.folder, phase, fault)
        disk = power.Disk(output)
        done = trial.note(reference.perform(arguments_of(reference, output, phase), trial.folder, environment=environment))
        log = power.read_log(environment["CONTINUA_FAULT_LOG"])
        if kind in ("kill", "half", "power", "names"):
            if done.status == 0:
                return Verdict("skipped", "the operation was not reached")
            if not reference.was_killed(done.status):
                return Verdict("wrong", f"exit status {done.status} instead of a kill")
            if kind in ("power", "names"):
                changes = disk.follow(log).lose_power(kind == "names", environment["CONTINUA_FAULT_SHADOW"])
                with open(os.path.join(trial.folder, "power.txt"), "w", encoding="utf-8") as stream:
                    stream.write("\n".join(changes) + "\n")
        else:
            if not any(operation == "fault" for operation, *_ in log):
                return Verdict("skipped", "the operation was not reached")
            # What failed, or the folder in which it failed; later failures may come first in the message.
            names = {os.path.basename(file).replace(".new", "") if "/" in file else "/run"}
            if file.startswith("out/"):
                names.add(os.path.join("/run", os.path.relpath(os.path.dirname(file), "out")).rstrip("/."))
            if kind in ("ever", "cut"):
                names |= reference.names(output)
            found = defect(done, names)
            if found:
                return found
            if done.status == 0:
                found = reference.difference(output)
                if found:
                    return Verdict("wrong", "exit status 0, but " + found)
        had_checkpoint = phase == "restart" or power.has_complete_checkpoint(log, kind == "names")
        found = reference.go_on(trial, output, had_checkpoint)
        return found or Verdict("accepted" if done.status == 0 else "refused", "")
