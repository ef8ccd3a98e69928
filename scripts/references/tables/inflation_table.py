#!/usr/bin/python3
"""The table of parameter_files/examples/inflation-test/, which is synthetic, to standard output; and the ring without load, to the error stream.

    scripts/references/tables/inflation_table.py > parameter_files/examples/inflation-test/inflation-test.csv

The artery of scripts/references/solids/artery.py (two layers, each with the law of Holzapfel, Gasser and Ogden; an opened ring of the inner radius 1.43
mm and an opening angle of 160 degrees) is held at axial stretches of 1.5 to 1.8 and inflated to 21 kPa. The equilibrium is that of the script, by
Simpson's rule and bisection. A transducer at the closed end shows the force F = N - pi a^2 p. The outer diameter has normal noise of 5 um and the force
of 0.2 mN, by Python's generator, seed 1.
"""

import math
import os
import random
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "solids"))
import artery  # noqa: E402

INNER, ANGLE = 1.43e-3, math.radians(160)  # of the opened ring
STRETCHES = (1.5, 1.6, 1.7, 1.8)
PRESSURES = [1e3 * p for p in (0, 1, 2, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21)]
NOISE_OF_DIAMETER, NOISE_OF_FORCE = 5e-6, 2e-4  # m, N


def main():
    layers = [artery.MEDIA, artery.ADVENTITIA]
    generator = random.Random(1)
    ring = artery.radius_at(0.0, layers, INNER, ANGLE, 1.0)
    k = 2 * math.pi / (2 * math.pi - ANGLE)
    radii, rest = [ring], INNER
    for layer in layers:
        rest += layer[4]
        radii.append(math.sqrt(ring**2 + (rest**2 - INNER**2) / k))
    print("the ring without load has the radii " + ", ".join(f"{1e3 * r:.7f}" for r in radii) + " mm and the thicknesses "
          + ", ".join(f"{1e3 * (b - a):.7f}" for a, b in zip(radii, radii[1:])) + " mm", file=sys.stderr)
    print("# Synthetic, not measured: an artery of two layers with fibres and an opening angle of 160 degrees, held at four axial stretches and")
    print("# inflated, with noise of 5 um and 0.2 mN; by scripts/references/tables/inflation_table.py.")
    print("axial stretch [1], pressure [kPa], outer diameter [mm], axial force [mN]")
    for stretch in STRETCHES:
        for pressure in PRESSURES:
            a = artery.radius_at(pressure, layers, INNER, ANGLE, stretch)
            _, b, force, _ = artery.inflate(layers, INNER, ANGLE, stretch, a)
            diameter = 2 * b + NOISE_OF_DIAMETER * generator.gauss(0, 1)
            transducer = force - math.pi * a * a * pressure + NOISE_OF_FORCE * generator.gauss(0, 1)
            print(f"{stretch}, {1e-3 * pressure:g}, {1e3 * diameter:.4f}, {1e3 * transducer:.3f}")


if __name__ == "__main__":
    main()
