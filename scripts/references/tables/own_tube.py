#!/usr/bin/python3
"""Makes the two synthetic tables of parameter_files/examples/own-tube.prm.

    scripts/references/tables/own_tube.py inlet parameter_files/examples/inlet-pressure.csv
    build/release/continua parameter_files/examples/own-tube.prm --set "Analysis=linear wave theory" --output output/own-tube-theory
    scripts/references/tables/own_tube.py stations output/own-tube-theory parameter_files/examples/stations.csv

`inlet`: a pulse of 40 mmHg over 80 mmHg that rises faster than it falls, as an instrument with steps of 0.1 mmHg would show
it each millisecond. `stations`: what exact wave theory says at the stations, each second millisecond, with normally
distributed noise (standard deviations below, seed 1) as of instruments. Needs the packages that scripts/packages.txt lists for plots.
"""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "lib"))
sys.dont_write_bytecode = True

import continua  # noqa: E402
import numpy  # noqa: E402

MMHG = 133.322387415  # Pa
PRESSURE_NOISE, DISTENSION_NOISE = 0.2, 1.0  # mmHg, um
PRESSURE_STATIONS, DISTENSION_STATIONS = (0.1, 0.3, 0.5), (0.3,)  # m


def write_inlet(file):
    times = numpy.arange(61)  # ms
    pressures = 80 + 40 * numpy.sin(numpy.pi * numpy.clip(times / 50, 0, 1) ** 0.75) ** 2
    with open(file, "w", encoding="utf-8") as stream:
        stream.write("# Synthetic, not measured: made by scripts/references/tables/own_tube.py, which says how.\n")
        stream.write("time [ms], pressure [mmHg]\n")
        for time, pressure in zip(times, pressures):
            stream.write(f"{time}, {pressure:.1f}\n")


def write_stations(folder, file):
    theory = continua.open(folder).waves["stations"].sel(source="theory")
    noise = numpy.random.RandomState(1)
    times = numpy.arange(0, 1000 * theory["time"].to_numpy()[-1] + 1e-6, 2)  # ms
    header, columns = ["time [ms]"], []
    for stations, field, unit, factor, deviation in (
        (PRESSURE_STATIONS, "pressure", "mmHg", 1 / MMHG, PRESSURE_NOISE),
        (DISTENSION_STATIONS, "wall distension", "um", 1e6, DISTENSION_NOISE),
    ):
        for station in stations:
            curve = theory[field].sel(position=station)
            exact = numpy.interp(times, 1000 * curve["time"].to_numpy(), factor * curve.to_numpy())
            header.append(f"{station:g} m: {field} [{unit}]")
            columns.append(exact + deviation * noise.standard_normal(len(times)))
    with open(file, "w", encoding="utf-8") as stream:
        stream.write(
            "# Synthetic, not measured: exact linear wave theory with normally distributed noise of 0.2 mmHg and 1 um,\n"
            "# made by scripts/references/tables/own_tube.py, which says how. Pressures are over the inlet's 80 mmHg.\n"
        )
        stream.write(", ".join(header) + "\n")
        for i, time in enumerate(times):
            stream.write(f"{time:g}, " + ", ".join(f"{column[i]:.2f}" for column in columns) + "\n")


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1] == "inlet":
        write_inlet(sys.argv[2])
    elif len(sys.argv) == 4 and sys.argv[1] == "stations":
        write_stations(sys.argv[2], sys.argv[3])
    else:
        sys.exit(__doc__)
