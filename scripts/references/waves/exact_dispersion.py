#!/usr/bin/python3
"""Wave numbers of axisymmetric harmonic waves in a tube full of liquid, to 20 digits: reference of
tests/theory/exact_dispersion.cc.

    scripts/references/waves/exact_dispersion.py [NAME ...]

Another way than Continua's, which takes potentials, Bessel functions and one large determinant. Here is neither: with
exp(i(omega t - k z)), shear modulus mu (i omega eta in the liquid), kappa = 1/K,

    1/M = kappa/(1 + 4 mu kappa/3),     a = lambda/M = (1 - 2 mu kappa/3)/(1 + 4 mu kappa/3),

the momentum balances and the law of the material are four ordinary differential equations over r, in which the
incompressible body is no exception. In w = u_r/r, u = u_z, s = sigma_rr, t = sigma_rz/r they are

    r w' = s/M - (1 + a) w + a i k u
    r u' = r^2 (t/mu + i k w)
    r s' = (a - 1) s + 2 mu (1 + a) w - 2 mu a i k u + r^2 (i k t - rho omega^2 w)
    r t' = -2 t + i k (a s + 2 mu a w - 2 mu (1 + a) i k u) - rho omega^2 u.

The two solutions that are regular on the axis are series in r^2; they are carried through the layers of the wall by
Taylor series about the inner radius of each of a few shells. What is left is the condition on the outer surface, a
determinant of two rows: sigma_rr = 0 with sigma_rz = 0 (free) or u_z = 0 (tethered), or sigma_rr = -k_r u_r with
sigma_rz = -k_z u_z (supported), or no displacement of the liquid at the wall (rigid). An inviscid liquid has one solution,
a series for s and w alone, and slides on the wall, whose axial displacement there is the second unknown. The root is found
by Muller's method with 50 digits more than the growth of the shear wave from the axis to the wall takes.

Also printed: for unit mean axial displacement of the liquid, the displacement u_r and shear stress of the liquid at the
inner wall, and the wall's axial force, bending moment about its middle radius and mean hoop stress over its section, from
integrals of the Taylor series. Needs python3-mpmath.
"""

import sys

from mpmath import besseli, matrix, mp, mpc, mpf, pi, sqrt, gamma

I = mpc(0, 1)


def solid(density, young, poisson):
    """Y and nu; the bulk modulus is that of both."""
    young, poisson = mpf(young), mpf(poisson)
    return {"rho": mpf(density), "kappa": 3 * (1 - 2 * poisson) / young, "mu": lambda omega: young / (2 * (1 + poisson))}


def maxwell(density, kappa, branches):
    def modulus(omega):
        return sum(mpf(m) if tau is None else mpf(m) * I * omega * mpf(tau) / (1 + I * omega * mpf(tau))
                   for m, tau in branches)
    return {"rho": mpf(density), "kappa": mpf(kappa), "mu": modulus}


def power_law(density, kappa, c, n):
    """Y(t) = c t^-n: Y(omega) = c Gamma(1 - n) (i omega)^n, mu = Y/(3 - Y kappa/3)."""
    c, n, kappa = mpf(c), mpf(n), mpf(kappa)

    def modulus(omega):
        young = c * gamma(1 - n) * (I * omega)**n
        return young / (3 - young * kappa / 3)
    return {"rho": mpf(density), "kappa": kappa, "mu": modulus}


def power_law_with_poissons_ratio(density, nu, c, n):
    """Shear and volume relax alike: mu = Y/(2 (1 + nu)), kappa = 3 (1 - 2 nu)/Y, a function of frequency as mu is."""
    c, n, nu = mpf(c), mpf(n), mpf(nu)

    def young(omega):
        return c * gamma(1 - n) * (I * omega)**n
    return {"rho": mpf(density), "kappa": lambda omega: 3 * (1 - 2 * nu) / young(omega),
            "mu": lambda omega: young(omega) / (2 * (1 + nu))}


def liquid(density, viscosity, kappa):
    return {"rho": mpf(density), "kappa": mpf(kappa), "mu": lambda omega: I * omega * mpf(viscosity)}


class System:
    """r y' = (A0 + r^2 A2) y, y = (w, u, s, t)."""

    def __init__(self, material, omega, k):
        self.mu = mu = material["mu"](omega)
        kappa, inertia = material["kappa"], material["rho"] * omega**2
        self.compliance = kappa / (1 + 4 * mu * kappa / 3)
        self.a = a = (1 - 2 * mu * kappa / 3) / (1 + 4 * mu * kappa / 3)
        self.k, self.inertia = k, inertia
        ik = I * k
        self.a0 = [[-(1 + a), a * ik, self.compliance, 0], [0, 0, 0, 0],
                   [2 * mu * (1 + a), -2 * mu * a * ik, a - 1, 0],
                   [2 * mu * a * ik, 2 * mu * (1 + a) * k**2 - inertia, a * ik, -2]]
        self.a2 = [[0, 0, 0, 0], [ik, 0, 0, 1 / mu if mu != 0 else None], [-inertia, 0, 0, ik], [0, 0, 0, 0]]

    def hoop_stress(self, y):
        return self.a * y[2] + 2 * self.mu * (self.a * (y[0] - I * self.k * y[1]) + y[0])

    def axial_stress(self, y):
        return self.a * y[2] + 2 * self.mu * (self.a * (y[0] - I * self.k * y[1]) - I * self.k * y[1])


def times(a, y):
    return [sum(a[i][j] * y[j] for j in range(4) if a[i][j] != 0) for i in range(4)]


def core(material, omega, k, radius):
    """The solutions that are regular on the axis, at the radius, as (y, mean of u_z over the section)."""
    system = System(material, omega, k)
    small = mpf(10)**(-mp.dps - 5)
    if system.mu == 0:
        # s = -p: inertia u = i k s, r w' = s kappa - 2 w + i k u, r s' = -inertia r^2 w.
        factor = material["kappa"] - k**2 / system.inertia
        s, w, total, x, n = mpf(1), factor / 2, [mpf(0), mpf(0), mpf(0)], mpf(1), 0
        while True:
            terms = [w * x, s * x, s * x / (n + 1)]
            total = [a + b for a, b in zip(total, terms)]
            if n > 5 and max(abs(term) for term in terms) < small * max(abs(b) for b in total):
                u = I * k / system.inertia
                return [([total[0], u * total[1], total[1], mpf(0)], u * total[2])]
            n += 1
            s = -system.inertia * w / (2 * n)
            w = factor * s / (2 * n + 2)
            x *= radius**2
    solutions = []
    for u, s in ((mpf(1), mpf(0)), (mpf(0), mpf(1))):
        w = (s * system.compliance + system.a * I * k * u) / (1 + system.a)
        t = (I * k * (system.a * s + 2 * system.mu * system.a * w - 2 * system.mu * (1 + system.a) * I * k * u)
             - system.inertia * u) / 2
        y = [w, u, s, t]
        total, mean, x, n = list(y), u, mpf(1), 0
        while True:
            n += 1
            right = times(system.a2, y)
            left = matrix(4, 4)
            for i in range(4):
                for j in range(4):
                    left[i, j] = (2 * n if i == j else 0) - system.a0[i][j]
            y = list(mp.lu_solve(left, matrix(right)))
            x *= radius**2
            total = [a + b * x for a, b in zip(total, y)]
            mean += y[1] * x / (n + 1)
            if n > 5 and all(abs(b * x) <= small * abs(a) for a, b in zip(total, y)):
                break
        solutions.append((total, mean))
    return solutions


def through(system, y, inner, outer, middle):
    """y at the outer radius, and the integrals 2 pi r sigma_zz, 2 pi r (r - middle) sigma_zz, sigma_theta over r."""
    integrals = [mpf(0)] * 3
    n_shells = int((outer - inner) / inner * 4) + 1
    for shell in range(n_shells):
        r0 = inner + (outer - inner) * shell / n_shells
        h = (outer - inner) / n_shells
        a0, a2 = system.a0, system.a2
        coefficients = [y]
        total, power, n = list(y), mpf(1), 0
        while True:
            now = coefficients[n]
            first, second = times(a0, now), times(a2, now)
            step = [first[i] + r0**2 * second[i] - n * now[i] for i in range(4)]
            if n >= 1:
                second = times(a2, coefficients[n - 1])
                step = [step[i] + 2 * r0 * second[i] for i in range(4)]
            if n >= 2:
                second = times(a2, coefficients[n - 2])
                step = [step[i] + second[i] for i in range(4)]
            n += 1
            coefficients.append([value / (r0 * n) for value in step])
            power *= h
            total = [a + b * power for a, b in zip(total, coefficients[n])]
            if n > 8 and all(abs(b * power) <= mpf(10)**(-mp.dps - 5) * max(abs(a), abs(c))
                             for a, b, c in zip(total, coefficients[n], y)):
                break
        for n, c in enumerate(coefficients):
            i0, i1, i2 = (h**(n + m) / (n + m) for m in (1, 2, 3))
            axial = system.axial_stress(c)
            integrals[0] += 2 * pi * axial * (r0 * i0 + i1)
            integrals[1] += 2 * pi * axial * (r0 * (r0 - middle) * i0 + (2 * r0 - middle) * i1 + i2)
            integrals[2] += 2 * pi * system.hoop_stress(c) * (r0 * i0 + i1)
        y = total
    return y, integrals


def conditions(case, omega, k):
    """Rows of the determinant, and what the solutions are at the inner wall."""
    radius = mpf(case["radius"])
    inner = core(case["fluid"], omega, k, radius)
    layers = case.get("layers", [])
    if not layers:
        if len(inner) == 1:
            return [[inner[0][0][0]]], inner, None
        return [[y[0] for y, _ in inner], [y[1] for y, _ in inner]], inner, None
    states = [y for y, _ in inner]
    if len(inner) == 1:
        # The wall's own axial displacement there is free.
        states = [[states[0][0], mpf(0), states[0][2], mpf(0)], [mpf(0), mpf(1), mpf(0), mpf(0)]]
    edges = [radius]
    for thickness, _ in layers:
        edges.append(edges[-1] + mpf(thickness))
    middle = mpf(2) / 3 * (edges[-1]**3 - radius**3) / (edges[-1]**2 - radius**2)
    integrals = [[mpf(0)] * 3 for _ in states]
    for i, (_, material) in enumerate(layers):
        system = System(material, omega, k)
        for j in range(2):
            states[j], more = through(system, states[j], edges[i], edges[i + 1], middle)
            integrals[j] = [a + b for a, b in zip(integrals[j], more)]
    radial, axial = (mpf(k) + I * omega * mpf(c) for k, c in case.get("support", ((0, 0), (0, 0))))
    outside = edges[-1]
    for j in range(2):
        integrals[j][2] /= pi * (edges[-1]**2 - radius**2)
    return [[y[2] + radial * outside * y[0] for y in states],
            [y[1] if case.get("tethered") else y[3] + axial / outside * y[1] for y in states]], inner, integrals


def determinant(case, omega, k):
    rows, _, _ = conditions(case, omega, k)
    return rows[0][0] if len(rows) == 1 else rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0]


def set_digits(case, omega):
    fluid = case["fluid"]
    mp.dps = 50
    if fluid["mu"](omega) != 0:
        argument = sqrt(fluid["rho"] * omega**2 / fluid["mu"](omega)) * mpf(case["radius"])
        mp.dps += int(1.5 * abs(mp.im(argument)) / mp.log(10))


def root(case, omega, start):
    x = [start * (1 + mpf(10)**-3), start * (1 - mpf(10)**-3), start]
    f = [determinant(case, omega, value) for value in x]
    for _ in range(60):
        if f[2] == 0:
            return x[2]
        h1, h2 = x[1] - x[0], x[2] - x[1]
        d1, d2 = (f[1] - f[0]) / h1, (f[2] - f[1]) / h2
        a = (d2 - d1) / (h1 + h2)
        b = a * h2 + d2
        discriminant = sqrt(b**2 - 4 * a * f[2])
        following = x[2] - 2 * f[2] / max(b + discriminant, b - discriminant, key=abs)
        done = abs(following - x[2]) < mpf(10)**-25 * abs(following)
        x = [x[1], x[2], following]
        if done:
            return following
        f = [f[1], f[2], determinant(case, omega, following)]
    raise RuntimeError("no root found")


def quantities(case, omega, k):
    rows, inner, integrals = conditions(case, omega, k)
    if len(rows) == 1:
        amplitudes = [mpf(1)]
    else:
        amplitudes = [rows[0][1], -rows[0][0]]
    means = [mean for _, mean in inner]
    unit = sum(a * m for a, m in zip(amplitudes, means))
    radius = mpf(case["radius"])
    result = [radius * sum(a * y[0] for a, (y, _) in zip(amplitudes, inner)) / unit,
              radius * sum(a * y[3] for a, (y, _) in zip(amplitudes, inner)) / unit]
    if integrals is not None:
        result += [sum(a * i[m] for a, i in zip(amplitudes, integrals)) / unit for m in range(3)]
    return result


mp.dps = 50
WATER = liquid("998", "1e-3", 1 / mpf("2.2e9"))
OIL = liquid("870", "0.1", 1 / mpf("1.5e9"))
BLOOD = liquid("1060", "4e-3", 1 / mpf("2.2e9"))
THIN = {"radius": "12.5e-3", "fluid": WATER, "layers": [("0.1e-3", solid("880", "1.72e6", "0.49"))]}
TUBE_3D = {"radius": "5e-3", "fluid": liquid("1000", "3e-3", 0), "layers": [("1e-3", solid("1200", "3e5", "0.3"))]}
THICK = {"radius": "12.5e-3", "fluid": BLOOD, "layers": [("5e-3", solid("1100", "1e6", "0.49"))]}
CASES = {
    "thin": THIN,
    "tube-3d": TUBE_3D,
    "tube-3d-held": dict(TUBE_3D, tethered=True),
    # Stiffness [Pa/m] and damping [Pa s/m] along the radius and the axis.
    "supported": dict(TUBE_3D, support=(("6e6", "300"), ("2e5", "30"))),
    "supported-held": dict(TUBE_3D, support=(("6e6", "300"), (0, 0)), tethered=True),
    "thick": THICK,
    "membrane": {"radius": "10e-3", "fluid": liquid("1050", "1e-5", 0), "tethered": True,
                 "layers": [("0.01e-3", solid("1000", "60e6", "0.5"))]},
    "steel": {"radius": "0.1", "fluid": OIL, "layers": [("5e-3", solid("7850", "200e9", "0.3"))]},
    "power-law": {"radius": "12.5e-3", "fluid": BLOOD, "layers": [("1e-3", power_law("880", 0, "1.3e6", "0.065"))]},
    "power-law-nu": {"radius": "12.5e-3", "fluid": BLOOD,
                     "layers": [("1e-3", power_law_with_poissons_ratio("880", "0.3", "1.3e6", "0.065"))]},
    "layered": {"radius": "9e-3", "fluid": BLOOD,
                "layers": [("0.2e-3", solid("1100", "0.3e6", "0.49")),
                           ("0.9e-3", maxwell("1050", "1e-9", [("0.4e6", None), ("0.3e6", "5e-3")])),
                           ("0.5e-3", solid("1000", "1.2e6", "0.45"))]},
    "rigid": {"radius": "1e-3", "fluid": liquid("998", "1e-3", 1 / mpf("2.2e9"))},
    "tube-3d-inviscid": dict(TUBE_3D, fluid=liquid("1000", 0, 0)),
    "inviscid": {"radius": "12.5e-3", "fluid": liquid("998", 0, 1 / mpf("2.2e9")),
                 "layers": [("1e-3", solid("880", "1.72e6", "0.49"))]},
}


def starts(case, omega):
    """Rough wave numbers of the pressure and axial waves and of the first bending wave."""
    radius, fluid = mpf(case["radius"]), case["fluid"]
    if not case.get("layers"):
        return [("pressure", omega * sqrt(fluid["rho"] * fluid["kappa"]) * (1 - I / 50))]
    h = sum(mpf(thickness) for thickness, _ in case["layers"])
    young, density, nu = mpf(0), mpf(0), mpf(0)
    for thickness, material in case["layers"]:
        mu = material["mu"](omega)
        y = 9 * mu / (3 + mu * material["kappa"])
        young += y * mpf(thickness) / h
        density += material["rho"] * mpf(thickness) / h
        nu += (y / mu / 2 - 1) * mpf(thickness) / h
    middle = radius + h / 2
    # A bent membrane about an inviscid liquid: a short wave is far from the long one.
    k = mp.re(omega) * sqrt(fluid["rho"] * 2 * middle / (mp.re(young) * h))
    for _ in range(100):
        stiffness = mp.re(young) * h / middle**2 + mp.re(young) * h**3 / 12 * k**4 - density * h * mp.re(omega)**2
        k = (k + mp.re(omega)**2 * fluid["rho"] * besseli(0, k * radius) / (besseli(1, k * radius) * stiffness)) / 2
    slowness = omega / mp.re(omega) * (1 - I / 50)
    result = [("pressure", sqrt(k**2 + mp.re(omega)**2 * fluid["rho"] * fluid["kappa"]) * slowness)]
    if case.get("tethered"):
        return result
    result.append(("axial", omega * sqrt(density / young) * (1 - I / 50)))
    result.append(("bending", (12 * (1 - nu**2))**(mpf(1) / 4) / sqrt(middle * h) * mpc(1, -1) / sqrt(2)))
    return result


# Case, frequency [Hz], decay of the complex frequency [1/s].
RUNS = [("thin", 10, 0), ("thin", 20, 28), ("thin", 200, 0), ("tube-3d", 20, 0), ("tube-3d", 100, 0), ("tube-3d", 167, 0),
        ("tube-3d-held", 20, 0), ("supported", 20, 0), ("supported", 100, 50), ("supported-held", 100, 0), ("thick", 5, 30),
        ("thick", 100, 0), ("membrane", 2, 0), ("steel", 50, 0),
        ("steel", 400, 200), ("power-law", 20, 0), ("power-law-nu", 20, 10), ("layered", 20, 10), ("rigid", 50, 0), ("rigid", 2000, 300),
        ("inviscid", 20, 0), ("tube-3d-inviscid", 20, 0), ("tube-3d-inviscid", 100, 0), ("tube-3d-inviscid", 167, 0)]


def at_frequency(case, omega):
    """The case with the numbers of its materials' compressibilities, which may depend on frequency."""
    def resolved(material):
        kappa = material["kappa"]
        return dict(material, kappa=kappa(omega) if callable(kappa) else kappa)
    return dict(case, fluid=resolved(case["fluid"]), layers=[(h, resolved(m)) for h, m in case.get("layers", [])])


def show(z):
    return "(" + mp.nstr(mp.re(z), 20, min_fixed=0, max_fixed=0) + ", " + mp.nstr(mp.im(z), 20, min_fixed=0, max_fixed=0) + ")"


def main():
    wanted = sys.argv[1:]
    for name in wanted:
        if name not in CASES:
            sys.exit("no case '" + name + "'; there are " + ", ".join(CASES))
    for name, frequency, decay in RUNS:
        if wanted and name not in wanted:
            continue
        omega = mpc(2 * pi * frequency, -decay)
        case = at_frequency(CASES[name], omega)
        set_digits(case, omega)
        for family, start in starts(case, omega):
            if family == "bending" and name == "thin" and frequency == 200:
                continue  # Bending and pressure wave have met: the start leads elsewhere.
            k = root(case, omega, start)
            print(f"{name} {frequency} Hz -{decay}i {family}: k = {show(k)}")
            print("    c =", mp.nstr(2 * pi * frequency / mp.re(k), 12), "start", mp.nstr(start, 5), "u_r, sigma_rz, force, moment, hoop stress:",
                  " ".join(show(value) for value in quantities(case, omega, k)), flush=True)


if __name__ == "__main__":
    main()
