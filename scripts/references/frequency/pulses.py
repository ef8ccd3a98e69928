#!/usr/bin/python3
"""Displacement of the top of a sheared column under a pulse of shear: of an elastic solid by d'Alembert's sum of waves, of a power law by a
Fourier integral over 64 times the duration. Pressure and flow rate of a plug of liquid before a windkessel by its ordinary differential equations.

    scripts/references/frequency/pulses.py

s^2 rho u = mu*(s) u'', u = 0 at the foot, mu* u' = f at the top of the column of height H: u(H) = f tanh(k H)/(mu* k), k = s sqrt(rho/mu*).
rho L/A dQ/dt + R1 Q + p = p_in(t), C dp/dt + p/R2 = Q: the pressure at the outlet is R1 Q + p.
"""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.special import gamma

HEIGHT, DENSITY, PULSE = 0.1, 1000., 5e-3


def traction(t):
    return np.where((t > 0) & (t < PULSE), np.sin(np.pi * t / PULSE) ** 2, 0.)


def elastic(t, modulus=1e6):
    speed = np.sqrt(modulus / DENSITY)

    def impulse(at):
        at = np.clip(at, 0., PULSE)
        return at / 2 - PULSE / (4 * np.pi) * np.sin(2 * np.pi * at / PULSE)

    total = impulse(t)
    for n in range(1, 40):
        total = total + 2 * (-1) ** n * impulse(t - 2 * n * HEIGHT / speed)
    return speed / modulus * total


def power_law(modulus):
    duration, n, growth = 64 * 0.03, 2 ** 20, 1e9
    a = np.log(growth) / duration
    t = duration * np.arange(n) / n
    load = np.fft.rfft(traction(t) * np.exp(-a * t))
    s = a + 2j * np.pi * np.arange(n // 2 + 1) / duration
    m = modulus(s)
    k = s * np.sqrt(DENSITY / m)
    response = np.fft.irfft(load * np.tanh(k * HEIGHT) / (m * k), n) * np.exp(a * t)
    return t, response


def windkessel(times):
    inertance = 1000. * 0.1 / (np.pi * 0.01 ** 2)
    proximal, distal, compliance = 8e6, 120e6, 1e-9

    def slopes(t, state):
        flow_rate, pressure = state
        driving = 1000. * np.sin(np.pi * t / 0.1) ** 2 if t < 0.1 else 0.
        return [(driving - proximal * flow_rate - pressure) / inertance, (flow_rate - pressure / distal) / compliance]

    state = solve_ivp(slopes, (0., times[-1]), [0., 0.], method="DOP853", t_eval=times, rtol=1e-11, atol=1e-16, max_step=1e-3).y
    return proximal * state[0] + state[1], state[0]


def main():
    times = np.array([5e-3, 8e-3, 15e-3, 23e-3])
    print("elastic, times [s]:", times)
    print("  displacement [m]:", elastic(times))
    fine = np.linspace(0., 30e-3, 300001)
    print("  largest, least:", elastic(fine).max(), elastic(fine).min())
    t, same = power_law(lambda s: 1e6 + 0 * s)
    part = t <= 30e-3
    print("  the same by the integral:", same[part].max(), same[part].min())

    # Shear from Y(s) = E_1 Gamma(1 - n) s^n and the bulk modulus of Poisson's ratio 0.5: mu = Y/3.
    def modulus(s):
        return 1.3e6 * gamma(0.8) * s ** 0.2 / 3

    t, response = power_law(modulus)
    part = t <= 30e-3
    print("power law, largest, least:", response[part].max(), response[part].min())
    print("  displacement [m]:", np.interp(times, t, response))

    fine = np.linspace(0., 0.4, 40001)
    for name, values in zip(("pressure [Pa]", "flow rate [m^3/s]"), windkessel(fine)):
        print("windkessel,", name, "largest, least, last:", values.max(), values.min(), values[-1])


main()
