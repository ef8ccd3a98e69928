#!/usr/bin/python3
"""The wave of an elastic layer over a fluid: reference of parameter_files/verification/elastic-layer-over-fluid.prm.

    scripts/references/interaction/layer_over_fluid.py [--expressions]

Prints frequency and decay of the standing wave cos(k x) exp(i omega t), k = pi/L, of a fluid of depth H on a rigid bottom
under an elastic layer of thickness h with a free surface, in plane strain; with --expressions also its fields, as the
parameter file has them.

Both are one linear continuum: with G = mu in the solid and G = i omega eta in the fluid, and p = -K div D,

    -rho omega^2 D = (K + G/3) grad div D + G lap D.

The potentials D_x = phi_x + psi_y, D_y = phi_y - psi_x, with phi = f(y) cos(k x) and psi = g(y) sin(k x), give
f'' = a^2 f with a^2 = k^2 - rho omega^2/(K + 4G/3) and g'' = b^2 g with b^2 = k^2 - rho omega^2/G, and

    D_x = (-k f + g') sin(k x),                         D_y = (f' - k g) cos(k x),
    sigma_yy = ((K - 2G/3)(a^2 - k^2) f + 2G (a^2 f - k g')) cos(k x),
    sigma_xy = G (-2 k f' + (b^2 + k^2) g) sin(k x),    p = -K (a^2 - k^2) f cos(k x).

Four exponentials in each layer; no motion at the bottom, displacement and traction continuous at y = H, no traction at
y = H + h: a determinant of order 8, whose root omega is found by the secant method. Needs python3-numpy.
"""

import sys

import numpy

LENGTH, DEPTH, THICKNESS = 50e-3, 20e-3, 5e-3
FLUID = {"rho": 1000., "eta": 0.1, "mu": 0., "K": 1e6, "from": 0., "to": DEPTH}
YOUNG, POISSON = 1e6, 0.45
LAYER = {"rho": 1100., "eta": 0., "mu": YOUNG / (2 * (1 + POISSON)), "K": YOUNG / (3 * (1 - 2 * POISSON)),
         "from": DEPTH, "to": DEPTH + THICKNESS}
K = numpy.pi / LENGTH


def exponents(material, omega):
    shear = material["mu"] + 1j * omega * material["eta"]
    a = numpy.sqrt(K**2 - material["rho"] * omega**2 / (material["K"] + 4 * shear / 3) + 0j)
    b = numpy.sqrt(K**2 - material["rho"] * omega**2 / shear + 0j)
    return shear, a, b


def amplitudes(material, omega):
    """(exponent, its origin, [D_x, D_y, sigma_yy, sigma_xy, p]) of the four waves; each is at most 1 in its layer."""
    shear, a, b = exponents(material, omega)
    bulk = material["K"]
    waves = []
    for exponent, origin in ((a, material["to"]), (-a, material["from"])):
        waves.append((exponent, origin, numpy.array([
            -K, exponent, (bulk - 2 * shear / 3) * (a**2 - K**2) + 2 * shear * a**2, -2 * shear * K * exponent,
            -bulk * (a**2 - K**2)])))
    for exponent, origin in ((b, material["to"]), (-b, material["from"])):
        waves.append((exponent, origin, numpy.array([
            exponent, -K, -2 * shear * K * exponent, shear * (b**2 + K**2), 0.])))
    return waves


def at(material, omega, y):
    """5 x 4: what the four waves are at y."""
    return numpy.array([numpy.exp(exponent * (y - origin)) * values
                        for exponent, origin, values in amplitudes(material, omega)]).T


def conditions(omega):
    """The 8 x 8 matrix, its rows and columns brought to the same size."""
    scale = numpy.array([K, K, LAYER["mu"] * K**2, LAYER["mu"] * K**2, 1.])[:, None]
    bottom, below = at(FLUID, omega, 0.) / scale, at(FLUID, omega, DEPTH) / scale
    above, top = at(LAYER, omega, DEPTH) / scale, at(LAYER, omega, DEPTH + THICKNESS) / scale
    none = numpy.zeros((2, 4))
    matrix = numpy.block([[bottom[:2], none], [below[:4], -above[:4]], [none, top[2:4]]])
    sizes = numpy.abs(matrix).max(axis=0)
    return matrix / sizes, sizes


def thin_plate():
    """A plate without longitudinal motion over an incompressible fluid without viscosity: where to look for the root."""
    bending = YOUNG * THICKNESS**3 / (12 * (1 - POISSON**2))
    mass = LAYER["rho"] * THICKNESS + FLUID["rho"] / (K * numpy.tanh(K * DEPTH))
    return numpy.sqrt(bending * K**4 / mass)


def root():
    before, omega = thin_plate() * 0.9, thin_plate() * (0.85 + 0.05j)
    value_before = numpy.linalg.det(conditions(before)[0])
    for _ in range(100):
        value = numpy.linalg.det(conditions(omega)[0])
        step = value * (omega - before) / (value - value_before)
        before, value_before, omega = omega, value, omega - step
        if abs(step) < 1e-13 * abs(omega):
            return omega
    sys.exit("the root was not found")


def mode(omega):
    """Coefficients of the eight waves, so that D_y is 1 mm at x = 0 on the top."""
    matrix, sizes = conditions(omega)
    coefficients = numpy.linalg.svd(matrix)[2][-1].conj() / sizes
    return coefficients * 1e-3 / (at(LAYER, omega, DEPTH + THICKNESS)[1] @ coefficients[4:])


def real_part(terms, omega, with_time):
    """The real part of sum c exp(kappa (y - y0) + i omega t) as text."""
    text = []
    for kappa, origin, c in terms:
        if c == 0:
            continue
        shift = f"(y-{origin:g})" if origin else "y"
        growth, phase = f"{kappa.real:.12g}*{shift}", f"{kappa.imag:.12g}*{shift}{numpy.angle(c):+.12g}"
        if with_time:
            growth += f"-{omega.imag:.12g}*t"
            phase += f"{omega.real:+.12g}*t"
        text.append(f"{abs(c):.12g}*exp({growth})*cos({phase})")
    return "(" + " + \\\n      ".join(text) + ")"


def field(omega, coefficients, component, factor, region, with_time):
    waves = amplitudes(region, omega)
    own = coefficients[:4] if region is FLUID else coefficients[4:]
    terms = [(exponent, origin, factor * c * values[component])
             for (exponent, origin, values), c in zip(waves, own)]
    along = f"sin(pi*x/{LENGTH:g})" if component in (0, 3) else f"cos(pi*x/{LENGTH:g})"
    return f"{along}*{real_part(terms, omega, with_time)}"


def print_expressions(omega, with_time):
    coefficients = mode(omega)

    def both(component, factor):
        fluid, layer = (field(omega, coefficients, component, factor, region, with_time) for region in (FLUID, LAYER))
        return f"if(y < {DEPTH:g}, \\\n      {fluid}, \\\n      {layer})"

    print("  set Velocity = " + both(0, 1j * omega) + ", \\\n    " + both(1, 1j * omega))
    print("  set Displacement = " + both(0, 1.) + ", \\\n    " + both(1, 1.))
    if with_time:
        print("  set Pressure = " + both(4, 1.))
    else:
        print("  subsection Pressures")
        for name, region in (("fluid", FLUID), ("wall", LAYER)):
            print(f"    set {name} = " + field(omega, coefficients, 4, 1., region, False))
        print("  end")


def main():
    if sys.argv[1:] not in ([], ["--expressions"]):
        sys.exit(__doc__)
    omega = root()
    matrix = conditions(omega)[0]
    singular = numpy.linalg.svd(matrix)[1]
    print(f"frequency             {omega.real / (2 * numpy.pi):.6f} Hz")
    print(f"decay per oscillation {numpy.exp(-2 * numpy.pi * omega.imag / omega.real):.6f}")
    print(f"thin plate, no viscosity {thin_plate() / (2 * numpy.pi):.4f} Hz; smallest singular value "
          f"{singular[-1]:.1e}, next {singular[-2]:.1e}")
    if sys.argv[1:]:
        print("subsection Initial state")
        print_expressions(omega, False)
        print("end\nsubsection Exact solution")
        print_expressions(omega, True)
        print("end")


if __name__ == "__main__":
    main()
