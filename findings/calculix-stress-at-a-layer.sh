#!/usr/bin/env bash
# Library:  CalculiX CrunchiX (ccx)
# Version:  Debian 12: calculix-ccx 2.20-1
# Sentence: At the interface of two layers the results file (.frd) has the mean of the two layers' stresses.
#
# Guessed:  The hoop stress of a wall of two layers jumps at their interface. The elements of each layer have their own stress, so
#           the results file shows one of the two values, or both.
# Seen:     A node of the interface has one value: the mean of both layers. It is the stress of none of them. It does not approach
#           either stress on a finer mesh. The displacements, and the stresses at the integration points, are right.
# Output:   Tube in plane strain, radii 10, 11 and 12 mm, Young's moduli 100 and 1000 kPa, inner pressure 10 kPa. Hoop stress at the
#           interface in kPa, with 4 and with 32 elements of second order across each layer:
#               inner layer:  exact   3.62   .frd with shared nodes  51.99 and 51.96   with nodes of its own   3.63 and   3.62
#               outer layer:  exact 100.31   .frd with shared nodes  51.99 and 51.96   with nodes of its own 100.36 and 100.30
# Matters:  Who compares the layers of a vessel wall in Continua with CalculiX, or shows the .frd in cgx, sees a stress that is wrong by
#           half of the jump, and a steep slope inside each layer beside it.
# To do:    Give each layer its own nodes at the interface, and couple them by *EQUATION, as below. Or take the stresses at the
#           integration points (*EL PRINT).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../scripts/lib/findings.sh"
unpack calculix-ccx=2.20-1 libspooles2.2=2.2-14
need_libraries ccx

cat >finding.py <<'END'
import subprocess
import sys

INNER, INTERFACE, OUTER = 10.0, 11.0, 12.0  # mm
MODULI = {"SOFT": 100.0, "STIFF": 1000.0}  # kPa, from inside to outside
POISSON, PRESSURE = 0.45, 10.0


def write_input(name, n, shared):
    """A ring of axisymmetric elements of second order, held axially, n across each layer; the nodes of the interface are `shared` or doubled."""
    size = (OUTER - INNER) / (2 * n)  # of a square element
    nodes, lines = {}, ["*NODE, NSET=ALL"]

    def add(radius, j):
        nodes[radius, j] = number = len(nodes) + 1
        lines.append(f"{number}, {radius:.10g}, {j * size / 2:.10g}, 0")
        return number

    last = 4 * n
    grid = {(i, j): add(INNER + (OUTER - INNER) * i / last, j) for i in range(last + 1) for j in range(3) if not (i % 2 and j == 1)}
    middle = 2 * n
    twins = {}
    if not shared:
        for j in range(3):
            number = len(grid) + len(twins) + 1
            lines.append(f"{number}, {INTERFACE:.10g}, {j * size / 2:.10g}, 0")
            twins[grid[middle, j]] = number
    for layer, first in (("SOFT", 0), ("STIFF", n)):
        lines.append(f"*ELEMENT, TYPE=CAX8, ELSET={layer}")
        for e in range(first, first + n):
            corners = [grid[2 * e + i, j] for i, j in ((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1))]
            if layer == "STIFF":
                corners = [twins.get(node, node) for node in corners]
            lines.append(", ".join(map(str, [e + 1, *corners])))
    for layer, modulus in MODULI.items():
        lines += [f"*MATERIAL, NAME={layer}", "*ELASTIC", f"{modulus}, {POISSON}", f"*SOLID SECTION, ELSET={layer}, MATERIAL={layer}"]
    lines += ["*BOUNDARY", "ALL, 2, 2"]
    for node, twin in twins.items():
        lines += ["*EQUATION", "2", f"{twin}, 1, 1., {node}, 1, -1."]
    lines += ["*STEP", "*STATIC", "*DLOAD", f"1, P4, {PRESSURE}", "*NODE FILE", "U", "*EL FILE", "S", "*END STEP", ""]
    with open(name + ".inp", "w") as stream:
        stream.write("\n".join(lines))
    return grid[middle, 0], twins.get(grid[middle, 0])


def hoop_stresses(name):
    """Node -> hoop stress of the block STRESS of the .frd, whose columns have 12 letters."""
    stresses, inside = {}, False
    with open(name + ".frd") as stream:
        for line in stream:
            if line.startswith(" -4"):
                inside = line.split()[1] == "STRESS"
            elif inside and line.startswith(" -1"):
                stresses[int(line[3:13])] = float(line[13 + 2 * 12:13 + 3 * 12])
    return stresses


def run(n, shared):
    name = f"tube-{n}-{shared}"
    node, twin = write_input(name, n, shared)
    output = subprocess.run(["ccx", name], check=True, capture_output=True, text=True).stdout
    if "ERROR" in output:
        sys.exit(output)
    stresses = hoop_stresses(name)
    return stresses[node], stresses[twin or node]


def lame(a, b, inside, outside):
    """Lame's cylinder in plane strain between the pressures: hoop stress and modulus times displacement, of the radius."""
    A = (inside * a**2 - outside * b**2) / (b**2 - a**2)
    B = (inside - outside) * a**2 * b**2 / (b**2 - a**2)
    return (lambda r: A + B / r**2), (lambda r: (1 + POISSON) * ((1 - 2 * POISSON) * A * r + B / r))


def jump(pressure):
    """Difference of the layers' displacements at the interface, which is linear in the pressure there."""
    inner = lame(INNER, INTERFACE, PRESSURE, pressure)[1](INTERFACE) / MODULI["SOFT"]
    return inner - lame(INTERFACE, OUTER, pressure, 0.0)[1](INTERFACE) / MODULI["STIFF"]


pressure = jump(0.0) / (jump(0.0) - jump(1.0))
exact = (lame(INNER, INTERFACE, PRESSURE, pressure)[0](INTERFACE), lame(INTERFACE, OUTER, pressure, 0.0)[0](INTERFACE))
mean = (exact[0] + exact[1]) / 2
still_so = True
for n in (4, 32):
    shared, own = run(n, True), run(n, False)
    for label, *values in zip(("inner", "outer"), exact, shared, own):
        print("{:2} elements, {} layer: hoop stress [kPa] exact {:6.2f}, shared nodes {:6.2f}, own nodes {:6.2f}".format(n, label, *values))
    for value, reference in ((shared[0], mean), (own[0], exact[0]), (own[1], exact[1])):
        still_so = still_so and abs(value - reference) < 0.005 * mean
sys.exit(0 if still_so else 3)
END
judge "$python" finding.py
