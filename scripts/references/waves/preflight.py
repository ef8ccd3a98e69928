#!/usr/bin/python3
"""The numbers of the pre-flight report for the tube of tests/case/preflight_report.cc, computed with mpmath.

    scripts/references/waves/preflight.py

A water-filled tube, R = 12.5 mm, h = 0.1 mm, 0.446 m long, at 20 Hz, with a step of 0.2 ms over 0.18 s. Needs python3-mpmath.
"""

from mpmath import besseli, exp, findroot, log, mp, mpc, mpf, nstr, pi, sqrt

mp.dps = 40
R, h, length, rho, rho_s, eta = mpf("0.0125"), mpf("1e-4"), mpf("0.446"), mpf(998), mpf(880), mpf("1e-3")
K, Y, nu = mpf("2.2e9"), mpf("1.72e6"), mpf("0.49")
f, dt, end = mpf(20), mpf("2e-4"), mpf("0.18")
omega = 2 * pi * f


def show(name, value):
    print(f"{name}: {nstr(value, 16)}")


mu, bulk = Y / (2 * (1 + nu)), Y / (3 * (1 - 2 * nu))
show("speed of sound", sqrt(K / rho))
show("longitudinal", sqrt((bulk + 4 * mu / 3) / rho_s))
show("bar", sqrt(Y / rho_s))
show("shear", sqrt(mu / rho_s))
show("Moens-Korteweg", sqrt(Y * h / (2 * R * rho)))
outer = R + h
free = h / R * ((outer**2 + R**2) / (outer**2 - R**2) + nu)
held = h / R * (1 + nu) * ((1 - 2 * nu) * R**2 + outer**2) / (outer**2 - R**2)
c_free = 1 / sqrt(rho * (1 / K + free * 2 * R / (Y * h)))
show("Korteweg, free", c_free)
show("Korteweg, held", 1 / sqrt(rho * (1 / K + held * 2 * R / (Y * h))))
show("transit", length / c_free)
k0 = omega / sqrt(Y * h / (2 * R * rho))
k = findroot(lambda k: omega**2 * (rho * besseli(0, k * R) / (k * besseli(1, k * R)) + rho_s * h) - Y * h / R**2, k0)
q = sqrt(mpc(0, 1) * omega * rho / eta) * R
f10 = 2 * besseli(1, q) / (q * besseli(0, q))
wave = omega / c_free * k / k0 / sqrt(1 - (1 - nu / 2) ** 2 * f10)
speed = omega / wave.real
show("phase speed", speed)
show("loss over the length", 1 - exp(wave.imag * length))
show("Womersley", R * sqrt(omega * rho / eta))
show("added mass", rho * R / (rho_s * h))
show("added mass of the wave", rho * besseli(0, k * R) / (k * besseli(1, k * R)) / (rho_s * h))
show("wavelength", speed / f)
show("Stokes layer", sqrt(2 * eta / rho / omega))
show("early reflection", 2 * sqrt(R * h) / (3 * (1 - nu**2)) ** mpf("0.25") / speed)
show("steps per period", 1 / (f * dt))
theta = omega * dt
for name, factor in (("Euler, trapezoidal", 1 / sqrt(1 + theta**2 / 2)), ("Euler, implicit", 1 / sqrt(1 + theta**2)),
                     ("backward differencing", abs((2 + sqrt(1 + 2j * theta)) / (3 - 2j * theta)))):
    show(f"damping, {name}", 1 - factor ** (end / dt))
