#!/usr/bin/python3
"""Checks what the program says to wrong input: bad_input.py PROGRAM CASE.prm WORKING_FOLDER.

Header comments of the case:

    # expect: status 2                  the exit status (2: the input is wrong, 1: the run failed)
    # expect: REGEX                     one or more; each must match what was printed (stdout and stderr together)
    # refuse: REGEX                     none or more; must not match
    # arguments: --set "Mesh/Cells=0"   more arguments, quoted as in a shell; {folder} stands for the working folder
    # file: missing.prm                 run this file (beside the case) instead of the case; `none` for no file
    # existing: run/summary.json        make this file in the working folder first; it must still be there, unchanged
    # ranks: 2
    # left: probes.csv                  none or more; tables of a run that failed, which must have rows
    # failed: REGEX                     summary.json says that the run failed, for a reason that matches

The output folder is WORKING_FOLDER/run. With status 2 nothing may have been made there.
"""

import json
import os
import re
import shlex

import driver

CONTENT = "made by a test\n"


def case(program, parameter_file, folder):
    entries = driver.header(parameter_file)
    status, patterns = None, []
    for text in entries.get("expect", []):
        match = re.fullmatch(r"status (\d+)", text)
        if match:
            status = int(match.group(1))
        else:
            patterns.append(text)
    if status is None or not patterns:
        raise driver.TestFailure("the header needs '# expect: status N' and at least one '# expect: REGEX'")

    existing = [os.path.join(folder, name) for name in entries.get("existing", [])]
    for path in existing:
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(CONTENT)

    file = driver.single(entries, "file", os.path.basename(parameter_file))
    arguments = [] if file == "none" else [os.path.join(os.path.dirname(parameter_file), file)]
    extra = driver.single(entries, "arguments", "").replace("{folder}", folder)
    arguments += shlex.split(extra)
    output = os.path.join(folder, "run")
    if "--output" not in arguments and file != "none":
        arguments += ["--output", output]

    done = driver.run(program, arguments, int(driver.single(entries, "ranks", "1")), folder, time_limit=60)
    text = done.stdout + done.stderr
    print(text)
    if done.returncode != status:
        raise driver.TestFailure(f"exit status {done.returncode}, expected {status}")
    for pattern in patterns:
        if not re.search(pattern, text, re.MULTILINE):
            raise driver.TestFailure(f"nothing printed matches '{pattern}'")
    for pattern in entries.get("refuse", []):
        if re.search(pattern, text, re.MULTILINE):
            raise driver.TestFailure(f"something printed matches '{pattern}'")

    for path in existing:
        with open(path, encoding="utf-8") as stream:
            if stream.read() != CONTENT:
                raise driver.TestFailure(f"{path} was changed")
    for name in entries.get("left", []):
        driver.read_table(os.path.join(output, name))
    for pattern in entries.get("failed", []):
        with open(os.path.join(output, "summary.json"), encoding="utf-8") as stream:
            summary = json.load(stream)
        if summary["status"] != "failed" or not re.search(pattern, summary["failure"]):
            raise driver.TestFailure(f"summary.json says '{summary['status']}', '{summary.get('failure', '')}'")
    if status == 2:
        made = [os.path.join(at, name) for at, folders, files in os.walk(folder) for name in folders + files]
        kept = set(existing) | {os.path.dirname(path) for path in existing}
        left_over = sorted(set(made) - kept)
        if left_over:
            raise driver.TestFailure(f"made although the input is wrong: {', '.join(left_over)}")


if __name__ == "__main__":
    driver.main(case)
