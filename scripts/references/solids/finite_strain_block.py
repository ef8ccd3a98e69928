#!/usr/bin/python3
"""The pulled cube by another program: CalculiX (Debian's calculix-ccx), C3D20R, for finite-strain-block.prm.

    scripts/references/solids/finite_strain_block.py [--compressible] [--cells N...]

Prints the displacement of the middle of the pulled face [mm] on N x N x N cells and the limit of the last three meshes. The energy is
G/2 (tr b J^(-2/3) - 3) + K/2 (J - 1)^2 with Young's modulus 1 MPa and Poisson's ratio 0.495. Continua has the law ln J = -p/K of the volume,
which differs by terms of (p/K)^2. --compressible: the law of St. Venant and Kirchhoff with Poisson's ratio 0.3, which is the same in both
programs. Takes two minutes.
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


def displacement(cells, compressible, folder):
    text, _ = calculix.finite_block("C3D20R", (cells, cells, cells), 0.3 if compressible else 0.495, not compressible)
    with open(os.path.join(folder, "case.inp"), "w", encoding="utf-8") as stream:
        stream.write("\n".join(text) + "\n")
    subprocess.run(["ccx", "-i", "case"], cwd=folder, env=dict(os.environ, OMP_NUM_THREADS="1"), stdout=subprocess.DEVNULL, check=True)
    return calculix.large_displacement(folder)[1]


def limit(cells, values):
    """(limit, order) of value = limit + C cells^-order through three meshes, whose differences fall."""
    wanted = (values[0] - values[1]) / (values[1] - values[2])
    low, high = 0.1, 20.0
    for _ in range(100):
        order = 0.5 * (low + high)
        a, b, c = (n**-order for n in cells)
        low, high = (order, high) if (a - b) / (b - c) < wanted else (low, order)
    return values[2] - (values[1] - values[2]) * c / (b - c), order


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--compressible", action="store_true")
    parser.add_argument("--cells", type=int, nargs="+", default=[6, 8, 10])
    arguments = parser.parse_args()
    found = []
    for cells in arguments.cells:
        with tempfile.TemporaryDirectory() as folder:
            found.append(displacement(cells, arguments.compressible, folder))
        print(f"{cells} x {cells} x {cells} cells: {found[-1]:.6f} mm", flush=True)
    if len(found) > 2:
        value, order = limit(arguments.cells[-3:], found[-3:])
        print(f"limit of the last three: {value:.5f} mm, order {order:.1f}")


if __name__ == "__main__":
    main()
