#!/usr/bin/python3
"""Errors with which Taylor-Hood elements interpolate a manufactured solution, as a measure for the errors of a run.

    scripts/references/manufactured/interpolation_errors.py NAME CELLS [DEGREE]

Prints the L2 errors, relative to the norm of the exact field, of velocity and displacement (the same), pressure and
stress at t = 1 s on the unit square or cube with CELLS equal cells along each edge: velocity and displacement are
interpolated at the nodes of degree k = DEGREE (default 2), the pressure with degree k - 1, and the stress is that of the
interpolants. NAME is one of manufactured_solution.py's. Needs python3-sympy and python3-numpy.
"""

import itertools
import sys

import numpy
import sympy

import manufactured_solution as solution


def lagrange(nodes, points):
    """Values and derivatives of the Lagrange polynomials, [polynomial, point]."""
    values, derivatives = [], []
    for i in range(len(nodes)):
        others = [node for j, node in enumerate(nodes) if j != i]
        polynomial = numpy.poly1d(others, r=True) / numpy.prod([nodes[i] - node for node in others])
        values.append(polynomial(points))
        derivatives.append(polynomial.deriv()(points))
    return numpy.array(values), numpy.array(derivatives)


def product(tables):
    """Tensor product of one table for each direction, [polynomial, point]."""
    result = tables[0]
    for table in tables[1:]:
        result = numpy.einsum("ip,jq->ijpq", result, table).reshape(result.shape[0] * table.shape[0], -1)
    return result


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    name, cells = sys.argv[1], int(sys.argv[2])
    degree = int(sys.argv[3]) if len(sys.argv) == 4 else 2
    model, material, shape, amplitude, given_pressure = solution.CASES[name]
    dim = len(shape)
    t = solution.t
    displacement = [component * amplitude for component in shape]
    velocity = [sympy.diff(component, t) for component in displacement]
    pressure = given_pressure
    if material["K"] is not None:
        pressure = -material["K"] * solution.gradient(displacement, model).trace()
    mixture = [material["eta"] * u + material["mu"] * d for u, d in zip(velocity, displacement)]

    symbols = (solution.x, solution.y, solution.z)[:dim]
    functions = {}
    for key, expressions in (("mixture", mixture), ("velocity", velocity), ("pressure", [pressure])):
        exact = [sympy.sympify(e).subs(t, 1) for e in expressions]
        derivatives = [sympy.diff(e, s) for e in exact for s in symbols]
        functions[key] = sympy.lambdify(symbols, exact, "numpy"), sympy.lambdify(symbols, derivatives, "numpy")

    def evaluate(function, where):
        return numpy.array([numpy.broadcast_to(f, where[0].shape) for f in function(*where)])

    gauss, weights = numpy.polynomial.legendre.leggauss(degree + 3)
    gauss, weights = (gauss + 1) / 2, weights / 2
    size = 1. / cells

    def cell_tables(k):
        values, derivatives = lagrange(numpy.linspace(0, 1, k + 1), gauss)
        gradients = [product([derivatives if d == e else values for e in range(dim)]) / size for d in range(dim)]
        nodes = numpy.array(list(itertools.product(numpy.linspace(0, 1, k + 1), repeat=dim))).T
        return nodes, product([values] * dim), gradients

    vector_nodes, vector_values, vector_gradients = cell_tables(degree)
    scalar_nodes, scalar_values, _ = cell_tables(degree - 1)
    points = numpy.array(list(itertools.product(gauss, repeat=dim))).T
    point_weights = numpy.prod(list(itertools.product(weights, repeat=dim)), axis=1)

    def stress(values, gradients, p, radius):
        """xx, yy, zz, xy [, xz, yz] from the mixture's values and gradients [component][direction]."""
        diagonal = [gradients[i][i] if i < dim else 0. * p for i in range(3)]
        if model == "axisymmetric":
            diagonal[2] = values[1] / radius
        mean = sum(diagonal) / 3
        normal = [2 * (d - mean) - p for d in diagonal]
        if model == "plane stress":
            normal[2] = 0. * p
        pairs = [(0, 1)] if dim == 2 else [(0, 1), (0, 2), (1, 2)]
        return numpy.array(normal + [gradients[i][j] + gradients[j][i] for i, j in pairs])

    errors, norms = {}, {}

    def add(key, approximate, exact, measure):
        errors[key] = errors.get(key, 0.) + numpy.sum((approximate - exact)**2 * measure)
        norms[key] = norms.get(key, 0.) + numpy.sum(exact**2 * measure)

    for cell in itertools.product(range(cells), repeat=dim):
        corner = numpy.array(cell)[:, None]
        x = (corner + points) * size
        at_vector_nodes, at_scalar_nodes = (corner + vector_nodes) * size, (corner + scalar_nodes) * size
        measure = point_weights * (x[1] if model == "axisymmetric" else 1.)
        p, p_exact = (evaluate(functions["pressure"][0], at_scalar_nodes) @ scalar_values)[0], \
            evaluate(functions["pressure"][0], x)[0]
        add("pressure", p, p_exact, measure)
        add("velocity and displacement", evaluate(functions["velocity"][0], at_vector_nodes) @ vector_values,
            evaluate(functions["velocity"][0], x), measure)
        nodal = evaluate(functions["mixture"][0], at_vector_nodes)
        gradients = [[nodal[i] @ vector_gradients[j] for j in range(dim)] for i in range(dim)]
        exact_gradients = evaluate(functions["mixture"][1], x).reshape(dim, dim, -1)
        add("stress", stress(nodal @ vector_values, gradients, p, x[1]),
            stress(evaluate(functions["mixture"][0], x), exact_gradients, p_exact, x[1]), measure)
    for key in errors:
        print(f"{key}: {numpy.sqrt(errors[key] / norms[key]):.3e}")


if __name__ == "__main__":
    main()
