#!/usr/bin/python3
"""A heart of elements without a length: references of tests/runs/network/network_heart_circuit.prm.

A ventricle p = E(t) (V - V0) (H. Suga, K. Sagawa, A. A. Shoukas, Circ. Res. 32, 1973) fills from an atrium of constant pressure
through a valve R_m, and empties through a valve with R_a and L_a, which lets nothing flow back, into a windkessel R_p, C, R_d:

    dV/dt = Q_m - Q,  Q_m = max(0, (p_at - p)/R_m),  L_a dQ/dt = p - R_a Q - p_ao while the valve is open,  p_ao = R_p Q + p_C,
    C dp_C/dt = Q - p_C/R_d.

Integrated by scipy (Radau, from one event of the valves to the next one) until a beat is like the one before to 1e-12. Needs scipy.
"""

import numpy as np
from scipy.integrate import solve_ivp

PERIOD = 0.8
LEAST, LARGEST = 8e6, 270e6  # Pa/m^3
UNLOADED = 10e-6  # m^3
ATRIUM, MITRAL = 1e3, 1e6  # Pa, Pa s/m^3
VALVE, INERTANCE = 1e6, 5e4  # Pa s/m^3, Pa s^2/m^3
PROXIMAL, DISTAL, COMPLIANCE = 10e6, 120e6, 10e-9


def elastance(t):
    return LEAST + (LARGEST - LEAST) * max(0.0, np.sin(2 * np.pi * t / PERIOD)) ** 2


def pressure(t, y):
    return elastance(t) * (y[0] - UNLOADED)


def drop(t, y):
    """What accelerates the liquid in the valve [Pa]."""
    return pressure(t, y) - (VALVE + PROXIMAL) * y[1] - y[2]


def rates(t, y, is_open):
    filling = max(0.0, (ATRIUM - pressure(t, y)) / MITRAL)
    flow = y[1] if is_open else 0.0
    return [filling - flow, drop(t, y) / INERTANCE if is_open else 0.0, (flow - y[2] / DISTAL) / COMPLIANCE, filling, pressure(t, y) * (flow - filling),
            PROXIMAL * flow + y[2]]


def beat(y, samples):
    """From the begin of a beat to its end: the state, and the states at times within."""
    t, is_open, times, states = 0.0, False, [], []
    while t < PERIOD - 1e-13:
        def opens(s, z):
            return drop(s, z)

        def closes(s, z):
            return z[1]

        opens.terminal = closes.terminal = True
        opens.direction, closes.direction = 1, -1
        end = PERIOD if t >= PERIOD / 2 else PERIOD / 2  # the elastance has a kink of its curvature
        found = solve_ivp(lambda s, z: rates(s, z, is_open), (t, end), y, method="Radau", rtol=1e-11, atol=1e-15, dense_output=True,
                          max_step=2e-3, events=closes if is_open else opens)
        inside = samples[(samples >= t) & (samples <= found.t[-1])]
        times.extend(inside)
        states.extend(found.sol(inside).T)
        t, y = found.t[-1], found.y[:, -1].copy()
        if found.t_events[0].size:
            is_open = not is_open
            y[1] = 0.0
            if not is_open and drop(t, y) > 0:
                raise RuntimeError("the valve chatters")
    return y, np.array(times), np.array(states)


def periodic():
    """(number of beats, times, states of the last one)."""
    y, samples, n = np.array([110e-6, 0.0, 9e3, 0.0, 0.0, 0.0]), np.linspace(0.0, PERIOD, 20001), 0
    while True:
        start = y.copy()
        start[3:] = 0.0
        y, times, states = beat(start, samples)
        n += 1
        if np.max(np.abs(y[[0, 2]] / start[[0, 2]] - 1)) < 1e-12:
            return n, times, states


if __name__ == "__main__":
    n, t, y = periodic()
    p = np.array([pressure(s, z) for s, z in zip(t, y)])
    aorta = PROXIMAL * y[:, 1] + y[:, 2]
    stroke = y[:, 0].max() - y[:, 0].min()
    print(f"beats to the periodic state: {n}")
    print(f"largest volume  {y[:, 0].max() * 1e6:.6f} ml, stroke volume {stroke * 1e6:.6f} ml, ejection fraction {stroke / y[:, 0].max():.7f}")
    print(f"stroke work     {y[-1, 4]:.7f} J")
    print(f"ventricle       largest pressure {p.max():.4f} Pa")
    print(f"aorta           largest {aorta.max():.4f} Pa, smallest {aorta.min():.4f} Pa, mean {y[-1, 5] / PERIOD:.4f} Pa")
    print(f"valve           largest flow rate {y[:, 1].max() * 1e6:.5f} ml/s, mean {y[-1, 3] / PERIOD * 1e6:.6f} ml/s")
