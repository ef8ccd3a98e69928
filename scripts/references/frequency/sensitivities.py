#!/usr/bin/python3
"""Sensitivities of responses with a closed form to the numbers of their files, and of the speed of a wave in a tube.

    scripts/references/frequency/sensitivities.py

For each response Q and each number m: m/|Q| d|Q|/dm and m d arg Q/dm, by differences of the closed form with 40 digits (mpmath). The cases are
those of tests/tiny_runs/harmonic_sensitivities_*.prm. The speed of the tube of tests/runs/frequency/sensitivities_tube.prm is that of
scripts/references/waves/exact_dispersion.py, by differential equations over the radius.
"""

import os
import sys

sys.dont_write_bytecode = True

import mpmath as mp

mp.mp.dps = 40


def prony(m, w):
    """Modulus of the column of harmonic-bar.prm."""
    relaxing = m["Shear moduli 1"] * mp.mpc(0, w * m["Relaxation times 1"])
    shear = m["Young's modulus"] / 2 / (1 + m["Poisson's ratio"]) + relaxing / (1 + mp.mpc(0, w * m["Relaxation times 1"]))
    return m["Young's modulus"] / 3 / (1 - 2 * m["Poisson's ratio"]) + shear * 4 / 3


BAR = {"Density": 1000, "Young's modulus": mp.mpf("83333.33333333333"), "Poisson's ratio": mp.mpf("0.25"), "Shear moduli 1": 20000,
       "Relaxation times 1": mp.mpf("0.1"), "Normal stiffness": 40000, "Normal damping": 3000, "Pressure": 1}


def bar_on_support(m, frequency):
    """Displacement at x = 2 m and stress xx at x = 0.5 m."""
    w = 2 * mp.pi * frequency
    modulus = prony(m, w)
    k = mp.sqrt(m["Density"] * w * w / modulus)
    z = mp.mpc(m["Normal stiffness"], w * m["Normal damping"])
    a = -m["Pressure"] / (z * mp.cos(2 * k) - modulus * k * mp.sin(2 * k))
    x = mp.mpf("0.5")
    return [a * (mp.cos(2 * k) + z / (modulus * k) * mp.sin(2 * k)), a * (-modulus * k * mp.sin(k * x) + z * mp.cos(k * x))]


def bar(m, frequency):
    """Displacement at the end of the bar of harmonic-bar.prm, which a wall holds."""
    w = 2 * mp.pi * frequency
    modulus = prony(m, w)
    k = mp.sqrt(m["Density"] * w * w / modulus)
    return [-m["Pressure"] * mp.tan(2 * k) / (modulus * k)]


LAYERS = {"fluid/Density": 1000, "fluid/Viscosity": mp.mpf("0.1"), "wall/Density": 1000, "wall/Relaxation modulus at one second": 2600,
          "wall/Exponent": mp.mpf("0.1"), "wall/Bulk modulus": 10**6, "Velocity 1": 1}


def layers(m, frequency):
    """Displacement of the interface and velocity at half the depth."""
    w = 2 * mp.pi * frequency
    n = m["wall/Exponent"]
    young = m["wall/Relaxation modulus at one second"] * mp.gamma(1 - n) * mp.mpc(0, w) ** n
    shear, liquid = young / (3 - young / (3 * m["wall/Bulk modulus"])), mp.mpc(0, w * m["fluid/Viscosity"])
    k, q = mp.sqrt(m["wall/Density"] * w * w / shear), mp.sqrt(m["fluid/Density"] * w * w / liquid)
    h, depth = mp.mpf("5e-3"), mp.mpf("10e-3")
    z = -shear * k / (liquid * q) * mp.cos(k * h) / mp.sin(k * h)
    a = m["Velocity 1"] / mp.mpc(0, w) / (mp.cos(q * depth) - z * mp.sin(q * depth))
    y = mp.mpf("5e-3") - depth
    return [a, mp.mpc(0, w) * a * (mp.cos(q * y) + z * mp.sin(q * y))]


PISTON = {"Density": 1000, "Viscosity": 50000, "Bulk modulus": mp.mpf("2.2e9"), "Velocity 1": mp.mpf("1e-3"),
          "Proximal resistance": mp.mpf("1e9"), "Distal resistance": mp.mpf("4e9"), "Compliance": mp.mpf("1e-11")}


def piston(m, frequency):
    """Pressure at the piston: its traction less the part of viscosity."""
    w = 2 * mp.pi * frequency
    area, length, s = mp.pi * mp.mpf("0.01")**2, 2, mp.mpc(0, w)
    modulus = m["Bulk modulus"] + s * m["Viscosity"] * 4 / 3
    k = mp.sqrt(m["Density"] * w * w / modulus)
    line = m["Density"] * w / (k * area)
    end = m["Proximal resistance"] + m["Distal resistance"] / (1 + s * m["Distal resistance"] * m["Compliance"])
    ratio = line * (end * mp.cos(k * length) + 1j * line * mp.sin(k * length)) / (line * mp.cos(k * length) + 1j * end * mp.sin(k * length))
    return [ratio * area * m["Velocity 1"] * m["Bulk modulus"] / modulus]


def show(name, function, numbers, frequency, probes):
    for number in numbers:
        def logarithm(factor, place):
            return mp.log(function({**numbers, number: numbers[number] * factor}, frequency)[place])
        for place, probe in enumerate(probes):
            slope = mp.diff(lambda factor: logarithm(factor, place), 1)
            print(f"{name}, {frequency} Hz, {probe} by {number}: {mp.nstr(slope.real, 10)} {mp.nstr(slope.imag, 10)} rad")


TUBE = {"fluid/Density": "1060", "wall/Young's modulus": "1.2e6", "wall/Density": "1100", "fluid/Viscosity": "4e-3"}


def show_tube(frequency):
    """Speed and attenuation of the tube of parameter_files/examples/heart-beats.prm, by differences of the exact wave."""
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../waves"))
    import exact_dispersion

    def wave_number(numbers):
        liquid = exact_dispersion.liquid(numbers["fluid/Density"], numbers["fluid/Viscosity"], 1 / mp.mpf("2.2e9"))
        tube = {"radius": "10e-3", "fluid": liquid, "tethered": True,
                "layers": [("2e-3", exact_dispersion.solid(numbers["wall/Density"], numbers["wall/Young's modulus"], "0.49"))]}
        omega = mp.mpc(2 * mp.pi * frequency)
        case = exact_dispersion.at_frequency(tube, omega)
        exact_dispersion.set_digits(case, omega)
        return exact_dispersion.root(case, omega, exact_dispersion.starts(case, omega)[0][1])

    step = mp.mpf("1e-6")
    for number, value in TUBE.items():
        less, more = (wave_number({**TUBE, number: mp.mpf(value) * (1 + sign * step)}) for sign in (-1, 1))
        speed = -mp.log(more.real / less.real) / (2 * step)
        attenuation = mp.log(more.imag / less.imag) / (2 * step)
        print(f"tube, {frequency} Hz, speed by {number}: {mp.nstr(speed, 8)}, attenuation {mp.nstr(attenuation, 8)}")


if __name__ == "__main__":
    show("support", bar_on_support, BAR, 1, ["displacement", "stress"])
    show("bar", bar, {key: BAR[key] for key in BAR if not key.startswith("Normal")}, 1, ["displacement"])
    show("layers", layers, LAYERS, 10, ["interface", "liquid"])
    show("piston", piston, PISTON, 100, ["pressure"])
    show_tube(20)
