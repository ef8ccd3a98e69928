#!/usr/bin/python3
"""The steady flow of a liquid of Carreau and Yasuda through a pipe: reference of
parameter_files/verification/blood-in-a-pipe.prm.

The shear stress is G r/2 under a pressure gradient G. At each radius the rate of shear g solves eta(g) g = G r/2; the velocity is
the integral of g from the radius to the wall, and the flow rate the integral of pi r^2 g. Needs mpmath.
"""

import mpmath as mp

mp.mp.dps = 20
ZERO, INFINITE, TIME, INDEX, EXPONENT = 0.056, 0.00345, 3.313, 0.3568, 2
RADIUS, GRADIENT = 5e-3, 200


def viscosity(rate):
    return INFINITE + (ZERO - INFINITE) * (1 + (TIME * rate) ** EXPONENT) ** ((INDEX - 1) / mp.mpf(EXPONENT))


def rate_at(radius):
    stress = GRADIENT * radius / 2
    if stress == 0:
        return mp.mpf(0)
    return mp.findroot(lambda rate: viscosity(rate) * rate - stress, (stress / ZERO, stress / INFINITE), solver="anderson",
                       tol=1e-25)


def velocity(radius):
    return mp.quad(rate_at, mp.linspace(radius, RADIUS, 9))


if __name__ == "__main__":
    print("velocity on the axis        ", mp.nstr(velocity(0), 10), "m/s")
    print("velocity at half the radius ", mp.nstr(velocity(RADIUS / 2), 10), "m/s")
    print("flow rate                   ",
          mp.nstr(mp.quad(lambda r: mp.pi * r**2 * rate_at(r), mp.linspace(0, RADIUS, 9)) * 1e6, 10), "ml/s")
    print("viscosity at the wall       ", mp.nstr(viscosity(rate_at(RADIUS)), 10), "Pa s")
