#!/usr/bin/python3
"""What the counts of benchmark_scaling on two ranks mean for many: extrapolate_ranks.py SCALING.json

Prints markdown tables. The model, for an interior rank of P with as many cells as were measured on one rank:

    compute      the step's time on one rank
    messages     (messages to a neighbour) (neighbours) alpha (levels) + (bytes a face between ranks) (faces) / beta
    collectives  (reductions and barriers) 2 log2(P) alpha + (broadcasts) log2(P) alpha + (all-to-all) P alpha
    MUMPS        (bytes of its broadcasts and reductions an unknown of the whole problem) (unknowns) / beta
    gathers      (gathers) log2(P) alpha + (bytes from a rank) P / beta

neighbours and faces are those of a cube (square) of cells in the middle of others: 26 (8), and 6 c^(2/3) (4 c^(1/2));
levels is the growth of the hierarchy of algebraic multigrid with the mesh, whose cells an aggregate unites 27 (9) at a
time; it is 1 without. Of MUMPS memory and work are told besides, not its messages: entries ~ N^(4/3) and operations ~ N^2 in
three dimensions, N log N and N^(3/2) in two (nested dissection; George 1973).
"""

import json
import math
import sys

ALPHA = 2e-6    # s, of a message between nodes
NODE = 25e9     # bytes/s of a node
RANKS = 128     # of a node
BETA = NODE / RANKS
MEMORY = 4e9    # bytes of a rank
TARGETS = (16, 128, 1024, 10000)
INDICES = 2**31


def table(heading, columns, rows):
    print(f"\n{heading}\n\n| " + " | ".join(columns) + " |\n|" + "---:|" * len(columns))
    for row in rows:
        print("| " + " | ".join(cell if isinstance(cell, str) else f"{cell:.3g}" for cell in row) + " |")


def find(tubes, dimensions, solver, mesh, ranks):
    for tube in tubes:
        if (tube["dimensions"], tube["solver"], tube["mesh"], tube["ranks"]) == (dimensions, solver, mesh, ranks):
            return tube["values"]
    return None


def steps(dimensions, solver, one, two):
    """Rows of the table of one tube."""
    cells = one["cells"]
    neighbours = 26 if dimensions == 3 else 8
    faces = 6 * cells**(2 / 3) if dimensions == 3 else 4 * cells**0.5
    aggregate = 27 if dimensions == 3 else 9

    def of(kind):
        return two[f"step other {kind} calls"], two[f"step other {kind} bytes"]

    for ranks in TARGETS:
        hops = math.ceil(math.log2(ranks))
        levels_here = 1 + max(0, math.log(one["dofs"] / 1000, aggregate))
        levels = 1 if solver != "iterative" else 1 + math.log(ranks, aggregate) / levels_here
        messages, message_bytes = of("messages")
        t_messages = messages * neighbours * ALPHA * levels + message_bytes / two["cut faces"] * faces / BETA
        collectives = of("reductions")[0] + of("barriers")[0]
        t_collectives = (collectives * 2 * hops + of("broadcasts")[0] * hops + of("all-to-all")[0] * ranks) * ALPHA
        of_mumps = sum(two[f"step mumps {kind} bytes"] for kind in ("broadcasts", "reductions")) / two["dofs"]
        t_mumps = of_mumps * ranks * one["dofs"] / BETA
        gathers, gather_bytes = of("gathers")
        t_gathers = gathers * hops * ALPHA + gather_bytes / 2 * ranks / BETA
        compute = one["step [s]"]
        whole = compute + t_messages + t_collectives + t_gathers + t_mumps
        yield (str(dimensions), solver, str(ranks), ranks * one["dofs"], 1e3 * compute, 1e3 * t_messages,
               1e3 * t_collectives, 1e3 * t_gathers, 1e3 * t_mumps, compute / whole)


def main():
    with open(sys.argv[1], encoding="utf-8") as stream:
        measured = json.load(stream)
    tubes, meshes = measured["tubes"], measured["meshes"]
    solvers = sorted({tube["solver"] for tube in tubes})
    direct = next((solver for solver in solvers if solver != "iterative"), None)

    rows = []
    for dimensions in (2, 3):
        for solver in solvers:
            one, two = (find(tubes, dimensions, solver, "strong", ranks) for ranks in (1, 2))
            if one and two:
                rows += steps(dimensions, solver, one, two)
    table(f"A step, the cells of the one-rank run on every rank; alpha = {1e6 * ALPHA:g} us, beta = {1e-9 * BETA:.2g} GB/s "
          "a rank",
          ("dim", "solver", "ranks", "unknowns", "compute [ms]", "messages [ms]", "collectives [ms]", "gathers [ms]",
           "whole vectors of MUMPS [ms]", "efficiency"), rows)

    rows = []
    for dimensions in (2, 3):
        one = find(tubes, dimensions, direct, "strong", 1)
        if not one:
            continue
        for ranks in TARGETS:
            growth = ranks * math.log2(ranks * one["dofs"]) / math.log2(one["dofs"]) if dimensions == 2 else ranks**(4 / 3)
            work = ranks**1.5 if dimensions == 2 else ranks**2
            factor = one["factor memory [bytes]"] * growth
            rows.append((str(dimensions), str(ranks), ranks * one["dofs"], 1e-9 * factor / ranks,
                         (one["first step [s]"] - one["step [s]"]) * work / ranks,
                         "yes" if factor / ranks < MEMORY else "no"))
    table("The direct solver, work and memory shared evenly",
          ("dim", "ranks", "unknowns", "factor a rank [GB]", "time of a factor [s]", f"fits into {1e-9 * MEMORY:g} GB"), rows)

    rows = []
    for dimensions in (2, 3):
        for solver in solvers:
            two = find(tubes, dimensions, solver, "strong", 2)
            if not two:
                continue
            for stage in ("set-up", "step", "probes", "fields"):
                rows.append((str(dimensions), solver, stage, two[f"{stage} other gathers calls"],
                             two[f"{stage} other gathers bytes"] / 2,
                             1e-6 * two[f"{stage} other gathers bytes"] / 2 * 10000))
    table("What every rank gathers from each other one",
          ("dim", "solver", "stage", "gathers", "bytes from a rank", "MB on 10000 ranks"), rows)

    rows = []
    for partitioner in ("p4est", "metis"):
        for coarse in sorted({mesh["coarse cells"] for mesh in meshes}):
            last = max((mesh for mesh in meshes if mesh["partitioner"] == partitioner
                        and mesh["coarse cells"] == coarse), key=lambda mesh: mesh["ranks"])
            whole = coarse == last["cells"] or partitioner == "metis"
            a_cell = last["bytes"] / last["cells"] * (1 if whole else last["ranks"])
            rows.append((partitioner, "not refined" if coarse == last["cells"] else "refined", str(last["ranks"]),
                         "every cell of the mesh" if whole else "a cell of the rank", a_cell, MEMORY / a_cell))
    table(f"Memory of the mesh on most ranks; cells that fill {1e-9 * MEMORY:g} GB of a rank",
          ("partitioner", "coarse mesh", "ranks", "a rank has", "bytes a cell", "cells at most"), rows)

    rows = []
    for dimensions in (2, 3):
        one = find(tubes, dimensions, direct, "strong", 1)
        if one:
            rows.append((str(dimensions), one["dofs"] / one["cells"], INDICES / (one["dofs"] / one["cells"]),
                         INDICES / one["dofs"], INDICES / 1e5))
    table("Unknowns of one kind have indices of 31 bits",
          ("dim", "unknowns a cell", "cells at most", "ranks at the measured unknowns a rank", "ranks at 1e5 a rank"), rows)


if __name__ == "__main__":
    main()
