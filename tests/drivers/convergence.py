#!/usr/bin/python3
"""Checks orders of convergence: convergence.py PROGRAM CASE.prm WORKING_FOLDER.

Header comments of the case:

    # level: Mesh/Cells = 4; Time/Time step = 20 ms     one line a run, coarse to fine; overrides joined by `;`
    # level: Mesh/Cells = 8; Time/Time step = 10 ms
    # ratio: 2                                          refinement from level to level (default 2)
    # order: velocity error = 2.8 .. 3.2                   the quantity is the error
    # order: tip: frequency = 1.9 .. 2.1, reference 3.3624 the error is the distance from a reference, in SI
    # order: tip: frequency = 1.9 .. 2.1, differences      from successive differences (three levels or more)
    # earlier pairs: 0.5                                   how far outside of it earlier orders may lie (default 0.5)
    # wider because: REASON                              where an interval is wider than 0.2, or `earlier pairs` than 0.5
    # bound: velocity error <= 1e-4                        on the finest level

A case of bounds alone may have one level; it suits runs whose screen output differs from machine to machine.
`PROBE: NAME` names the quantity of one probe. The order between the two finest levels must lie in the interval: one
that is too high shows an error, too, such as a reference that a coarse mesh happens to meet. The theoretical order must
lie in it. An error below 1e-13 is round-off and has no order.
"""

import math
import os
import re

import driver

ROUND_OFF = 1e-13
ORDER = re.compile(r"(?:(?P<probe>[^:]+):\s*)?(?P<name>[^:]+?)\s*=\s*(?P<lowest>[.\d]+)\s*\.\.\s*(?P<highest>[.\d]+)"
                   r"(?:,\s*(?:reference\s+(?P<reference>[-+.\deE]+)|(?P<differences>differences)))?")
BOUND = re.compile(r"(?:(?P<probe>[^:]+):\s*)?(?P<name>[^:]+?)\s*<=\s*(?P<bound>[-+.\deE]+)")


def match_all(pattern, entry, text):
    match = pattern.fullmatch(text)
    if not match:
        raise driver.TestFailure(f"cannot read '# {entry}: {text}'")
    return match


def observed_orders(errors, ratio):
    """The order between each level and the next; none (nan) where an error is at round-off."""
    return [math.nan if min(coarse, fine) < ROUND_OFF else math.log(coarse / fine) / math.log(ratio)
            for coarse, fine in zip(errors, errors[1:])]


def outside(label, observed, lowest, highest, margin):
    """What is wrong with the orders, from the coarsest pair to the finest."""
    failures = []
    for pair, order in enumerate(observed, 1):
        last = pair == len(observed)
        low, high = (lowest, highest) if last else (lowest - margin, highest + margin)
        if not low <= order <= high:
            where = "between the two finest levels" if last else f"between levels {pair} and {pair + 1}"
            failures.append(f"{label}: order {order:.3f} {where}, expected {low:g} .. {high:g}")
    return failures


def case(program, parameter_file, folder):
    entries = driver.header(parameter_file)
    levels = [[part.strip() for part in text.split(";") if part.strip()] for text in entries.get("level", [])]
    orders = [match_all(ORDER, "order", text) for text in entries.get("order", [])]
    bounds = [match_all(BOUND, "bound", text) for text in entries.get("bound", [])]
    if not orders and not bounds or len(levels) < (2 if orders else 1):
        raise driver.TestFailure("the header needs two or more lines '# level:' with one or more '# order:', or one or "
                                 "more '# level:' with '# bound:' only")
    ratio = float(driver.single(entries, "ratio", "2"))
    margin = float(driver.single(entries, "earlier pairs", "0.5"))

    if margin > 0.5 and not entries.get("wider because"):
        raise driver.TestFailure("'# earlier pairs:' above 0.5 needs '# wider because: REASON'")

    summaries = []
    for index, overrides in enumerate(levels):
        output = os.path.join(folder, f"level-{index}")
        arguments = [parameter_file, "--output", output]
        for override in overrides:
            key, equals, value = override.partition("=")
            if not equals:
                raise driver.TestFailure(f"'{override}' in '# level:' is not KEY = VALUE")
            arguments += ["--set", f"{key.strip()}={value.strip()}"]
        driver.run_to_the_end(program, arguments, folder=folder)
        summaries.append(os.path.join(output, "summary.json"))

    failures = []
    for order in orders:
        label = order["name"] if order["probe"] is None else f"{order['probe']}: {order['name']}"
        values = [driver.quantity(summary, order["name"], order["probe"]) for summary in summaries]
        if order["differences"]:
            if len(values) < 3:
                raise driver.TestFailure("'differences' needs three levels or more")
            errors = [abs(b - a) for a, b in zip(values, values[1:])]
        elif order["reference"] is not None:
            errors = [abs(value - float(order["reference"])) for value in values]
        else:
            errors = [abs(value) for value in values]
        observed = observed_orders(errors, ratio)
        print(f"{label}: values {values}, errors {errors}, orders {[round(x, 3) for x in observed]}")
        lowest, highest = float(order["lowest"]), float(order["highest"])
        if not 0 < highest - lowest <= 1:
            raise driver.TestFailure(f"'{order['lowest']} .. {order['highest']}' is empty, or wider than one order")
        if highest - lowest > 0.2 + 1e-9 and not entries.get("wider because"):
            raise driver.TestFailure(f"'{order['lowest']} .. {order['highest']}' is wider than 0.2: it needs "
                                     "'# wider because: REASON'")
        failures += outside(label, observed, lowest, highest, margin)
    for bound in bounds:
        value = driver.quantity(summaries[-1], bound["name"], bound["probe"])
        print(f"{bound['name']}: {value} on the finest level")
        if not abs(value) <= float(bound["bound"]):
            failures.append(f"{bound['name']}: {value:.4g} on the finest level, expected at most {bound['bound']}")
    if failures:
        raise driver.TestFailure("\n".join(failures))


if __name__ == "__main__":
    driver.main(case)
