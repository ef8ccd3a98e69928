#!/usr/bin/python3
"""A rigid pipe between a pump and a compliance: references of tests/runs/network/network_at_both_ends.prm.

The flow in the pipe is that of J. R. Womersley (J. Physiol. 127, 1955): at the Laplace variable s a pipe of length l has
p_1 - p_2 = s rho l/(pi a^2)/(1 - 2 I_1(z)/(z I_0(z))) Q, z = a sqrt(s rho/eta). The pump has the pressure p_1 = 100 Pa sin^2(w t/2), and the
compliance the volume C p_2. Needs mpmath. Two methods for the inverse of the Laplace transform (de Hoog, Talbot) must agree.
"""

import mpmath as mp

mp.mp.dps = 20

LENGTH, RADIUS, DENSITY, VISCOSITY, COMPLIANCE = map(mp.mpf, ("0.06", "0.005", "1000", "1", "1e-9"))
PRESSURE, FREQUENCY = mp.mpf(100), 10 * mp.pi


def impedance(s):
    z = RADIUS * mp.sqrt(s * DENSITY / VISCOSITY)
    return s * DENSITY * LENGTH / (mp.pi * RADIUS**2) / (1 - 2 * mp.besseli(1, z) / (z * mp.besseli(0, z)))


def flow_rate(s):
    return PRESSURE / 2 * (1 / s - s / (s**2 + FREQUENCY**2)) / (impedance(s) + 1 / (COMPLIANCE * s))


def at(time, of):
    values = [mp.invertlaplace(of, time, method=method) for method in ("dehoog", "talbot")]
    assert abs(values[0] - values[1]) < mp.mpf("1e-8") * abs(values[0]), values
    return values[0]


if __name__ == "__main__":
    for time in (mp.mpf("0.1"), mp.mpf("0.2"), mp.mpf("0.4")):
        pump, store = PRESSURE * mp.sin(FREQUENCY * time / 2) ** 2, at(time, lambda s: flow_rate(s) / s) / COMPLIANCE
        # The joints are at a third and at two thirds of the pipe.
        print(f"t = {mp.nstr(time, 3)} s: flow rate {mp.nstr(at(time, flow_rate) * 1e6, 8)} ml/s, pressures of the pump {mp.nstr(pump, 8)}, "
              f"of the joints {mp.nstr((2 * pump + store) / 3, 8)} and {mp.nstr((pump + 2 * store) / 3, 8)}, of the store {mp.nstr(store, 8)} Pa")
