#!/usr/bin/env bash
# Library:  CalculiX CrunchiX (ccx)
# Version:  Debian 12: calculix-ccx 2.20-1
# Sentence: In axisymmetric models a load counts for the whole circle, but the reaction that ccx prints is that of 2 degrees.
#
# Guessed:  The reactions of a body in equilibrium are the loads with the other sign.
# Seen:     ccx takes a force of *CLOAD as that of the whole circle. The sum of the reactions of *NODE PRINT, TOTALS=ONLY is a 180th part of it, since ccx
#           makes a wedge of 2 degrees of the elements. The displacements are right.
# Output:   Cylinder, radius 10 mm, length 20 mm, Young's modulus 1 MPa, pulled by 31.4159 N, elements CAX8:
#               elongation           2.00000 mm, exact 2.00000 mm
#               sum of the reactions -0.174533 N, a 180th part of the load
# Matters:  Who holds the end of a tube in CalculiX and compares the axial force of the wall with the probe `force` of Continua (whole circle) finds
#           another number by a factor of 180.
# To do:    Multiply the reactions of axisymmetric elements by 180.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../scripts/lib/findings.sh"
unpack calculix-ccx=2.20-1 libspooles2.2=2.2-14
need_libraries ccx

cat >finding.py <<'END'
import math
import subprocess
import sys

RADIUS, LENGTH, MODULUS, FORCE = 10.0, 20.0, 1.0, 10.0 * math.pi  # mm, MPa, N
# One element of second order. The radial motion is free, and Poisson's ratio 0, so that the stress is uniform.
POINTS = [(0, 0), (RADIUS, 0), (RADIUS, LENGTH), (0, LENGTH), (RADIUS / 2, 0), (RADIUS, LENGTH / 2), (RADIUS / 2, LENGTH), (0, LENGTH / 2)]
# A uniform stress on the top: the nodes at radius 0, R/2 and R take 0, 2/3 and 1/3 of the force.
lines = ["*NODE, NSET=ALL", *(f"{i + 1}, {x}, {y}, 0" for i, (x, y) in enumerate(POINTS)),
         "*ELEMENT, TYPE=CAX8, ELSET=BODY", "1, 1, 2, 3, 4, 5, 6, 7, 8", "*NSET, NSET=BOTTOM", "1, 2, 5", "*NSET, NSET=TOP", "3, 4, 7",
         "*MATERIAL, NAME=M", "*ELASTIC", f"{MODULUS}, 0.", "*SOLID SECTION, ELSET=BODY, MATERIAL=M", "*BOUNDARY", "BOTTOM, 2, 2", "1, 1, 1",
         "4, 1, 1", "8, 1, 1", "*STEP", "*STATIC", "*CLOAD", f"7, 2, {2 * FORCE / 3:.12g}", f"3, 2, {FORCE / 3:.12g}",
         "*NODE PRINT, NSET=BOTTOM, TOTALS=ONLY", "RF", "*NODE PRINT, NSET=TOP", "U", "*END STEP", ""]
with open("cylinder.inp", "w") as stream:
    stream.write("\n".join(lines))
output = subprocess.run(["ccx", "cylinder"], check=True, capture_output=True, text=True).stdout
if "ERROR" in output:
    sys.exit(output)
with open("cylinder.dat") as stream:
    rows = [line.split() for line in stream if line.strip()]
numbers = [row for row in rows if all(part.lstrip("-").replace(".", "").replace("E", "").replace("+", "").replace("-", "").isdigit() for part in row)]
reaction = next(float(row[1]) for row in numbers if len(row) == 3)
elongation = next(float(row[2]) for row in numbers if len(row) == 4 and row[0] == "3")
exact = FORCE * LENGTH / (MODULUS * math.pi * RADIUS**2)
print(f"elongation {elongation:.5f} mm, exact {exact:.5f} mm")
print(f"load {FORCE:.4f} N, sum of the reactions {reaction:.6g} N: the load over {-FORCE / reaction:.4f}")
if abs(elongation - exact) > 1e-4 * exact:
    sys.exit("the model is not as it was meant")
sys.exit(0 if abs(FORCE / reaction + 180) < 0.1 else 3)
END
judge "$python" finding.py
