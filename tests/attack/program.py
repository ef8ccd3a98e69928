"""Runs the program under attack, within limits, and says what came of it."""

import collections
import os
import re
import signal
import subprocess
import time

HERE = os.path.dirname(os.path.abspath(__file__))

# What a trial showed. `refused`: exit status 1 or 2 with a message, as it should be. `accepted`: exit status 0 and the
# right result. `wrong`: another status, no message, another result. `lost`: what was on the disk and named complete is
# gone.
KINDS = ("refused", "accepted", "wrong", "crash", "hang", "lost", "skipped")
BAD = ("wrong", "crash", "hang", "lost")
Verdict = collections.namedtuple("Verdict", "kind note")

# Texts of libraries and of C++ that mean nothing to a user.
INTERNAL = re.compile(r"An error occurred in line|std::|json\.exception|[Bb]oost|terminate called|basic_string|"
                      r"vector::|"
                      r"Exception on processing|dealii::|unordered_map|\bstack dump\b")
SANITIZER = re.compile(r"ERROR: (Address|Leak)Sanitizer|runtime error: ")
CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f]")


class Done:
    """A run that ended: exit status (negative: a signal), what it printed, seconds, whether it had to be ended."""

    def __init__(self, command, status, output, errors, seconds, hung):
        self.command, self.status, self.output, self.errors = command, status, output, errors
        self.seconds, self.hung = seconds, hung

    def text(self):
        end = "ended for taking too long" if self.hung else f"exit status {self.status}"
        printed = self.output[-4000:] + self.errors[-4000:]
        return f"+ {' '.join(self.command)}\n{printed}-- {end} after {self.seconds:.1f} s\n"


class Program:
    """The program, and the limits of its runs: `time_limit` [s], `memory` [GB] of address space (0: none)."""

    def __init__(self, path, time_limit=120., memory=4):
        self.path, self.time_limit, self.memory = os.path.abspath(path), time_limit, memory

    def start(self, arguments, folder, environment=None, limits="", wrapper=(), ranks=1):
        """A running subprocess.Popen, of mpiexec where there are several ranks. `limits`: commands of a shell before the start (ulimit, trap)."""
        variables = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", DEAL_II_NUM_THREADS="1",
                         OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_hwloc_base_binding_policy="none",
                         PRTE_MCA_rmaps_default_mapping_policy=":oversubscribe",
                         PRTE_MCA_hwloc_default_binding_policy="none", OMPI_ALLOW_RUN_AS_ROOT="1",
                         OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMPI_MCA_mpi_yield_when_idle="1", LC_ALL="C.UTF-8")
        memory = f"ulimit -v {self.memory << 20}; " if self.memory else ""
        script = f"ulimit -c 0; {memory}{limits}{'; ' if limits else ''}exec {'env ' if environment else ''}\"$@\""
        # Set by env, for the program alone: the shell has none of it.
        variables_of_program = [f"{key}={value}" for key, value in (environment or {}).items()]
        launcher = ["mpiexec", "--bind-to", "none", "-n", str(ranks)] if ranks > 1 else []
        command = ["/bin/sh", "-c", script, "sh", *variables_of_program, *wrapper, *launcher, self.path, *arguments]
        return subprocess.Popen(command, cwd=folder, env=variables, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, start_new_session=True)

    def finish(self, process, arguments, time_limit=None):
        """Waits for the end, and brings it about when the time is over."""
        begin, hung = time.monotonic(), False
        try:
            output, errors = process.communicate(timeout=time_limit or self.time_limit)
        except subprocess.TimeoutExpired:
            hung = True
            end_group(process)
            output, errors = process.communicate()
        return Done([self.path, *arguments], process.returncode, output.decode("utf-8", "replace"),
                    errors.decode("utf-8", "replace"), time.monotonic() - begin, hung)

    def run(self, arguments, folder, environment=None, limits="", wrapper=(), time_limit=None, ranks=1):
        return self.finish(self.start(arguments, folder, environment, limits, wrapper, ranks), arguments, time_limit)


def family_of(process):
    """The process and all that it started: the ranks below mpiexec have groups of their own."""
    children = collections.defaultdict(list)
    for name in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{name}/stat", encoding="utf-8", errors="replace") as stream:
                children[int(stream.read().rpartition(")")[2].split()[1])].append(int(name))
        except OSError:
            pass
    family = [process.pid]
    for pid in family:
        family += children[pid]
    return family


def end_group(process):
    """Ends a process and all that it started."""
    for pid in family_of(process):
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass


def defect(done, names):
    """What is wrong with the way in which a run ended, or None. A run that did not end with 0 must have said why,
    naming one of `names` (no matter which one if there are none)."""
    if done.hung:
        return Verdict("hang", f"more than {done.seconds:.0f} s")
    if SANITIZER.search(done.errors):
        return Verdict("crash", "a sanitizer's report")
    if done.status < 0:
        return Verdict("crash", f"ended by {signal.Signals(-done.status).name}")
    if done.status not in (0, 1, 2):
        return Verdict("crash", f"exit status {done.status}")
    if done.status == 0:
        return None
    if not done.errors.strip():
        return Verdict("wrong", f"exit status {done.status} without a message")
    internal = INTERNAL.search(done.errors)
    if internal:
        return Verdict("wrong", f"the message is an internal text ('{internal.group(0)}')")
    if CONTROL.search(done.errors):
        return Verdict("wrong", "the message holds control characters")
    if names and not any(name in done.errors for name in names):
        return Verdict("wrong", f"exit status {done.status}, but the message names none of {', '.join(sorted(names))}")
    return None


def judge_reading(done, names):
    """Of input that may be right or not: refused before any work with 2 (Verdict), accepted (None), or a defect."""
    found = defect(done, names)
    if found:
        return found
    if done.status == 1:
        return Verdict("wrong", "wrong input ended with exit status 1 instead of 2")
    return Verdict("refused", "") if done.status == 2 else None
