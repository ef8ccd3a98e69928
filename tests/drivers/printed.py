#!/usr/bin/python3
"""Prints the entries of a parameter file: printed.py PROGRAM CASE.prm WORKING_FOLDER.

The program prints the entries of the file into the folder as printed.prm (what a run writes as parameters.prm) and as
printed.json; the test printed/plain_handler compares the two.
"""

import os

import driver


def case(program, parameter_file, folder):
    for style in ("prm", "json"):
        done = driver.run_to_the_end(program, [parameter_file, f"--print-parameters={style}"])
        with open(os.path.join(folder, f"printed.{style}"), "w", encoding="utf-8") as stream:
            stream.write(done.stdout)


if __name__ == "__main__":
    driver.main(case)
