#!/usr/bin/python3
"""Answers of a bar to the material tests: references of tests/runs/laboratory/material_kelvin_voigt.prm, material_maxwell.prm and
material_volume.prm, by numerical inversion of the Laplace transforms instead of partial fractions.

    stress of a ramp to e within T:  Y(s) (e/T) (1 - exp(-s T))/s^2      strain of a stress S:  S/(s Y(s))
    Y(s) = 9 K mu/(3 K + mu), mu(s) = s eta + sum mu_k s/(s + 1/tau_k), K(s) alike

Needs mpmath.
"""

import mpmath as mp

mp.mp.dps = 30
STRAIN, LOADING_TIME, STRESS, TIME = mp.mpf("0.03"), mp.mpf("0.2"), mp.mpf(10), mp.mpf(1)


def report(name, mu, bulk):
    def young(s):
        return 9 * bulk(s) * mu(s) / (3 * bulk(s) + mu(s))

    stress = mp.invertlaplace(lambda s: young(s) * STRAIN / LOADING_TIME * (1 - mp.exp(-s * LOADING_TIME)) / s**2, TIME,
                              method="dehoog", degree=60)
    strain = mp.invertlaplace(lambda s: STRESS / (young(s) * s), TIME, method="talbot")
    print(f"{name}: after 1 s stress {mp.nstr(stress, 9)} Pa, strain {mp.nstr(strain, 9)}")
    for frequency in (0.5, 5):
        modulus = young(mp.mpc(0, 2 * mp.pi * frequency))
        print(f"    {frequency} Hz: storage {mp.nstr(modulus.real, 9)} Pa, loss {mp.nstr(modulus.imag, 9)} Pa, "
              f"tan delta {mp.nstr(modulus.imag / modulus.real, 9)}")


def main():
    spring = mp.mpf(6500) / 3  # K of Y = 2600 Pa, nu = 0.3
    report("Kelvin-Voigt", lambda s: 1000 + 100 * s, lambda s: spring)
    report("Maxwell", lambda s: 1000 * s / (s + 10), lambda s: mp.mpf(2000))
    report("volume change that relaxes", lambda s: 1000 + 2000 * s / (s + 10) + 500 * s / (s + 1),
           lambda s: spring + 2000 * s / (s + 5))


if __name__ == "__main__":
    main()
