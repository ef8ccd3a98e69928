#!/usr/bin/python3
"""Checks the output folder: output_folder.py PROGRAM CASE.prm WORKING_FOLDER. Nothing in it is lost, and nothing left.

Header comments of the case:

    # shows: one run at a time     what is checked; one of the functions below, in words
    # set: Time/End time = 1 s     none or more; overrides of all runs
    # first: ../runs/beams/beam.prm -> modes.csv, wave-*.csv    for `overwrite`: one or more; a run that was in the folder
                                                                before, and what it must have left there
    # signal: SIGTERM              for `signal in the set-up`: which one
    # limit: 3000                  for `full disk`: no file may have more bytes, once the run has begun
    # in the way: NAME             or: this folder stands where the run writes
    # expect: REGEX                what is printed then
"""

import fnmatch
import json
import os
import re
import resource
import signal
import subprocess

import driver
from restart import Background, content, summary_of

OF_THE_USER = "of the user\n"


def names_in(folder):
    """Files and folders below a folder, without what depends on the run: pieces of a checkpoint and of the fields."""
    found = set()
    for path, folders, files in os.walk(folder):
        found.update(os.path.relpath(os.path.join(path, name), folder) for name in folders + files)
    return found


def overwrite(program, parameter_file, folder, entries, common):
    """What runs of other analyses have left goes, what the user has put beside it stays."""
    alone = os.path.join(folder, "alone")
    driver.run_to_the_end(program, [parameter_file, "--output", alone, *common], folder=folder)
    wanted = names_in(alone)
    documentation = json.loads(driver.run_to_the_end(program, ["--print-parameters=json"], folder=folder).stdout)
    performed = {summary_of(alone)["analysis"]}
    for first in entries["first"]:
        name, _, tables = (part.strip() for part in first.partition("->"))
        output = os.path.join(folder, os.path.basename(name)[:-4])
        arguments = [os.path.join(os.path.dirname(parameter_file), name), "--output", output]
        driver.run_to_the_end(program, arguments, folder=folder)
        before = names_in(output)
        performed.add(summary_of(output)["analysis"])
        for table in tables.split(","):
            if not fnmatch.filter(before, table.strip()):
                raise driver.TestFailure(f"{name} has written no {table.strip()}: the test shows nothing")
        runs = {os.path.dirname(path) for path in before if os.path.basename(path) == "summary.json"}
        own = {os.path.join(run, file) for run in runs
               for file in ("notes.txt", "wave-own.csv", "harmonic-own.csv", "fields/view.pvsm")}
        for file in own:
            with open(os.path.join(output, file), "w", encoding="utf-8") as stream:
                stream.write(OF_THE_USER)
        driver.run_to_the_end(program, [parameter_file, "--output", output, "--overwrite", *common], folder=folder)
        left = names_in(output)
        kept = own | {os.path.dirname(file) for file in own} - {""}
        if left != wanted | kept:
            raise driver.TestFailure(f"after {name} an overwrite leaves {sorted(left - wanted - kept)} "
                                     f"and lacks {sorted((wanted | kept) - left)}")
        for file in own:
            with open(os.path.join(output, file), encoding="utf-8") as stream:
                if stream.read() != OF_THE_USER:
                    raise driver.TestFailure(f"{file} has changed")
    # A new analysis must come here.
    analyses, = (entry["values"].split(", ") for entry in documentation if entry["path"] == "Analysis")
    if set(analyses) != performed:
        raise driver.TestFailure(f"no file is run whose Analysis is one of {sorted(set(analyses) - performed)}")


def one_run_at_a_time(program, parameter_file, folder, entries, common):
    """Who comes while a run works in the folder is refused and changes nothing; after kill -9 the next one goes on."""
    output = os.path.join(folder, "run")
    arguments = [parameter_file, "--output", output, *common]
    run = Background(program, arguments)
    try:
        current = os.path.join(output, "checkpoint", "current")
        run.wait_for(lambda: os.path.exists(current), "it had a checkpoint")
        # Its files stand still.
        os.kill(run.process.pid, signal.SIGSTOP)
        before = content(output)
        for option in ([], ["--overwrite"], ["--restart"]):
            done = driver.run(program, [*arguments, *option], folder=folder)
            pattern = f"another run works in this folder: process {run.process.pid} on {os.uname().nodename} since 20"
            if done.returncode != 2 or not re.search(pattern, done.stderr):
                raise driver.TestFailure(f"exit status {done.returncode} instead of 2 with {option}, "
                                         f"or not '{pattern}':\n{done.stderr}")
            if content(output) != before:
                raise driver.TestFailure(f"the run that was refused with {option} changed the folder")
        driver.run_to_the_end(program, [*arguments, "--validate"], folder=folder)
    finally:
        run.kill()
    if not os.path.exists(os.path.join(output, "lock")):
        raise driver.TestFailure("there is no file 'lock' after kill -9: the test shows nothing")
    # Two restarts at once: one goes on.
    pair = [Background(program, [*arguments, "--restart"]) for _ in range(2)]
    ends = sorted(run.process.wait(timeout=120) for run in pair)
    errors = "".join(run.process.communicate()[1] for run in pair)
    if ends != [0, 2] or "another run works in this folder" not in errors:
        raise driver.TestFailure(f"two restarts at once end with {ends}:\n{errors}")
    if os.path.exists(os.path.join(output, "lock")):
        raise driver.TestFailure("the run is over and its lock is left")
    whole = os.path.join(folder, "whole")
    driver.run_to_the_end(program, [parameter_file, "--output", whole, *common], folder=folder)
    for name in ("probes.csv", "power.csv", "fields.pvd"):
        if content(output)[os.path.join(output, name)] != content(whole)[os.path.join(whole, name)]:
            raise driver.TestFailure(f"{name} is not that of a run in one piece")


def signal_in_the_set_up(program, parameter_file, folder, entries, common):
    """A signal before the first step ends the run in order."""
    output = os.path.join(folder, "run")
    name = driver.single(entries, "signal")
    run = Background(program, [parameter_file, "--output", output, *common])
    parameters = os.path.join(output, "parameters.prm")
    run.wait_for(lambda: os.path.exists(parameters), "it could be interrupted")
    for _ in range(2):
        os.kill(run.process.pid, getattr(signal, name))
    errors = run.process.communicate(timeout=120)[1]
    pattern = f"interrupted by {name} in the set-up, after .*--overwrite"
    if run.process.returncode != 1 or not re.search(pattern, errors):
        raise driver.TestFailure(f"exit status {run.process.returncode} after {name}\n{errors}")
    if summary_of(output)["status"] != "interrupted":
        raise driver.TestFailure(f"the summary says '{summary_of(output)['status']}'")
    if os.path.exists(os.path.join(output, "probes.csv")):
        raise driver.TestFailure("the run was not interrupted in its set-up")


def closed_screen(program, parameter_file, folder, entries, common):
    """Nobody reads what the run prints: it goes on to its end."""
    output = os.path.join(folder, "run")
    reader, writer = os.pipe()
    os.close(reader)
    done = subprocess.run([program, parameter_file, "--output", output, *common], env=driver.environment(),
                          stdout=writer, stderr=subprocess.PIPE, text=True, timeout=300, check=False)
    os.close(writer)
    if done.returncode != 0 or summary_of(output)["status"] != "finished":
        raise driver.TestFailure(f"exit status {done.returncode}\n{done.stderr}")


def full_disk(program, parameter_file, folder, entries, common):
    """A limit on the size of files stands for a full disk: the program itself names file and reason."""
    output = os.path.join(folder, "run")
    for name in entries.get("in the way", []):
        os.makedirs(os.path.join(output, name))
    run = Background(program, [parameter_file, "--output", output, *common])
    if "limit" in entries:
        limit = int(driver.single(entries, "limit"))
        parameters = os.path.join(output, "parameters.prm")
        run.wait_for(lambda: os.path.exists(parameters), "its disk could be full")
        resource.prlimit(run.process.pid, resource.RLIMIT_FSIZE, (limit, limit))
    errors = run.process.communicate(timeout=120)[1]
    print(errors)
    if run.process.returncode != 1:
        raise driver.TestFailure(f"exit status {run.process.returncode} instead of 1")
    for pattern in entries["expect"]:
        if not re.search(pattern, errors):
            raise driver.TestFailure(f"nothing printed matches '{pattern}'")
    if re.search("An error occurred|violated condition|deal.II", errors):
        raise driver.TestFailure("the message is that of a library")


SHOWN = {function.__name__.replace("_", " "): function
         for function in (overwrite, one_run_at_a_time, closed_screen, full_disk)}
SHOWN["signal in the set-up"] = signal_in_the_set_up


def case(program, parameter_file, folder):
    entries = driver.header(parameter_file)
    what = driver.single(entries, "shows")
    if what not in SHOWN:
        raise driver.TestFailure(f"the header needs '# shows: ' one of {', '.join(SHOWN)}")
    SHOWN[what](program, parameter_file, folder, entries, driver.overrides(entries.get("set", [])))


if __name__ == "__main__":
    driver.main(case)
