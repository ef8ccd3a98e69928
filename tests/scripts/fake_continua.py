#!/usr/bin/python3
"""Stands in for the program in the tests of the drivers and scripts: the same command line, y = sin(t) for a result.

Keys of its parameter files: `Cells` (the error is Cells^-2), `End time`, `Amplitude` (then y is a constant and a sign that
alternates with this amplitude), `Relaxation` (in W, of 3 W that are put in; 0.5 W are viscous and the rest is stored), `Misbehave` (what
the drivers must notice), `Interrupted` (the first call ends with a checkpoint in the middle), `Fails` (what it ends with).
"""

import base64
import json
import math
import os
import re
import struct
import sys
import zlib

with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "VERSION"), encoding="utf-8") as file_of_version:
    VERSION = file_of_version.read().strip()


def data_array(kind, name, width, numbers, ascii_text):
    """As deal.II writes them: ascii, or in blocks that are compressed and coded."""
    head = f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{width}" '
    if ascii_text:
        return head + 'format="ascii">' + " ".join(repr(x) for x in numbers) + "</DataArray>"
    data = struct.pack(f"<{len(numbers)}{'f' if kind == 'Float32' else 'i'}", *numbers)
    blocks = [data[i:i + 16] for i in range(0, len(data), 16)]
    packed = [zlib.compress(block) for block in blocks]
    sizes = struct.pack(f"<{3 + len(blocks)}I", len(blocks), 16, len(blocks[-1]), *map(len, packed))
    return (head + 'format="binary">' + base64.b64encode(sizes).decode() + base64.b64encode(b"".join(packed)).decode()
            + "</DataArray>")


def write_fields(output, n, value, reverse, ascii_text):
    """Three cells of a line with one field; in the other order when told to."""
    cells = [2, 1, 0] if reverse else [0, 1, 2]
    points = [x for cell in cells for place in (cell, cell + 1) for x in (float(place), 0.0, 0.0)]
    values = [value * (cell + 1) for cell in cells for _ in range(2)]
    os.makedirs(os.path.join(output, "fields"), exist_ok=True)
    with open(os.path.join(output, "fields", "solution-00000.vtu"), "w", encoding="utf-8") as stream:
        stream.write('<VTKFile type="UnstructuredGrid" version="0.1"'
                     + ('' if ascii_text else ' compressor="vtkZLibDataCompressor"') + '><UnstructuredGrid>'
                     '<Piece NumberOfPoints="6" NumberOfCells="3"><Points>'
                     + data_array("Float32", "points", 3, points, ascii_text) + "</Points><Cells>"
                     + data_array("Int32", "connectivity", 1, list(range(6)), ascii_text)
                     + data_array("Int32", "offsets", 1, [2, 4, 6], ascii_text) + "</Cells><PointData>"
                     + data_array("Float32", "velocity", 1, values, ascii_text)
                     + data_array("Float32", "rank", 1, [float(reverse)] * 6, ascii_text)
                     + "</PointData></Piece></UnstructuredGrid></VTKFile>")
    with open(os.path.join(output, "fields.pvd"), "w", encoding="utf-8") as stream:
        stream.write(f'<VTKFile><Collection><DataSet timestep="{n}" part="0" file="fields/solution-00000.vtu"/>'
                     "</Collection></VTKFile>")


def write_log(output, ranks, misbehave):
    """What it chose, and a partition that moves while the number of unknowns stays."""
    library = "CHOLMOD, simplicial" if ranks == 1 else "MUMPS, with pivoting"
    block = "; fluid block: relaxation" if misbehave == "choices" and ranks > 1 else ""
    with open(os.path.join(output, "log.txt"), "w", encoding="utf-8") as stream:
        stream.write(f"ranks: {ranks}\nLinear solver: iterative, as it is\nFGMRES; stiff block: {library}{block}\n")
        for i in range(1, 5):
            first = 6 if misbehave == "still" else i
            cells = "12" if ranks == 1 else f"{first} {12 - first}"
            stream.write(f"t = {i} s: mesh of 12 cells\n100 unknowns; cells of each rank: {cells}\n")
        stream.write(f"Wall time by section:\n  total {ranks} s\n")


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
        place = file if misbehave == "no line" else f"{file}:{4 if misbehave == 'wrong line' else 3}"
        print(f"{place}: 'Mesh/Cels': no such key; the nearest is 'Cells'", file=sys.stderr)
        sys.exit(2)
    if "--validate" in flags:
        print("valid")
        return

    rank = int(os.environ.get("OMPI_COMM_WORLD_RANK", "0"))
    ranks = int(os.environ.get("OMPI_COMM_WORLD_SIZE", "1"))
    if rank != 0:
        return
    checkpoint = os.path.join(output, "checkpoint", "current")
    os.makedirs(os.path.dirname(checkpoint), exist_ok=True)
    if "Fails" in keys:
        with open(os.path.join(output, "summary.json"), "w", encoding="utf-8") as stream:
            json.dump({"version": VERSION, "status": "failed", "failure": keys["Fails"], "wall time [s]": {"total": 1}}, stream)
        print("error: " + keys["Fails"], file=sys.stderr)
        sys.exit(1)
    n = int(keys.get("End time", "10"))
    is_interrupted = "Interrupted" in keys and "--restart" not in flags
    n = n // 2 if is_interrupted else n
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
    write_fields(output, n, math.sin(n) * (1 + (1e-6 if misbehave == "field" and first else 0)),
                 misbehave == "order of cells" and first > 0, misbehave == "ascii")
    write_log(output, ranks, misbehave)
    error = float(keys["Cells"])**(-1 if misbehave == "order" else -2)
    passed = misbehave != "value"
    summary = {
        "title": "A sine",
        "version": VERSION,
        "status": "interrupted" if is_interrupted else "finished",
        "wall time [s]": {"total": 2.5},
        "steps": n - first if misbehave == "steps" else n,
        "warnings": [],
        **({"restarts": 1} if first else {}),
        "quantities": [{"name": "velocity error", "value": error, "unit": "m/s", "probe": ""},
                       {"name": "frequency", "value": 3 + error, "unit": "Hz", "probe": "tip"},
                       {"name": "energy relaxed", "value": 1.0 * n, "unit": "J", "probe": "wall"}],
        "checks": [{"name": "frequency", "probe": "tip", "criterion": "3 Hz +- 10 %", "expected": 3.0,
                    "tolerance": 0.3, "unit": "Hz", "value": 3 + error, "passed": passed}] if misbehave != "nothing" else [],
    }
    with open(os.path.join(output, "summary.json"), "w", encoding="utf-8") as stream:
        json.dump(summary, stream)
    if is_interrupted:
        sys.exit(1)
    print("frequency (tip): " + ("within 10 % of 3 Hz" if passed else "FAILED"))


if __name__ == "__main__":
    main()
