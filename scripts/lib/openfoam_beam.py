"""The cantilever of the thesis's chapter 4 for OpenFOAM's solidDisplacementFoam: its case files, and what a run of it says."""

import os
import re

PROGRAMS = ("blockMesh", "solidDisplacementFoam")

# One cell of unit depth, whose front and back are `empty`: plane strain.
BLOCK_MESH = """
scale 1;
vertices ((0 0 0) ({length} 0 0) ({length} {height} 0) (0 {height} 0) (0 0 1) ({length} 0 1) ({length} {height} 1) (0 {height} 1));
blocks (hex (0 1 2 3 4 5 6 7) ({cells[0]} {cells[1]} 1) simpleGrading (1 1 1));
edges ();
boundary
(
    clamped {{ type patch; faces ((0 4 7 3)); }}
    end {{ type patch; faces ((1 2 6 5)); }}
    sides {{ type patch; faces ((0 1 5 4) (3 7 6 2)); }}
    frontAndBack {{ type empty; faces ((0 3 2 1) (4 5 6 7)); }}
);
mergePatchPairs ();
"""
CONTROL = """
application solidDisplacementFoam;
startFrom startTime;
startTime 0;
stopAt endTime;
endTime {end_time};
deltaT {time_step};
writeControl timeStep;
writeInterval 1000000000;
writePrecision 12;
timePrecision 9;
runTimeModifiable false;
functions
{{
    tip
    {{
        type surfaceFieldValue;
        libs (fieldFunctionObjects);
        regionType patch;
        name end;
        operation areaAverage;
        fields (D);
        writeFields false;
        log false;
        writeControl timeStep;
        writeInterval 1;
    }}
}}
"""
# The schemes of the tutorial plateHole, but for the gradient: least squares have twice the error here (7 instead of 3.4 %
# in the deflection with 40 x 10 cells).
SCHEMES = """
d2dt2Schemes { default Euler; }
ddtSchemes { default Euler; }
gradSchemes { default Gauss linear; }
divSchemes { default Gauss linear; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
"""
# PCG is up to a third faster here than the tutorial's GAMG.
SOLUTION = """
solvers {{ "(D|T)" {{ solver PCG; preconditioner DIC; tolerance 1e-14; relTol 0.1; }} }}
stressAnalysis {{ compactNormalStress {compact}; nCorrectors 100000; D {tolerance:g}; }}
"""
MECHANICAL = """
rho {{ type uniform; value {density}; }}
nu {{ type uniform; value {poisson}; }}
E {{ type uniform; value {young}; }}
planeStress no;
"""
THERMAL = """
C { type uniform; value 1; }
k { type uniform; value 1; }
alpha { type uniform; value 0; }
thermalStress no;
"""
DISPLACEMENT = """
dimensions [0 1 0 0 0 0 0];
internalField uniform (0 0 0);
boundaryField
{{
    clamped {{ type fixedValue; value uniform (0 0 0); }}
    end {{ type tractionDisplacement; traction uniform (0 {shear} 0); pressure uniform 0; value uniform (0 0 0); }}
    sides {{ type tractionDisplacement; traction uniform (0 0 0); pressure uniform 0; value uniform (0 0 0); }}
    frontAndBack {{ type empty; }}
}}
"""


def write_case(folder, beam, cells, time_step, tolerance, compact, end_time):
    """The case files. `beam`: length, height [m], young [Pa], poisson, density [kg/m^3], shear [Pa]; times in seconds."""
    values = dict(beam, cells=cells, time_step=time_step, end_time=end_time, tolerance=tolerance,
                  compact="yes" if compact else "no")
    files = {"system/blockMeshDict": BLOCK_MESH.format(**values), "system/controlDict": CONTROL.format(**values),
             "system/fvSchemes": SCHEMES, "system/fvSolution": SOLUTION.format(**values),
             "constant/mechanicalProperties": MECHANICAL.format(**values), "constant/thermalProperties": THERMAL,
             "0/D": DISPLACEMENT.format(**values)}
    for name, text in files.items():
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        kind = "volVectorField" if name == "0/D" else "dictionary"
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(f"FoamFile {{ version 2.0; format ascii; class {kind}; object {os.path.basename(name)}; }}\n{text}")


def read_tip(folder):
    """(times [s], mean displacement of the free end along y [m]), from rest at time 0; as far as the run came."""
    path = os.path.join(folder, "postProcessing", "tip", "0", "surfaceFieldValue.dat")
    if not os.path.exists(path):
        return [], []
    with open(path, encoding="utf-8") as stream:
        return parse_tip(stream.read())


def parse_tip(text):
    """Of the table of `surfaceFieldValue`; a last line that is cut short does not count."""
    times, values = [0.0], [0.0]
    for line in text.splitlines(keepends=True):
        match = re.fullmatch(r"\s*(\S+)\s+\(\s*(\S+)\s+(\S+)\s+(\S+)\s*\)\s*\n", line)
        if match and not line.startswith("#"):
            times.append(float(match.group(1)))
            values.append(float(match.group(3)))
    return times, values


def count_corrections(lines):
    """Corrections of all steps, of the program's lines: each solves for Dx once."""
    return sum("Solving for Dx" in line for line in lines)
