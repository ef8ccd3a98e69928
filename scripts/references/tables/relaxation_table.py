#!/usr/bin/python3
"""The table of parameter_files/examples/relaxation-test/, which is synthetic, to standard output.

    scripts/references/tables/relaxation_table.py > parameter_files/examples/relaxation-test/relaxation-test.csv

The measured tables of the thesis are not published. This one is what its tensile test (section 5.3) would show of its law,
Y(t) = c (t/1 s)^-n with c = 1.3e6 Pa (its table 6.3) and n = 0.065: a strip 0.14 mm thick and 37.3 mm wide whose strain rises
evenly to 3 % within 0.2 s and is held. The force is that of the Boltzmann integral (5.1),

    F = A c e/(T (1 - n)) (t^(1-n) - max(t - T, 0)^(1-n)),

times 1 + 0.005 g with normal numbers g of Python's generator, seed 1: noise of 0.5 %.
"""

import random

C = 1.3e6  # Pa
N = 0.065
STRAIN = 0.03
LOADING_TIME = 0.2  # s
AREA = 0.14e-3 * 37.3e-3  # m^2
NOISE = 0.005


def force(time):
    """[N]"""
    held = max(time - LOADING_TIME, 0.0)
    return AREA * C * STRAIN / (LOADING_TIME * (1 - N)) * (time**(1 - N) - held**(1 - N))


def main():
    generator = random.Random(1)
    loading = [0.01 * k for k in range(1, 21)]
    held = [0.2 * 10**(k / 30) for k in range(1, 112)]
    print("# Synthetic, not measured: the law Y(t) = 1.3e6 Pa (t/1 s)^-0.065 in a tensile test of a strip of 0.14 mm by 37.3 mm")
    print("# that is strained by 3 % within 0.2 s and held, with noise of 0.5 %; by scripts/references/tables/relaxation_table.py.")
    print("time [s], force [N]")
    for time in loading + held:
        print(f"{time:.6g}, {force(time) * (1 + NOISE * generator.gauss(0, 1)):.5g}")


if __name__ == "__main__":
    main()
