#!/usr/bin/python3
"""Checks runs whose mesh and partition change all the time: mesh_changes.py PROGRAM CASE.prm WORKING_FOLDER.

One rank is compared with several ranks and with a run in pieces, each piece on another number of ranks. Header comments
of the case:

    # changes: 25              the mesh changes at least so often
    # of equal size: 2         on all numbers of ranks together at least so many of these changes keep the number of unknowns
                               and move the partition: every vector keeps its global size and changes its layout
    # ranks: 2, 3              the numbers of ranks that are compared with one
    # pieces: 2, 3, 1          the ranks of each piece of the run in pieces
    # stops: 10 ms, 20 ms      where all pieces but the last end
    # tolerance: 1e-8          of probes.csv, relative to the largest magnitude of each column
    # floor: 1e-12             magnitude below which a column of probes.csv counts as zero (default 0)
    # power tolerance: 1e-8    of power.csv, relative to the largest magnitude of each unit: powers in W, energies and the
                               energy that changes of the mesh bring in J

The residual of the power and its share are round-off; they are not compared.
"""

import os
import re

import choices
import driver


def list_of(entries, key):
    return [text.strip() for text in driver.single(entries, key, "").split(",") if text.strip()]


def changes_of_mesh(output):
    """(number of unknowns, cells of each rank) after each change of the mesh, as log.txt shows them."""
    with open(os.path.join(output, "log.txt"), encoding="utf-8") as stream:
        return re.findall(r"(\S+) unknowns; cells of each rank: (.*)$", stream.read(), re.MULTILINE)


def compare(one, other, entries):
    driver.compare_tables(os.path.join(one, "probes.csv"), os.path.join(other, "probes.csv"),
                          float(driver.single(entries, "tolerance", "1e-8")),
                          float(driver.single(entries, "floor", "0")))
    driver.compare_tables(os.path.join(one, "power.csv"), os.path.join(other, "power.csv"),
                          float(driver.single(entries, "power tolerance", "1e-8")), floor_share=1.,
                          left_out=("residual [W]", "share [1]"))


def case(program, parameter_file, folder):
    entries = driver.header(parameter_file)
    pieces, stops = list_of(entries, "pieces"), list_of(entries, "stops")
    if pieces and len(stops) != len(pieces) - 1:
        raise driver.TestFailure("the header needs one stop between each piece and the next")
    one = os.path.join(folder, "1-rank")
    driver.run_to_the_end(program, [parameter_file, "--output", one], 1, folder, time_limit=3600)
    n_equal = 0
    for ranks in list_of(entries, "ranks"):
        other = os.path.join(folder, f"{ranks}-ranks")
        driver.run_to_the_end(program, [parameter_file, "--output", other], int(ranks), folder, time_limit=3600)
        print(f"{ranks} ranks against one")
        choices.compare_choices(one, other)
        compare(one, other, entries)
        changes = changes_of_mesh(other)
        n_equal += sum(a[0] == b[0] and a[1] != b[1] for a, b in zip(changes, changes[1:]))
        print(f"{len(changes)} changes of the mesh; {n_equal} so far keep the number of unknowns and move the partition")
        if len(changes) < int(driver.single(entries, "changes", "1")):
            raise driver.TestFailure("the mesh changes too seldom")
    if n_equal < int(driver.single(entries, "of equal size", "0")):
        raise driver.TestFailure("too few changes keep the number of unknowns and move the partition")

    if not pieces:
        return
    whole = os.path.join(folder, "pieces")
    for number, ranks in enumerate(pieces):
        arguments = [parameter_file, "--output", whole]
        arguments += ["--restart"] if number > 0 else []
        arguments += driver.overrides([f"Time/End time = {stops[number]}"] if number < len(stops) else [])
        driver.run_to_the_end(program, arguments, int(ranks), folder, time_limit=3600)
    print(f"pieces on {', '.join(pieces)} ranks against one run on one rank")
    compare(one, whole, entries)


if __name__ == "__main__":
    driver.main(case)
