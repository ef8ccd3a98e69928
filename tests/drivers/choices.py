"""What a run chose by itself, from its log and summary: nothing of it may depend on the number of ranks."""

import json
import os
import re

import driver

# The library that makes a factor is one of the things that the program says to depend on the ranks.
FACTOR = re.compile(r"(CHOLMOD|MUMPS)(, [a-zA-Z ]+)?")
LINES = re.compile(r"^(Linear solver:|FGMRES|t = \S+ s: mesh of|Initial |The time step|A load|  )", re.MULTILINE)
KEYS = ("status", "steps", "cells", "degrees of freedom", "linear solver", "reason of linear solver")


def choices(output):
    """Lines of log.txt up to the table of wall times, and values of summary.json."""
    with open(os.path.join(output, "log.txt"), encoding="utf-8") as stream:
        lines = stream.read().split("Wall time by section")[0].splitlines()
    with open(os.path.join(output, "summary.json"), encoding="utf-8") as stream:
        summary = json.load(stream)
    chosen = [line for line in lines if LINES.match(line)]
    chosen += [f"{key}: {summary[key]}" for key in KEYS if key in summary]
    return [FACTOR.sub("a factor", line) for line in chosen]


def compare_choices(first, second):
    one, other = choices(first), choices(second)
    if one != other:
        differing = [line for line in one + other if (line in one) != (line in other)]
        raise driver.TestFailure("the program chose otherwise:\n" + "\n".join(differing or ["the order of lines"]))
