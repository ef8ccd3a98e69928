#!/usr/bin/python3
"""Cook's membrane in large deformation by another program: CalculiX (Debian's calculix-ccx), C3D20R, for finite-strain-cook.prm.

    scripts/references/finite_strain_cook.py

Prints the displacement across the panel of the upper corner (48, 60) of the loaded end [mm] on meshes that are graded to the clamped upper corner, where
the stress is singular, and their limit. The energy is G/2 (tr b J^(-2/3) - 3) + K/2 (J - 1)^2 with G = 80.1938 MPa and K = 400942 MPa. The volume
changes so little (p/K is 1e-4 or less but near the corner) that the law of the volume does not matter. The load is a shear of 6.25 MPa that keeps its
direction. Takes two minutes.
"""

import argparse
import itertools
import os
import subprocess
import sys
import tempfile

SCRIPTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(SCRIPTS, "lib"))
sys.dont_write_bytecode = True

import calculix  # noqa: E402

SHEAR_MODULUS, BULK_MODULUS, TRACTION = 80.1938, 40.0942e4, 6.25  # [MPa], lengths in mm


def knots(cells, end):
    """Places of the cells' corners between 0 and 1, which are dense at the end 0 or 1."""
    return [(i / cells) ** 2 if end == 0 else 1 - (1 - i / cells) ** 2 for i in range(cells + 1)]


def between(places, value):
    """Piecewise linear, so that the nodes in the middle of edges are there."""
    cells = len(places) - 1
    i = min(int(value * cells), cells - 1)
    return places[i] + (value * cells - i) * (places[i + 1] - places[i])


def displacement(cells, folder):
    """Across the panel, of the upper corner of the loaded end [mm]."""
    along, across = knots(cells, 0), knots(cells, 1)

    def place(s, t):
        s, t = between(along, s), between(across, t)
        return 48 * s, 44 * s + t * (44 - 28 * s)

    layer = calculix.Layer(place, (cells, cells), "C3D20R", 1.0)
    i, j = layer.last()
    lines = []
    for line in calculix.model_text(layer, {"young": 1.0, "poisson": 0.3}):
        if line == "*ELASTIC":
            lines.append("*HYPERELASTIC, NEO HOOKE")
        elif lines and lines[-1].startswith("*HYPERELASTIC"):
            lines.append(f"{SHEAR_MODULUS / 2:.12g}, {2 / BULK_MODULUS:.12g}")
        else:
            lines.append(line)
    held = layer.nodes_at(i=0)
    lines += calculix.held(held, 1) + calculix.held(held, 2)
    # Of a face with eight nodes the corners get -1/12 of the force and the middles of edges 1/3.
    forces = {}
    for cell in range(cells):
        share = TRACTION * 16 * (across[cell + 1] - across[cell])
        for b, c in itertools.product(range(3), range(3)):
            if (b, c) != (1, 1):
                node = layer.node(i, 2 * cell + b, c)
                forces[node] = forces.get(node, 0.0) + share * (1 / 3 if 1 in (b, c) else -1 / 12)
    lines += calculix.node_set(layer.node(i, j))
    lines += ["*STEP, NLGEOM, INC=200", "*STATIC", "0.1, 1.0, 1e-6, 0.1", *calculix.loads(forces, 2), *calculix.watch(), "*END STEP"]
    with open(os.path.join(folder, "case.inp"), "w", encoding="utf-8") as stream:
        stream.write("\n".join(lines) + "\n")
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    subprocess.run(["ccx", "-i", "case"], cwd=folder, env=environment, stdout=subprocess.DEVNULL, check=True)
    time, _, y = calculix.displacements(folder)[-1]
    if abs(time - 1) > 1e-9:
        raise calculix.CalculixError(f"CalculiX stopped at {time} of the load")
    return y


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
