#!/usr/bin/python3
"""A thick cylinder of layers under inner pressure, its ends held axially: references of parameter_files/verification/layered-wall-static.prm.

In each layer u = a r + b/r, with which radial, hoop and axial stress are 2 (lambda + mu) a -/+ 2 mu b/r^2 and 2 lambda a (G. Lame).
Displacement and radial stress are continuous between layers; the radial stress is -P inside and zero outside.
Radii in m, moduli and pressure in Pa. Needs numpy.
"""

import numpy as np

PRESSURE = 10e3
RADII = [10e-3, 10.2e-3, 11.2e-3, 12e-3]
YOUNG = [0.2e6, 0.4e6, 1e6]
POISSON = [0.49, 0.45, 0.4]
NAMES = ["intima", "media", "adventitia"]

SHEAR = [y / (2 * (1 + nu)) for y, nu in zip(YOUNG, POISSON)]
LAMBDA = [y * nu / ((1 + nu) * (1 - 2 * nu)) for y, nu in zip(YOUNG, POISSON)]


def displacement(layer, r):
    """Coefficients of (a, b) in u."""
    return np.array([r, 1 / r])


def stress(layer, r, sign):
    """Coefficients of (a, b) in the radial (sign -1) or the hoop stress (sign 1)."""
    return np.array([2 * (LAMBDA[layer] + SHEAR[layer]), sign * 2 * SHEAR[layer] / r**2])


def main():
    n = len(YOUNG)
    matrix, load = np.zeros((2 * n, 2 * n)), np.zeros(2 * n)
    matrix[0, 0:2], load[0] = stress(0, RADII[0], -1), -PRESSURE
    matrix[1, 2 * n - 2 :] = stress(n - 1, RADII[n], -1)
    for i in range(n - 1):
        for row, of in ((2 + 2 * i, displacement), (3 + 2 * i, lambda k, r: stress(k, r, -1))):
            matrix[row, 2 * i : 2 * i + 2] = of(i, RADII[i + 1])
            matrix[row, 2 * i + 2 : 2 * i + 4] = -of(i + 1, RADII[i + 1])
    # The rows differ by many orders of magnitude in their units.
    scale = np.abs(matrix).max(axis=1)
    columns = np.abs(matrix / scale[:, None]).max(axis=0)
    solution = np.linalg.solve(matrix / scale[:, None] / columns, load / scale) / columns
    for i, radius in enumerate(RADII):
        layer = min(i, n - 1)
        u = displacement(layer, radius) @ solution[2 * layer : 2 * layer + 2]
        print(f"r = {radius * 1e3:g} mm: displacement {u * 1e6:.8g} um")
    for i in range(n):
        radius = (RADII[i] + RADII[i + 1]) / 2
        a_b = solution[2 * i : 2 * i + 2]
        radial, hoop, axial = stress(i, radius, -1) @ a_b, stress(i, radius, 1) @ a_b, 2 * LAMBDA[i] * a_b[0]
        print(
            f"{NAMES[i]}, r = {radius * 1e3:g} mm: radial {radial:.8g} Pa, hoop {hoop:.8g} Pa, axial {axial:.8g} Pa, "
            f"pressure {-(radial + hoop + axial) / 3:.8g} Pa"
        )


if __name__ == "__main__":
    main()
