#!/usr/bin/python3
"""Deflection of the beam of chapter 4 at rest, nearly incompressible, by another program: CalculiX (Debian's calculix-ccx), C3D20R.

    scripts/references/solids/nearly_incompressible_beam.py

Prints the deflection of the tip [m] on three meshes and its limit by Richardson's extrapolation, at Poisson's ratios of 0.49 and 0.4999.
The references of parameter_files/thesis/chapter-4/fv-static-0.49.prm and fv-static-0.4999.prm. Takes 10 s.
"""

import os
import subprocess
import sys
import tempfile

SCRIPTS = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(SCRIPTS, "lib"))
sys.dont_write_bytecode = True

import calculix  # noqa: E402

LENGTH, HEIGHT, YOUNG, DENSITY, TRACTION = 20.0, 5.0, 4e9, 1450.0, 1e6


def deflection(poisson, cells, folder):
    layer = calculix.Layer(calculix.beam((LENGTH, HEIGHT)), cells, "C3D20R", 1.0)
    i, j = layer.last()
    held = layer.nodes_at(i=0)
    lines = calculix.model_text(layer, {"young": YOUNG, "poisson": poisson, "density": DENSITY})
    lines += calculix.held(held, 1) + calculix.held(held, 2) + calculix.node_set(layer.node(i, j // 2))
    lines += ["*STEP", "*STATIC", *calculix.loads(layer.end_forces(TRACTION * HEIGHT), 2), *calculix.watch(), "*END STEP"]
    with open(os.path.join(folder, "case.inp"), "w", encoding="utf-8") as stream:
        stream.write("\n".join(lines) + "\n")
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    subprocess.run(["ccx", "-i", "case"], cwd=folder, env=environment, stdout=subprocess.DEVNULL, check=True)
    return calculix.displacements(folder)[-1][2]


def main():
    for poisson in (0.49, 0.4999):
        with tempfile.TemporaryDirectory() as folder:
            values = [deflection(poisson, (8 * n, 2 * n), folder) for n in (4, 8, 16)]
        first, second, third = values
        limit = third + (third - second) ** 2 / ((second - first) - (third - second))
        print(f"nu = {poisson}:", ", ".join(f"{value:.5f}" for value in values), f"m on 32 x 8, 64 x 16, 128 x 32 cells; limit {limit:.5f} m")


if __name__ == "__main__":
    main()
