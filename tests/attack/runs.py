"""Small runs that the attacks damage, and the question whether two runs have the same results, byte for byte."""

import json
import os
import shutil
import time

from program import HERE, Verdict, defect

CASES = os.path.join(HERE, "cases")
CASE = "channel.prm"
# So that the first part of the run stops between two checkpoints.
PARTLY = "Time/End time=2.5 ms"


def as_options(overrides):
    return [argument for text in overrides for argument in ("--set", text)]


class AttackError(Exception):
    """The undisturbed run does not do what the attack needs."""


def copy_case(folder):
    """The small case with all that it reads, in a folder; its parameter file."""
    shutil.copytree(CASES, folder, dirs_exist_ok=True)
    for name in ("pulse.csv", "wall.prm"):
        make_long(os.path.join(folder, name))
    return os.path.join(folder, CASE)


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


def difference(expected, output):
    """In what the results in a folder differ from expected ones; empty if in nothing."""
    found = results(output)
    for name in sorted(set(expected) | set(found)):
        if name not in found:
            return f"{name} is not there"
        if name not in expected:
            return f"{name} is there, which the undisturbed run does not write"
        if expected[name] != found[name]:
            one, other = expected[name], found[name]
            place = next((i for i, (a, b) in enumerate(zip(one, other)) if a != b), min(len(one), len(other)))
            return f"{name} differs from byte {place} on ({len(other)} bytes, {len(one)} in the undisturbed run)"
    return ""


def wait_until_open(process, path, time_limit):
    """Whether the process comes to have the file open."""
    end, folder = time.monotonic() + time_limit, f"/proc/{process.pid}/fd"
    while process.poll() is None and time.monotonic() < end:
        try:
            if path in (os.readlink(os.path.join(folder, name)) for name in os.listdir(folder)):
                return True
        except OSError:
            pass
        time.sleep(0.0005)
    return False


def must_be_valid(program, folder, arguments):
    """The undisturbed input is accepted: else its refusal after a change would show nothing."""
    done = program.run([*arguments, "--validate"], folder)
    if done.status != 0:
        raise AttackError(f"the undisturbed input is refused\n{done.text()}")


class Reference:
    """The case, its undisturbed run (`whole`) and the same run up to a checkpoint in the middle (`partly`)."""

    def __init__(self, program, folder, overrides=()):
        self.program, self.folder = program, folder
        self.overrides = list(overrides)
        self.case = copy_case(os.path.join(folder, "case"))
        self.whole, self.partly = os.path.join(folder, "whole"), os.path.join(folder, "partly")
        self.seconds = self.to_the_end(self.arguments(self.whole))
        self.expected = results(self.whole)
        if "probes.csv" not in self.expected or not self.expected["summary.json"].startswith(b"{"):
            raise AttackError(f"the undisturbed run has no table or no summary: {sorted(self.expected)}")

    def to_the_end(self, arguments):
        done = self.program.run(arguments, self.folder)
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

    def names(self, output):
        """What a message may name: anything in the folder, and the input."""
        return {"/" + os.path.basename(output), *os.listdir(os.path.dirname(self.case))}

    def go_on(self, trial, output, had_checkpoint):
        """After a disturbance: --restart must reach the results of the undisturbed run; a run anew if there was no
        checkpoint."""
        if os.path.isdir(os.path.join(output, "checkpoint")):
            done = trial.note(self.program.run(self.arguments(output, "--restart"), trial.folder))
            found = defect(done, ())
            if found:
                return Verdict(found.kind, "the restart after it: " + found.note)
            if done.status == 0:
                found = difference(self.expected, output)
                return Verdict("lost", "the restart after it: " + found) if found else None
            if had_checkpoint:
                return Verdict("lost", f"a checkpoint was complete, but the restart ends with {done.status}")
            if done.status == 1:
                return Verdict("wrong", "the restart without a complete checkpoint ends with 1 instead of 2")
        elif had_checkpoint:
            return Verdict("lost", "the folder of the checkpoint is gone")
        done = trial.note(self.program.run(self.arguments(output, "--overwrite"), trial.folder))
        if done.status != 0:
            found = defect(done, ()) or Verdict("wrong", f"exit status {done.status}")
            return Verdict(found.kind, "the run anew after it: " + found.note)
        found = difference(self.expected, output)
        return Verdict("wrong", "the run anew after it: " + found) if found else None
