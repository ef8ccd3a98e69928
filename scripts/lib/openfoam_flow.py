"""Flows for OpenFOAM on the cells of a mesh of Continua: case files, meshes, and what a run says.

The flow around Turek and Hron's cylinder with a rigid beam (pimpleFoam), and the steady flow behind a stenosis (simpleFoam, a
wedge of 5 degrees)."""

import math
import os
import re

import numpy

CHANNEL, HEIGHT = 2.5, 0.41
DENSITY, DEPTH = 1000, 0.1
HALF_ANGLE = math.radians(2.5)

# A push across the inflow until 4 s starts the vortices. On coarse meshes they die away after it.
CYLINDER_CONTROL = """
application pimpleFoam;
startFrom latestTime;
stopAt endTime;
endTime {end_time};
deltaT {time_step};
writeControl timeStep;
writeInterval {write_interval};
purgeWrite 1;
writePrecision 12;
timePrecision 9;
runTimeModifiable false;
functions
{{
    obstacle
    {{
        type forces;
        libs (forces);
        patches (obstacle);
        rho rhoInf;
        rhoInf {density};
        CofR (0 0 0);
        writeControl timeStep;
        writeInterval 1;
    }}
}}
"""
CYLINDER_SCHEMES = """
ddtSchemes { default backward; }
gradSchemes { default Gauss linear; }
divSchemes { default none; div(phi,U) Gauss linear; div((nuEff*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
"""
CYLINDER_SOLUTION = """
solvers
{{
    p {{ solver GAMG; smoother GaussSeidel; tolerance {tolerance}; relTol 0.01; }}
    pFinal {{ $p; relTol 0; }}
    U {{ solver PBiCGStab; preconditioner DILU; tolerance 1e-9; relTol 0; }}
    UFinal {{ $U; }}
}}
PIMPLE {{ nOuterCorrectors 2; nCorrectors 2; nNonOrthogonalCorrectors 1; }}
"""
TURBULENCE = "simulationType laminar;\n"
CYLINDER_VELOCITY = """
dimensions [0 1 -1 0 0 0 0];
internalField uniform (0 0 0);
boundaryField
{{
    inlet
    {{
        type exprFixedValue;
        value uniform (0 0 0);
        variables ("ramp = time() < 2 ? 0.5*(1 - cos(pi()*time()/2)) : 1" "y = pos().y()" "push = time() < 4 ? 0.2*ramp*sin(2*pi()*4.4*time()) : 0");
        valueExpr "1.5*{speed}*4*y*({height} - y)/({height}*{height})*vector(ramp, push, 0)";
    }}
    outlet {{ type zeroGradient; }}
    walls {{ type noSlip; }}
    obstacle {{ type noSlip; }}
    frontAndBack {{ type empty; }}
}}
"""
CYLINDER_PRESSURE = """
dimensions [0 2 -2 0 0 0 0];
internalField uniform 0;
boundaryField
{
    inlet { type zeroGradient; }
    outlet { type fixedValue; value uniform 0; }
    walls { type zeroGradient; }
    obstacle { type zeroGradient; }
    frontAndBack { type empty; }
}
"""


STENOSIS_CONTROL = """
application simpleFoam;
startFrom startTime;
startTime 0;
stopAt endTime;
endTime {iterations};
deltaT 1;
writeControl timeStep;
writeInterval {iterations};
writePrecision 12;
runTimeModifiable false;
functions
{{
    stress {{ type wallShearStress; libs (fieldFunctionObjects); patches (wall); writeControl writeTime; }}
    points
    {{
        type probes;
        libs (sampling);
        fields (p U);
        probeLocations ((0.02 1e-6 0) (0.2 1e-6 0) (0.04 1e-6 0) (0.06 1e-6 0));
        interpolationScheme cellPoint;
        writeControl writeTime;
        fixedLocations false;
    }}
}}
"""
STENOSIS_SCHEMES = """
ddtSchemes { default steadyState; }
gradSchemes { default Gauss linear; }
divSchemes { default none; div(phi,U) Gauss linear; div((nuEff*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
"""
STENOSIS_SOLUTION = """
solvers
{
    p { solver GAMG; smoother GaussSeidel; tolerance 1e-12; relTol 0.05; }
    U { solver PBiCGStab; preconditioner DILU; tolerance 1e-14; relTol 0.05; }
}
SIMPLE { consistent yes; nNonOrthogonalCorrectors 1; }
relaxationFactors { equations { U 0.9; } }
"""
STENOSIS_VELOCITY = """
dimensions [0 1 -1 0 0 0 0];
internalField uniform (0.02 0 0);
boundaryField
{
    inlet
    {
        type exprFixedValue;
        value uniform (0 0 0);
        variables ("y = pos().y()" "z = pos().z()");
        valueExpr "vector(0.04*(1 - (y*y + z*z)/2.5e-5), 0, 0)";
    }
    outlet { type zeroGradient; }
    wall { type noSlip; }
    front { type wedge; }
    back { type wedge; }
}
"""
STENOSIS_PRESSURE = """
dimensions [0 2 -2 0 0 0 0];
internalField uniform 0;
boundaryField
{
    inlet { type zeroGradient; }
    outlet { type fixedValue; value uniform 0; }
    wall { type zeroGradient; }
    front { type wedge; }
    back { type wedge; }
}
"""


def write_files(folder, files):
    kinds = {"0/U": "volVectorField", "0/p": "volScalarField"}
    for name, text in files.items():
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(f"FoamFile {{ version 2.0; format ascii; class {kinds.get(name, 'dictionary')}; "
                         f"object {os.path.basename(name)}; }}\n{text}")


def write_cylinder(folder, time_step, end_time, speed, tolerance=1e-7):
    """The files of the flow around the cylinder; times [s], the mean velocity of the inflow [m/s], the tolerance of the pressure."""
    values = dict(time_step=time_step, end_time=end_time, write_interval=max(1, round(0.5 / time_step)), density=DENSITY,
                  speed=speed, height=HEIGHT, tolerance=tolerance)
    write_files(folder, {
        "system/controlDict": CYLINDER_CONTROL.format(**values), "system/fvSchemes": CYLINDER_SCHEMES,
        "system/fvSolution": CYLINDER_SOLUTION.format(**values), "constant/transportProperties": "transportModel Newtonian;\nnu 1e-3;\n",
        "constant/turbulenceProperties": TURBULENCE, "0/U": CYLINDER_VELOCITY.format(**values), "0/p": CYLINDER_PRESSURE})


def write_stenosis(folder, iterations):
    """The files of the steady flow behind the stenosis."""
    write_files(folder, {
        "system/controlDict": STENOSIS_CONTROL.format(iterations=iterations), "system/fvSchemes": STENOSIS_SCHEMES,
        "system/fvSolution": STENOSIS_SOLUTION, "constant/transportProperties": "transportModel Newtonian;\nnu 1e-6;\n",
        "constant/turbulenceProperties": TURBULENCE, "0/U": STENOSIS_VELOCITY, "0/p": STENOSIS_PRESSURE})


def boundary_edges(quadrilaterals):
    """The edges (two numbers of points) that belong to one quadrilateral alone."""
    uses = {}
    for quadrilateral in quadrilaterals:
        for a, b in zip(quadrilateral, numpy.roll(quadrilateral, -1)):
            uses.setdefault((min(a, b), max(a, b)), []).append((a, b))
    return [found[0] for found in uses.values() if len(found) == 1]


def write_gmsh(path, names, nodes, elements):
    """A file of gmsh, format 2.2. `names` by the number of a physical surface; elements: (type, physical number, nodes from 1)."""
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{len(names) + 1}\n")
        for number, name in names.items():
            stream.write(f'2 {number} "{name}"\n')
        stream.write(f'3 {len(names) + 1} "liquid"\n$EndPhysicalNames\n$Nodes\n{len(nodes)}\n')
        for i, (x, y, z) in enumerate(nodes, 1):
            stream.write(f"{i} {x:.15g} {y:.15g} {z:.15g}\n")
        stream.write(f"$EndNodes\n$Elements\n{len(elements)}\n")
        for i, (kind, physical, corners) in enumerate(elements, 1):
            stream.write(f"{i} {kind} 2 {physical} {physical} {' '.join(map(str, corners))}\n")
        stream.write("$EndElements\n")


TRIANGLE, QUADRILATERAL, HEXAHEDRON, PRISM = 2, 3, 5, 6  # of gmsh


def write_layer(points, quadrilaterals, path):
    """One layer of hexahedra over the plane flow around the cylinder; points n x 2 [m], quadrilaterals m x 4, round about."""
    names = {1: "inlet", 2: "outlet", 3: "walls", 4: "obstacle", 5: "frontAndBack"}
    n = len(points)
    elements = []
    for a, b in boundary_edges(quadrilaterals):
        x, y = (points[a] + points[b]) / 2
        patch = 1 if x < 1e-6 else 2 if x > CHANNEL - 1e-6 else 3 if y < 1e-6 or y > HEIGHT - 1e-6 else 4
        elements.append((QUADRILATERAL, patch, [a + 1, b + 1, b + n + 1, a + n + 1]))
    for corners in quadrilaterals + 1:
        elements += [(QUADRILATERAL, 5, corners), (QUADRILATERAL, 5, corners + n)]
    elements += [(HEXAHEDRON, 6, [*corners, *(corners + n)]) for corners in quadrilaterals + 1]
    nodes = [(x, y, z) for z in (0, DEPTH) for x, y in points]
    write_gmsh(path, names, nodes, elements)


def write_wedge(points, quadrilaterals, path):
    """A wedge around the x axis of the axisymmetric flow; points n x 2 (x, r) [m], quadrilaterals m x 4, round about."""
    names = {1: "inlet", 2: "outlet", 3: "wall", 4: "front", 5: "back"}
    nodes, front, back = [], {}, {}
    for i, (x, r) in enumerate(points):
        # One node on the axis, two elsewhere.
        if r > 1e-9:
            nodes.append((x, r * math.cos(HALF_ANGLE), -r * math.sin(HALF_ANGLE)))
            front[i] = len(nodes)
        nodes.append((x, r * math.cos(HALF_ANGLE), r * math.sin(HALF_ANGLE)))
        back[i] = len(nodes)
        front.setdefault(i, len(nodes))
    end = points[:, 0].max()
    elements = []
    for a, b in boundary_edges(quadrilaterals):
        x, r = (points[a] + points[b]) / 2
        if r > 1e-9:
            corners = list(dict.fromkeys([front[a], front[b], back[b], back[a]]))
            elements.append((QUADRILATERAL if len(corners) == 4 else TRIANGLE,
                             1 if x < 1e-9 else 2 if x > end - 1e-9 else 3, corners))
    for corners in quadrilaterals:
        elements += [(QUADRILATERAL, 4, [front[i] for i in corners]), (QUADRILATERAL, 5, [back[i] for i in corners])]
    for corners in quadrilaterals:
        on_axis = [points[i, 1] <= 1e-9 for i in corners]
        if not any(on_axis):
            elements.append((HEXAHEDRON, 6, [front[i] for i in corners] + [back[i] for i in corners]))
            continue
        first = next(i for i in range(4) if on_axis[i] and on_axis[(i + 1) % 4])
        a, b, c, d = numpy.roll(corners, -first)
        elements.append((PRISM, 6, [front[a], front[d], back[d], front[b], front[c], back[c]]))
    write_gmsh(path, names, nodes, elements)


def set_patch_types(folder, types):
    """gmshToFoam makes each patch one of the type `patch`."""
    path = os.path.join(folder, "constant", "polyMesh", "boundary")
    with open(path, encoding="utf-8") as stream:
        text = stream.read()
    for name, kind in types.items():
        text = re.sub(rf"(\b{name}\s*\{{\s*type\s+)patch", rf"\g<1>{kind}", text)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)


def read_forces(folder):
    """(times [s], drag [N/m], lift [N/m]) of all parts of a run, per metre of depth."""
    rows = {}
    root = os.path.join(folder, "postProcessing", "obstacle")
    for part in sorted(os.listdir(root), key=float):
        with open(os.path.join(root, part, "force.dat"), encoding="utf-8") as stream:
            for line in stream:
                numbers = re.findall(r"[-+0-9.eE]+", line)
                if not line.startswith("#") and len(numbers) == 10:
                    rows[float(numbers[0])] = (float(numbers[1]) / DEPTH, float(numbers[2]) / DEPTH)
    times = sorted(rows)
    return numpy.array(times), *(numpy.array([rows[time][i] for time in times]) for i in (0, 1))


def read_vectors(path, pattern=r"^\((\S+) (\S+) (\S+)\)$"):
    with open(path, encoding="utf-8") as stream:
        return numpy.array([[float(v) for v in found] for found in re.findall(pattern, stream.read(), re.M)])


def read_wall(folder, iterations):
    """(x [m], shear stress along x over the density [m^2/s^2]) of the wall's faces, by x."""
    mesh = os.path.join(folder, "constant", "polyMesh")
    points = read_vectors(os.path.join(mesh, "points"))
    with open(os.path.join(mesh, "faces"), encoding="utf-8") as stream:
        faces = [[int(v) for v in found.split()] for found in re.findall(r"^\d+\(([\d ]+)\)$", stream.read(), re.M)]
    with open(os.path.join(mesh, "boundary"), encoding="utf-8") as stream:
        found = re.search(r"\bwall\s*\{.*?nFaces\s+(\d+);\s*startFace\s+(\d+);", stream.read(), re.S)
    n, first = int(found.group(1)), int(found.group(2))
    x = numpy.array([points[face][:, 0].mean() for face in faces[first : first + n]])
    # Of the patches only the wall has values that are not uniform.
    stress = read_vectors(os.path.join(folder, str(iterations), "wallShearStress"))[-n:, 0]
    order = numpy.argsort(x)
    return x[order], stress[order]


def processor_times(path):
    """(times of the flow [s], processor time of the program so far [s]) of what it printed."""
    times, used = [], []
    with open(path, encoding="utf-8") as stream:
        for line in stream:
            if match := re.match(r"Time = (\S+)", line):
                time = float(match.group(1))
            elif match := re.match(r"ExecutionTime = (\S+) s", line):
                times.append(time)
                used.append(float(match.group(1)))
    return numpy.array(times), numpy.array(used)
