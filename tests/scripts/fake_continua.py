#!/usr/bin/python3
"""Stands in for the program in the tests of the drivers and scripts: the same command line, y = sin(t) for a result.

Keys of its parameter files: `Cells` (the error is Cells^-2), `End time`, `Amplitude` (then y is a constant and a sign that
alternates with this amplitude), `Relaxation` (in W, of 3 W that are put in; 0.5 W are viscous and the rest is stored), `Misbehave` (what
the drivers must notice).
"""

import json
import math
import os
import re
import sys


def main():
    arguments = sys.argv[1:]
    file, output, overrides, flags = None, None, [], set()
    while arguments:
        argument = arguments.pop(0)
        if argument == "--output":
            output = arguments.pop(0)
        elif argument == "--set":
            overrides.append(arguments.pop(0))
        elif argument.startswith("--"):
            flags.add(argument)
        else:
            file = argument
    with open(file, encoding="utf-8") as stream:
        keys = dict(re.findall(r"^\s*set\s+(.*?)\s*=\s*(.*?)\s*$", stream.read(), re.MULTILINE))
    for override in overrides:
        path, value = override.split("=", 1)
        keys[path.split("/")[-1]] = value
    misbehave = keys.get("Misbehave", "")

    if "Cells" not in keys:
        if misbehave == "crash":
            os.abort()
        if misbehave == "folder":
            os.makedirs(output)
        print(f"{file}: line 3: no key 'Cels'; the nearest is 'Cells'", file=sys.stderr)
        sys.exit(2)
    if "--validate" in flags:
        print("valid")
        return

    rank = int(os.environ.get("OMPI_COMM_WORLD_RANK", "0"))
    ranks = int(os.environ.get("OMPI_COMM_WORLD_SIZE", "1"))
    if rank != 0:
        return
    checkpoint = os.path.join(output, "checkpoint")
    n = int(keys.get("End time", "10"))
    first = 0
    if "--restart" in flags:
        with open(checkpoint, encoding="utf-8") as stream:
            first = int(stream.read()) + (2 if misbehave == "restart" else 1)
    os.makedirs(output, exist_ok=True)
    with open(os.path.join(output, "probes.csv"), "a" if first else "w", encoding="utf-8") as stream:
        if not first:
            stream.write("time [s],tip: displacement y [m]\n")
        for i in range(first, n + 1):
            value = math.sin(i) * (1 + (1e-6 * (ranks - 1) if misbehave == "ranks" else 0))
            if "Amplitude" in keys:
                value = 1 + (-1)**i * float(keys["Amplitude"])
            stream.write(f"{i},{value!r}\n")
    if "Relaxation" in keys:
        relaxation = float(keys["Relaxation"])
        with open(os.path.join(output, "power.csv"), "w", encoding="utf-8") as stream:
            stream.write("time [s],balance time [s],external [W],viscous [W],relaxation [W],wall: relaxation [W],"
                         "kinetic energy [J],strain energy [J],compressive energy [J],work of loads [J]\n")
            for i in range(1, n + 1):
                balance = i if misbehave == "balance" else i - 0.5
                stored = (2 if misbehave == "stored" else 2.5 - relaxation) * i
                stream.write(f"{i},{balance},3,0.5,{relaxation},{relaxation},0,{stored},0,{3 * i}\n")
    with open(checkpoint, "w", encoding="utf-8") as stream:
        stream.write(str(n))
    error = float(keys["Cells"])**(-1 if misbehave == "order" else -2)
    passed = misbehave != "value"
    summary = {
        "title": "A sine",
        "status": "finished",
        "steps": n - first if misbehave == "steps" else n,
        "warnings": [],
        **({"restarts": 1} if first else {}),
        "quantities": [{"name": "velocity error", "value": error, "unit": "m/s", "probe": ""},
                       {"name": "frequency", "value": 3 + error, "unit": "Hz", "probe": "tip"},
                       {"name": "energy relaxed", "value": 1.0 * n, "unit": "J", "probe": "wall"}],
        "checks": [{"name": "frequency", "probe": "tip", "criterion": "3 Hz +- 10 %", "expected": 3.0,
                    "tolerance": 0.3, "unit": "Hz", "value": 3 + error, "passed": passed}],
    }
    with open(os.path.join(output, "summary.json"), "w", encoding="utf-8") as stream:
        json.dump(summary, stream)
    print("frequency (tip): " + ("within 10 % of 3 Hz" if passed else "FAILED"))


if __name__ == "__main__":
    main()
