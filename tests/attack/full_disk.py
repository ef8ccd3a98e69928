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


class Attack:
    name = "full-disk"
    summary = "a file system that is full (as root) and a limit of the size of files, in a run and in a restart"

    def __init__(self, program, options):
        self.program = program

    def prepare(self, folder):
        self.reference = runs.Reference(self.program, folder).make_partly()
        self.size = sum(max(4096, len(data)) for data in runs.content(self.reference.whole).values()) // 1024 + 16
        self.largest = max(len(data) for data in runs.content(self.reference.whole).values()) // 1024
        self.can_mount = subprocess.run(["unshare", "-m", "mount", "-t", "tmpfs", "none", folder], check=False,
                                        stderr=subprocess.DEVNULL).returncode == 0

    def corpus(self):
        return runs.corpus_lines("full-disk.txt")

    def trials(self, number, seed):
        """Names: PHASE disk KILOBYTES, PHASE file KILOBYTES, PHASE signal KILOBYTES (SIGXFSZ has its usual effect)."""
        chance = random.Random(seed)
        names = []
        while len(names) < number:
            phase, how = chance.choice(("run", "restart")), chance.choice(("disk", "disk", "disk", "file", "signal"))
            size = chance.randrange(4, self.size, 4) if how == "disk" else chance.randrange(self.largest)
            names.append(f"{phase} {how} {size}")
        return names

    def perform(self, trial):
        phase, how, size = trial.name.split()
        output = os.path.join(trial.folder, "run")
        os.mkdir(output)
        if phase == "restart":
            shutil.copytree(self.reference.partly, output, dirs_exist_ok=True)
        more = ["--restart"] if phase == "restart" else []
        if how == "disk":
            if not self.can_mount:
                return Verdict("skipped", "mounting needs root")
            full = os.path.join(trial.folder, "full")
            before, output = output, os.path.join(trial.folder, "saved")
            os.mkdir(full)
            os.mkdir(output)
            used = sum(max(4096, len(data)) for data in runs.content(before).values()) // 1024 + 16
            arguments = self.reference.arguments(full, *more)
            room = str(used * (phase == "restart") + int(size))
            wrapper = ("unshare", "-m", "sh", "-c", ON_A_SMALL_DISK, "sh", room, full, before, output)
            done = self.program.run(arguments, trial.folder, wrapper=wrapper)
        else:
            # Later than MPI has started, which does not bear the limit.
            arguments = self.reference.arguments(output, *more)
            process = self.program.start(arguments, trial.folder, limits="trap '' XFSZ" if how == "file" else "")
            if runs.wait_until_open(process, os.path.join(output, "log.txt"), self.program.time_limit):
                resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (1024 * int(size), 1024 * int(size)))
            done = self.program.finish(process, arguments)
        trial.note(done)
        found = defect(done, {"/full", "/run"})
        if found:
            return found
        if done.status != 0 and not REASON.search(done.errors):
            return Verdict("wrong", "the message does not say that the disk is full")
        if done.status == 0:
            found = runs.difference(self.reference.expected, output)
            if found:
                return Verdict("wrong", "exit status 0, but " + found)
        had_checkpoint = os.path.exists(os.path.join(output, "checkpoint", "current"))
        found = self.reference.go_on(trial, output, had_checkpoint)
        return found or Verdict("accepted" if done.status == 0 else "refused", "")
