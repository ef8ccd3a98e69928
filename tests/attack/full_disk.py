"""A disk that fills up, and a limit of the size of a file: the run says so, and goes on elsewhere from what it kept."""

import os
import random
import re
import resource
import shutil
import subprocess

import runs
from program import Verdict, defect

REASON = re.compile(r"No space left|File too large|full", re.IGNORECASE)
# A small file system of its own, which only this command and its children see; what was in it is copied to the end.
ON_A_SMALL_DISK = ('mount -t tmpfs -o size="$1"k none "$2" && cp -a "$3"/. "$2" && saved=$4 && disk=$2 && '
                   'shift 4 && { "$@"; '
                   'status=$?; cp -a "$disk"/. "$saved"; exit $status; }')


def room_of(sizes):
    """Kilobytes that files of these sizes take on a disk."""
    return sum(max(4096, size) for size in sizes) // 1024 + 16


class Attack:
    name = "full-disk"
    summary = "a file system that is full (as root) and a limit of the size of files, in a run and in a restart"

    def __init__(self, program, options):
        self.program = program

    def prepare(self, folder):
        self.references = runs.Made(lambda run: runs.Reference(self.program, os.path.join(folder, run), run=run).make_partly())
        self.can_mount = subprocess.run(["unshare", "-m", "mount", "-t", "tmpfs", "none", folder], check=False,
                                        stderr=subprocess.DEVNULL).returncode == 0

    def corpus(self):
        return runs.corpus_lines("full-disk.txt")

    def trials(self, number, seed):
        """Names: [RUN: ]PHASE disk KILOBYTES, PHASE file KILOBYTES, PHASE signal KILOBYTES (SIGXFSZ has its usual effect)."""
        chance = random.Random(seed)
        names = []
        for run in runs.runs_of_trials(number, seed):
            sizes = [len(data) for data in runs.content(self.references[run].whole).values()]
            phase, how = chance.choice(("run", "restart")), chance.choice(("disk", "disk", "disk", "file", "signal"))
            size = chance.randrange(4, room_of(sizes), 4) if how == "disk" else chance.randrange(max(sizes) // 1024)
            names.append(runs.joined_name(run, f"{phase} {how} {size}"))
        return names

    def perform(self, trial):
        run, rest = runs.split_name(trial.name)
        phase, how, size = rest.split()
        reference = self.references[run]
        output = os.path.join(trial.folder, "run")
        os.mkdir(output)
        if phase == "restart":
            shutil.copytree(reference.partly, output, dirs_exist_ok=True)
        more = ["--restart"] if phase == "restart" else []
        if how == "disk":
            if not self.can_mount:
                return Verdict("skipped", "mounting needs root")
            full = os.path.join(trial.folder, "full")
            before, output = output, os.path.join(trial.folder, "saved")
            os.mkdir(full)
            os.mkdir(output)
            used = room_of(len(data) for data in runs.content(before).values())
            arguments = reference.arguments(full, *more)
            room = str(used * (phase == "restart") + int(size))
            wrapper = ("unshare", "-m", "sh", "-c", ON_A_SMALL_DISK, "sh", room, full, before, output)
            done = reference.perform(arguments, trial.folder, wrapper=wrapper)
        else:
            # Later than MPI has started, which does not bear the limit.
            arguments = reference.arguments(output, *more)
            process = reference.start(arguments, trial.folder, limits="trap '' XFSZ" if how == "file" else "")
            if runs.wait_until_open(process, os.path.join(output, "log.txt"), self.program.time_limit, self.program.path):
                for pid in runs.processes_of_program(process, self.program.path):
                    resource.prlimit(pid, resource.RLIMIT_FSIZE, (1024 * int(size), 1024 * int(size)))
            done = self.program.finish(process, arguments)
        trial.note(done)
        found = defect(done, {"/full", "/run"})
        if found:
            return found
        if done.status != 0 and not REASON.search(done.errors):
            return Verdict("wrong", "the message does not say that the disk is full")
        if done.status == 0:
            found = reference.difference(output)
            if found:
                return Verdict("wrong", "exit status 0, but " + found)
        had_checkpoint = os.path.exists(os.path.join(output, "checkpoint", "current"))
        found = reference.go_on(trial, output, had_checkpoint)
        return found or Verdict("accepted" if done.status == 0 else "refused", "")
