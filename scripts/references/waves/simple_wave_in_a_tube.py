#!/usr/bin/python3
"""A pulse of finite amplitude in a long elastic tube, by characteristics: no finite elements, and nothing of Continua.

    simple_wave_in_a_tube.py [PROBES.csv]

The wall is an incompressible neo-Hookean layer of the radii A and B that keeps its length, the liquid is inviscid and incompressible, and the pulse is long. With the inner radius a

    p(a) = int mu ((r/R)^2 - (R/r)^2)/r dr,   r^2 = a^2 + R^2 - A^2,   c^2 = (a/2 rho) dp/da,   u(p) = int_0^p dp/(rho c),

a wave that runs into liquid at rest carries each pressure at the speed u + c (G. B. Whitham, Linear and Nonlinear Waves (1974), chapter 6), until a front would become vertical. At the inlet
the flow rate is given, Q = pi a^2 u.
The case is parameter_files/verification/simple-wave-in-a-tube.prm. With its probes.csv the script shows both.
"""

import csv
import math
import sys

MU, A, B, RHO = 1e5, 10e-3, 11e-3, 1000.0  # Pa, m, m, kg/m^3
FLOW, DURATION = 180e-6, 0.15  # m^3/s, s: Q = FLOW sin^2(pi t/DURATION)
HIGHEST = 2200.0  # Pa: characteristics up to here
STATIONS = (0.2, 0.4, 0.6)  # m
N = 400  # intervals of the trapezoidal and of Simpson's rule


def pressure(a):
    """Simpson's rule over the undeformed wall."""
    total = 0.0
    for i in range(N + 1):
        big = A + (B - A) * i / N
        small = math.sqrt(a * a + big * big - A * A)
        stretch = small / big
        weight = 1 if i in (0, N) else 4 if i % 2 else 2
        # dr = R/r dR
        total += weight * MU * (stretch**2 - stretch**-2) / small * big / small
    return total * (B - A) / (3 * N)


def radius(wanted):
    """By bisection, on the way up."""
    low, high = A, 1.3 * A
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if pressure(middle) < wanted else (low, middle)
    return 0.5 * (low + high)


def speed(a):
    step = 1e-6 * A
    return math.sqrt(0.5 * a / RHO * (pressure(a + step) - pressure(a - step)) / (2 * step))


def characteristics():
    """[(p, u + c, u, a)] for pressures from 0 on."""
    rows, velocity, last = [], 0.0, None
    for i in range(N + 1):
        p = HIGHEST * i / N
        a = radius(p)
        c = speed(a)
        if last is not None:
            velocity += 0.5 * (HIGHEST / N) * (1 / (RHO * c) + 1 / (RHO * last))
        last = c
        rows.append((p, velocity + c, velocity, a))
    return rows


def at_flow_rate(rows, flow):
    """The same, by lines between the rows."""
    flows = [math.pi * a * a * u for _, _, u, a in rows]
    i = next(i for i in range(N) if flows[i + 1] >= flow)
    share = (flow - flows[i]) / (flows[i + 1] - flows[i])
    return tuple(one + share * (other - one) for one, other in zip(rows[i], rows[i + 1]))


def arrivals(rows, share, station):
    """(pressure [Pa] of that share of the largest flow rate, the times [s] at which it passes, on the way up and down)."""
    p, total, _, _ = at_flow_rate(rows, share * FLOW)
    at_inlet = DURATION / math.pi * math.asin(math.sqrt(share))
    return p, at_inlet + station / total, DURATION - at_inlet + station / total


def measured(path, station, level, is_peak):
    """The times [s] at which a pressure passes in a table of probes, by a line between two rows; the peak by a parabola."""
    with open(path, encoding="utf-8") as file:
        table = list(csv.reader(file))
    column = table[0].index(f"tube {station:g} m: pressure [Pa]")
    times = [float(row[0]) for row in table[1:]]
    values = [float(row[column]) for row in table[1:]]
    top = max(range(len(values)), key=values.__getitem__)
    left, middle, right = values[top - 1 : top + 2]
    shift = 0.5 * (left - right) / (left - 2 * middle + right)
    if is_peak:
        return (times[top] + shift * (times[1] - times[0]),) * 2
    up = next(i for i in range(top) if values[i + 1] >= level)
    down = next(i for i in range(top, len(values) - 1) if values[i + 1] <= level)
    return tuple(times[i] + (level - values[i]) / (values[i + 1] - values[i]) * (times[i + 1] - times[i]) for i in (up, down))


def main():
    rows = characteristics()
    peak = at_flow_rate(rows, FLOW)
    print(f"without load: c = {rows[0][1]:.5f} m/s; at the peak: {peak[0]:.3f} Pa, radius {peak[3] / A:.5f} of the undeformed one, u = {peak[2]:.5f} m/s, u + c = {peak[1]:.5f} m/s")
    for station in STATIONS:
        for share in (0.25, 0.5, 0.75, 1.0):
            level, up, down = arrivals(rows, share, station)
            text = f"{station} m, {share:4.0%} of the flow rate: {level:8.2f} Pa, {1e3 * up:8.3f} ms up, {1e3 * down:8.3f} ms down"
            if len(sys.argv) > 1:
                found = measured(sys.argv[1], station, level, share == 1.0)
                text += f"; found {1e3 * found[0]:8.3f}, {1e3 * found[1]:8.3f} ms"
            print(text)


if __name__ == "__main__":
    main()
