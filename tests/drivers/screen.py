#!/usr/bin/python3
"""Compares what a program prints with a reference: screen.py [--ranks N] --numdiff FILE REFERENCE FOLDER COMMAND...

The command runs in FOLDER, which is emptied first. Its standard output is compared with the file REFERENCE by numdiff,
which takes numbers as equal that agree to 1e-6 absolutely or to 1e-8 relatively. Of a search for a steady state the steps
and the corrections may be a quarter more or less, or two, since round-off decides which one is the last; how far its time
steps have grown is not compared. Of a fit whose parameters trade off the limits of the intervals are compared to two digits: they change in the fourth one
with the round-off of another processor. Standard error is not compared, since libraries write there what depends on the machine; it is shown
when the test fails.
"""

import argparse
import os
import re
import subprocess
import sys

import driver

SEPARATORS = " \t\r\n=,:;<>[](){}^"
SEARCH = re.compile(r"^(At rest|Found) after (\d+) steps( of \S+ s to \S+ s)?( with (\d+) corrections)?", re.MULTILINE)
INTERVAL = re.compile(r"\((\d+ %): (\S+) to (\S+)( \w+)?\)")
FREEDOM, LEAST_FREEDOM = 0.25, 2


def without_counts(text):
    """(the text with a word for what round-off decides in a search for a steady state, the steps and corrections of each search)."""
    counts = [int(count) for search in SEARCH.finditer(text) for count in (search[2], search[5] or 0)]
    return SEARCH.sub(r"\1 after some steps with some corrections", text), counts


def with_short_intervals(text):
    """The text with two digits of the limits of intervals, if parameters trade off."""
    if " trade off: " not in text:
        return text
    return INTERVAL.sub(lambda found: f"({found[1]}: {float(found[2]):.1e} to {float(found[3]):.1e}{found[4] or ''})", text)


def counts_agree(found, wanted):
    return len(found) == len(wanted) and all(abs(this - that) <= max(LEAST_FREEDOM, FREEDOM * that) for this, that in zip(found, wanted))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ranks", type=int, default=1)
    parser.add_argument("--numdiff", default="numdiff")
    parser.add_argument("reference")
    parser.add_argument("folder")
    parser.add_argument("command", nargs=argparse.REMAINDER)
    arguments = parser.parse_args()

    folder = driver.fresh_folder(arguments.folder)
    output = os.path.join(folder, "stdout")
    error_file = os.path.join(folder, "stderr")
    command = driver.on_ranks(arguments.command, arguments.ranks, error_file)
    with open(output, "w", encoding="utf-8") as stdout, open(error_file, "a+", encoding="utf-8", errors="replace") as stderr:
        status = subprocess.run(command, cwd=folder, env=driver.environment(), stdin=subprocess.DEVNULL, stdout=stdout,
                                stderr=stderr, check=False).returncode
        stderr.seek(0)
        errors = stderr.read()
    compared, counts = [], []
    for path in (arguments.reference, output):
        with open(path, encoding="utf-8", errors="replace") as stream:
            whole = stream.read()
        text, its_counts = without_counts(with_short_intervals(whole))
        counts.append(its_counts)
        compared.append(path)
        if text != whole:
            compared[-1] = os.path.join(folder, f"{len(compared)}-without-counts")
            with open(compared[-1], "w", encoding="utf-8") as stream:
                stream.write(text)
    difference = subprocess.run([arguments.numdiff, "-a", "1e-6", "-r", "1e-8", "-s", SEPARATORS, *compared], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                                check=False)
    if status == 0 and difference.returncode == 0 and counts_agree(counts[1], counts[0]):
        return
    print("+", " ".join(command), "in", folder)
    if status != 0:
        print(f"FAILED: exit status {status}")
    if difference.returncode != 0:
        print(f"FAILED: {output} differs from {arguments.reference}")
        print("\n".join(difference.stdout.splitlines()[:40]))
    if not counts_agree(counts[1], counts[0]):
        print(f"FAILED: steps and corrections of the searches are {counts[1]}, expected {counts[0]} within a quarter or two")
    print("standard error:\n" + errors)
    sys.exit(1)


if __name__ == "__main__":
    main()
