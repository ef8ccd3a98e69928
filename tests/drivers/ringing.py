#!/usr/bin/python3
"""Looks for values that ring with the time step: ringing.py PROGRAM CASE.prm WORKING_FOLDER.

Header comments of the case:

    # run: Time/Scheme = crank nicolson; Time/Time step = 3 ms     one line a run; overrides joined by `;`
    # rings: tip: pressure <= 1e-3                                 in every run, of the column's largest magnitude
    # bound: weak divergence at the end <= 1e-9                    a quantity of every run
    # ringing run: Time/Scheme = euler implicit                    a run in which a `rings` bound must be broken

How much a column rings is the largest amplitude a that it holds for six rows: of d = (v(n-1) - 2 v(n) + v(n+1)) / 4, which is
a (-1)^n for a value that alternates from step to step, six in a row have alternating signs and at least the magnitude a. A
jump, a wave that the steps resolve, and a ringing that is damped away at once do not count. The first four steps, in
which a scheme may start anew, do not either.
"""

import os
import re

import driver

WINDOW = 6
STARTING_STEPS = 4
BOUND = re.compile(r"(?P<name>.+?)\s*<=\s*(?P<bound>[-+.\deE]+)")


def ringing(values):
    """The largest amplitude that alternates in sign for WINDOW rows."""
    second = [(a - 2 * b + c) / 4 for a, b, c in zip(values, values[1:], values[2:])]
    largest = 0.0
    for start in range(len(second) - WINDOW + 1):
        window = second[start:start + WINDOW]
        if all(a * b < 0 for a, b in zip(window, window[1:])):
            largest = max(largest, min(abs(d) for d in window))
    return largest


def find_column(names, name):
    """The number of the column 'PROBE: FIELD', whose unit need not be told."""
    found = [number for number, full in enumerate(names) if full == name or full.rpartition(" [")[0] == name]
    if len(found) != 1:
        raise driver.TestFailure(f"there is no column '{name}'; there are {names}")
    return found[0]


def bounds(entries, key):
    result = []
    for text in entries.get(key, []):
        match = BOUND.fullmatch(text)
        if not match:
            raise driver.TestFailure(f"cannot read '# {key}: {text}'")
        result.append((match["name"], float(match["bound"])))
    return result


def perform(program, parameter_file, text, output):
    """Runs with the overrides in `text`."""
    arguments = [parameter_file, "--output", output]
    for override in (part.strip() for part in text.split(";") if part.strip()):
        key, equals, value = override.partition("=")
        if not equals:
            raise driver.TestFailure(f"'{override}' in '# run:' is not KEY = VALUE")
        arguments += ["--set", f"{key.strip()}={value.strip()}"]
    driver.run_to_the_end(program, arguments)


def shares(output, rings):
    """How much each column rings, over its largest magnitude."""
    names, rows = driver.read_table(os.path.join(output, "probes.csv"))
    result = {}
    for name, _ in rings:
        column = find_column(names, name)
        values = [row[column] for row in rows]
        scale = max(map(abs, values))
        result[name] = ringing(values[1 + STARTING_STEPS:]) / scale if scale > 0 else 0.0
    return result


def case(program, parameter_file, folder):
    entries = driver.header(parameter_file)
    rings = bounds(entries, "rings")
    quantities = bounds(entries, "bound")
    if not entries.get("run") or not rings:
        raise driver.TestFailure("the header needs one or more lines '# run:' and '# rings:'")

    failures = []
    for index, text in enumerate(entries["run"]):
        output = os.path.join(folder, f"run-{index}")
        perform(program, parameter_file, text, output)
        for name, share in shares(output, rings).items():
            print(f"{name} rings with {share:.3g} of its largest magnitude")
            bound = dict(rings)[name]
            if not share <= bound:
                failures.append(f"{text}: {name} rings with {share:.3g}, expected at most {bound:g}")
        for name, bound in quantities:
            value = driver.quantity(os.path.join(output, "summary.json"), name)
            print(f"{name}: {value:.3g}")
            if not abs(value) <= bound:
                failures.append(f"{text}: {name} is {value:.3g}, expected at most {bound:g}")
    # A check of the check: what is known to ring must be seen.
    for index, text in enumerate(entries.get("ringing run", [])):
        output = os.path.join(folder, f"ringing-run-{index}")
        perform(program, parameter_file, text, output)
        found = shares(output, rings)
        print("; ".join(f"{name} rings with {share:.3g}" for name, share in found.items()))
        if all(found[name] <= bound for name, bound in rings):
            failures.append(f"{text}: nothing rings, and should")
    if failures:
        raise driver.TestFailure("\n".join(failures))


if __name__ == "__main__":
    driver.main(case)
