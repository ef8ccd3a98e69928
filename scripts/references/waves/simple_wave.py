#!/usr/bin/python3
"""A wave of finite amplitude in a liquid without viscosity: reference of parameter_files/verification/finite-amplitude-sound.prm.

The law of volume, rho = rho0 (1 + n (p - p0)/K)^(1/n), has the speed of sound a with a^2 = dp/drho = (K + n (p - p0))/rho, that is
a = a0 (rho/rho0)^((n - 1)/2) with a0^2 = K/rho0. In a wave that runs into liquid at rest the Riemann invariant u - 2 a/(n - 1) is
-2 a0/(n - 1) everywhere, so that a = a0 + (n - 1)/2 u. What the boundary x = 0 does at the time s, u = f(s), travels with
u + a = a0 + (n + 1)/2 f(s): u(x, t) = f(s) where x = (a0 + (n + 1)/2 f(s)) (t - s). The first shock begins at the least
(a0 + (n + 1)/2 f)^2/((n + 1)/2 f').

usage: simple_wave.py [FOLDER...]     prints the profile; with folders of runs also their largest errors, in parts of the amplitude
Needs mpmath.
"""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "lib"))
sys.dont_write_bytecode = True

import continua  # noqa: E402
import mpmath as mp  # noqa: E402

mp.mp.dps = 20
DENSITY, BULK, EXPONENT = 1000, mp.mpf("2.2e9"), mp.mpf("7.15")
AMPLITUDE, DURATION = 30, mp.mpf("1e-3")  # u(0, t) = AMPLITUDE sin(pi t/DURATION)^4
TIME = mp.mpf("2.814e-3")
PLACES = ["3.2", "3.4", "3.6", "3.7", "3.75", "3.8", "3.85", "3.9", "4.0"]

SOUND = mp.sqrt(BULK / DENSITY)
RATE = (EXPONENT + 1) / 2


def boundary(time):
    return AMPLITUDE * mp.sin(mp.pi * time / DURATION) ** 4 if 0 < time < DURATION else mp.mpf(0)


def speed(time):
    return SOUND + RATE * boundary(time)


def first_shock():
    """The distance of the first shock, and when its characteristic leaves the boundary."""
    def distance(time):
        slope = 4 * AMPLITUDE * mp.pi / DURATION * mp.sin(mp.pi * time / DURATION) ** 3 * mp.cos(mp.pi * time / DURATION)
        return speed(time) ** 2 / (RATE * slope)
    leaves = mp.findroot(lambda time: mp.diff(distance, time), (DURATION / 10, DURATION * 9 / 20), solver="anderson")
    return distance(leaves), leaves


def velocity(place):
    """Characteristics do not cross before the shock: what has left the boundary at 0 is ahead of all else."""
    if place >= SOUND * TIME:
        return mp.mpf(0)
    return boundary(mp.findroot(lambda time: speed(time) * (TIME - time) - place, (0, DURATION), solver="anderson", tol=1e-25))


def pressure(flow):
    return BULK / EXPONENT * ((1 + (EXPONENT - 1) / 2 * flow / SOUND) ** (2 * EXPONENT / (EXPONENT - 1)) - 1)


if __name__ == "__main__":
    shock, leaves = first_shock()
    steepest = speed(leaves) * (TIME - leaves)
    print("the first shock begins at       ", mp.nstr(shock, 7), "m")
    print("its characteristic is, at the end,", mp.nstr(steepest, 7), "m from the boundary:", mp.nstr(steepest / shock, 5))
    print("amplitude of the pressure       ", mp.nstr(pressure(AMPLITUDE) / 1e6, 8), "MPa")
    profile = {place: (velocity(mp.mpf(place)), pressure(velocity(mp.mpf(place)))) for place in PLACES}
    for place, (flow, push) in profile.items():
        print(f"at {place:>4} m: {mp.nstr(flow, 8):>12} m/s, {mp.nstr(push / 1e6, 8):>12} MPa")
    for folder in sys.argv[1:]:
        run = continua.open(folder)
        errors = [
            max(abs(run.quantity(f"final {field}", f"{place} m: {field}") - exact[i]) for place, exact in profile.items()) / scale
            for i, (field, scale) in enumerate((("velocity x", AMPLITUDE), ("pressure", pressure(AMPLITUDE))))
        ]
        print(f"{folder}: largest error of the velocity {mp.nstr(errors[0], 3)}, of the pressure {mp.nstr(errors[1], 3)}")
