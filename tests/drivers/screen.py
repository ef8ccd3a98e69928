#!/usr/bin/python3
"""Compares what a program prints with a reference: screen.py [--ranks N] --numdiff FILE REFERENCE FOLDER COMMAND...

The command runs in FOLDER, which is emptied first. Its standard output is compared with the file REFERENCE by numdiff,
which takes numbers as equal that agree to 1e-6 absolutely or to 1e-8 relatively. Standard error is not compared, since
libraries write there what depends on the machine; it is shown when the test fails.
"""

import argparse
import os
import subprocess
import sys

import driver

SEPARATORS = " \t\r\n=,:;<>[](){}^"


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
    difference = subprocess.run([arguments.numdiff, "-a", "1e-6", "-r", "1e-8", "-s", SEPARATORS, arguments.reference,
                                 output], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                                check=False)
    if status == 0 and difference.returncode == 0:
        return
    print("+", " ".join(command), "in", folder)
    if status != 0:
        print(f"FAILED: exit status {status}")
    if difference.returncode != 0:
        print(f"FAILED: {output} differs from {arguments.reference}")
        print("\n".join(difference.stdout.splitlines()[:40]))
    print("standard error:\n" + errors)
    sys.exit(1)


if __name__ == "__main__":
    main()
