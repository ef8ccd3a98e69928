#!/usr/bin/python3
"""Derives the manufactured solution of tests/convergence/common/moving-interface.prm: a liquid under an elastic wall that both move far.

    scripts/references/manufactured/moving_interface.py             sections of the parameter file
    scripts/references/manufactured/moving_interface.py --numbers   values at the end, of which the tests have theirs

The motion of the wall is chosen, X -> (x, y) with x = X + c (Y - 1)^2, y = Y + a x^2/2: two shears, so that volumes stay and the
inverse is known. The interface, undeformed Y = 1, is then the parabola y = 1 + a x^2/2. With s = y - 1 - a x^2/2 the liquid has

    U = (0, a' x^2/2) + (d/dy, -d/dx) (s^2 q/2),

which has no divergence and is the velocity of the wall at s = 0. There q is such that liquid and wall have the same shear traction,
and the pressure of the wall is that of the liquid, which is chosen, and the jump that makes the normal tractions equal. Then

    f = rho DU/Dt - div sigma,   sigma = 2 eta sym grad U - p I (liquid),   mu dev(F F^T) - p I (wall),

as functions of the present place. Acceleration b and Force density g together are rho b + g = f in both, so that no formula asks on
which side a point is: where the computed interface lies a little beside the exact one, the points between them would have the force
of the other side, and the wall would ring. The constants are those of the parameter file. Needs python3-sympy, --numbers
python3-scipy.
"""

import re
import sys

import sympy
from sympy import Rational, cos

x, y, t, X, Y, s = sympy.symbols("x y t X Y s", real=True)
DENSITY, WALL_DENSITY = 1, 2
VISCOSITY, SHEAR_MODULUS = Rational(1, 10), 1
END_TIME = Rational(4, 5)
# From rest, without a jump of the acceleration, and not exact in time for any scheme.
a = c = t**3
LIQUID_PRESSURE = t * cos(x + y)
SLOPE = a * x  # of the interface


def at_place(expression):
    """A function of the undeformed place as one of the present place."""
    at_rest = y - a * x**2 / 2
    return sympy.sympify(expression).subs({X: x - c * (at_rest - 1)**2, Y: at_rest}, simultaneous=True)


def divergence(stress):
    return [sympy.diff(stress[i, 0], x) + sympy.diff(stress[i, 1], y) for i in range(2)]


def derive():
    """Of wall and liquid: velocity, pressure beside that of the liquid, stress without the latter, force without its gradient."""
    along = X + c * (Y - 1)**2
    motion = [along, Y + a * along**2 / 2]
    gradient = sympy.Matrix(2, 2, lambda i, j: sympy.diff(motion[i], (X, Y)[j]))
    assert sympy.simplify(gradient.det()) == 1
    strain = (gradient * gradient.T).applyfunc(at_place)
    wall_stress = SHEAR_MODULUS * (strain - (strain.trace() + 1) / 3 * sympy.eye(2))

    to_interface = y - 1 - a * x**2 / 2
    q = (SHEAR_MODULUS * SLOPE / VISCOSITY - SLOPE.diff(t) * (1 - SLOPE**2)) / (1 + SLOPE**2)**2
    stream = to_interface**2 * q / 2
    velocity = [sympy.diff(stream, y), a.diff(t) * x**2 / 2 - sympy.diff(stream, x)]
    rate = sympy.Matrix(2, 2, lambda i, j: sympy.diff(velocity[i], (x, y)[j]))
    assert sympy.simplify(rate.trace()) == 0
    stress = VISCOSITY * (rate + rate.T)

    normal, tangent = sympy.Matrix([-SLOPE, 1]), sympy.Matrix([1, SLOPE])
    difference = ((wall_stress - stress) * normal).subs(y, 1 + a * x**2 / 2)
    assert sympy.simplify((tangent.T * difference)[0]) == 0, "the shear tractions differ"
    jump = sympy.simplify((normal.T * difference)[0] / (1 + SLOPE**2))
    wall_stress -= jump * sympy.eye(2)

    wall_velocity = [sympy.diff(component, t) for component in motion]
    wall_force = [WALL_DENSITY * at_place(sympy.diff(motion[i], t, 2)) - divergence(wall_stress)[i] for i in range(2)]
    force = [DENSITY * (sympy.diff(velocity[i], t) + sum(velocity[j] * rate[i, j] for j in range(2))) - divergence(stress)[i]
             for i in range(2)]
    return {"wall": (wall_velocity, jump, wall_stress, wall_force), "liquid": (velocity, 0, stress, force), "motion": motion}


def text(expression):
    """Factors of polynomials."""
    return str(sympy.factor(sympy.simplify(expression))).replace("**", "^")


def text_beside_interface(expression):
    """The same in powers of the distance s from the interface, and of the square of its normal."""
    square = sympy.Symbol("w")
    expression = sympy.together(sympy.simplify(sympy.sympify(expression).subs(y, s + 1 + a * x**2 / 2)))
    expression = sympy.collect(sympy.expand(expression), s, sympy.factor).subs(1 + SLOPE**2, square)
    result = str(expression)
    for name, meaning in ((s, y - 1 - a * x**2 / 2), (square, 1 + SLOPE**2)):
        result = re.sub(rf"\b{name}\b", f"({meaning})", result)
    return result.replace("**", "^")


def wrapped(entry):
    """Lines of the file, broken at blanks."""
    lines, line = [], entry
    while len(line) > 158:
        cut = line.rfind(" ", 0, 156)
        lines.append(line[:cut] + " \\")
        line = "      " + line[cut + 1:]
    print("\n".join(lines + [line]))


def two_sided(of_liquid, of_wall):
    return f"if(y < {text(1 + a * x**2 / 2)}, {text_beside_interface(of_liquid)}, {text_beside_interface(of_wall)})"


def print_sections(solution):
    velocity, _, stress, force = solution["liquid"]
    wall_velocity, jump, _, wall_force = solution["wall"]
    def print_boundary(name, key, functions):
        print(f"  subsection {name}")
        wrapped(f"    set {key} = " + ", ".join(text(function) for function in functions))
        print("  end")

    # rho b + g = f in both: the difference of the densities has the difference of the forces.
    accelerations, densities = [], []
    for coordinate, of_liquid, of_wall in zip((x, y), *([text_beside_interface(f) for f in forces] for forces in (force, wall_force))):
        difference = WALL_DENSITY - DENSITY
        accelerations.append(f"(({of_wall}) - ({of_liquid}))/{difference}")
        densities.append(f"{text(sympy.diff(LIQUID_PRESSURE, coordinate))} + ({WALL_DENSITY}*({of_liquid}) - {DENSITY}*({of_wall}))/{difference}")
    print("subsection Body force")
    wrapped("  set Acceleration = " + ", ".join(accelerations))
    wrapped("  set Force density = " + ", ".join(densities))
    print("end\nsubsection Boundaries")
    print_boundary("bottom", "Velocity", [component.subs(y, 0) for component in velocity])
    for name, sign, place in (("inlet", -1, 0), ("outlet", 1, 1)):
        traction = [sign * (stress[0, 0] - LIQUID_PRESSURE), sign * stress[0, 1]]
        print_boundary(name, "Traction", [component.subs(x, place) for component in traction])
    for name, place in (("wall inlet end", {X: 0, Y: y}), ("wall outlet end", {X: 1, Y: y}), ("top", {X: x, Y: Rational(3, 2)})):
        print_boundary(name, "Velocity", [component.subs(place, simultaneous=True) for component in wall_velocity])
    print("end\nsubsection Exact solution")
    wrapped("  set Velocity = " + ", ".join(two_sided(*sides) for sides in zip(velocity, map(at_place, wall_velocity))))
    wrapped(f"  set Pressure = {text(LIQUID_PRESSURE)} + " + two_sided(0, jump))
    print("end")


def print_numbers(solution):
    from scipy.integrate import quad

    _, _, stress, _ = solution["liquid"]
    total = stress - LIQUID_PRESSURE * sympy.eye(2)
    on_interface = (total * sympy.Matrix([-SLOPE, 1])).subs(y, 1 + a * x**2 / 2)
    for direction in range(2):
        value = quad(sympy.lambdify(x, on_interface[direction].subs(t, END_TIME)), 0, 1, epsabs=1e-14)[0]
        print(f"force on the wall {'xy'[direction]}: {-value:.12g} N/m")
    for direction, at_rest in enumerate((X, Y)):
        way = (solution["motion"][direction] - at_rest).subs({X: Rational(1, 2), Y: Rational(5, 4), t: END_TIME})
        print(f"displacement {'xy'[direction]} of the wall at (0.5, 1.25): {float(way):.12g} m")


if __name__ == "__main__":
    (print_numbers if sys.argv[1:] == ["--numbers"] else print_sections)(derive())
