#!/usr/bin/python3
"""Checks that a run in two pieces gives what one run gives: restart.py PROGRAM CASE.prm WORKING_FOLDER.

Header comments of the case:

    # stop: Time/End time = 5 ms     what ends the first piece; it must leave a checkpoint
    # kill: first checkpoint         instead: the first piece is killed as soon as it has written a checkpoint
    # set: Checkpoint/Steps = 10     none or more; overrides of all runs
    # set in the whole run: KEY = VALUE   none or more; what the second piece takes from the checkpoint and the whole run must be given
    # ranks: 1                       ranks of the whole run and of the first piece (default 1)
    # restart ranks: 1               ranks of the second piece (default: the same)
    # tolerance: 0                   0 (default): probes.csv and power.csv agree byte by byte; otherwise as in ranks.py
"""

import os
import subprocess
import time

import driver


def compare(first, second, tolerance):
    if tolerance > 0:
        driver.compare_tables(first, second, tolerance, left_out=("residual [W]", "share [1]"))
        return
    driver.read_table(first)
    with open(first, encoding="utf-8") as stream:
        rows = stream.read().splitlines()
    with open(second, encoding="utf-8") as stream:
        other_rows = stream.read().splitlines()
    for line, (row, other) in enumerate(zip(rows, other_rows), 1):
        if row != other:
            raise driver.TestFailure(f"line {line} differs:\n{row}\nin {first},\n{other}\nin {second}")
    if len(rows) != len(other_rows):
        raise driver.TestFailure(f"{len(rows)} lines in {first}, {len(other_rows)} in {second}")


def run_until_checkpoint(program, arguments, output, time_limit=60):
    """Kills the run, as a batch system or a power cut would, when it has written its first checkpoint."""
    current = os.path.join(output, "checkpoint", "current")
    with subprocess.Popen([program, *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        end = time.monotonic() + time_limit
        while not os.path.exists(current) and process.poll() is None and time.monotonic() < end:
            time.sleep(0.002)
        if process.poll() is not None or not os.path.exists(current):
            process.kill()
            raise driver.TestFailure("the run ended, or took too long, before it could be killed at a checkpoint")
        process.kill()


def case(program, parameter_file, folder):
    entries = driver.header(parameter_file)
    stop = entries.get("stop", [])
    kill = driver.single(entries, "kill", "")
    if not stop and kill != "first checkpoint":
        raise driver.TestFailure("the header needs '# stop: KEY = VALUE' or '# kill: first checkpoint'")
    common = driver.overrides(entries.get("set", []))
    ranks = int(driver.single(entries, "ranks", "1"))
    restart_ranks = int(driver.single(entries, "restart ranks", str(ranks)))
    tolerance = float(driver.single(entries, "tolerance", "0"))

    whole, pieces = os.path.join(folder, "whole"), os.path.join(folder, "pieces")
    of_whole = driver.overrides(entries.get("set in the whole run", []))
    driver.run_to_the_end(program, [parameter_file, "--output", whole, *common, *of_whole], ranks, folder)
    if kill:
        run_until_checkpoint(program, [parameter_file, "--output", pieces, *common], pieces)
    else:
        driver.run_to_the_end(program, [parameter_file, "--output", pieces, *common, *driver.overrides(stop)], ranks, folder)
    n_whole = len(driver.read_table(os.path.join(whole, "probes.csv"))[1])
    n_half = len(driver.read_table(os.path.join(pieces, "probes.csv"))[1])
    if n_half >= n_whole:
        raise driver.TestFailure(f"the first piece has {n_half} rows of {n_whole}: nothing is left to restart")
    driver.run_to_the_end(program, [parameter_file, "--output", pieces, "--restart", *common], restart_ranks, folder)

    for name in ("probes.csv", "power.csv"):
        if name == "probes.csv" or os.path.exists(os.path.join(whole, name)):
            compare(os.path.join(whole, name), os.path.join(pieces, name), tolerance)


if __name__ == "__main__":
    driver.main(case)
