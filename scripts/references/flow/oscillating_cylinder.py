#!/usr/bin/python3
"""The force on a cylinder that swings a little in a liquid at rest: reference of parameter_files/verification/oscillating-cylinder-stokes.prm.

    scripts/references/flow/oscillating_cylinder.py

The solution of G. G. Stokes (Trans. Camb. Phil. Soc. 9 (1851) 8-106) for a cylinder of radius a with the velocity V exp(i w t), without convection, in a liquid
without end: the force on a metre is -i w rho pi a^2 Z V exp(i w t) with Z = 1 + 4 K1(k)/(k K0(k)), k = a sqrt(i w/nu). The real part of Z is the coefficient of
added mass. Needs numpy and scipy.
"""

import numpy as np
from scipy.special import kv

RADIUS, PERIOD, DENSITY, VISCOSITY, SPEED = 0.5, 5.0, 1.0, 0.01, 1e-3


def main():
    frequency = 2 * np.pi / PERIOD
    k = RADIUS * np.sqrt(1j * frequency * DENSITY / VISCOSITY)
    impedance = 1 + 4 * kv(1, k) / (k * kv(0, k))
    size = DENSITY * np.pi * RADIUS**2 * frequency * SPEED
    print(f"coefficient of added mass {impedance.real:.5f}, of the force against the velocity {-impedance.imag:.5f}")
    print(f"amplitude of the force {size * abs(impedance):.5e} N/m")
    # The velocity is -SPEED at the end, after whole periods.
    print(f"force after whole periods {-size * impedance.imag:.5e} N/m")


if __name__ == "__main__":
    main()
