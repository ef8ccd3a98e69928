#!/usr/bin/python3
"""The benchmark FSI1 of Turek and Hron by another program: a second opinion on parameter_files/verification/turek-hron-fsi1.prm.

    scripts/references/interaction/beam_in_flow.py [SIZE ...]

Prints the displacement of the tip, drag and lift for meshes of gmsh whose triangles are SIZE times those of the first one (1, 0.8, 0.6 and 0.5
unless the command line gives others; 4 minutes of one core for all of them).

FEniCS solves the steady equations at once for the velocity v of the liquid, the displacement u of beam and mesh (quadratic triangles) and the pressure p of
the liquid (linear ones), over the undeformed mesh, with F = I + Grad u and J = det F. With all test functions it finds

    liquid:  J sigma F^-T : Grad(test) + rho J (grad v v).test = 0,  J div v = 0,  sigma = -p I + eta (grad v + grad v^T)
    beam:    F S : Grad(test) = 0,  S = 2 mu E + lambda tr(E) I  (St. Venant and Kirchhoff)
    mesh:    div(k Grad u) = 0 in the liquid, k = 1/volume of the cell.

The derivative for Newton's iteration is made by FEniCS. The method has nothing in common with that of Continua but the equations: triangles,
straight sides on the cylinder, displacements as unknowns, no time. The equation of the mesh is scaled by 1e-16, so that it gives no force to the beam: with
1e-9 the displacement is wrong by 0.8 %. The beam is not symmetric in such a mesh, so that the displacement across it settles late.

Needs python3-dolfin and python3-gmsh.
"""

import math
import sys

import dolfin as d
import gmsh

LENGTH, HEIGHT, CENTRE, RADIUS = 2.5, 0.41, 0.2, 0.05
TIP, HALF_THICKNESS = 0.6, 0.01
DENSITY, VISCOSITY, MEAN_SPEED = 1000.0, 1.0, 0.2
SHEAR_MODULUS, POISSON = 0.5e6, 0.4
LIQUID, BEAM = 1, 2
SCALE_OF_MESH_EQUATION = 1e-16


def triangles(size):
    """Vertices, triangles and their regions."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    geometry, field = gmsh.model.geo, gmsh.model.mesh.field

    def point(x, y):
        return geometry.addPoint(x, y, 0)

    root = CENTRE + math.sqrt(RADIUS**2 - HALF_THICKNESS**2)
    centre = point(CENTRE, CENTRE)
    circle = [point(root, CENTRE + HALF_THICKNESS), point(CENTRE, CENTRE + RADIUS), point(CENTRE - RADIUS, CENTRE),
              point(CENTRE, CENTRE - RADIUS), point(root, CENTRE - HALF_THICKNESS), point(CENTRE + RADIUS, CENTRE)]
    arcs = [geometry.addCircleArc(circle[i], centre, circle[(i + 1) % 6]) for i in range(6)]
    tip = [point(TIP, CENTRE + HALF_THICKNESS), point(TIP, CENTRE - HALF_THICKNESS)]
    sides = [geometry.addLine(circle[0], tip[0]), geometry.addLine(tip[0], tip[1]), geometry.addLine(tip[1], circle[4])]
    corners = [point(0, 0), point(LENGTH, 0), point(LENGTH, HEIGHT), point(0, HEIGHT)]
    walls = [geometry.addLine(corners[i], corners[(i + 1) % 4]) for i in range(4)]
    liquid = geometry.addPlaneSurface([geometry.addCurveLoop(walls), geometry.addCurveLoop(arcs[:4] + [-s for s in reversed(sides)])])
    beam = geometry.addPlaneSurface([geometry.addCurveLoop(arcs[4:] + sides)])
    geometry.synchronize()

    def graded(kind, entities, smallest, nearest, farthest):
        distance = field.add("Distance")
        field.setNumbers(distance, kind, entities)
        if kind == "CurvesList":
            field.setNumber(distance, "NNodesByEdge", 400)
        threshold = field.add("Threshold")
        field.setNumber(threshold, "InField", distance)
        for key, value in (("SizeMin", smallest), ("SizeMax", 0.025), ("DistMin", nearest), ("DistMax", farthest)):
            field.setNumber(threshold, key, value * size if "Size" in key else value)
        return threshold

    least = field.add("Min")
    field.setNumbers(least, "FieldsList", [graded("CurvesList", arcs + sides, 0.004, 0.01, 0.15),
                                           graded("PointsList", tip + [circle[0], circle[4]], 0.0004, 0, 0.12),
                                           graded("CurvesList", arcs, 0.0015, 0, 0.15)])
    field.setAsBackgroundMesh(least)
    for name in ("ExtendFromBoundary", "FromPoints", "FromCurvature"):
        gmsh.option.setNumber("Mesh.MeshSize" + name, 0)
    gmsh.model.mesh.generate(2)
    result = vertices_and_cells(liquid, beam)
    gmsh.finalize()
    return result


def vertices_and_cells(liquid, beam):
    """The mesh of gmsh: places of the vertices, and for each triangle its region and vertices."""
    tags, places, _ = gmsh.model.mesh.getNodes()
    place = {tag: (places[3 * i], places[3 * i + 1]) for i, tag in enumerate(tags)}
    cells = []
    for region, surface in ((LIQUID, liquid), (BEAM, beam)):
        _, _, nodes = gmsh.model.mesh.getElements(2, surface)
        cells += [(region, nodes[0][i:i + 3]) for i in range(0, len(nodes[0]), 3)]
    used = sorted({n for _, nodes in cells for n in nodes})
    number = {tag: i for i, tag in enumerate(used)}
    return [place[tag] for tag in used], [(region, [number[n] for n in nodes]) for region, nodes in cells]


def mesh_of(vertices, cells):
    """The mesh of FEniCS with its regions."""
    mesh, editor = d.Mesh(), d.MeshEditor()
    editor.open(mesh, "triangle", 2, 2)
    editor.init_vertices(len(vertices))
    editor.init_cells(len(cells))
    for i, vertex in enumerate(vertices):
        editor.add_vertex(i, vertex)
    for i, (_, nodes) in enumerate(cells):
        editor.add_cell(i, nodes)
    editor.close(False)
    regions = d.MeshFunction("size_t", mesh, 2)
    for i, (region, _) in enumerate(cells):
        regions[i] = region
    mesh.order()
    return mesh, regions


def steady_equations(mesh, regions, density, viscosity, poisson):
    """Space, state, residual and the solid's shear modulus, which the caller sets (SI units)."""
    d.parameters["form_compiler"]["quadrature_degree"] = 6
    quadratic, linear = d.VectorElement("CG", d.triangle, 2), d.FiniteElement("CG", d.triangle, 1)
    space = d.FunctionSpace(mesh, d.MixedElement([quadratic, quadratic, linear]))
    dx = d.Measure("dx", domain=mesh, subdomain_data=regions)
    state = d.Function(space)
    (v, u, p), (test_v, test_u, test_p) = d.split(state), d.TestFunctions(space)
    identity = d.Identity(2)
    F = identity + d.grad(u)
    J, inverse = d.det(F), d.inv(F)
    gradient = d.grad(v) * inverse
    stress = -p * identity + viscosity * (gradient + gradient.T)
    strain = (F.T * F - identity) / 2
    shear = d.Constant(1)
    piola = 2 * shear * strain + 2 * shear * poisson / (1 - 2 * poisson) * d.tr(strain) * identity
    momentum = (J * d.inner(stress * inverse.T, d.grad(test_v)) + density * J * d.dot(gradient * v, test_v)) * dx(LIQUID) \
        + d.inner(F * piola, d.grad(test_v)) * dx(BEAM)
    mass = J * d.tr(gradient) * test_p * dx(LIQUID) + d.Constant(1e-12) * p * test_p * dx(BEAM)
    motion = d.Constant(SCALE_OF_MESH_EQUATION) / d.CellVolume(mesh) * d.inner(d.grad(u), d.grad(test_u)) * dx(LIQUID) \
        + 1e4 * d.dot(v, test_u) * dx(BEAM)  # the velocity of the beam is zero
    return space, state, momentum + mass + motion, shear


def on(*conditions):
    """The part of the boundary where one of the conditions holds."""
    return lambda x, boundary: boundary and any(condition(x) for condition in conditions)


def find_rest(space, state, residual, shear, moduli, fixed):
    """Newton's iteration for each of the shear moduli in turn: from a stiff solid it finds the soft one."""
    for condition in fixed:
        condition.apply(state.vector())
        condition.homogenize()
    derivative = d.derivative(residual, state)
    for modulus in moduli:
        shear.assign(modulus)
        for _ in range(15):
            matrix, right = d.assemble(derivative), d.assemble(-residual)
            for condition in fixed:
                condition.apply(matrix, right)
            change = d.Vector()
            d.solve(matrix, change, right, "mumps")
            state.vector().axpy(1, change)
            if change.norm("linf") < 1e-9:
                break
        else:
            sys.exit("Newton's iteration does not converge")


def solve(size):
    mesh, regions = mesh_of(*triangles(size))
    space, state, residual, shear = steady_equations(mesh, regions, DENSITY, VISCOSITY, POISSON)
    inlet, outlet = lambda x: d.near(x[0], 0), lambda x: d.near(x[0], LENGTH)
    walls = lambda x: d.near(x[1], 0) or d.near(x[1], HEIGHT)
    cylinder = lambda x: 0.1 < x[0] < 0.3 and 0.1 < x[1] < 0.3
    inflow = d.Expression(("6*speed*x[1]*(height - x[1])/(height*height)", "0"), speed=MEAN_SPEED, height=HEIGHT, degree=2)
    zero = d.Constant((0, 0))
    fixed = [d.DirichletBC(space.sub(0), inflow, on(inlet)), d.DirichletBC(space.sub(0), zero, on(walls, cylinder)),
             d.DirichletBC(space.sub(1), zero, on(inlet, outlet, walls, cylinder))]
    held = [list(d.DirichletBC(space.sub(0).sub(i), d.Constant(0), on(cylinder)).get_boundary_values()) for i in range(2)]
    find_rest(space, state, residual, shear, [SHEAR_MODULUS * stiffness for stiffness in (1e4, 10, 1)], fixed)
    tip = state(d.Point(TIP, CENTRE))
    force = d.assemble(residual)
    print(f"{size:5} {space.dim():9} {tip[2] * 1e3:12.7f} {tip[3] * 1e3:11.6f} {-sum(force[i] for i in held[0]):10.5f}"
          f" {-sum(force[i] for i in held[1]):10.6f}", flush=True)


def main():
    d.set_log_level(40)
    print(" size  unknowns  along [mm]  across [mm]  drag [N/m]  lift [N/m]", flush=True)
    for size in sys.argv[1:] or ("1", "0.8", "0.6", "0.5"):
        solve(float(size))


if __name__ == "__main__":
    main()
