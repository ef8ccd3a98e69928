#!/usr/bin/python3
"""Makes the two synthetic tables of parameter_files/examples/own-tube.prm.

    scripts/references/own_tube.py inlet parameter_files/examples/inlet-pressure.csv
    build/release/continua parameter_files/examples/own-tube.prm --set "Analysis=linear wave theory" \\
        --set "Probes/stations/Measured=" --output output/own-tube-theory
    scripts/references/own_tube.py stations output/own-tube-theory/wave.csv parameter_files/examples/stations.csv

`inlet`: a pulse of 40 mmHg over 80 mmHg that rises faster than it falls, as an instrument with steps of 0.1 mmHg would show
it each millisecond. `stations`: what exact wave theory says at the stations, each second millisecond, with normally
distributed noise (standard deviations below, seed 1) as of instruments. Needs python3-numpy.
"""

import csv
import sys

import numpy

MMHG = 133.322387415  # Pa
PRESSURE_NOISE, DISTENSION_NOISE = 0.2, 1.0  # mmHg, um
PRESSURE_STATIONS, DISTENSION_STATIONS = (0.1, 0.3, 0.5), (0.3,)  # m


def write_inlet(file):
    times = numpy.arange(61)  # ms
    pressures = 80 + 40 * numpy.sin(numpy.pi * numpy.clip(times / 50, 0, 1) ** 0.75) ** 2
    with open(file, "w", encoding="utf-8") as stream:
        stream.write("# Synthetic, not measured: made by scripts/references/own_tube.py, which says how.\n")
        stream.write("time [ms], pressure [mmHg]\n")
        for time, pressure in zip(times, pressures):
            stream.write(f"{time}, {pressure:.1f}\n")


def write_stations(wave, file):
    with open(wave, encoding="utf-8", newline="") as stream:
        rows = list(csv.reader(stream))
    names = [name.strip() for name in rows[0]]
    values = numpy.array(rows[1:], float)
    noise = numpy.random.RandomState(1)
    times = numpy.arange(0, 1000 * values[-1, 0] + 1e-6, 2)  # ms
    header, columns = ["time [ms]"], []
    for stations, field, unit, factor, deviation in (
        (PRESSURE_STATIONS, "pressure", "mmHg", 1 / MMHG, PRESSURE_NOISE),
        (DISTENSION_STATIONS, "wall distension", "um", 1e6, DISTENSION_NOISE),
    ):
        for station in stations:
            column = names.index(next(n for n in names if n.startswith(f"stations {station:g} m: {field}, theory")))
            exact = numpy.interp(times, 1000 * values[:, 0], factor * values[:, column])
            header.append(f"{station:g} m: {field} [{unit}]")
            columns.append(exact + deviation * noise.standard_normal(len(times)))
    with open(file, "w", encoding="utf-8") as stream:
        stream.write(
            "# Synthetic, not measured: exact linear wave theory with normally distributed noise of 0.2 mmHg and 1 um,\n"
            "# made by scripts/references/own_tube.py, which says how. Pressures are over the inlet's 80 mmHg.\n"
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
