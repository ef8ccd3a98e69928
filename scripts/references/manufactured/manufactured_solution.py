#!/usr/bin/python3
"""Derives the manufactured solutions of parameter_files/verification and tests/convergence.

    scripts/references/manufactured/manufactured_solution.py [NAME...]

Without a NAME: the names. For each name it prints, ready for a parameter file, the entries of Body force, of Exact
solution, of the boundaries with a given traction, and of Initial state. The displacement D(x, t) is chosen; then

    U = dD/dt,    p = -K div D  (chosen where K is infinite),
    s = 2 eta dev(sym grad U) + 2 mu dev(sym grad D),    sigma = s - p I,
    rho b = rho dU/dt - div sigma,

with the three-dimensional deviator and, in axisymmetry (x axial, y radial), the hoop strain D_y/y; in plane stress p is
-(sigma_xx + sigma_yy)/3 in the end. The steady-gas cases have convection and a density rho = rho0 (1 + p/K): the mass flux m, which
has no divergence and stays inside the body, and the specific volume v are chosen; then

    U = m v,    p = K (1/(rho0 v) - 1),    rho b = m.grad U - div (2 eta dev(sym grad U) - p I).

The stream cases have convection, and no divergence: U and p are chosen; then

    rho b = rho dU/dt + rho U.grad U - div (2 eta sym grad U - p I).

Needs python3-sympy;
the constants are those of the parameter files and stay exact fractions up to the printed text.
"""

import sys

import sympy
from sympy import Rational, cos, sin

x, y, z, t = sympy.symbols("x y z t", real=True)

# Young's modulus 2600 Pa and Poisson's ratio 0.3: mu = 1000 Pa, K = 6500/3 Pa.
SOLID = {"rho": 1000, "eta": 0, "mu": 1000, "K": Rational(6500, 3)}
# The same in plane stress, where lambda = Y nu/((1 + nu)(1 - nu)) and K = lambda + 2 mu/3 in a form without eps_zz.
SHEET = {"rho": 1000, "eta": 0, "mu": 1000, "K": Rational(32000, 21)}
INCOMPRESSIBLE = {"rho": 1000, "eta": 0, "mu": 1000, "K": None}
FLUID = {"rho": 1000, "eta": 100, "mu": 0, "K": 1000}
INCOMPRESSIBLE_FLUID = {"rho": 1000, "eta": 100, "mu": 0, "K": None}
VISCOUS = {"rho": 1000, "eta": 100, "mu": 1000, "K": Rational(6500, 3)}

# Accelerated evenly from rest: exact in time for backward Euler with the trapezoidal update.
EVEN = t**2 / 2
# Moving at the start, and with all derivatives.
WAVE = sin(2 * t + 1)
MM = Rational(1, 100)

PLANE_SHAPE = [MM * sin(2 * x + y), MM * cos(x - 2 * y)]
SHEAR_WAVES = [MM * (2 * cos(x + 2 * y) + sin(2 * x - y)), MM * (-cos(x + 2 * y) + 2 * sin(2 * x - y))]
SPACE_SHAPE = [MM * sin(2 * x + y), MM * cos(y - z), MM * sin(x + 2 * z)]
AXIAL_SHAPE = [MM * sin(2 * x + y**2), MM * y * cos(x + y**2)]
# In the velocity's space with a divergence in the pressure's, on any mesh of straight cells: no error in space.
QUADRATIC = [MM * (x**2 + x * y), MM * (y**2 - 2 * x * y + x)]
QUADRATIC_SPACE = [MM * (x**2 + x * y), MM * (y**2 - y * z), MM * (x * z + z**2 + x)]
QUADRATIC_AXIAL = [MM * (x**2 + y**2), MM * y * (1 + x)]
QUADRATIC_SOLENOIDAL = [MM * (x**2 - 2 * x * y), MM * (y**2 - 2 * x * y + x)]

# A gas that circulates in a box of 1 m, at Mach numbers up to 0.2 to 0.6: rho0 = 2 kg/m^3, K = 10 Pa.
GAS = {"rho": 2, "eta": Rational(1, 2), "K": 10}
FLUX = Rational(2, 5)
SINES = [sin(sympy.pi * c) for c in (x, y, z)]
COSINES = [cos(sympy.pi * c) for c in (x, y, z)]
# name -> model, mass flux, rho0 times the specific volume
GASES = {
    "steady-gas-plane-strain": ("plane", [FLUX * sympy.pi * SINES[0] * COSINES[1], -FLUX * sympy.pi * COSINES[0] * SINES[1]],
                                1 + (COSINES[0] + COSINES[1]) / 20),
    "steady-gas-axisymmetric": ("axisymmetric", [FLUX * (2 - 4 * y**2) * SINES[0], -FLUX * sympy.pi * y * (1 - y**2) * COSINES[0]],
                                1 + (COSINES[0] + y**2) / 20),
    "steady-gas-3d": ("space", [FLUX * sympy.pi * SINES[i] * (COSINES[(i + 1) % 3] - COSINES[(i + 2) % 3]) for i in range(3)],
                      1 + (COSINES[0] + COSINES[1]) / 20),
}

# A liquid with convection in a box of 1 m, some m/s fast.
STREAM = {"rho": 1, "eta": Rational(1, 50)}
# name -> model, velocity, which has the space of the elements, pressure
STREAMS = {
    "time-stream": ("plane", [WAVE * (y**2 + x), WAVE * (x**2 - y)], cos(3 * t) * (x + 2 * y)),
    "time-stream-axisymmetric": ("axisymmetric", [WAVE * (y**2 + x), -WAVE * y / 2], cos(3 * t) * (x + 2 * y)),
    "time-stream-linear": ("plane", [(1 + t) * (y**2 + x), (1 + t) * (x**2 - y)], (1 + t) * (x + 2 * y)),
    "time-stream-3d": ("space", [WAVE * (y**2 + x), WAVE * (z**2 - y), WAVE * x**2], cos(3 * t) * (x + 2 * y - z)),
}

# name -> model, material, displacement, pressure where the material is incompressible
CASES = {
    "plane-strain": ("plane", SOLID, PLANE_SHAPE, EVEN, None),
    "axisymmetric": ("axisymmetric", SOLID, AXIAL_SHAPE, EVEN, None),
    "3d": ("space", SOLID, SPACE_SHAPE, EVEN, None),
    "incompressible": ("plane", INCOMPRESSIBLE, SHEAR_WAVES, EVEN, 10 * t * cos(x - y)),
    "fluid": ("plane", FLUID, PLANE_SHAPE, EVEN, None),
    "plane-stress": ("plane stress", SHEET, PLANE_SHAPE, EVEN, None),
    "patch-plane-strain": ("plane", VISCOUS, QUADRATIC, EVEN, None),
    "patch-plane-stress": ("plane stress", SHEET, QUADRATIC, EVEN, None),
    "patch-axisymmetric": ("axisymmetric", SOLID, QUADRATIC_AXIAL, EVEN, None),
    "patch-3d": ("space", SOLID, QUADRATIC_SPACE, EVEN, None),
    "patch-incompressible": ("plane", INCOMPRESSIBLE, QUADRATIC_SOLENOIDAL, EVEN, 10 * t * (1 + x - 2 * y)),
    "patch-fluid": ("plane", FLUID, QUADRATIC, EVEN, None),
    "patch-fluid-axisymmetric": ("axisymmetric", FLUID, QUADRATIC_AXIAL, EVEN, None),
    "patch-fluid-incompressible": ("plane", INCOMPRESSIBLE_FLUID, QUADRATIC_SOLENOIDAL, EVEN, 10 * t * (1 + x - 2 * y)),
    "time-plane-strain": ("plane", SOLID, QUADRATIC, WAVE, None),
    "time-viscous": ("plane", VISCOUS, QUADRATIC, WAVE, None),
    "time-axisymmetric": ("axisymmetric", SOLID, QUADRATIC_AXIAL, WAVE, None),
    "time-plane-stress": ("plane stress", SHEET, QUADRATIC, WAVE, None),
    "time-3d": ("space", SOLID, QUADRATIC_SPACE, WAVE, None),
    "time-incompressible": ("plane", INCOMPRESSIBLE, QUADRATIC_SOLENOIDAL, WAVE, 10 * WAVE * (1 + x - 2 * y)),
    "time-fluid": ("plane", FLUID, QUADRATIC, WAVE, None),
}
OUTWARD = {"left": (0, -1), "right": (0, 1), "bottom": (1, -1), "top": (1, 1), "back": (2, -1), "front": (2, 1)}


def gradient(vector, model):
    """The 3 x 3 gradient; in axisymmetry the hoop strain is its last entry."""
    components = list(vector) + [0] * (3 - len(vector))
    result = sympy.Matrix(3, 3, lambda i, j: sympy.diff(components[i], (x, y, z)[j]))
    if model == "axisymmetric":
        result[2, 2] = components[1] / y
    return result


def deviator(matrix):
    symmetric = (matrix + matrix.T) / 2
    return symmetric - symmetric.trace() / 3 * sympy.eye(3)


def divergence(stress, model):
    result = [sum(sympy.diff(stress[i, j], (x, y, z)[j]) for j in range(3)) for i in range(3)]
    if model == "axisymmetric":
        result[0] += stress[0, 1] / y
        result[1] += (stress[1, 1] - stress[2, 2]) / y
    return result


def simple(expression):
    """Sorted by the sines and cosines, without a factor 1/y that cancels."""
    expanded = sympy.expand(sympy.expand(sympy.sympify(expression)))
    functions = sorted(expanded.atoms(sin, cos), key=str)
    return sympy.collect(expanded, functions, sympy.factor) if functions else sympy.expand(expanded)


def text(expression, at_time=None):
    expression = sympy.sympify(expression)
    if at_time is not None:
        expression = expression.subs(t, at_time)
    return str(simple(expression)).replace("**", "^")


def entry(key, expressions, at_time=None):
    separator = ", \\\n      "
    print(f"  set {key} = " + separator.join(text(e, at_time) for e in expressions))


def print_tractions(stress, dim):
    print("end\n# Tractions sigma.n by the direction of the normal (the sign is that of the outward normal)")
    for boundary, (direction, sign) in OUTWARD.items():
        if direction < dim:
            print(f"# {boundary}")
            entry("Traction", [sign * stress[i, direction] for i in range(dim)])


def derive(name):
    model, material, shape, amplitude, given_pressure = CASES[name]
    dim = len(shape)
    displacement = [component * amplitude for component in shape]
    velocity = [sympy.diff(component, t) for component in displacement]
    dilatation = sympy.simplify(gradient(displacement, model).trace())
    if material["K"] is None:
        assert dilatation == 0, "an incompressible material needs a displacement without divergence"
        pressure = given_pressure
    else:
        pressure = -material["K"] * dilatation
    stress = (2 * material["eta"] * deviator(gradient(velocity, model))
              + 2 * material["mu"] * deviator(gradient(displacement, model)) - pressure * sympy.eye(3))
    force = [material["rho"] * sympy.diff(velocity[i], t) - divergence(stress, model)[i] for i in range(dim)]
    if model == "plane stress":
        stress[2, 2] = 0
        pressure = -stress.trace() / 3
    components = [stress[0, 0], stress[1, 1], stress[2, 2], stress[0, 1]]
    if dim == 3:
        components += [stress[0, 2], stress[1, 2]]

    print(f"# {name}\nsubsection Body force")
    entry("Force density", force)
    print("end\nsubsection Exact solution")
    entry("Velocity", velocity)
    entry("Displacement", displacement)
    entry("Pressure", [pressure])
    entry("Stress", components)
    print("end\nsubsection Initial state")
    entry("Velocity", velocity, 0)
    entry("Displacement", displacement, 0)
    entry("Pressure", [pressure], 0)
    print_tractions(stress, dim)


def derive_stream(name):
    model, velocity, pressure = STREAMS[name]
    dim = len(velocity)
    slope = gradient(velocity, model)
    assert sympy.simplify(slope.trace()) == 0, "the velocity needs to have no divergence"
    stress = 2 * STREAM["eta"] * deviator(slope) - pressure * sympy.eye(3)
    resistance = divergence(stress, model)
    force = [STREAM["rho"] * (sympy.diff(velocity[i], t) + sum(velocity[j] * sympy.diff(velocity[i], (x, y, z)[j]) for j in range(dim)))
             - resistance[i] for i in range(dim)]
    print(f"# {name}\nsubsection Body force")
    entry("Force density", force)
    print("end\nsubsection Exact solution")
    entry("Velocity", velocity)
    entry("Pressure", [pressure])
    print("end\nsubsection Initial state")
    entry("Velocity", velocity, 0)
    entry("Pressure", [pressure], 0)
    print_tractions(stress, dim)


def derive_gas(name):
    model, flux, volume = GASES[name]
    dim = len(flux)
    spread = gradient(flux, model).trace()
    assert sympy.simplify(spread) == 0, "the mass flux needs to have no divergence"
    velocity = [component * volume / GAS["rho"] for component in flux]
    pressure = GAS["K"] * (1 / volume - 1)
    viscous = 2 * GAS["eta"] * deviator(gradient(velocity, model))
    slope = [sympy.diff(pressure, c) for c in (x, y, z)]
    resistance = divergence(viscous, model)
    force = [sum(flux[j] * sympy.diff(velocity[i], (x, y, z)[j]) for j in range(dim)) - resistance[i] for i in range(dim)]

    def entry_with_pressure(key, parts, pressures):
        # The pressure is a quotient: it stays as it is, beside the sorted polynomial of sines and cosines.
        sums = [[text(part)] * (part != 0) + [str(p).replace("**", "^")] * (p != 0) for part, p in zip(parts, pressures)]
        texts = [" + ".join(terms).replace("+ -", "- ") for terms in sums]
        print(f"  set {key} = " + ", \\\n      ".join(texts))

    print(f"# {name}\nsubsection Body force")
    entry_with_pressure("Force density", force, slope[:dim])
    print("end\nsubsection Exact solution")
    entry("Velocity", velocity)
    entry_with_pressure("Pressure", [0], [pressure])
    print("end\n# Tractions sigma.n by the direction of the normal (the sign is that of the outward normal)")
    for boundary, (direction, sign) in OUTWARD.items():
        if direction < dim:
            print(f"# {boundary}")
            entry_with_pressure("Traction", [sign * viscous[i, direction] for i in range(dim)],
                                [-sign * pressure if i == direction else 0 for i in range(dim)])


def main():
    if len(sys.argv) == 1:
        print("\n".join([*CASES, *GASES, *STREAMS]))
    for name in sys.argv[1:]:
        if name in GASES:
            derive_gas(name)
        elif name in STREAMS:
            derive_stream(name)
        else:
            derive(name)


if __name__ == "__main__":
    main()
