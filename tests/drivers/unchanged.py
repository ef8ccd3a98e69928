#!/usr/bin/python3
"""Checks that a result hardly depends on some entries: unchanged.py PROGRAM CASE.prm WORKING_FOLDER.

Header comments of the case:

    # run: Mesh/Cells = 4; Time/Time step = 20 ms     two or more, one line a run; overrides joined by `;`
    # run: Mesh/Cells = 8; Time/Time step = 20 ms
    # run: common/OTHER.prm; Mesh/Cells = 8           another file, with its path from the case's folder
    # tolerance: 1e-3                                 of the largest magnitude of each column of the first probes.csv
    # tolerance of pressure gradient: 2e-3            none or more; of the columns of one field
"""

import os

import driver


def case(program, parameter_file, folder):
    entries = driver.header(parameter_file)
    tolerance = float(driver.single(entries, "tolerance", "0"))
    runs = entries.get("run", [])
    if len(runs) < 2 or tolerance <= 0:
        raise driver.TestFailure("the header needs two lines '# run: KEY = VALUE' and '# tolerance: NUMBER'")
    prefix = "tolerance of "
    of_fields = {key[len(prefix):]: float(driver.single(entries, key)) for key in entries if key.startswith(prefix)}
    tables = []
    for number, run in enumerate(runs, 1):
        output = os.path.join(folder, f"run-{number}")
        first, *others = [part.strip() for part in run.split(";")]
        file = parameter_file
        if first.endswith(".prm") and "=" not in first:
            file = os.path.join(os.path.dirname(parameter_file), first)
        else:
            others.insert(0, first)
        driver.run_to_the_end(program, [file, "--output", output, *driver.overrides(others)], folder=folder)
        tables.append(os.path.join(output, "probes.csv"))
    columns, _ = driver.read_table(tables[0])
    for field in of_fields:
        if not any(name.rpartition(": ")[2].partition(" [")[0] == field for name in columns):
            raise driver.TestFailure(f"'# tolerance of {field}:': there is no column of this field; there are {columns}")
    for run, table in zip(runs[1:], tables[1:]):
        print(f"{run} against {runs[0]}")
        driver.compare_tables(tables[0], table, tolerance, of_fields=of_fields)


if __name__ == "__main__":
    driver.main(case)
