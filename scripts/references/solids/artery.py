#!/usr/bin/python3
"""Inflation of an artery of two layers with an axial prestretch and an opening angle: the numbers of the files artery-*.prm,
unloaded-shape-artery.prm and loaded-artery.prm.

    scripts/references/solids/artery.py

Each layer is incompressible, with the law of Holzapfel, Gasser and Ogden. The opened ring has the radii R and the sector 2 pi - alpha,
k = 2 pi/(2 pi - alpha). With the axial stretch z the closed and inflated tube has, from the inner radius a,

    r^2 = a^2 + (R^2 - A^2)/(k z),   stretches k r/R around, z along, R/(k z r) across the wall,

and the pressure is the integral of (sigma_around - sigma_across)/r over the wall. Simpson's rule; the radius by bisection. No finite
elements are in it.
"""

import math

# Of a rabbit's carotid artery: shear modulus, k1 [Pa], k2 [1], angle of the fibres from the circumference, thickness [m]
# (G. A. Holzapfel, T. C. Gasser, R. W. Ogden, J. Elasticity 61 (2000) 1).
MEDIA = (3000.0, 2363.2, 0.8393, math.radians(29), 0.26e-3)
ADVENTITIA = (300.0, 562.0, 0.7112, math.radians(62), 0.13e-3)
DENSITY = 1060.0  # of the liquid, in the speed of waves [kg/m^3]


def differences(layer, across, around, along):
    """The stresses around and along less the one across [Pa]."""
    modulus, k1, k2, angle, _ = layer
    of_around, of_along = modulus * (around**2 - across**2), modulus * (along**2 - across**2)
    strain = (around * math.cos(angle)) ** 2 + (along * math.sin(angle)) ** 2 - 1
    if strain > 0:
        fibres = 2 * 2 * k1 * strain * math.exp(k2 * strain**2)  # two families
        of_around += fibres * (around * math.cos(angle)) ** 2
        of_along += fibres * (along * math.sin(angle)) ** 2
    return of_around, of_along


def inflate(layers, inner, opening_angle, along, a, n_intervals=400):
    """Pressure [Pa], outer radius [m], axial force of the wall [N], and the stress around at the inner face [Pa], for the radius a."""
    k = 2 * math.pi / (2 * math.pi - opening_angle)
    radius = lambda rest: math.sqrt(a * a + (rest * rest - inner * inner) / (k * along))
    pressure, parts, rest = 0.0, [], inner
    for layer in layers:
        r0, r1 = radius(rest), radius(rest + layer[4])
        h = (r1 - r0) / n_intervals
        for i in range(n_intervals):
            nodes = []
            for r in (r0 + i * h, r0 + (i + 0.5) * h, r0 + (i + 1) * h):
                at_rest = math.sqrt(inner * inner + k * along * (r * r - a * a))
                around = k * r / at_rest
                nodes.append((r, *differences(layer, 1 / (around * along), around, along)))
            of_part = h / 6 * sum(w * n[1] / n[0] for w, n in zip((1, 4, 1), nodes))
            parts.append((h, nodes, pressure, of_part))
            pressure += of_part
        rest += layer[4]
    force = 0.0
    for h, nodes, before, of_part in parts:
        # The stress across is -p plus the integral up to r, within an interval that is short enough for a line.
        across = (before - pressure, before + of_part / 2 - pressure, before + of_part - pressure)
        force += h / 6 * sum(w * 2 * math.pi * n[0] * (s + n[2]) for w, n, s in zip((1, 4, 1), nodes, across))
    return pressure, radius(rest), force, parts[0][1][0][1] - pressure


def radius_at(pressure, *case):
    low, high = 0.3 * case[1], 2 * case[1]
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if inflate(*case, middle)[0] < pressure else (low, middle)
    return middle


def distensibility(a, *case):
    """dA/dp over A [1/Pa] of the section inside, by a difference quotient; a long wave of a liquid of density rho has the speed 1/sqrt(rho D).
    Many intervals, since fibres that begin to bear somewhere in the wall make a bend in the stress."""
    h, n = 1e-5 * a, 20000
    return 4 * h / a / (inflate(*case, a + h, n)[0] - inflate(*case, a - h, n)[0])


def image(pressure, inner, along, share):
    """The closed ring whose layers meet under the pressure at this share of the wall: the thickness of its adventitia, and what inflate() gives."""
    low, high = 0.05e-3, 0.5e-3
    for _ in range(32):
        thickness = 0.5 * (low + high)
        layers = [MEDIA, ADVENTITIA[:4] + (thickness,)]
        a = radius_at(pressure, layers, inner, 0.0, along)
        b = inflate(layers, inner, 0.0, along, a)[1]
        meet = math.sqrt(a * a + ((inner + MEDIA[4]) ** 2 - inner**2) / along)
        low, high = (thickness, high) if (meet - a) / (b - a) > share else (low, thickness)
    return thickness, a, inflate(layers, inner, 0.0, along, a)


if __name__ == "__main__":
    for name, inner, degrees, along in (("closed ring", 0.71e-3, 0, 1.7), ("opened ring", 1.43e-3, 160, 1.7)):
        case = ([MEDIA, ADVENTITIA], inner, math.radians(degrees), along)
        for pressure in (0.0, 5e3, 13.33e3, 21.33e3):
            a = radius_at(pressure, *case)
            _, b, force, around = inflate(*case, a)
            d = distensibility(a, *case)
            print(f"{name}, opening angle {degrees} deg, axial stretch {along}: at {pressure:g} Pa the inner radius is {a * 1e3:.7f} mm, the outer "
                  f"one {b * 1e3:.7f} mm, the axial force {force:.7f} N, the stress around inside {around:.2f} Pa, the distensibility {d:.6e} 1/Pa, "
                  f"the speed of long waves of a liquid of {DENSITY:g} kg/m^3 {1 / math.sqrt(DENSITY * d):.6f} m/s")
    thickness, a, (_, b, force, around) = image(13.33e3, 0.71e-3, 1.7, 0.625)
    print(f"image of a closed ring, axial stretch 1.7, whose layers meet at 5/8 of the wall under 13330 Pa: the adventitia is {thickness * 1e3:.7f} mm thick "
          f"at rest, the inner radius is {a * 1e3:.7f} mm, the outer one {b * 1e3:.7f} mm, the axial force {force:.7f} N, the stress around inside {around:.2f} Pa")
