#!/usr/bin/python3
"""The windkessel of parameter_files/verification/pipe-with-rcr.prm under the flow of its table, without Continua.

    scripts/references/outlets/pipe_with_rcr.py

The compliance's volume x obeys dx/dt = Q - x/tau, tau = R_d C. In a row interval of length h, with Q = a + b s,

    x(h) = x(0) e^(-h/tau) + a tau (1 - e^(-h/tau)) + b tau (h - tau (1 - e^(-h/tau))),

and p = R_p Q + x/C. Prints the largest pressure, its time, and the pressure at the end.
"""

import csv
import math
import os

FLOW = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../parameter_files/verification/pipe-with-rcr.csv")
PROXIMAL, DISTAL, COMPLIANCE = 12.1e6, 121.2e6, 0.15e-9
N_SAMPLES = 1000  # in an interval of the table


def main():
    with open(FLOW, encoding="utf-8") as stream:
        rows = [row for row in csv.reader(line for line in stream if not line.startswith("#"))][1:]
    table = [(float(time), float(flow) * 1e-6) for time, flow in rows]
    tau, x, largest = DISTAL * COMPLIANCE, 0.0, (0.0, 0.0)
    for (begin, flow), (end, next_flow) in zip(table, table[1:]):
        slope, start = (next_flow - flow) / (end - begin), x
        for i in range(1, N_SAMPLES + 1):
            s = (end - begin) * i / N_SAMPLES
            filling = -tau * math.expm1(-s / tau)
            x = start * math.exp(-s / tau) + flow * filling + slope * tau * (s - filling)
            largest = max(largest, (PROXIMAL * (flow + slope * s) + x / COMPLIANCE, begin + s))
    print(f"largest {largest[0]:.3f} Pa at {largest[1]:.5f} s, at the end {PROXIMAL * table[-1][1] + x / COMPLIANCE:.4f} Pa")


if __name__ == "__main__":
    main()
