#!/usr/bin/python3
"""Numbers of the closed-form wave theory at high precision, for the unit tests in tests/theory.

    scripts/references/waves/closed_form_theory.py

Everything is computed with mpmath (60 digits) from the equations and not from the formulas that the program uses: the flow
in a rigid tube by quadrature of its profile, psi by solving Lame's cylinder for its two constants, the membrane's wave
number by a root search in the dispersion equation.
Needs python3-mpmath.
"""

from mpmath import besseli, besselj, bessely, besselk, diff, findroot, lu_solve, matrix, mp, mpc, mpf, nstr, pi, quad, sqrt

mp.dps = 60
I = mpc(0, 1)


def show(name, value):
    value = mpc(value)
    print(f"{name}: {nstr(value.real, 17)} {nstr(value.imag, 17)}")


def bessel_functions():
    functions = {"J": besselj, "Y": bessely, "I": besseli, "K": besselk}
    for name, n, z in (
        ("J", 0, 0.001 - 0.002j), ("J", 1, 1e-12 + 1e-12j), ("J", 0, 2.404825557695773), ("J", 1, 3.8317059702075125 + 1e-10j),
        ("J", 2, 20 - 15j), ("J", 0, 100), ("J", 1, -7 + 400j), ("Y", 0, 0.001 - 0.002j), ("Y", 1, 3 - 4j), ("Y", 2, 50 + 20j),
        ("I", 0, 2 + 3j), ("I", 1, 30 - 1j), ("K", 0, 2 + 3j), ("K", 1, 1e-6)):
        show(f"{name}{n}({z})", functions[name](n, mpc(z)))
    stokes = -7.0710678118654755e2 + 7.0710678118654755e2j
    for name, m, a, n, b in (
        ("J", 1, stokes, 0, stokes), ("J", 1, 1e-3 - 1e-3j, 0, 1e-3 - 1e-3j), ("J", 0, 400 + 2000j, 1, 410 + 2001j),
        ("J", 2, 5e4 - 5e4j, 0, 5.001e4 - 5e4j), ("J", 0, 2.404825557695773, 1, 2.404825557695773),
        ("J", 1, 12.5 - 7j, 0, 13 - 6j), ("Y", 0, 30 - 3000j, 1, 31 - 3001j), ("I", 1, 5000 + 3j, 0, 5001 + 2j),
        ("I", 0, 0.01, 1, 0.02j), ("K", 0, 5001 + 3j, 1, 5000 + 2j)):
        show(f"{name}{m}({a})/{name}{n}({b})", functions[name](m, mpc(a)) / functions[name](n, mpc(b)))


# A rigid tube of 12.5 mm filled with water; P = dp/dz = 2 - 3i Pa/m.
R, rho, eta, P = mpf("0.0125"), mpf(998), mpf("0.001"), mpc(2, -3)


def rigid_velocity(omega, r):
    """Solution of i omega rho u = -P + eta (u'' + u'/r), u(R) = 0, with modified Bessel functions."""
    q = sqrt(I * omega * rho / eta)
    return I * P / (rho * omega) * (1 - besseli(0, q * r) / besseli(0, q * R))


def womersley():
    for omega in (mpf("1e-6"), mpf(2), mpf(125), mpc(125, -7)):
        mean = quad(lambda r: rigid_velocity(omega, r) * 2 * r / R**2, [0, R / 2, 0.95 * R, R])
        shear = -eta * diff(lambda r: rigid_velocity(omega, r), R)
        inviscid = I * P / (rho * omega)
        print(f"omega = {nstr(omega, 17)}: alpha {nstr(R * sqrt(omega * rho / eta), 17)}")
        show("  1 - F10", mean / inviscid)
        show("  velocity at R/2", rigid_velocity(omega, R / 2))
        show("  flow rate", mean * pi * R**2)
        show("  wall shear stress", shear)
        show("  wave number for c0 = 2.6 + 0.1i", omega / mpc("2.6", "0.1") * sqrt(inviscid / mean))


def lame(inner, thickness, nu, anchoring):
    """psi = (Y h / 2R) (2 u(R) / R) / p for p = 1, Y = 1: u = a r + b / r, sigma_r(R) = -1, sigma_r(R + h) = 0."""
    outer = inner + thickness
    area_ratio = inner**2 / (outer**2 - inner**2)
    # Unknowns a, b, axial strain e. sigma = lambda tr + 2 mu eps.
    mu, lam = 1 / (2 * (1 + nu)), nu / ((1 + nu) * (1 - 2 * nu))

    def radial(r):
        return [2 * lam + 2 * mu, -2 * mu / r**2, lam]

    rows = [radial(inner), radial(outer)]
    right = [-1, 0]
    if anchoring == "throughout":
        rows.append([0, 0, 1])
        right.append(0)
    else:
        rows.append([2 * lam, 0, lam + 2 * mu])
        right.append(area_ratio if anchoring == "upstream" else 0)
    a, b, _ = lu_solve(matrix(rows), matrix(right))
    return thickness / inner * (a + b / inner**2)


def korteweg():
    for anchoring in ("upstream", "throughout", "expansion joints"):
        for inner, thickness, nu in (("5e-3", "1e-3", "0.3"), ("0.0125", "1e-4", "0.49")):
            show(f"psi, {anchoring}, R {inner}, h {thickness}, nu {nu}",
                 lame(mpf(inner), mpf(thickness), mpf(nu), anchoring))
    # Water and a steel pipe: 1/c^2 = rho (1/K + psi 2R/(Y h)).
    for anchoring in ("upstream", "throughout", "expansion joints"):
        psi = lame(mpf("0.25"), mpf("0.01"), mpf("0.3"), anchoring)
        show(f"steel pipe, {anchoring}", 1 / sqrt(1000 * (1 / mpf("2.1e9") + psi * 2 * mpf("0.25") / (mpf("2.07e11") * mpf("0.01")))))


def membrane(radius, h, rho_s, nu, omega, modulus):
    def equation(k):
        return omega**2 * (rho * besseli(0, k * radius) / (k * besseli(1, k * radius)) + rho_s * h) - modulus * h / radius**2

    long_wave = omega * sqrt(2 * radius * rho / (modulus * h))
    k = findroot(equation, long_wave)
    q = sqrt(I * omega * rho / eta) * radius
    f10 = 2 * besseli(1, q) / (q * besseli(0, q))
    print(f"R {nstr(radius, 5)}, h {nstr(h, 5)}, omega {nstr(omega, 6)}:")
    show("  k membrane", k)
    show("  k membrane, viscous", k / sqrt(1 - f10))
    for anchoring, a in (("throughout", 1), ("expansion joints", 1 - nu / 2)):
        psi = lame(radius, h, nu, anchoring)
        thick = omega * sqrt(rho * (1 / mpf("2.2e9") + psi * 2 * radius / (modulus * h)))
        show(f"  k closed formula, {anchoring}", thick * k / long_wave / sqrt(1 - a**2 * f10))


def membranes():
    for omega in (mpf("0.1"), 2 * pi * 20, 2 * pi * 200):
        membrane(mpf("0.0125"), mpf("1e-4"), mpf(880), mpf("0.49"), omega, mpf("1.72e6"))
    membrane(mpf("0.0125"), mpf("1e-4"), mpf(880), mpf("0.49"), 2 * pi * mpc(20, "-0.5"), mpc("1.72e6", "1.7e5"))
    membrane(mpf("5e-3"), mpf("1e-3"), mpf(1200), mpf("0.3"), 2 * pi * 167, mpf("3e5"))


if __name__ == "__main__":
    bessel_functions()
    womersley()
    korteweg()
    membranes()
