#!/usr/bin/python3
"""Checks that a result hardly depends on some entries: unchanged.py PROGRAM CASE.prm WORKING_FOLDER.

Header comments of the case:

    # run: Mesh/Cells = 4; Time/Time step = 20 ms     two or more, one line a run; overrides joined by `;`
    # run: Mesh/Cells = 8; Time/Time step = 20 ms
    # tolerance: 1e-3                                 of the largest magnitude of each column of the first probes.csv
"""

import os

import driver


def case(program, parameter_file, folder):
    entries = driver.header(parameter_file)
    tolerance = float(driver.single(entries, "tolerance", "0"))
    runs = entries.get("run", [])
    if len(runs) < 2 or tolerance <= 0:
        raise driver.TestFailure("the header needs two lines '# run: KEY = VALUE' and '# tolerance: NUMBER'")
    tables = []
    for number, run in enumerate(runs, 1):
        output = os.path.join(folder, f"run-{number}")
        driver.run_to_the_end(program, [parameter_file, "--output", output, *driver.overrides(run.split(";"))],
                              folder=folder)
        tables.append(os.path.join(output, "probes.csv"))
    for run, table in zip(runs[1:], tables[1:]):
        print(f"{run} against {runs[0]}")
        driver.compare_tables(tables[0], table, tolerance)


if __name__ == "__main__":
    driver.main(case)
