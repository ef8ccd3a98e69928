#!/usr/bin/python3
"""The developed steady flow of a liquid through a circular bend: reference of parameter_files/verification/flow-in-a-bend.prm
and flow-in-a-bend-200.prm.

    scripts/references/flow/flow_in_a_bend.py [POINTS_ALONG_A_RADIUS [POINTS_AROUND]]

Far inside a bend the flow is the same in each section, and the pressure falls by the same amount G from each radian of the bend to the
next. With the distance r from the axis of the bend, the height z over its plane, the velocities u, v along r and z and w along the
bend, the stream function s (u = -s_z/r, v = s_r/r) and the vorticity o = u_z - v_r the equations are

    u w_r + v w_z + u w/r                 = G/(rho r) + nu (w_rr + w_r/r + w_zz - w/r^2)
    u o_r + v o_z - u o/r - 2 w w_z/r     = nu (o_rr + o_r/r + o_zz - o/r^2)
    r o + s_rr + s_zz - s_r/r             = 0

with w = s = ds/dn = 0 on the wall. They are solved by collocation in the disc of the section (L. N. Trefethen, Spectral Methods in
MATLAB, SIAM 2000, chapter 11) and Newton's iteration. The mean of w fixes G. Lengths are in radii of the vessel, velocities in
mean velocities, pressures in rho times the mean velocity squared. The number of Dean is D = Re sqrt(a/R) with the diameter in Re.

Beside the friction stands that of two correlations of measurements for gentle bends: C. M. White, Proc. R. Soc. A 123 (1929)
645-663, and D. Hasson, Res. Corresp. 1 (1955) S1. Needs numpy.
"""

import sys

import numpy as np

CURVATURE = 0.1


def chebyshev(n):
    """The points and the matrix of the derivative on [-1, 1] with n + 1 points."""
    x = np.cos(np.pi * np.arange(n + 1) / n)
    c = np.array([2] + [1] * (n - 1) + [2]) * (-1) ** np.arange(n + 1)
    differences = np.subtract.outer(x, x)
    matrix = np.outer(c, 1 / c) / (differences + np.eye(n + 1))
    return x, matrix - np.diag(matrix.sum(axis=1))


def periodic(n):
    """The matrix of the derivative on n equal steps of the circle; n is even."""
    h = 2 * np.pi / n
    k = np.arange(1, n)
    column = np.concatenate([[0], 0.5 * (-1.0) ** k / np.tan(k * h / 2)])
    return np.array([[column[(i - j) % n] for j in range(n)] for i in range(n)])


class Section:
    """The disc of the section: points, derivatives along r and z, weights of the integral."""

    def __init__(self, radial, around):
        n = 2 * radial - 1
        x, d = chebyshev(n)
        half = radial
        self.distance, d2 = x[:half], d @ d
        self.around, self.half = around, half
        turn = np.roll(np.eye(around), around // 2, axis=0)

        def whole(matrix):
            # A point at a negative distance is one at the opposite angle.
            return np.kron(matrix[:half, :half], np.eye(around)) + np.kron(matrix[:half, half:][:, ::-1], turn)

        along, angle = whole(d), np.kron(np.diag(1 / self.distance), periodic(around))
        theta = 2 * np.pi * np.arange(around) / around
        self.theta = np.tile(theta, half)
        s = np.repeat(self.distance, around)
        cosine, sine = np.cos(self.theta)[:, None], np.sin(self.theta)[:, None]
        self.d_r = cosine * along - sine * angle
        self.d_z = sine * along + cosine * angle
        self.laplace = whole(d2) + (1 / s)[:, None] * along + angle @ angle
        self.normal = along
        self.r = 1 / CURVATURE + s * np.cos(self.theta)
        self.wall = s > 1 - 1e-12
        # Clenshaw and Curtis, of s|ds| over [-1, 1]: the weights that integrate all even polynomials over the half exactly.
        powers = np.arange(half)
        moments = 1 / (2 * powers + 2)
        weights = np.linalg.solve(np.array([self.distance ** (2 * p) for p in powers]), moments)
        self.weights = np.repeat(weights, around) * 2 * np.pi / around

    def at(self, field, distance, theta):
        """The value at a point inside, by the interpolation that belongs to the points."""
        n = 2 * self.half - 1
        x = np.cos(np.pi * np.arange(n + 1) / n)
        values = field.reshape(self.half, self.around)
        whole = np.concatenate([values, np.roll(values, self.around // 2, axis=1)[::-1]])
        modes = np.fft.fft(whole, axis=1) / self.around
        k = np.fft.fftfreq(self.around, 1 / self.around)
        line = np.real(modes @ np.exp(1j * k * theta))
        weight = (-1.0) ** np.arange(n + 1)
        weight[[0, -1]] /= 2
        gap = distance - x
        if np.any(abs(gap) < 1e-14):
            return line[np.argmin(abs(gap))]
        return np.sum(weight / gap * line) / np.sum(weight / gap)


def flow(section, dean, start=None):
    """w, s, o and G at a number of Dean, by Newton's iteration."""
    n = len(section.r)
    viscosity = 2 / (dean / np.sqrt(CURVATURE))
    r = section.r[:, None]
    d_r, d_z = section.d_r, section.d_z
    diffusion = viscosity * (section.laplace + d_r / r - np.diag(1 / section.r**2))
    elliptic = section.laplace - d_r / r
    unknowns = np.zeros(3 * n + 1) if start is None else start.copy()
    if start is None:
        unknowns[:n] = 2 * (1 - (section.r - 1 / CURVATURE) ** 2 - section_height(section) ** 2)
        unknowns[-1] = 8 * viscosity / CURVATURE
    wall, inner = section.wall, ~section.wall
    for _ in range(40):
        w, s, o = unknowns[:n], unknowns[n : 2 * n], unknowns[2 * n : 3 * n]
        u, v = -(d_z @ s) / section.r, (d_r @ s) / section.r
        along = u[:, None] * d_r + v[:, None] * d_z
        du, dv = -d_z / r, d_r / r
        residual, matrix = np.zeros(3 * n + 1), np.zeros((3 * n + 1, 3 * n + 1))
        residual[:n] = along @ w + u * w / section.r - unknowns[-1] / section.r - diffusion @ w
        matrix[:n, :n] = along + np.diag(u / section.r) - diffusion
        matrix[:n, n : 2 * n] = (d_r @ w + w / section.r)[:, None] * du + (d_z @ w)[:, None] * dv
        matrix[:n, -1] = -1 / section.r
        residual[n : 2 * n] = section.r * o + elliptic @ s
        matrix[n : 2 * n, n : 2 * n] = elliptic
        matrix[n : 2 * n, 2 * n : 3 * n] = np.diag(section.r)
        residual[2 * n : 3 * n] = along @ o - u * o / section.r - 2 * w * (d_z @ w) / section.r - diffusion @ o
        matrix[2 * n : 3 * n, :n] = -2 / r * (np.diag(d_z @ w) + w[:, None] * d_z)
        matrix[2 * n : 3 * n, n : 2 * n] = (d_r @ o - o / section.r)[:, None] * du + (d_z @ o)[:, None] * dv
        matrix[2 * n : 3 * n, 2 * n : 3 * n] = along - np.diag(u / section.r) - diffusion
        rows = np.arange(n)[wall]
        for offset, operator, value in ((0, np.eye(n), w), (n, np.eye(n), s), (2 * n, section.normal, s)):
            residual[offset + rows] = operator[wall] @ value
            matrix[offset + rows] = 0
            column = n if offset == 2 * n else offset
            matrix[offset + rows, column : column + n] = operator[wall]
        residual[-1] = section.weights @ w / np.pi - 1
        matrix[-1, :n] = section.weights / np.pi
        change = np.linalg.solve(matrix, residual)
        unknowns -= change
        if np.max(abs(change)) < 1e-10 * np.max(abs(unknowns)):
            return unknowns
    sys.exit("Newton's iteration does not converge")


def section_height(section):
    return np.repeat(section.distance, section.around) * np.sin(section.theta)


def main():
    radial, around = (int(a) for a in (sys.argv[1:] + ["16", "40"][len(sys.argv) - 1 :])[:2])
    section = Section(radial, around)
    unknowns = None
    for dean in (5, 20, 50, 100, 150, 200):
        unknowns = flow(section, dean, unknowns)
        if dean not in (5, 50, 200):
            continue
        n = len(section.r)
        w, s, drop = unknowns[:n], unknowns[n : 2 * n], unknowns[-1]
        u, v = -(section.d_z @ s) / section.r, (section.d_r @ s) / section.r
        reynolds = dean / np.sqrt(CURVATURE)
        ratio = drop * CURVATURE / (16 / reynolds)
        print(f"Dean number {dean}, Re {reynolds:.4f}, curvature {CURVATURE}")
        print(f"  friction over that of a straight pipe  {ratio:.5f}"
              + (f"   (White {1 / (1 - (1 - (11.6 / dean) ** 0.45) ** (1 / 0.45)):.3f}, Hasson {0.556 + 0.0969 * dean**0.5:.3f})"
                 if dean > 11.6 else ""))
        print(f"  pressure drop of a radian              {drop:.6f} rho W^2")
        for name, distance, theta in (("at the centre", 0, 0), ("half way outward", 0.5, 0), ("half way inward", 0.5, np.pi),
                                      ("half way upward", 0.5, np.pi / 2), ("near the wall, upward", 0.9, np.pi / 2)):
            print(f"  {name:22} along {section.at(w, distance, theta):9.6f}, outward {section.at(u, distance, theta):9.6f}, "
                  f"upward {section.at(v, distance, theta):9.6f} W")
        k = np.argmax(w)
        print(f"  largest velocity along the bend        {w[k]:.5f} W")


if __name__ == "__main__":
    main()
