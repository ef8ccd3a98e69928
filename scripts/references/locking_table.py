#!/usr/bin/python3
"""Prints how nearly and fully incompressible solids converge under refinement: no locking.

    scripts/references/locking_table.py [--program FILE] [--output DIR]

Runs parameter_files/verification/lame-cylinder.prm and cook-membrane.prm on uniform meshes of n x n cells for several
Poisson's ratios nu and prints a Markdown table of the deviations of a displacement from its reference: the inner surface of
Lame's cylinder from the closed solution of that nu, and Cook's loaded end at (48 m, 52 m) from 16.4537 m, the value of
graded meshes at nu = 0.499975 (see the parameter files). Both displacements would fall far short, the more so the nearer nu
is to 0.5, if the elements locked. Takes about half a minute.
"""

import argparse
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))
sys.dont_write_bytecode = True

import continua  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
CELLS = (1, 2, 4, 8, 16)


def lame(nu):
    """Radial displacement [m] of the inner surface: a = 10 mm, b = 20 mm, P = 1 MPa, Y = 1 GPa, no axial strain."""
    a, b, pressure, young = 0.01, 0.02, 1e6, 1e9
    return (1 + nu) / young * pressure * a**2 / (b**2 - a**2) * ((1 - 2 * nu) * a + b**2 / a)


def cook(_):
    return 16.4537


def lame_settings(nu, n):
    return {"Mesh/Radial cells": n, "Mesh/Axial cells": n, "Materials/body/Poisson's ratio": nu}


def cook_settings(nu, n):
    # The shear modulus stays 0.375 Pa.
    return {"Mesh/Cells": f"{n}, {n}", "Adaptivity/Cycles": 0, "Materials/membrane/Poisson's ratio": nu,
            "Materials/membrane/Young's modulus": 0.75 * (1 + nu)}


ROWS = [("Lame's cylinder", "lame-cylinder.prm", "inner surface", lame, lame_settings, nu)
        for nu in (0.3, 0.49, 0.4999, 0.499999, 0.5)]
ROWS += [("Cook's membrane", "cook-membrane.prm", "middle", cook, cook_settings, nu)
         for nu in (0.4999, 0.4999750012499375, 0.499999, 0.5)]


def displacement(program, file, probe, settings, output):
    file = os.path.join(ROOT, "parameter_files", "verification", file)
    try:
        return continua.run(file, settings, output=output, program=program, overwrite=True).quantity("final displacement y", probe)
    except continua.ContinuaError as error:
        sys.exit(f"error: {error}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    build_root = os.environ.get("CONTINUA_BUILD_ROOT", os.path.join(ROOT, "build"))
    parser.add_argument("--program", default=os.path.join(build_root, "release", "continua"), metavar="FILE")
    parser.add_argument("--output", default=os.path.join(ROOT, "output", "locking"), metavar="DIR")
    arguments = parser.parse_args()
    print("| case | nu | reference [m] | " + " | ".join(f"{n} x {n}" for n in CELLS) + " |")
    print("|---|---|---|" + "---|" * len(CELLS))
    for name, file, probe, reference, settings, nu in ROWS:
        cells = []
        for n in CELLS:
            value = displacement(arguments.program, file, probe, settings(nu, n), arguments.output)
            cells.append(f"{100 * (value / reference(nu) - 1):+.3g} %")
        print(f"| {name} | {nu:.9g} | {reference(nu):.6g} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
