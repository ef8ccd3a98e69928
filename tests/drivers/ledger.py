#!/usr/bin/python3
"""Closes the accounts of a run from its table: ledger.py PROGRAM CASE.prm WORKING_FOLDER.

The case starts at rest with nothing stored, takes Crank-Nicolson without a smooth start and writes power.csv after every step,
so that a power in the table holds in the middle of its step and dt times it is what the scheme exchanged. Then

* the integral of the external power is what the energies at the end hold, with the integrals of the viscous and the relaxation
  power, of the damping of supports and of what leaves through outlets, but for what new meshes changed: the energies come from
  the state alone, the powers from the scheme's equations;
* what the scheme has lost by its own column is what the integrals give and the energies do not hold;
* the integral of a region's relaxation power is its `energy relaxed`, which the run finds another way, as what the springs were
  given and do not hold.

Header comments of the case, both optional:

    # tolerance: 1e-8        of the work of the loads
    # relaxes: wall >= 0.1   a region (none if it is the only one), and the share of the work that it must turn into heat at
                           least
"""

import os
import re

import driver

TRANSFER = "energy change by transfer [J]"

def integral(rows, column):
    """Of a power that holds in the middle of the steps, the first of which starts at zero."""
    total, start = 0.0, 0.0
    for row in rows:
        total += (row[0] - start) * row[column]
        start = row[0]
    return total


def case(program, parameter_file, folder):
    entries = driver.header(parameter_file)
    tolerance = float(driver.single(entries, "tolerance", "1e-8"))
    output = os.path.join(folder, "run")
    driver.run_to_the_end(program, [parameter_file, "--output", output], folder=folder)
    names, rows = driver.read_table(os.path.join(output, "power.csv"))
    summary = os.path.join(output, "summary.json")

    def column(name):
        if name not in names:
            raise driver.TestFailure(f"power.csv has no column '{name}'; it has {names}")
        return names.index(name)

    start = 0.0
    for row in rows:
        middle = 0.5 * (start + row[0])
        if abs(row[column("balance time [s]")] - middle) > 1e-9 * row[0]:
            raise driver.TestFailure(f"the step to {row[0]:g} s is not balanced in its middle: the case needs "
                                     "Crank-Nicolson without a smooth start, and a row after every step")
        start = row[0]

    work = integral(rows, column("external [W]"))
    failures = []

    def compare(text, found, expected):
        print(f"{text}: {found:.10g} J, expected {expected:.10g} J, apart by {abs(found - expected) / abs(work):.2g} "
              "of the work")
        if not abs(found - expected) <= tolerance * abs(work):
            failures.append(f"{text}: {found:.12g} J and {expected:.12g} J differ by more than {tolerance:g} of the "
                            f"work of the loads, {work:.6g} J")

    compare("work of the loads", rows[-1][column("work of loads [J]")], work)
    # Bodies that do not relax have no column of it, and bodies without a support none of that.
    stores = ["kinetic", "strain", "compressive"] + (["support"] if "support energy [J]" in names else [])
    held = sum(rows[-1][column(f"{name} energy [J]")] for name in stores)
    losses = ["viscous [W]"] + [name for name in ("relaxation [W]", "support damping [W]") if name in names]
    lost = sum(integral(rows, column(name)) for name in losses)
    left = sum(integral(rows, column(name)) for name in names if re.fullmatch(r"outlet .*: leaving \[W\]", name))
    transfer = rows[-1][names.index(TRANSFER)] if TRANSFER in names else 0.0
    compare("held, turned into heat and left", held + lost + left, work + transfer)
    if "loss of the scheme [J]" in names:
        given = sum(integral(rows, column(f"{name} [W]")) for name in stores)
        heat = integral(rows, column("relaxation [W]")) if "relaxation [W]" in names else 0.0
        compare("lost by the scheme", rows[-1][column("loss of the scheme [J]")], given - heat - (held - transfer))
    if TRANSFER in names:
        compare("changed by new meshes", transfer, driver.quantity(summary, TRANSFER.partition(" [")[0]))
        print(f"new meshes change the energy by {transfer / work:.2g} of the work")
        if driver.quantity(summary, "mesh changes") < 2:
            failures.append("the mesh does not change")

    regions = {name.partition(":")[0]: number for number, name in enumerate(names)
               if re.fullmatch(r".*: relaxation \[W\]", name)}
    if not regions and "relaxation [W]" in names:  # one region has no columns of its own
        regions = {None: column("relaxation [W]")}
    for region, number in regions.items():
        compare(f"relaxed in {region or 'the body'}", integral(rows, number),
                driver.quantity(summary, "energy relaxed", region))
    for text in entries.get("relaxes", []):
        region, _, share = (part.strip() for part in text.partition(">="))
        found = integral(rows, regions[region or None]) / work
        print(f"{region or 'the body'} turns {found:.3g} of the work into heat")
        if not found >= float(share):
            failures.append(f"{region} turns {found:.3g} of the work into heat, expected at least {share}")
    if failures:
        raise driver.TestFailure("\n".join(failures))


if __name__ == "__main__":
    driver.main(case)
