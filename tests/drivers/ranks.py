#!/usr/bin/python3
"""Checks that the result does not depend on the number of ranks: ranks.py PROGRAM CASE.prm WORKING_FOLDER.

Header comments of the case, all optional:

    # ranks: 1, 2, 3        the numbers of ranks; the first is what the others are compared with
    # others: KEY = VALUE   none or more; what all runs but the first have besides
    # tolerance: 1e-8       relative to the largest magnitude of each column of probes.csv (and beats.csv, power.csv if there)
    # floor: 1e-12          magnitude below which a column counts as zero (default 0)
    # power tolerance: 1e-6 for power.csv
    # power floor share: 1   the tolerance of a column of power.csv is at least relative to this share of the largest
                            magnitude of its unit in the table: an iterative solver's tolerance is one of the whole
                            balance, not of its smallest part (default 0)
    # iterations: 0.05      largest relative difference of the iterations of all linear solves (not compared without it)
    # most iterations: 200  of all linear solves of a run together
    # left out of the screen: REGEX   none or more; lines of the screen that may differ

Without `others` the runs must have chosen the same, too, by log.txt and summary.json: meshes, linear solver, its blocks.

The power's residual and its share are nothing but round-off where the balance closes, and so is the energy that changes of
the mesh bring where cells are only divided; they are not compared.
"""

import json
import os
import re

import choices
import driver


def linear_iterations(output):
    with open(os.path.join(output, "summary.json"), encoding="utf-8") as file:
        return json.load(file)["linear iterations"]


def case(program, parameter_file, folder):
    entries = driver.header(parameter_file)
    ranks = [int(text) for text in driver.single(entries, "ranks", "1, 2, 3").split(",")]
    tolerance = float(driver.single(entries, "tolerance", "1e-8"))
    floor = float(driver.single(entries, "floor", "0"))
    power_tolerance = float(driver.single(entries, "power tolerance", str(tolerance)))
    power_floor_share = float(driver.single(entries, "power floor share", "0"))

    iterations_tolerance = driver.single(entries, "iterations", None)
    most_iterations = int(driver.single(entries, "most iterations", "0"))
    left_out = entries.get("left out of the screen", [])
    outputs, screens = [], []
    others = driver.overrides(entries.get("others", []))
    for i, n in enumerate(ranks):
        output = os.path.join(folder, f"{i}-ranks-{n}")
        arguments = [parameter_file, "--output", output, *(others if i > 0 else [])]
        done = driver.run_to_the_end(program, arguments, ranks=n, folder=folder)
        outputs.append(output)
        if most_iterations and linear_iterations(output) > most_iterations:
            raise driver.TestFailure(f"{linear_iterations(output)} iterations on {n} ranks, more than {most_iterations}")
        lines = done.stdout.replace(output, "OUTPUT").splitlines(keepends=True)
        screens.append("".join(line for line in lines if not any(re.search(pattern, line) for pattern in left_out)))
    for n, output, screen in zip(ranks[1:], outputs[1:], screens[1:]):
        print(f"{n} ranks against {ranks[0]}")
        driver.compare_tables(os.path.join(outputs[0], "probes.csv"), os.path.join(output, "probes.csv"), tolerance,
                              floor)
        if os.path.exists(os.path.join(outputs[0], "beats.csv")):
            driver.compare_tables(os.path.join(outputs[0], "beats.csv"), os.path.join(output, "beats.csv"), tolerance,
                                  floor, gaps=True)
        if os.path.exists(os.path.join(outputs[0], "power.csv")):
            driver.compare_tables(os.path.join(outputs[0], "power.csv"), os.path.join(output, "power.csv"),
                                  power_tolerance, floor, floor_share=power_floor_share,
                                  left_out=("residual [W]", "share [1]", "energy change by transfer [J]"))
        if iterations_tolerance is not None:
            first, present = (linear_iterations(path) for path in (outputs[0], output))
            if abs(present - first) > float(iterations_tolerance) * first:
                raise driver.TestFailure(f"{present} iterations on {n} ranks, and {first} on {ranks[0]}")
        if not others:
            choices.compare_choices(outputs[0], output)
        if screen != screens[0]:
            raise driver.TestFailure(f"the screen output differs.\non {ranks[0]}:\n{screens[0]}\non {n}:\n{screen}")


if __name__ == "__main__":
    driver.main(case)
