#!/usr/bin/python3
"""The tables of parameter_files/examples/material-fit/, which are synthetic; and how well constants can be found in them.

    scripts/references/tables/prony_tables.py parameter_files/examples/material-fit

The relaxation of Young's modulus is 400 + 150 exp(-t/0.5 s) + 80 exp(-t/10 s) kPa. The tables are those of three tests, each value times 1 + e g with
normal numbers g of Python's generator, seed 1:

* relaxation: a strain of 2 % that rises evenly within 0.1 s and is held, e = 0.003;
* creep: a stress of 5 kPa that is there from t = 0 on, e = 0.003. The poles of the compliance 1/E(s) are the roots of a polynomial (numpy);
* storage and loss modulus, to each of which e = 0.005 times the magnitude of both is added.

It then fits each table by scipy.optimize.least_squares, in the logarithms of the constants, and prints what it finds with the standard errors of the
curvature and of the residuals. At last it fits all tables together, each with its own variance: the sum of the squares of its residuals over its number of values
less its share of the constants (the trace of its part of J (J^T J)^-1 J^T), found in turn with the constants.
"""

import math
import os
import random
import sys

import numpy
import scipy.optimize

MODULI, TIMES = (400.0, 150.0, 80.0), (0.5, 10.0)  # kPa, s
STRAIN, LOADING_TIME, STRESS = 0.02, 0.1, 5.0  # 1, s, kPa
NOISE, NOISE_OF_MODULI = 0.003, 0.005
NAMES = ("long-term Young's modulus [kPa]", "modulus 1 [kPa]", "modulus 2 [kPa]", "time 1 [s]", "time 2 [s]")


def relaxation(constants, time):
    """Stress over the strain that is held, after an even loading [kPa]."""
    spring, moduli, times = constants[0], constants[1:3], constants[3:5]
    held = time - LOADING_TIME
    return spring + sum(m * tau / LOADING_TIME * (numpy.exp(-held / tau) - numpy.exp(-time / tau)) for m, tau in zip(moduli, times))


def creep(constants, time):
    """Strain over stress [1/kPa]."""
    spring, moduli, times = constants[0], constants[1:3], constants[3:5]
    # E(s) = numerator/denominator with the denominator prod (s + 1/tau).
    rates = [1 / tau for tau in times]
    denominator = numpy.poly([-r for r in rates])
    numerator = spring * denominator
    for i, modulus in enumerate(moduli):
        others = numpy.poly([-r for j, r in enumerate(rates) if j != i])
        numerator = numpy.polyadd(numerator, modulus * numpy.polymul([1.0, 0.0], others))
    # The inverse transform of 1/(s E(s)): residues at 0 and at the roots.
    result = numpy.full_like(time, 1 / spring)
    slope = numpy.polyder(numpy.polymul([1.0, 0.0], numerator))
    for root in numpy.roots(numerator).real:
        result = result + numpy.polyval(denominator, root) / numpy.polyval(slope, root) * numpy.exp(root * time)
    return result


def moduli(constants, frequency):
    """Complex Young's modulus [kPa]."""
    omega = 2j * math.pi * frequency
    return constants[0] + sum(m * omega * tau / (1 + omega * tau) for m, tau in zip(constants[1:3], constants[3:5]))


def fit(name, residuals):
    """Prints constants and standard errors; `residuals` of the constants, over the unit of the noise."""
    truth = numpy.array([*MODULI, *TIMES])
    found = scipy.optimize.least_squares(lambda x: residuals(numpy.exp(x)), numpy.log(truth), xtol=1e-14, ftol=1e-14, gtol=1e-14, jac="3-point")
    n, p = found.jac.shape
    variance = 2 * found.cost / (n - p)
    errors = numpy.exp(found.x) * numpy.sqrt(variance * numpy.diag(numpy.linalg.inv(found.jac.T @ found.jac)))
    print(f"{name}: {n} values, root of the mean square of the residuals {math.sqrt(2 * found.cost / n):.6f}")
    for label, value, error, exact in zip(NAMES, numpy.exp(found.x), errors, truth):
        print(f"  {label}: {value:.6g} +- {error:.4g}, {abs(value - exact) / error:.2f} standard errors from {exact:g}")


def fit_together(parts):
    """The same of several tables; `parts`: for each a function of the constants, over the unit of its noise."""
    truth = numpy.array([*MODULI, *TIMES])
    logarithms, noise = numpy.log(truth), [1.0] * len(parts)
    for _ in range(30):
        found = scipy.optimize.least_squares(lambda x: numpy.concatenate([part(numpy.exp(x)) / s for part, s in zip(parts, noise)]), logarithms,
                                             xtol=1e-14, ftol=1e-14, gtol=1e-14, jac="3-point")
        logarithms, covariance = found.x, numpy.linalg.inv(found.jac.T @ found.jac)
        errors = numpy.exp(found.x) * numpy.sqrt(numpy.diag(covariance))
        before, first = noise, 0
        noise = []
        for part, s in zip(parts, before):
            residuals = part(numpy.exp(logarithms))
            rows = found.jac[first : first + len(residuals)]
            first += len(residuals)
            noise.append(math.sqrt(numpy.sum(residuals**2) / (len(residuals) - numpy.trace(rows @ covariance @ rows.T))))
        if max(abs(a / b - 1) for a, b in zip(noise, before)) < 1e-6:
            break
    print(f"together: noise {', '.join(f'{s:.6f}' for s in noise)}")
    for label, value, error, exact in zip(NAMES, numpy.exp(found.x), errors, truth):
        print(f"  {label}: {value:.6g} +- {error:.4g}, {abs(value - exact) / error:.2f} standard errors from {exact:g}")


def write(folder, name, header, rows, comment):
    with open(os.path.join(folder, name), "w", encoding="utf-8") as stream:
        stream.write("# Synthetic, not measured: Young's modulus relaxes as 400 + 150 exp(-t/0.5 s) + 80 exp(-t/10 s) kPa;\n"
                     f"# {comment}; by scripts/references/tables/prony_tables.py.\n{header}\n")
        for row in rows:
            stream.write(", ".join(f"{value:.6g}" for value in row) + "\n")


def main():
    folder = sys.argv[1]
    truth = [*MODULI, *TIMES]
    generator = random.Random(1)
    gauss = lambda n: numpy.array([generator.gauss(0, 1) for _ in range(n)])

    time = LOADING_TIME * 10 ** (numpy.arange(1, 61) / 20)
    stress = STRAIN * relaxation(truth, time) * (1 + NOISE * gauss(len(time)))
    write(folder, "relaxation.csv", "time [s], stress [kPa]", zip(time, stress), "a strain of 2 % within 0.1 s, noise of 0.3 %")
    strain = STRESS * creep(truth, time) * (1 + NOISE * gauss(len(time)))
    write(folder, "creep.csv", "time [s], strain [1]", zip(time, strain), "a stress of 5 kPa from t = 0 on, noise of 0.3 %")
    frequency = 10 ** (-3 + numpy.arange(0, 31) / 7.5)
    exact = moduli(truth, frequency)
    storage = exact.real + NOISE_OF_MODULI * abs(exact) * gauss(len(frequency))
    loss = exact.imag + NOISE_OF_MODULI * abs(exact) * gauss(len(frequency))
    write(folder, "moduli.csv", "frequency [Hz], storage modulus [kPa], loss modulus [kPa]", zip(frequency, storage, loss),
          "noise of 0.5 % of the magnitude")

    # As they stand in the files.
    tables = {name: numpy.loadtxt(os.path.join(folder, name + ".csv"), delimiter=",", skiprows=3) for name in ("relaxation", "creep", "moduli")}
    time, values = tables["relaxation"].T
    of_relaxation = lambda x: numpy.log(STRAIN * relaxation(x, time) / values)
    fit("relaxation", of_relaxation)
    found = scipy.optimize.least_squares(
        lambda x: numpy.log(math.exp(x[0]) * STRAIN / (LOADING_TIME * (1 - x[1])) * (time ** (1 - x[1]) - (time - LOADING_TIME) ** (1 - x[1])) / values),
        [math.log(500.0), 0.05], xtol=1e-14, ftol=1e-14, gtol=1e-14, jac="3-point")
    print(f"relaxation, power law: c {math.exp(found.x[0]):.6g} kPa, n {found.x[1]:.6g}, root of the mean square {math.sqrt(2 * found.cost / len(time)):.6f}")
    times, strains = tables["creep"].T
    of_creep = lambda x: numpy.log(STRESS * creep(x, times) / strains)
    fit("creep", of_creep)
    frequency, storage, loss = tables["moduli"].T
    magnitude = numpy.hypot(storage, loss)
    of_moduli = lambda x: numpy.concatenate([(moduli(x, frequency).real - storage) / magnitude, (moduli(x, frequency).imag - loss) / magnitude])
    fit("moduli", of_moduli)
    fit_together([of_relaxation, of_creep, of_moduli])


if __name__ == "__main__":
    main()
