"""Small runs that the attacks damage, and the question whether two runs have the same results."""

import collections
import csv
import io
import json
import os
import shutil
import sys
import threading
import time

from program import HERE, Verdict, defect, family_of

sys.path.append(os.path.join(HERE, "..", "drivers"))
import driver  # noqa: E402
import fields  # noqa: E402

CASES = os.path.join(HERE, "cases")
CASE = "channel.prm"
# So that the first part of the run stops between two checkpoints.
PARTLY = "Time/End time=2.5 ms"

# A run that is damaged: its file, its ranks, a region, an end time before that of PARTLY at which it has a checkpoint, and how far a restart may
# be from the run in one piece: 0 is byte for byte. Newton's iteration begins anew with another matrix, and ends within its tolerance. `any_order`:
# a restart may make the cells of a mesh that has adapted in another order, in which the states of fields have them. `longer`: the end time for attacks
# that must hit the run while it steps.
Run = collections.namedtuple("Run", "file ranks region shorter tolerance any_order longer", defaults=(False, "100 ms"))
RUNS = {"channel": Run(CASE, 1, "fluid", "1.5 ms", 0.),
        "adaptive": Run("adaptive.prm", 1, "fluid", "1.5 ms", 0., True),
        "beats": Run("beats.prm", 1, "body", "2 ms", 0., longer="40 ms"),
        "convection": Run("convection.prm", 1, "fluid", "1.5 ms", 1e-7),
        "finite": Run("finite.prm", 1, "body", "1.5 ms", 1e-7),
        "ranks": Run("adaptive.prm", 2, "fluid", "1.5 ms", 1e-9, longer="40 ms"),
        "moving": Run("moving.prm", 1, "fluid", "1.5 ms", 1e-7)}


def longer(run, overrides):
    """The overrides with the end time of a run that is long enough to be hit while it steps."""
    return [f"Time/End time={RUNS[run].longer}", *overrides]


def split_name(name):
    """The run of a trial, which stands before a colon, and the rest of its name. Without a colon it is the channel's."""
    run, colon, rest = name.partition(": ")
    return (run, rest) if colon else ("channel", name)


def joined_name(run, rest):
    return rest if run == "channel" else f"{run}: {rest}"


def runs_of_trials(number, seed):
    """The run of each trial. Few trials have one together, since each run costs undisturbed ones, too: the seed chooses it among all but the
    channel, which the corpus has already. Otherwise the runs take turns."""
    names = list(RUNS)
    if number < 20:
        return [names[1 + (seed - 1) % (len(names) - 1)]] * number
    return [names[count % len(names)] for count in range(number)]


class Made:
    """What belongs to a run, made when it is first asked for. Several trials ask at a time."""

    def __init__(self, make):
        self.make, self.made, self.lock = make, {}, threading.Lock()

    def __getitem__(self, run):
        with self.lock:
            if run not in self.made:
                self.made[run] = self.make(run)
            return self.made[run]


def as_options(overrides):
    return [argument for text in overrides for argument in ("--set", text)]


class AttackError(Exception):
    """The undisturbed run does not do what the attack needs."""


def copy_case(folder, file=CASE):
    """A small case with all that it reads, in a folder; its parameter file."""
    shutil.copytree(CASES, folder, dirs_exist_ok=True)
    for name in ("pulse.csv", "wall.prm"):
        make_long(os.path.join(folder, name))
    return os.path.join(folder, file)


def make_long(path):
    """Comments after the first line: what counts comes in the second block that is read."""
    with open(path, encoding="utf-8") as stream:
        first, *rest = stream.read().splitlines(True)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(first + ("# " + 77 * "." + "\n") * 120 + "".join(rest))


def corpus_lines(name):
    """Names of trials that once failed."""
    with open(os.path.join(HERE, "corpus", name), encoding="utf-8") as stream:
        return [line.rstrip("\n") for line in stream if line.strip() and not line.startswith("#")]


def corpus_files(name):
    """The same for an attack whose corpus is files: `corpus FILE`."""
    return sorted("corpus " + file for file in os.listdir(os.path.join(HERE, "corpus", name)))


def content(folder):
    """{name: bytes} of all files in a folder, but for the lock and what is left of temporary files."""
    result = {}
    for path, _, names in os.walk(folder):
        for name in names:
            whole = os.path.join(path, name)
            if os.path.isfile(whole) and not os.path.islink(whole):
                with open(whole, "rb") as stream:
                    result[os.path.relpath(whole, folder)] = stream.read()
    return result


def results(output):
    """{name: bytes} of what a run computed: tables, fields and their list, and of the summary what does not depend on
    the time that it took."""
    kept = {}
    for name, data in content(output).items():
        if name.endswith(".csv") and not name.startswith("input") or name == "fields.pvd" or name.startswith("fields/"):
            kept[name] = data
    try:
        with open(os.path.join(output, "summary.json"), encoding="utf-8") as stream:
            summary = json.load(stream)
        wanted = {key: summary.get(key) for key in ("status", "steps", "quantities", "checks")}
        kept["summary.json"] = json.dumps(wanted, indent=1).encode()
    except (OSError, ValueError) as error:
        kept["summary.json"] = str(error).encode()
    return kept


def difference(expected, output, whole=None):
    """In what the results in a folder differ from expected ones; empty if in nothing. With `whole`, the folder of the expected ones, the cells of
    a state of fields may stand in another order."""
    found = results(output)
    for name in sorted(set(expected) | set(found)):
        if name not in found:
            return f"{name} is not there"
        if name not in expected:
            return f"{name} is there, which the undisturbed run does not write"
        if expected[name] != found[name] and not (whole and name.startswith("fields/")):
            one, other = expected[name], found[name]
            place = next((i for i, (a, b) in enumerate(zip(one, other)) if a != b), min(len(one), len(other)))
            return f"{name} differs from byte {place} on ({len(other)} bytes, {len(one)} in the undisturbed run)"
    return difference_of_fields(whole, output) if whole else ""


def difference_of_fields(whole, output, tolerance=0.):
    """In what the states of fields of two runs differ, whose cells may stand in another order; empty if in nothing."""
    try:
        fields.compare_runs(whole, output, tolerance, any_order=True)
    except driver.TestFailure as problem:
        return str(problem)
    return ""


# Columns of power.csv that are nothing but round-off where the balance closes.
ROUND_OFF = ("residual [W]", "share [1]")


def numbers_differ(one, other, tolerance):
    """In what two tables differ by more than the tolerance, relative to the largest magnitude of the unit; empty if in nothing."""
    tables = [list(csv.reader(io.StringIO(data.decode("utf-8", "replace")))) for data in (one, other)]
    if tables[0][0] != tables[1][0] or [len(row) for row in tables[0]] != [len(row) for row in tables[1]]:
        return "has other columns or rows"
    try:
        columns = [[[float(cell) for cell in column] for column in zip(*table[1:])] for table in tables]
    except ValueError:
        return "" if one == other else "has gaps, and differs"
    largest = collections.defaultdict(float)
    for name, column in zip(tables[0][0], columns[0]):
        largest[driver.unit_of(name)] = max([largest[driver.unit_of(name)], *(abs(cell) for cell in column if cell == cell)])
    for name, column, other_column in zip(tables[0][0], *columns):
        if name in ROUND_OFF:
            continue
        if [cell != cell for cell in column] != [cell != cell for cell in other_column]:
            return f"lacks other numbers in '{name}'"
        worst = max((abs(a - b) for a, b in zip(column, other_column) if a == a), default=0.)
        if not worst <= tolerance * largest[driver.unit_of(name)]:
            return f"differs in '{name}' by {worst:.3g}"
    return ""


def near_difference(expected, whole, output, tolerance, files=True):
    """As difference(), for runs whose numbers are the same within a tolerance; `files`: the runs have files of the same names, too."""
    found = results(output)
    if not files:
        expected, found = ({name: data for name, data in of_run.items() if "/" not in name} for of_run in (expected, found))
    if set(found) != set(expected):
        return "other files are there: " + ", ".join(sorted(set(found) ^ set(expected)))
    for name in sorted(found):
        if name.endswith(".csv"):
            problem = numbers_differ(expected[name], found[name], tolerance)
            if problem:
                return f"{name} {problem}"
    steps = [json.loads(files["summary.json"]) for files in (expected, found)]
    if any(steps[0][key] != steps[1][key] for key in ("status", "steps")):
        return "summary.json has another status or number of steps"
    return difference_of_fields(whole, output, tolerance)


def processes_of_program(process, path):
    """The processes of a run: its ranks below mpiexec, or itself."""
    found = []
    for pid in family_of(process):
        try:
            if os.path.samefile(f"/proc/{pid}/exe", path):
                found.append(pid)
        except OSError:
            pass
    return found


def wait_until_open(process, path, time_limit, program=None):
    """The process that comes to have the file open, of a run of several ranks that of rank 0; None if there is none."""
    end = time.monotonic() + time_limit
    while process.poll() is None and time.monotonic() < end:
        for pid in processes_of_program(process, program) if program else [process.pid]:
            folder = f"/proc/{pid}/fd"
            try:
                if path in (os.readlink(os.path.join(folder, name)) for name in os.listdir(folder)):
                    return pid
            except OSError:
                pass
        time.sleep(0.0005)
    return None


def must_be_valid(program, folder, arguments):
    """The undisturbed input is accepted: else its refusal after a change would show nothing."""
    done = program.run([*arguments, "--validate"], folder)
    if done.status != 0:
        raise AttackError(f"the undisturbed input is refused\n{done.text()}")


class Reference:
    """The case, its undisturbed run (`whole`) and the same run up to a checkpoint in the middle (`partly`)."""

    def __init__(self, program, folder, overrides=(), run="channel"):
        self.program, self.folder, self.run = program, folder, RUNS[run]
        self.overrides = list(overrides)
        self.case = copy_case(os.path.join(folder, "case"), self.run.file)
        self.whole, self.partly = os.path.join(folder, "whole"), os.path.join(folder, "partly")
        self.seconds = self.to_the_end(self.arguments(self.whole))
        self.expected = results(self.whole)
        if "probes.csv" not in self.expected or not self.expected["summary.json"].startswith(b"{"):
            raise AttackError(f"the undisturbed run has no table or no summary: {sorted(self.expected)}")

    def start(self, arguments, folder, **more):
        return self.program.start(arguments, folder, ranks=self.run.ranks, **more)

    def perform(self, arguments, folder, **more):
        return self.program.run(arguments, folder, ranks=self.run.ranks, **more)

    def to_the_end(self, arguments):
        done = self.perform(arguments, self.folder)
        if done.status != 0:
            raise AttackError(f"the undisturbed run failed\n{done.text()}")
        return done.seconds

    def make_partly(self, end=PARTLY):
        """`end` takes the place of another end time."""
        overrides = [text for text in self.overrides if not text.startswith("Time/End time=")] + [end]
        self.to_the_end([self.case, "--output", self.partly, *as_options(overrides)])
        return self

    def arguments(self, output, *more):
        return [self.case, "--output", output, *as_options(self.overrides), *more]

    def difference(self, output):
        """In what the results in a folder differ from those of the undisturbed run; empty if in nothing."""
        if self.run.tolerance == 0.:
            return difference(self.expected, output, self.whole if self.run.any_order else None)
        return near_difference(self.expected, self.whole, output, self.run.tolerance)

    def ended_by_signal(self, status):
        """mpiexec says by its own status which signal ended a rank."""
        return status < 0 or (self.run.ranks > 1 and status > 128)

    def was_killed(self, status):
        return status == -9 or (self.run.ranks > 1 and status == 137)

    def names(self, output):
        """What a message may name: anything in the folder, and the input."""
        return {"/" + os.path.basename(output), *os.listdir(os.path.dirname(self.case))}

    def go_on(self, trial, output, had_checkpoint):
        """After a disturbance: --restart must reach the results of the undisturbed run; a run anew if there was no
        checkpoint."""
        if os.path.isdir(os.path.join(output, "checkpoint")):
            done = trial.note(self.perform(self.arguments(output, "--restart"), trial.folder))
            found = defect(done, ())
            if found:
                return Verdict(found.kind, "the restart after it: " + found.note)
            if done.status == 0:
                found = self.difference(output)
                return Verdict("lost", "the restart after it: " + found) if found else None
            if had_checkpoint:
                return Verdict("lost", f"a checkpoint was complete, but the restart ends with {done.status}")
            if done.status == 1:
                return Verdict("wrong", "the restart without a complete checkpoint ends with 1 instead of 2")
        elif had_checkpoint:
            return Verdict("lost", "the folder of the checkpoint is gone")
        done = trial.note(self.perform(self.arguments(output, "--overwrite"), trial.folder))
        if done.status != 0:
            found = defect(done, ()) or Verdict("wrong", f"exit status {done.status}")
            return Verdict(found.kind, "the run anew after it: " + found.note)
        found = self.difference(output)
        return Verdict("wrong", "the run anew after it: " + found) if found else None
