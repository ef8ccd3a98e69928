#!/usr/bin/python3
"""The flap in Mok's channel at rest by another program: a second opinion on the end of parameter_files/verification/flap-in-a-channel.prm.

    scripts/references/interaction/flap_in_channel.py [SIZE ...]

Prints the displacement of the tip in the steady flow for meshes of gmsh whose triangles are SIZE times those of the first one (1.4 and 1 unless the command
line gives others; 2 minutes of one core for both). The equations are those of beam_in_flow.py, with the numbers of the flap: plane stress with 2.3 MPa and
0.45 is plane strain with E (1 + 2 n)/(1 + n)^2 and n/(1 + n).

Needs python3-dolfin and python3-gmsh.
"""

import math
import sys

import dolfin as d
import gmsh

import beam_in_flow as steady

HEIGHT, PLACE, FLAP_HEIGHT, THICKNESS = 0.5, 0.5, 0.25, 0.005
THROAT, THROAT_PLACE, LENGTH, SLOPE = 0.2, 1.36, 1.75, 0.4034
DENSITY, VISCOSITY, SPEED = 956.0, 0.145, 0.2428
MODULUS, PLANE_STRESS_RATIO = 2.3e6, 0.45
POISSON = PLANE_STRESS_RATIO / (1 + PLANE_STRESS_RATIO)
SHEAR_MODULUS = MODULUS / (2 * (1 + PLANE_STRESS_RATIO))  # the same in both


def triangles(size):
    """Vertices, triangles and their regions."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    geometry, field = gmsh.model.geo, gmsh.model.mesh.field
    angle, rise = math.atan(SLOPE), HEIGHT - THROAT
    radius = (SLOPE * (THROAT_PLACE - PLACE - THICKNESS) - rise) / (SLOPE * math.sin(angle) - 1 + math.cos(angle))
    arc = (THROAT_PLACE - radius * math.sin(angle), rise - radius * (1 - math.cos(angle)))
    places = [(0, 0), (PLACE, 0), (PLACE + THICKNESS, 0), arc, (THROAT_PLACE, rise), (LENGTH, rise), (LENGTH, HEIGHT), (0, HEIGHT)]
    corners = [geometry.addPoint(x, y, 0) for x, y in places]
    centre = geometry.addPoint(THROAT_PLACE, rise - radius, 0)
    sides = [geometry.addCircleArc(corners[3], centre, corners[4]) if i == 3 else geometry.addLine(corners[i], corners[(i + 1) % 8]) for i in range(8)]
    tip = [geometry.addPoint(PLACE, FLAP_HEIGHT, 0), geometry.addPoint(PLACE + THICKNESS, FLAP_HEIGHT, 0)]
    flap_sides = [geometry.addLine(corners[1], tip[0]), geometry.addLine(tip[0], tip[1]), geometry.addLine(tip[1], corners[2])]
    liquid = geometry.addPlaneSurface([geometry.addCurveLoop([sides[0]] + flap_sides + sides[2:])])
    flap = geometry.addPlaneSurface([geometry.addCurveLoop([sides[1]] + [-s for s in reversed(flap_sides)])])
    geometry.synchronize()
    distance, threshold = field.add("Distance"), field.add("Threshold")
    field.setNumbers(distance, "CurvesList", flap_sides)
    field.setNumber(distance, "NNodesByEdge", 400)
    field.setNumber(threshold, "InField", distance)
    for key, value in (("SizeMin", 0.0025), ("SizeMax", 0.025), ("DistMin", 0.003), ("DistMax", 0.25)):
        field.setNumber(threshold, key, value * size if "Size" in key else value)
    field.setAsBackgroundMesh(threshold)
    for name in ("ExtendFromBoundary", "FromPoints", "FromCurvature"):
        gmsh.option.setNumber("Mesh.MeshSize" + name, 0)
    gmsh.model.mesh.generate(2)
    result = steady.vertices_and_cells(liquid, flap)
    gmsh.finalize()
    return result


def solve(size):
    mesh, regions = steady.mesh_of(*triangles(size))
    space, state, residual, shear = steady.steady_equations(mesh, regions, DENSITY, VISCOSITY, POISSON)
    # The places of gmsh differ from the sides by round-off, which is more than the tolerance of d.near by itself.
    inlet, outlet, top = lambda x: d.near(x[0], 0, 1e-9), lambda x: d.near(x[0], LENGTH, 1e-9), lambda x: d.near(x[1], HEIGHT, 1e-9)
    bottom = lambda x: not (inlet(x) or outlet(x) or top(x))
    inflow = d.Expression(("speed*x[1]*(1 - x[1])", "0"), speed=SPEED, degree=2)
    zero = d.Constant((0, 0))
    # The corner of inlet and bottom belongs to both; the inflow is zero there.
    fixed = [d.DirichletBC(space.sub(0), inflow, steady.on(inlet)), d.DirichletBC(space.sub(0).sub(1), d.Constant(0), steady.on(top)),
             d.DirichletBC(space.sub(0), zero, steady.on(bottom)), d.DirichletBC(space.sub(0), zero, steady.on(lambda x: d.near(x[1], 0, 1e-9))),
             d.DirichletBC(space.sub(1), zero, steady.on(inlet, outlet, top, bottom, lambda x: d.near(x[1], 0, 1e-9)))]
    steady.find_rest(space, state, residual, shear, [SHEAR_MODULUS * stiffness for stiffness in (1e3, 10, 5, 3, 2, 1.5, 1.2, 1)], fixed)
    tip = state(d.Point(PLACE, FLAP_HEIGHT))
    print(f"{size:5} {space.dim():9} {tip[2] * 1e3:14.4f} {tip[3] * 1e3:14.4f}", flush=True)


def main():
    d.set_log_level(40)
    print(" size  unknowns  along x [mm]  along y [mm]", flush=True)
    for size in sys.argv[1:] or ("1.4", "1"):
        solve(float(size))


if __name__ == "__main__":
    main()
