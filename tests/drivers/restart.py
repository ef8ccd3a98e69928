#!/usr/bin/python3
"""Checks that a run in pieces gives what one run gives: restart.py PROGRAM CASE.prm WORKING_FOLDER.

Header comments of the case:

    # stop: Time/End time = 5 ms     what ends the first piece; it must leave a checkpoint
    # kill: first checkpoint         instead: the first piece is killed as soon as it has written a checkpoint
    # kill: 5 writings               instead: so many pieces are killed at random moments while they write a checkpoint
    # signal: SIGTERM                instead: the first piece gets this signal, on several ranks one of them, after its first steps
    # repeated: SIGUSR1              and then this one again and again until it has ended
    # set: Checkpoint/Steps = 10     none or more; overrides of all runs
    # set in the whole run: KEY = VALUE   none or more; what the second piece takes from the checkpoint and the whole run must be given
    # ranks: 1                       ranks of the whole run and of the first piece (default 1)
    # restart ranks: 1               ranks of the second piece (default: the same)
    # refused: Mesh/Axial cells = 7 -> PATTERN   none or more; a restart with this override is refused for this reason
    # refused without: checkpoint/*/rank-0 -> PATTERN   none or more; so is one without this file
    # refused with a bit changed in: FILE -> PATTERN    or with a damaged one
    # refused with half of: FILE -> PATTERN             or with one that is cut
    # tolerance: 0                   0 (default): tables, fields, fields.pvd and quantities agree to the last bit;
                                     otherwise tables as in ranks.py, and fields relative to their largest magnitude
    # floor: 0                       as in ranks.py
    # cells: in another order        the mesh changes: the fields are those of the same cells, whose order may differ

Runs on several ranks write pieces: their cells are those of all pieces, in any order.
"""

import glob
import json
import os
import random
import re
import signal
import subprocess
import time

import driver
import fields


def compare(first, second, tolerance, floor):
    # The first of the beats has none before it to differ from.
    gaps = os.path.basename(first) == "beats.csv"
    if tolerance > 0:
        # Refinement alone changes the energy by round-off.
        driver.compare_tables(first, second, tolerance, floor,
                              left_out=("residual [W]", "share [1]", "energy change by transfer [J]"), gaps=gaps)
        return
    driver.read_table(first, gaps)
    with open(first, encoding="utf-8") as stream:
        rows = stream.read().splitlines()
    with open(second, encoding="utf-8") as stream:
        other_rows = stream.read().splitlines()
    for line, (row, other) in enumerate(zip(rows, other_rows), 1):
        if row != other:
            raise driver.TestFailure(f"line {line} differs:\n{row}\nin {first},\n{other}\nin {second}")
    if len(rows) != len(other_rows):
        raise driver.TestFailure(f"{len(rows)} lines in {first}, {len(other_rows)} in {second}")


def summary_of(output):
    with open(os.path.join(output, "summary.json"), encoding="utf-8") as stream:
        return json.load(stream)


def compare_summaries(whole, pieces, n_restarts, tolerance):
    one, other = summary_of(whole), summary_of(pieces)
    for key in ("status", "steps"):
        if one[key] != other[key]:
            raise driver.TestFailure(f"'{key}' of the summary is {one[key]} in one run and {other[key]} in pieces")
    # Numbers in them may be those of a piece, whose end is another.
    texts = lambda summary: {re.sub(r"[0-9.]+(e[-+]?[0-9]+)?", "#", text) for text in summary["warnings"]}
    lost = texts(one) - texts(other)
    if lost:
        raise driver.TestFailure(f"the summary of the run in pieces lost the warnings {lost}")
    # A piece that was killed before its first checkpoint is none of those that led here.
    if not 1 <= other.get("restarts", 0) <= n_restarts:
        raise driver.TestFailure(f"the summary counts {other.get('restarts')} restarts, there were {n_restarts}")
    quantities, others = ([(q["name"], q["probe"], q["value"] if tolerance == 0 else None) for q in summary["quantities"]]
                          for summary in (one, other))
    if quantities != others:
        raise driver.TestFailure(f"quantities differ: {sorted(set(quantities) ^ set(others), key=str)}")


def listed_fields(output):
    """[(time, base name of the state)] of fields.pvd; every file in the folder belongs to one of them."""
    path = os.path.join(output, "fields.pvd")
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as stream:
        entries = re.findall(r'timestep="([^"]*)" part="0" file="fields/(solution-\d+)\.p?vtu"', stream.read())
    states = [name for _, name in entries]
    for name in os.listdir(os.path.join(output, "fields")):
        if name.split(".")[0] not in states:
            raise driver.TestFailure(f"fields/{name} belongs to no state in fields.pvd")
    return entries


class Background:
    """A run that goes on while the driver looks at it."""

    def __init__(self, program, arguments, ranks=1):
        command = driver.on_ranks([program, *arguments], ranks)
        print("+", " ".join(command), "&", flush=True)
        # A limit on the size of files ends no process: it stands for a full disk.
        self.process = subprocess.Popen(command, env=driver.environment(), stdin=subprocess.DEVNULL,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                                        preexec_fn=lambda: signal.signal(signal.SIGXFSZ, signal.SIG_IGN))
        self.ranks = ranks

    def wait_for(self, condition, what, time_limit=60):
        end = time.monotonic() + time_limit
        while not condition():
            if self.process.poll() is not None or time.monotonic() > end:
                self.process.kill()
                raise driver.TestFailure(f"the run ended, or took too long, before {what}:\n{self.process.communicate()[1]}")
            time.sleep(0.0005)

    def kill(self):
        self.process.kill()
        self.process.communicate()

    def one_rank(self):
        """The process of the last rank."""
        if self.ranks == 1:
            return self.process.pid
        with open(f"/proc/{self.process.pid}/task/{self.process.pid}/children", encoding="ascii") as stream:
            return int(stream.read().split()[-1])


def is_being_written(output):
    """Whether there is a checkpoint that is not the current one."""
    folder = os.path.join(output, "checkpoint")
    try:
        with open(os.path.join(folder, "current"), encoding="ascii") as stream:
            current = stream.read().strip()
        return any(name.isdigit() and name != current for name in os.listdir(folder))
    except OSError:
        return False


def n_rows(output, name="probes.csv"):
    try:
        with open(os.path.join(output, name), encoding="utf-8") as stream:
            return sum(1 for _ in stream) - 1
    except OSError:
        return 0


def run_until_checkpoint(program, arguments, output):
    """Kills the run, as a batch system or a power cut would, when it has written its first checkpoint."""
    run = Background(program, arguments)
    run.wait_for(lambda: os.path.exists(os.path.join(output, "checkpoint", "current")), "it could be killed at a checkpoint")
    run.kill()


def kill_writings(program, arguments, output, number):
    """Kills one piece after another within the time that it takes to write a checkpoint."""
    randomly = random.Random(1)
    n_within = 0
    for piece in range(number):
        run = Background(program, [*arguments, *(["--restart"] if piece > 0 else [])])
        if piece > 0:
            # What an earlier piece left is gone once the run goes on.
            run.wait_for(lambda: not is_being_written(output), "it had removed the checkpoint that was not finished")
        run.wait_for(lambda: is_being_written(output), "it wrote a checkpoint")
        time.sleep(randomly.choice((0., 0.0005, 0.001, 0.002, 0.004)))
        run.kill()
        n_within += is_being_written(output)
    print(f"{n_within} of {number} were killed within the writing")
    if n_within == 0:
        raise driver.TestFailure("none was killed within the writing: the test shows nothing")


def interrupt(program, arguments, output, ranks, name, repeated):
    run = Background(program, arguments, ranks)
    run.wait_for(lambda: os.path.exists(os.path.join(output, "probes.csv")), "it could be interrupted")
    os.kill(run.one_rank(), getattr(signal, name))
    while repeated and run.process.poll() is None:
        os.kill(run.one_rank(), getattr(signal, repeated))
        time.sleep(0.0002)
    errors = run.process.communicate(timeout=60)[1]
    if run.process.returncode != 1:
        raise driver.TestFailure(f"exit status {run.process.returncode} after {name}\n{errors}")
    if f"interrupted by {name}" not in errors or "--restart" not in errors:
        raise driver.TestFailure(f"the message after {name} is:\n{errors}")
    status = summary_of(output)["status"]
    if status != "interrupted":
        raise driver.TestFailure(f"the summary says '{status}' after {name}")


def content(folder):
    """All files in a folder, byte by byte."""
    result = {}
    for path, _, names in os.walk(folder):
        for name in names:
            with open(os.path.join(path, name), "rb") as stream:
                result[os.path.join(path, name)] = stream.read()
    return result


def expect_refusal(program, arguments, output, pattern, folder):
    """Exit status 2, the reason, and nothing in the folder touched."""
    before = content(output)
    done = driver.run(program, arguments, 1, folder)
    if done.returncode != 2 or not re.search(pattern, done.stderr):
        raise driver.TestFailure(f"exit status {done.returncode} instead of 2, or another reason than '{pattern}':\n{done.stderr}")
    if content(output) != before:
        raise driver.TestFailure("the restart that was refused changed the folder")


def refusals(program, arguments, output, entries, folder):
    def split(text):
        return (part.strip() for part in text.split("->", 1))

    for entry in entries.get("refused", []):
        override, pattern = split(entry)
        expect_refusal(program, [*arguments, *driver.overrides([override])], output, pattern, folder)
    for key in ("refused without", "refused with a bit changed in", "refused with half of"):
        for entry in entries.get(key, []):
            name, pattern = split(entry)
            path, = glob.glob(os.path.join(output, name))
            with open(path, "rb") as stream:
                whole = stream.read()
            os.remove(path)
            if key != "refused without":
                with open(path, "wb") as stream:
                    stream.write(whole[:len(whole) // 2] if key.endswith("half of")
                                 else whole[:-30] + bytes([whole[-30] ^ 1]) + whole[-29:])
            expect_refusal(program, arguments, output, pattern, folder)
            with open(path, "wb") as stream:
                stream.write(whole)


def case(program, parameter_file, folder):
    entries = driver.header(parameter_file)
    stop = entries.get("stop", [])
    kill, signal_name = driver.single(entries, "kill", ""), driver.single(entries, "signal", "")
    if bool(stop) + bool(kill) + bool(signal_name) != 1:
        raise driver.TestFailure("the header needs '# stop: KEY = VALUE', '# kill: ...' or '# signal: NAME'")
    common = driver.overrides(entries.get("set", []))
    ranks = int(driver.single(entries, "ranks", "1"))
    restart_ranks = int(driver.single(entries, "restart ranks", str(ranks)))
    tolerance = float(driver.single(entries, "tolerance", "0"))
    floor = float(driver.single(entries, "floor", "0"))

    whole, pieces = os.path.join(folder, "whole"), os.path.join(folder, "pieces")
    of_whole = driver.overrides(entries.get("set in the whole run", []))
    driver.run_to_the_end(program, [parameter_file, "--output", whole, *common, *of_whole], ranks, folder)
    first_piece = [parameter_file, "--output", pieces, *common]
    n_restarts = 1
    if kill == "first checkpoint":
        run_until_checkpoint(program, first_piece, pieces)
    elif kill:
        n_restarts = int(kill.split()[0])
        kill_writings(program, first_piece, pieces, n_restarts)
    elif signal_name:
        interrupt(program, first_piece, pieces, ranks, signal_name, driver.single(entries, "repeated", ""))
    else:
        driver.run_to_the_end(program, [*first_piece, *driver.overrides(stop)], ranks, folder)
    if n_rows(pieces) >= n_rows(whole):
        raise driver.TestFailure(f"the first piece has {n_rows(pieces)} rows of {n_rows(whole)}: nothing is left to restart")
    second_piece = [parameter_file, "--output", pieces, "--restart", *common]
    refusals(program, second_piece, pieces, entries, folder)
    driver.run_to_the_end(program, second_piece, restart_ranks, folder)

    for name in ("probes.csv", "beats.csv", "power.csv", "residuals.csv"):
        if name == "probes.csv" or os.path.exists(os.path.join(whole, name)):
            compare(os.path.join(whole, name), os.path.join(pieces, name), tolerance, floor)
    if listed_fields(whole) != listed_fields(pieces):
        raise driver.TestFailure(f"fields.pvd lists {listed_fields(whole)} in one run and {listed_fields(pieces)} in pieces")
    any_order = driver.single(entries, "cells") == "in another order" or tolerance > 0
    n_compared = fields.compare_runs(whole, pieces, tolerance, floor, any_order)
    print(f"{n_compared} states of fields agree")
    compare_summaries(whole, pieces, n_restarts, tolerance)


if __name__ == "__main__":
    driver.main(case)
