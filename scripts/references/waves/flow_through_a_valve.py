#!/usr/bin/python3
"""Liquid without friction in a rigid tube that ends in a valve, under a pressure that swings: L dQ/dt + R Q = P sin(w t) while the valve is open.

It opens at t = 0 and closes when Q comes to zero, which is before the pressure has had its period; until the next period the pressure at the valve is
that at the inlet. Each period is as the first. Prints the largest velocity and the pressure at the valve then, when the valve closes, and the pressure
there at 76 ms, for tests/runs/network/network_valve_at_a_body.prm.
"""

import numpy as np
from scipy.optimize import brentq

amplitude, frequency, resistance = 500., 25., 5e6  # [Pa], [Hz], [Pa s/m^3]
density, length, radius = 1050., 0.04, 0.01
area, w = np.pi * radius**2, 2 * np.pi * frequency
inertance = density * length / area


def flow_rate(t):
    swing = resistance * np.sin(w * t) - w * inertance * np.cos(w * t) + w * inertance * np.exp(-resistance * t / inertance)
    return amplitude * swing / (resistance**2 + (w * inertance)**2)


if __name__ == "__main__":
    slope = 1e-7
    largest = brentq(lambda t: flow_rate(t + slope) - flow_rate(t - slope), 0.005, 0.025)
    closes = brentq(flow_rate, 0.025, 0.039)
    print(f"largest velocity {flow_rate(largest) / area:.6f} m/s at {1e3 * largest:.3f} ms, then {resistance * flow_rate(largest):.4f} Pa at the valve")
    print(f"closes at {1e3 * closes:.3f} ms; at 76 ms {amplitude * np.sin(w * 0.076):.6f} Pa at the valve, and no flow")
