#!/usr/bin/python3
"""Adds up columns of probes.csv that must cancel at all times: balance.py PROGRAM CASE.prm WORKING_FOLDER.

Header comments of the case:

    # term: FACTOR * COLUMN   once for each column: its name without the unit, "lumen: volume change"
    # tolerance: 1e-10        of the largest term at any time, for the sum at all times
"""

import os

import driver


def case(program, parameter_file, folder):
    entries = driver.header(parameter_file)
    tolerance = float(driver.single(entries, "tolerance"))
    output = os.path.join(folder, "run")
    driver.run_to_the_end(program, [parameter_file, "--output", output], folder=folder)
    names, rows = driver.read_table(os.path.join(output, "probes.csv"))
    columns = [name.rpartition(" [")[0] for name in names]
    terms = []
    for term in entries["term"]:
        factor, _, name = term.partition(" * ")
        if name not in columns:
            raise driver.TestFailure(f"probes.csv has no column '{name}'; it has {columns}")
        terms.append((float(factor), columns.index(name)))
    largest = {column: max(abs(factor * row[column]) for row in rows) for factor, column in terms}
    if min(largest.values()) == 0.0:
        raise driver.TestFailure("a term is zero at all times: the test shows nothing")
    residual, time = max((abs(sum(factor * row[column] for factor, column in terms)), row[0]) for row in rows)
    scale = max(largest.values())
    print(f"the sum is {residual / scale:.2g} of the largest term at {time:g} s, allowed {tolerance:g}")
    if residual > tolerance * scale:
        raise driver.TestFailure("the terms do not cancel")


if __name__ == "__main__":
    driver.main(case)
