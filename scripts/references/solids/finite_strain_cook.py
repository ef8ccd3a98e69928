#!/usr/bin/python3
"""Cook's membrane in large deformation by another program: CalculiX (Debian's calculix-ccx), C3D20R, for finite-strain-cook.prm.

    scripts/references/solids/finite_strain_cook.py

Prints the displacement across the panel of the upper corner (48, 60) of the loaded end [mm] on meshes that are graded to the clamped upper corner, where
the stress is singular, and their limit. The energy is G/2 (tr b J^(-2/3) - 3) + K/2 (J - 1)^2 with G = 80.1938 MPa and K = 400942 MPa. The volume
changes so little (p/K is 1e-4 or less but near the corner) that the law of the volume does not matter. The load is a shear of 6.25 MPa that keeps its
direction. Takes two minutes.
"""

import argparse
import os
import subprocess
import sys
import tempfile

SCRIPTS = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(SCRIPTS, "lib"))
sys.dont_write_bytecode = True

import calculix  # noqa: E402


def knots(cells, end):
    """Places of the cells' corners between 0 and 1, which are dense at the end 0 or 1."""
    return [(i / cells) ** 2 if end == 0 else 1 - (1 - i / cells) ** 2 for i in range(cells + 1)]


def displacement(cells, folder):
    """Across the panel, of the upper corner of the loaded end [mm]."""
    lines, _ = calculix.finite_cook("C3D20R", (cells, cells), knots(cells, 0), knots(cells, 1), first=0.1, largest=0.1)
    with open(os.path.join(folder, "case.inp"), "w", encoding="utf-8") as stream:
        stream.write("\n".join(lines) + "\n")
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    subprocess.run(["ccx", "-i", "case"], cwd=folder, env=environment, stdout=subprocess.DEVNULL, check=True)
    return calculix.large_displacement(folder)[1]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cells", type=int, nargs="+", default=[8, 16, 32])
    found = []
    for cells in parser.parse_args().cells:
        with tempfile.TemporaryDirectory() as folder:
            found.append(displacement(cells, folder))
        print(f"{cells} x {cells} cells: {found[-1]:.5f} mm", flush=True)
    if len(found) > 2:
        # Aitken's extrapolation, of meshes that are halved.
        first, second = found[-2] - found[-3], found[-1] - found[-2]
        print(f"limit of the last three: {found[-1] + second**2 / (first - second):.4f} mm")


if __name__ == "__main__":
    main()
