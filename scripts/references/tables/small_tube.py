#!/usr/bin/python3
"""Makes the synthetic measurements of the identifications of a small tube in tests/runs/studies and in tests/scripts/test_identification.py.

    build/release/continua tests/runs/studies/common/small-tube.prm --output output/small-tube
    scripts/references/tables/small_tube.py output/small-tube simulated tests/runs/studies/common/small-tube-simulated.csv
    build/release/continua tests/runs/studies/common/small-tube.prm --set "Analysis=linear wave theory" --output output/small-tube-theory
    scripts/references/tables/small_tube.py output/small-tube-theory theory tests/runs/studies/common/small-tube-theory.csv
    scripts/references/tables/small_tube.py strip tests/runs/studies/common/small-tube-strip.csv

The histories of the stations, of the simulation on the file's own mesh or of the exact theory, each millisecond, with normally distributed noise
(standard deviations below, seed 1). `strip`: the relaxation of a bar of the same wall at a strain of 2 %, with noise of 0.3 % of each value. With the Laplace variable s
its modulus is E(s) = 9 K mu/(3 K + mu), mu(s) = mu_0 + mu_1 s tau/(1 + s tau), whose partial fractions are its exponentials. Needs the packages that scripts/packages.txt lists for plots.
"""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "lib"))
sys.dont_write_bytecode = True

import continua  # noqa: E402
import numpy  # noqa: E402

STATIONS = (0.05, 0.15)  # m
FIELDS = (("pressure", "Pa", 1, 5, 1), ("wall distension", "um", 1e6, 0.3, 2))  # unit, its number in SI, noise, decimals


def write(folder, source, file):
    waves = continua.open(folder).waves["stations"].sel(source=source)
    noise = numpy.random.RandomState(1)
    times = numpy.arange(0, 1000 * waves["time"].to_numpy()[-1] + 1e-6)  # ms
    header, columns = ["time [ms]"], []
    for field, unit, factor, deviation, decimals in FIELDS:
        for station in STATIONS:
            curve = waves[field].sel(position=station)
            exact = numpy.interp(times, 1000 * curve["time"].to_numpy(), factor * curve.to_numpy())
            header.append(f"{station:g} m: {field} [{unit}]")
            columns.append([f"{value:.{decimals}f}" for value in exact + deviation * noise.standard_normal(len(times))])
    with open(file, "w", encoding="utf-8") as stream:
        stream.write("# Synthetic, not measured: made by scripts/references/tables/small_tube.py, which says how.\n")
        stream.write(", ".join(header) + "\n")
        for i, time in enumerate(times):
            stream.write(f"{time:g}, " + ", ".join(column[i] for column in columns) + "\n")


def strip_modulus(times, young=1.2e6, ratio=0.49, shear=30e3, relaxation_time=5e-3):
    """Stress over strain [Pa] of a bar that is stretched at t = 0."""
    bulk, lasting = young / (3 * (1 - 2 * ratio)), young / (2 * (1 + ratio))
    # E(s) = 9 K N/(3 K (1 + s tau) + N), N = mu (1 + s tau) = mu_0 + (mu_0 + mu_1) tau s.
    top, slope = lasting, (lasting + shear) * relaxation_time
    bottom, slope_below = 3 * bulk + top, 3 * bulk * relaxation_time + slope
    last, first = 9 * bulk * top / bottom, 9 * bulk * slope / slope_below
    return last + (first - last) * numpy.exp(-times * bottom / slope_below)


def write_strip(file, strain=0.02):
    noise = numpy.random.RandomState(1)
    times = numpy.geomspace(1e-3, 10, 25)
    stresses = strain * strip_modulus(times) * (1 + 0.003 * noise.standard_normal(len(times)))
    with open(file, "w", encoding="utf-8") as stream:
        stream.write("# Synthetic, not measured: made by scripts/references/tables/small_tube.py, which says how.\n")
        stream.write("time [ms], stress [kPa]\n")
        for time, stress in zip(times, stresses):
            stream.write(f"{1000 * time:.6g}, {stress / 1000:.6g}\n")


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1] == "strip":
        write_strip(sys.argv[2])
        sys.exit()
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    write(*sys.argv[1:])
