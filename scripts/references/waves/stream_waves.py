#!/usr/bin/python3
"""Long waves in a tube whose liquid flows: reference of the class StreamWaves (tests/theory/stream_waves.cc) and of
parameter_files/verification/stream-in-a-tube*.prm.

Without viscosity: the mean over the section of 1/(lambda - V)^2 is rho (D lambda'/(lambda - V_wall) + 1/K), by mpmath's quadrature and
root finder; lambda' is lambda on a mesh that stays, lambda - V_wall on a moving wall.

With viscosity, for V = V_max (1 - s^(m/2)) with an even m, s = (r/R)^2: the series u = sum a_j s^j and 2 r v/R^2 = sum b_j s^j in

  i rho (omega - k V) u + rho V_s 2 r v/R^2 - 4 eta/R^2 (s u')' = i k p,  (2 r v/R^2)' = i k u - i (omega - k V) p/K.

No Chebyshev points, no matrices. usage: stream_waves.py. Needs mpmath.
"""

import mpmath as mp

mp.mp.dps = 120


class Tube:
    """SI units; D: distensibility, K_inverse: 1/K, U: mean velocity, m: exponent (0: a plug)."""

    def __init__(self, radius, density, viscosity, distensibility, inverse_bulk, mean, exponent):
        self.radius, self.density, self.viscosity = mp.mpf(radius), mp.mpf(density), mp.mpf(viscosity)
        self.distensibility, self.inverse_bulk = mp.mpmathify(distensibility), mp.mpf(inverse_bulk)
        self.mean, self.exponent = mp.mpf(mean), exponent
        self.largest = self.mean * (exponent + 2) / exponent if exponent else self.mean

    def velocity(self, place):
        return self.largest * (1 - place ** self.exponent) if self.exponent else self.mean

    def long_wave_speed(self, with_stream, moving):
        slip = self.velocity(1)
        at_rest = 1 / mp.sqrt(self.density * (mp.re(self.distensibility) + self.inverse_bulk))

        def residual(speed):
            mean = mp.quad(lambda r: 2 * r / (speed - self.velocity(r)) ** 2, [0, 0.5, 1])
            return mean - self.density * (
                mp.re(self.distensibility) * ((speed - slip) if moving else speed) / (speed - slip) + self.inverse_bulk)
        begin = (self.largest if with_stream else 0) + (1 if with_stream else -1) * at_rest / 50
        end = (self.largest if with_stream else 0) + (2 if with_stream else -2) * at_rest
        return mp.findroot(residual, (begin, end), solver="anderson", tol=1e-30)

    def excess(self, omega, k, moving):
        """The flow into the wall of unit pressure less what the wall takes."""
        rho, half = self.density, self.exponent // 2
        diffusion = 4 * self.viscosity / self.radius**2
        n = 60 + int(6 * self.radius * mp.sqrt(omega * rho / self.viscosity))

        def series(start, push):
            a, b = [mp.mpc(start)], [mp.mpc(0)]
            for j in range(n):
                # omega - k V = (omega - k V_max) + k V_max s^half; V_s = -V_max half s^(half - 1)
                compression = ((omega - k * self.largest) if j == 0 else 0) + (k * self.largest if j == half else 0)
                b.append((1j * k * a[j] - 1j * compression * self.inverse_bulk * push) / (j + 1))
                right = 1j * rho * (omega - k * self.largest) * a[j]
                if j >= half:
                    right += 1j * rho * k * self.largest * a[j - half]
                if j >= half - 1:
                    right -= rho * self.largest * half * b[j - half + 1]
                if j == 0:
                    right -= 1j * k * push
                a.append(right / (diffusion * (j + 1) ** 2))
            return mp.fsum(a), mp.fsum(b)
        free, forced = series(1, 0), series(0, 1)
        at_wall = self.largest * half * self.distensibility if moving else mp.mpf(0)
        factor = (at_wall - forced[0]) / free[0]
        return factor * free[1] + forced[1] - 1j * omega * self.distensibility

    def wave_number(self, frequency, with_stream, moving):
        omega = 2 * mp.pi * frequency
        z = mp.mpc(0, 1) ** mp.mpf("1.5") * self.radius * mp.sqrt(omega * self.density / self.viscosity)
        slowed = mp.sqrt(1 / (1 - 2 * mp.besselj(1, z) / (z * mp.besselj(0, z))))
        start = omega / self.long_wave_speed(with_stream, moving) * slowed
        return mp.findroot(lambda k: self.excess(omega, k, moving) / self.distensibility, (start, start * 1.001),
                           solver="secant", tol=1e-25)


def text(value, digits=13):
    return mp.nstr(value, digits)


if __name__ == "__main__":
    print("long waves without viscosity [m/s]: with and against the stream on a mesh that stays, the same on a moving wall")
    for name, tube in {
        "plug": Tube(0.01, 1000, 0, "4e-5", 0, 0.5, 0),
        "plug, compressible": Tube(0.01, 1000, 0, "4e-5", "1e-5", 0.5, 0),
        "plug in a rigid tube": Tube(0.01, 1000, 0, 0, "1e-7", 10, 0),
        "Poiseuille": Tube(0.01, 1000, 0, "4e-5", 0, 0.5, 2),
        "exponent 7": Tube(0.01, 1000, 0, "4e-5", "1e-5", 0.5, 7),
    }.items():
        print(f"  {name:22}", *(text(tube.long_wave_speed(*which)) for which in
                                ((True, False), (False, False), (True, True), (False, True))))
    print("wave numbers of viscous liquids [1/m], in the same order")
    for name, tube, frequency in (
        ("no stream, 10 Hz", Tube(0.01, 1000, "4e-3", "4e-5", 0, 0, 2), 10),
        ("Poiseuille, 10 Hz", Tube(0.01, 1000, "4e-3", "4e-5", 0, "0.25", 2), 10),
        ("exponent 8, 1 Hz", Tube(0.01, 1000, "4e-3", "4e-5", "1e-5", "0.5", 8), 1),
        ("viscoelastic, 30 Hz", Tube(0.01, 1000, "1e-3", mp.mpc("4e-5", "-4e-6"), 0, "0.5", 2), 30),
    ):
        print(f"  {name:20}", *(text(tube.wave_number(frequency, *which)) for which in
                              ((True, False), (False, False), (True, True), (False, True))))
    print("water and glycerine: speed with less that against the stream [m/s], on a mesh that stays and on a moving wall")
    tube = Tube("0.01", 1100, "4e-3", 1 / mp.mpf(1100 * 25), 0, "0.25", 2)
    for frequency in (2, 4, 8, 16):
        print(f"  {frequency:2} Hz", *(text(sum(2 * mp.pi * frequency / mp.re(tube.wave_number(frequency, with_stream, moving))
                                            for with_stream in (True, False)), 5) for moving in (False, True)))
