#!/usr/bin/python3
"""The table of rules between features (`continua --print-rules`) against the program: files with two features each, on one tiny body, are valid or
refused with a sentence of the table that forbids two of their features, at the entry of the refused one. A feature without a row here, a pair that
the table forbids and the program accepts, and a refusal by any other sentence or at another place fail the test. So does a rule that holds in no
file here and is shown by no other test. Two features that give one entry two values have a file only where a rule names both. All files are
checked by one call of the program. Files that are valid run, too, a run in time for two steps: a few that have each feature at least once, or with
CONTINUA_ALL_PAIRS=1 all."""

import functools
import itertools
import json
import os
import re
import subprocess
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))

# A tube of liquid, right in everything. None stands for an entry that is not there.
BODY = {
    "Analysis": "transient", "Model": "axisymmetric",
    "Geometry/Type": "tube", "Geometry/Law": "uniform", "Geometry/Inner diameter": "4 mm", "Geometry/Wall thickness": "1 mm",
    "Geometry/Length": "8 mm", "Mesh/Axial cells": "2", "Mesh/Radial cells": "1", "Mesh/Wall cells": "1",
    "Materials/fluid/Type": "newtonian", "Materials/fluid/Density": "1000 kg/m^3", "Materials/fluid/Viscosity": "1 mPa s",
    "Materials/fluid/Bulk modulus": "2.2 GPa",
    "Materials/wall/Type": "hookean", "Materials/wall/Density": "1000 kg/m^3", "Materials/wall/Young's modulus": "1 MPa",
    "Materials/wall/Poisson's ratio": "0.3",
    "Boundaries/inlet/Type": "pressure", "Boundaries/inlet/Pressure": "1 Pa",
    "Boundaries/outlet/Type": "pressure", "Boundaries/outlet/Pressure": "0 Pa",
    "Boundaries/wall inlet end/Type": "fixed", "Boundaries/wall outlet end/Type": "fixed",
    "Boundaries/outside/Type": "free", "Boundaries/axis/Type": "axis",
    "Time/Time step": "1 ms", "Time/End time": "60 ms"}

# The same as a channel under a wall, for models in a plane.
CHANNEL = {"Geometry/Type": "layered channel", "Geometry/Law": None, "Geometry/Inner diameter": None, "Geometry/Wall thickness": None,
           "Geometry/Fluid depth": "2 mm", "Geometry/Layer thicknesses": "1 mm", "Mesh/Radial cells": None, "Mesh/Fluid cells": "1",
           "Boundaries/bottom/Type": "fixed", "Boundaries/axis/Type": None}

# A sort of snippet that needs a liquid, and one that has none: they cannot be in one file.
LIQUID = {"Materials/fluid/Young's modulus": None}
SOLID = {"Materials/fluid/Type": "hookean", "Materials/fluid/Viscosity": None, "Materials/fluid/Bulk modulus": None,
         "Materials/fluid/Young's modulus": "1 MPa", "Materials/fluid/Poisson's ratio": "0.3"}
WITHOUT_TIME = {f"Time/{key}": None for key in ("Time step", "End time", "Scheme", "Update", "Time step control")}
NOT_IN_TIME = {**WITHOUT_TIME, "Adaptivity/Every n steps": None}
STEADY = {"Analysis": "steady", **NOT_IN_TIME}
MODAL = {"Analysis": "modal", **NOT_IN_TIME, **SOLID, "Boundaries/inlet/Type": "free", "Boundaries/inlet/Pressure": None}
CELL_WISE = {"Discretisation": "cell-wise"}
CONVECTION = {"Convection": "navier stokes"}
FINITE = {"Deformation": "finite"}
EXPLICIT = {**CONVECTION, **LIQUID, "Flow/Time treatment": "explicit", "Flow/Convection stabilisation": "none", "Materials/fluid/Bulk modulus": None,
            "Materials/fluid/Incompressible": "true"}
STEADY_START = {"Initial state/Type": "steady"}
PRONY = {"Materials/wall/Type": "prony", "Materials/wall/Shear moduli": "1 MPa", "Materials/wall/Relaxation times": "5 ms"}
MAXWELL = {"Materials/wall/Type": "maxwell", "Materials/wall/Shear modulus": "1 MPa", "Materials/wall/Bulk modulus": "2 MPa",
           "Materials/wall/Relaxation time": "5 ms", "Materials/wall/Young's modulus": None, "Materials/wall/Poisson's ratio": None}
FLOW_RATE = {**LIQUID, "Boundaries/inlet/Type": "flow rate", "Boundaries/inlet/Pressure": None, "Boundaries/inlet/Flow rate": "1e-9 m^3/s"}
OUTLET = {**LIQUID, "Boundaries/outlet/Pressure": None}
RESISTANCE = {**OUTLET, "Boundaries/outlet/Type": "resistance", "Boundaries/outlet/Resistance": "1e4 Pa s/m^3"}


# What the predicates below ask for. They look at the entries of a file alone.
def has(key, *values):
    return lambda file: file.get(key) in values


def analysis(file):
    return file["Analysis"]


def cell_wise(file):
    return file.get("Discretisation") == "cell-wise"


def finite(file):
    return file.get("Deformation") == "finite"


def liquid(file):
    return file["Materials/fluid/Type"] in ("newtonian", "carreau-yasuda")


def convection(file):
    return file.get("Convection") == "navier stokes"


def moves(file):
    return finite(file) and liquid(file) and not cell_wise(file)


def moves_between_steps(file):
    return cell_wise(file) and liquid(file) and "Mesh motion" in file


def form(file, *names):
    return cell_wise(file) and file.get("Cell-wise/Formulation", "velocity-pressure") in names


def explicit(file):
    return convection(file) and file.get("Flow/Time treatment") == "explicit"


def steady_start(file):
    return analysis(file) in ("transient", "steady") and "Initial state/Type" in file and file["Initial state/Type"] != "given"


def unloaded(file):
    return file.get("Unloaded shape") == "inverse solve"


def wall_type(file, *types):
    return file["Materials/wall/Type"] in types


def hookean(file):
    return not liquid(file) and wall_type(file, "hookean")


def in_time(file):
    return analysis(file) == "transient"


def stabilised_by(file, name):
    return convection(file) and not cell_wise(file) and file.get("Flow/Convection stabilisation", "grad-div") == name


def solver(key, *values):
    return lambda file: not cell_wise(file) and file.get("Linear solver/" + key) in values


# Feature -> entries that turn it on (None: it comes with others alone), and whether it is on in a file.
FEATURES = {
    "transient": ({}, has("Analysis", "transient")),
    "steady": (STEADY, has("Analysis", "steady")),
    "modal": (MODAL, has("Analysis", "modal")),
    "highest modes": ({**MODAL, "Modal/Which": "highest"}, has("Modal/Which", "highest")),
    "shift of modes": ({**MODAL, "Modal/Shift": "10 Hz"}, lambda file: "Modal/Shift" in file),
    "harmonic": ({"Analysis": "harmonic", "Harmonic/Frequencies": "10 Hz", "Harmonic/Unit load at": "inlet", **NOT_IN_TIME}, has("Analysis", "harmonic")),
    "resonances": ({"Analysis": "resonances", "Resonances/Lowest frequency": "1 Hz", "Resonances/Highest frequency": "10 Hz", **NOT_IN_TIME},
                   has("Analysis", "resonances")),
    "periodic response": ({"Analysis": "periodic response", "Periodic state/Period": "20 ms", "Periodic state/Probes": "wall",
                           "Probes/wall/Point": "4 mm, 3 mm", "Probes/wall/Fields": "displacement y",
                           "Boundaries/inlet/Pressure": "sin(100*pi*t)"}, has("Analysis", "periodic response")),
    "pulse response": ({"Analysis": "pulse response"}, has("Analysis", "pulse response")),
    "no steps in time": (STEADY, lambda file: not in_time(file)),
    "plane stress": ({"Model": "plane stress", **SOLID}, has("Model", "plane stress")),
    "taylor hood": ({}, lambda file: not cell_wise(file)),
    "velocity degree other than 2": ({"Finite element/Velocity degree": "3"},
                                     lambda file: not cell_wise(file) and file.get("Finite element/Velocity degree", "2") != "2"),
    "cell-wise": (CELL_WISE, cell_wise),
    "displacement form": ({**CELL_WISE, **SOLID, "Cell-wise/Formulation": "displacement"}, lambda file: form(file, "displacement")),
    "velocity form": ({**CELL_WISE, **SOLID, "Cell-wise/Formulation": "velocity"}, lambda file: form(file, "velocity")),
    "explicit pressure form": ({**CELL_WISE, "Cell-wise/Formulation": "velocity explicit pressure"},
                               lambda file: form(file, "velocity explicit pressure")),
    "velocity-pressure form": (CELL_WISE, lambda file: form(file, "velocity-pressure")),
    "coupled solve": (CELL_WISE,
                      lambda file: cell_wise(file) and file.get("Cell-wise/Solution") != "segregated"),
    "segregated loop": ({**CELL_WISE, "Cell-wise/Solution": "segregated"},
                        lambda file: cell_wise(file) and file.get("Cell-wise/Solution") == "segregated"),
    "longitudinal stencil": ({**CELL_WISE, "Cell-wise/Stencil coefficient": "longitudinal"}, has("Cell-wise/Stencil coefficient", "longitudinal")),
    "inconsistent accumulated term": ({**CELL_WISE, "Cell-wise/Accumulated term": "inconsistent"},
                                      has("Cell-wise/Accumulated term", "inconsistent")),
    "force balance of boundaries": ({**CELL_WISE, "Cell-wise/Pressure at boundaries": "force balance"},
                                    has("Cell-wise/Pressure at boundaries", "force balance")),
    "trapezoidal pressure": ({**CELL_WISE, "Cell-wise/Pressure update": "trapezoidal"}, has("Cell-wise/Pressure update", "trapezoidal")),
    "pressure unlike the displacement": ({**CELL_WISE, "Cell-wise/Pressure update": "euler"}, has("Cell-wise/Pressure update", "trapezoidal", "euler")),
    "power by the thesis's operators": ({**CELL_WISE, "Cell-wise/Power operator": "compact"}, has("Cell-wise/Power operator", "compact")),
    "liquid": (LIQUID, liquid),
    "no liquid": (SOLID, lambda file: not liquid(file)),
    "flow curve": ({**CONVECTION, **LIQUID, "Materials/fluid/Type": "carreau-yasuda", "Materials/fluid/Viscosity": None,
                    "Materials/fluid/Zero-rate viscosity": "10 mPa s", "Materials/fluid/Infinite-rate viscosity": "3 mPa s",
                    "Materials/fluid/Time constant": "1 s", "Materials/fluid/Power-law index": "0.4"}, has("Materials/fluid/Type", "carreau-yasuda")),
    "compressible liquid": ({**LIQUID, "Materials/fluid/Bulk modulus": "2.2 GPa"},
                            lambda file: liquid(file) and "Materials/fluid/Incompressible" not in file),
    "maxwell liquid": (MAXWELL, lambda file: wall_type(file, "maxwell")),
    "no convection": ({}, lambda file: not convection(file)),
    "convection": (CONVECTION, convection),
    "convection on a mesh that stays": (CONVECTION, lambda file: convection(file) and not moves(file)),
    "explicit convection": (EXPLICIT, explicit),
    "explicit convection in all steps": (EXPLICIT, lambda file: explicit(file) and not steady_start(file)),
    "explicit convection with a factor": (EXPLICIT, lambda file: explicit(file) and not steady_start(file)
                                          and file.get("Linear solver/Type") != "iterative"),
    "supg": ({**CONVECTION, "Flow/Convection stabilisation": "supg"}, lambda file: stabilised_by(file, "supg")),
    "grad-div by the local speed": ({**CONVECTION, "Flow/Convection stabilisation": "grad-div"}, lambda file: stabilised_by(file, "grad-div")),
    "linear equations": ({}, lambda file: not finite(file) and not (liquid(file) and (convection(file) or moves_between_steps(file)))),
    "load steps": ({**STEADY, **CONVECTION, "Steady/Load steps": "2"}, has("Steady/Load steps", "2")),
    "small deformation": ({}, lambda file: not finite(file)),
    "finite deformation": (FINITE, finite),
    "finite deformation of a solid": (FINITE, finite),
    "no solid, and no boundary that moves": (None, lambda file: False),
    "unloaded shape": ({**FINITE, "Unloaded shape": "inverse solve"}, unloaded),
    "prestretch": ({**FINITE, **STEADY_START, "Materials/wall/Axial prestretch": "1.05"}, lambda file: "Materials/wall/Axial prestretch" in file),
    "no direction in any material": (FINITE, lambda file: finite(file) and "Materials/wall/Axial prestretch" not in file),
    "solid that relaxes": (PRONY, lambda file: not wall_type(file, "hookean")),
    "volume that relaxes": ({**PRONY, "Materials/wall/Volumetric relaxation": "as the shear"},
                            lambda file: "Materials/wall/Volumetric relaxation" in file),
    "power law": ({"Materials/wall/Type": "power law", "Materials/wall/Young's modulus": None, "Materials/wall/Poisson's ratio": None,
                   "Materials/wall/Bulk modulus": "2 MPa", "Materials/wall/Relaxation modulus at one second": "1 MPa",
                   "Materials/wall/Exponent": "0.1"}, lambda file: wall_type(file, "power law")),
    "solid without a spring that holds": (MAXWELL, lambda file: wall_type(file, "maxwell")),
    "material that is no Hookean solid": ({}, lambda file: not hookean(file)),
    "incompressible material": ({**LIQUID, "Materials/fluid/Bulk modulus": None, "Materials/fluid/Incompressible": "true"},
                                lambda file: "Materials/fluid/Incompressible" in file or file.get("Materials/wall/Poisson's ratio") == "0.5"),
    "incompressible solid": ({"Materials/wall/Poisson's ratio": "0.5"}, has("Materials/wall/Poisson's ratio", "0.5")),
    "liquid of a steady flow": (STEADY, lambda file: analysis(file) == "steady" and liquid(file)),
    "mesh that stays": ({}, lambda file: not finite(file) and not moves_between_steps(file)),
    "mesh that moves": (FINITE, moves),
    "cell-wise mesh that moves": ({**CELL_WISE, **CONVECTION, **LIQUID, "Mesh motion": "elastic"}, moves_between_steps),
    "hyperelastic motion of the mesh": ({**FINITE, **LIQUID, "Mesh motion": "hyperelastic"},
                                        lambda file: (moves(file) or moves_between_steps(file)) and file.get("Mesh motion") != "elastic"),
    "mesh that follows a boundary": ({**FINITE, **LIQUID, "Boundaries/inlet/Mesh": "follows", "Boundaries/inlet/Mesh velocity": "0, 0"},
                                     has("Boundaries/inlet/Mesh", "follows")),
    "adaptive mesh": ({"Adaptivity/Every n steps": "1"}, lambda file: "Adaptivity/Every n steps" in file),
    "metis": ({"Mesh/Partitioner": "metis"}, has("Mesh/Partitioner", "metis")),
    "support": ({"Boundaries/outside/Type": "support", "Boundaries/outside/Normal damping": "1e3 Pa s/m"}, has("Boundaries/outside/Type", "support")),
    "cavity": ({**FINITE, **LIQUID, "Boundaries/inlet/Type": "cavity", "Boundaries/inlet/Pressure": None, "Boundaries/inlet/Volume ratio": "1"},
               has("Boundaries/inlet/Type", "cavity")),
    "outlet": (RESISTANCE, has("Boundaries/outlet/Type", "resistance", "windkessel", "network", "absorbing")),
    "windkessel": ({**OUTLET, "Boundaries/outlet/Type": "windkessel", "Boundaries/outlet/Proximal resistance": "1e3 Pa s/m^3",
                    "Boundaries/outlet/Distal resistance": "1e4 Pa s/m^3", "Boundaries/outlet/Compliance": "1e-9 m^3/Pa"},
                   has("Boundaries/outlet/Type", "windkessel")),
    "network at an end": ({**OUTLET, "Boundaries/outlet/Type": "network", "Boundaries/outlet/Node": "joint", "Network/Vessels/vessel/From": "joint",
                           "Network/Vessels/vessel/To": "end", "Network/Vessels/vessel/Length": "50 mm", "Network/Vessels/vessel/Radius at start": "2 mm",
                           "Network/Vessels/vessel/Wall thickness at start": "1 mm", "Network/Vessels/vessel/Young's modulus": "1 MPa",
                           "Network/Viscosity": "1 mPa s", "Network/Terminals/end/Type": "absorbing"}, has("Boundaries/outlet/Type", "network")),
    "outlet that holds the flow rate": ({**RESISTANCE, "Boundaries/outlet/Coupling": "flow"}, has("Boundaries/outlet/Coupling", "flow")),
    "absorbing end": ({**OUTLET, "Boundaries/outlet/Type": "absorbing"}, has("Boundaries/outlet/Type", "absorbing")),
    "free profile": ({**FLOW_RATE, **FINITE, "Boundaries/inlet/Profile": "free"}, has("Boundaries/inlet/Profile", "free")),
    "womersley profile": ({**FLOW_RATE, "Boundaries/inlet/Profile": "womersley", "Boundaries/inlet/Flow before the start": "steady"},
                          has("Boundaries/inlet/Profile", "womersley")),
    "womersley profile of a liquid that was at rest": (
        {**FLOW_RATE, "Boundaries/inlet/Profile": "womersley"},
        lambda file: file.get("Boundaries/inlet/Profile") == "womersley" and "Boundaries/inlet/Flow before the start" not in file),
    "weight": ({"Body force/Acceleration": "10, 0"}, lambda file: "Body force/Acceleration" in file),
    "crank nicolson": ({"Time/Scheme": "crank nicolson"}, lambda file: in_time(file) and file.get("Time/Scheme") == "crank nicolson"),
    "trapezoidal update": ({"Time/Update": "trapezoidal"}, lambda file: in_time(file) and file.get("Time/Update") == "trapezoidal"),
    "adaptive steps": ({"Time/Time step control": "adaptive"}, lambda file: "Time/Time step control" in file),
    "displacement form by backward differencing": (
        None, lambda file: in_time(file) and form(file, "displacement") and "Time/Scheme" not in file),
    "steady start": (STEADY_START, steady_start),
    "start from the shape of the mesh": ({},
                                         lambda file: in_time(file) and not steady_start(file) and not unloaded(file)),
    "no unloaded shape in a steady flow": (STEADY, lambda file: analysis(file) == "steady" and not unloaded(file)),
    "iterative solver": ({"Linear solver/Type": "iterative"}, solver("Type", "iterative")),
    "cholmod": ({"Linear solver/Direct solver": "cholmod"}, solver("Direct solver", "cholmod")),
    "umfpack": ({"Linear solver/Direct solver": "umfpack"}, solver("Direct solver", "umfpack")),
    "several ranks": (None, lambda file: False),
    "matrix-free products": ({"Linear solver/Velocity product": "matrix-free"}, solver("Velocity product", "matrix-free")),
    "polynomial multigrid": ({"Linear solver/Stiff block": "polynomial multigrid"}, solver("Stiff block", "polynomial multigrid")),
    "checkpoints": ({"Output/Checkpoint interval": "1 ms"}, lambda file: "Output/Checkpoint interval" in file),
    "checkpoint at the end": ({"Output/Checkpoint at end": "true"}, lambda file: "Output/Checkpoint at end" in file),
    "analysis without checkpoints": (STEADY, lambda file: analysis(file) != "transient"),
    "averages of wall shear stress": ({"Output/Further fields": "averages of wall shear stress"}, lambda file: "Output/Further fields" in file),
}

# Entries and sections that rules name -> entries of a file that has them, beside those of the other feature.
ENTRIES = {
    "set Mesh motion": {"Mesh motion": "elastic"},
    "set Boundaries/<name>/Mesh": {"Boundaries/inlet/Mesh": "fixed"},
    "subsection Wall directions": {"Wall directions/Type": "straight axis"},
    "set Wave theory/Mean pressure": {"Wave theory/Mean pressure": "0 Pa"},
    "set Initial state/Velocity": {"Initial state/Velocity": "0, 0"},
    "set Initial state/Displacement": {"Initial state/Displacement": "0, 0"},
    "set Initial state/Pressure": {"Initial state/Pressure": "0 Pa"},
    "subsection Initial state/Pressures": {"Initial state/Pressures/fluid": "0 Pa"},
    "set Initial state/Type": {"Initial state/Type": "given"},
    "subsection Exact solution": {"Exact solution/Displacement": "0, 0"},
    "set Exact solution/Stress": {"Exact solution/Stress": "0, 0, 0, 0"},
    "set Steady/Time of loads": {**STEADY_START, "Steady/Time of loads": "1 ms"},
    "set Steady/Load steps": {**STEADY, **CONVECTION, "Steady/Load steps": "1"},
    "set Linear solver/Factor precision": {"Linear solver/Factor precision": "double"},
    "set Linear solver/Tolerance": {"Linear solver/Type": "iterative", "Linear solver/Tolerance": "1e-8"},
    "set Linear solver/Refinement steps": {"Linear solver/Refinement steps": "1"},
    "set Linear solver/Kept factors": {"Linear solver/Kept factors": "1"},
    "set Boundaries/<name>/Initial pressure": {
        **OUTLET, "Boundaries/outlet/Type": "windkessel", "Boundaries/outlet/Proximal resistance": "1e3 Pa s/m^3",
        "Boundaries/outlet/Distal resistance": "1e4 Pa s/m^3", "Boundaries/outlet/Compliance": "1e-9 m^3/Pa",
        "Boundaries/outlet/Initial pressure": "0 Pa"},
    "set Boundaries/<name>/Inflow pressure": {**LIQUID, "Boundaries/inlet/Inflow pressure": "static"},
    "subsection Flow": {"Flow/Convective term": "skew"},
    "set Flow/Convective term": {**CONVECTION, "Flow/Convective term": "skew"},
    "set Flow/Convection stabilisation": {**CONVECTION, "Flow/Convection stabilisation": "none"},
    "set Flow/Stabilisation viscosity": {**CONVECTION, "Flow/Stabilisation viscosity": "1 mPa s"},
    "subsection Newton": {"Newton/Slowest rate": "0.5"},
    "set Newton/Slowest rate": {"Newton/Slowest rate": "0.5"},
    "set Newton/Slow iteration": {"Newton/Slow iteration": "new factor"},
    "set Newton/Tangent products": {"Newton/Tangent products": "assembled"},
    "set Newton/Krylov tolerance": {"Newton/Krylov tolerance": "1e-3"},
    "set Newton/Most Krylov iterations": {"Newton/Most Krylov iterations": "10"},
    "set Materials/<region>/Volume exponent": {**LIQUID, "Materials/fluid/Volume exponent": "7"},
    "set Materials/<region>/Reference pressure": {**LIQUID, "Materials/fluid/Reference pressure": "0 Pa"},
    "set Output/Further fields": {"Output/Further fields": "averages of wall shear stress"},
    **{f"set Cell-wise/{key}": {**CELL_WISE, f"Cell-wise/{key}": value} for key, value in (
        ("Rhie-Chow", "none"), ("Rhie-Chow in time", "made anew"), ("Pressure update", "as the displacement"), ("Pressure at boundaries", "momentum"),
        ("Pressure corrections", "1"), ("Pressure at boundaries as", "value"), ("Tolerance", "1e-8"), ("Maximum corrections", "10"),
        ("At the cap", "fail"), ("Residual history", "true"), ("Velocity at boundaries as", "value"), ("Accumulated term", "consistent"),
        ("Power operator", "scheme"), ("Convective interpolation", "upwind"))},
}

# Sentences of rules that hold in no file here -> the test that shows them, with their beginning; None: there is none, since it needs two ranks.
ELSEWHERE = {
    "a free profile is that of a section which moves, and here the mesh stays": "tests/bad_input/flow/flow_rate_free_on_a_mesh_that_stays.prm",
    "the volume of a cavity is that of the deformed body": "tests/bad_input/cavities/cavity_small_deformation.prm",
    "with small deformation the shape of the mesh is also the one without load": "tests/bad_input/finite/finite_unloaded_small.prm",
    "no region is a solid, and the mesh of the liquids follows no boundary": "tests/bad_input/finite/finite_liquids_alone.prm",
    "with a prestretch the shape of the mesh is not in balance, and the run would start with a jump":
        "tests/bad_input/finite/finite_prestretch_start.prm",
    "a modal analysis is of solids, which a fluid is not": "tests/bad_input/modal/modal_of_a_fluid.prm",
    "a viscosity that depends on the rate of shear is not linear, and belongs to Newton's iteration":
        "tests/bad_input/flow/flow_curve_without_convection.prm",
    "explicit convection is there for incompressible liquids, whose density stays": "tests/bad_input/flow/explicit_convection_gas.prm",
    "this solver works on one rank only": None,
}

# Sentences of readers of one boundary, which refuse what no rule does.
OF_ONE_BOUNDARY = ("a womersley profile is for one viscous liquid of constant viscosity",)


def text_of(file):
    """The text of a parameter file."""
    lines, tree = [], {}
    for path, value in file.items():
        *sections, key = path.split("/")
        at = tree
        for section in sections:
            at = at.setdefault(section, {})
        at[key] = value

    def write(node, indent):
        for key, value in node.items():
            if isinstance(value, dict):
                lines.append(f"{indent}subsection {key}")
                write(value, indent + "  ")
                lines.append(f"{indent}end")
            else:
                lines.append(f"{indent}set {key} = {value}")

    write({key: value for key, value in tree.items() if not isinstance(value, dict)}, "")
    write({key: value for key, value in tree.items() if isinstance(value, dict)}, "")
    return "\n".join(lines) + "\n"


def file_with(first, second):
    """The entries of a file with two features, or None if they give one entry two values."""
    if any(first[key] != second[key] for key in first.keys() & second.keys()):
        return None
    entries = {**BODY, **first, **second}
    if entries["Model"] == "plane stress":
        entries = {**entries, **CHANNEL}
        entries = {key.replace("/outside/", "/top/"): value for key, value in entries.items()}
    if finite(entries) and entries["Boundaries/outlet/Type"] == "absorbing":
        # The loaded tube that goes on behind the end.
        entries["Materials/wall/Poisson's ratio"] = "0.5"
        if entries["Boundaries/outside/Type"] == "free":
            entries.update({"Boundaries/outside/Type": "pressure", "Boundaries/outside/Pressure": "0 Pa", "Boundaries/outside/Tangential": "fixed"})
        if unloaded(entries):
            entries["Boundaries/outlet/Mean pressure"] = "0 Pa"
    return {key: value for key, value in entries.items() if value is not None}


def is_complete(file):
    """Whether the material and the boundary that several snippets change have the entries of their types, and no other."""
    pressed = file["Boundaries/inlet/Type"] == "pressure"
    return (liquid(file) or "Materials/fluid/Young's modulus" in file) and pressed == ("Boundaries/inlet/Pressure" in file)


def files_of_rule(first, second):
    """Files in which both of two names of a rule are on, where a file can have both."""
    entries = [ENTRIES[name] if name in ENTRIES else FEATURES[name][0] for name in (first, second)]
    if None in entries:
        return []
    file = file_with(*entries)
    files = [file] if file else [file_with({**entries[0], **entries[1]}, {}), file_with({**entries[1], **entries[0]}, {})]
    return [file for file in files if is_complete(file) and is_on(first, file) and is_on(second, file)]


def place_of(name, entry_of):
    """A pattern of the place that an error names, of what a rule refuses."""
    path = name.split(" ", 1)[1] if name not in entry_of else entry_of[name].split(" = ")[0]
    return "/".join("[^/]*" if part in ("<region>", "<name>") else re.escape(part) for part in path.split("/"))


def is_on(name, file):
    """Whether a file has what a rule names: a feature, an entry or a section. Entries of the section of the other discretisation do not count."""
    if name in FEATURES:
        return FEATURES[name][1](file)
    word, path = name.split(" ", 1)
    if path.startswith(("Linear solver/", "Finite element/") if cell_wise(file) else "Cell-wise/"):
        return False
    pattern = re.escape(path).replace("<region>", "[^/]*").replace("<name>", "[^/]*") + ("$" if word == "set" else "/")
    return any(re.match(pattern, key) for key in file)


class WhatGoesWithWhat(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.table = json.loads(subprocess.run([PROGRAM, "--print-rules=json"], capture_output=True, text=True, check=True).stdout)
        cls.names = [feature["name"] for feature in cls.table["features"]]
        cls.entry_of = {feature["name"]: feature["entry"] for feature in cls.table["features"]}

    @classmethod
    @functools.lru_cache(maxsize=None)
    def refusals(cls):
        """Of each of the files the error of the program, or None where it is valid."""
        texts = list(cls.files()[0])
        with tempfile.TemporaryDirectory() as folder:
            for number, text in enumerate(texts):
                with open(os.path.join(folder, f"{number}.prm"), "w", encoding="utf-8") as stream:
                    stream.write(text)
            done = subprocess.run([PROGRAM, "--validate", *(f"{number}.prm" for number in range(len(texts)))], cwd=folder, capture_output=True,
                                  text=True, check=False)
        assert done.returncode in (0, 2), done.stderr[-2000:]
        valid = {int(number) for number in re.findall(r"^(\d+)\.prm: valid$", done.stdout, re.MULTILINE)}
        errors = {int(number): error for number, error in re.findall(r"(?:^|: )(\d+)\.prm(?::\d+)?: (.*)", done.stderr)}
        assert valid | set(errors) == set(range(len(texts))), done.stderr[-2000:]
        return [None if number in valid else errors[number] for number in range(len(texts))]

    def test_features(self):
        """Each feature has a row here."""
        self.assertEqual(set(FEATURES), set(self.names))

    def test_names(self):
        """A rule names features that exist, entries or sections."""
        for rule in self.table["rules"]:
            for name in rule["refused"] + rule["with"]:
                self.assertTrue(name in self.names or re.match(r"(set|subsection) [A-Z]", name), name)

    def test_entries(self):
        """Each entry and each section that a rule names has a row here. An error can point to what a rule refuses."""
        in_rules = {name for rule in self.table["rules"] for name in rule["refused"] + rule["with"]}
        self.assertEqual(set(ENTRIES), in_rules - set(self.names))
        for rule in self.table["rules"]:
            for name in rule["refused"]:
                self.assertNotRegex(self.entry_of.get(name, ""), r" of | without |^mpirun|^Analysis$")

    def test_elsewhere(self):
        """The tests that are named for rules without a file here have their sentences."""
        for reason, path in ELSEWHERE.items():
            if path is not None:
                with open(os.path.join(ROOT, path), encoding="utf-8") as stream:
                    self.assertIn(reason[:25], stream.read().replace("\\", ""), path)

    def sentences(self, file):
        """Patterns of the errors that the table has for a file: the place and the reason."""
        return [place_of(name, self.entry_of) + "': " + re.escape(rule["reason"]) for rule in self.table["rules"] for name in rule["refused"]
                if is_on(name, file) and any(is_on(other, file) for other in rule["with"])]

    @classmethod
    @functools.lru_cache(maxsize=None)
    def files(cls):
        """What each file is of, by its text, and the files."""
        pair_of_text, files = {}, []

        def add(file, first, second):
            if text_of(file) not in pair_of_text:
                pair_of_text[text_of(file)] = (first, second)
                files.append(file)

        apart = {frozenset(pair) for pair in cls.table["apart"]}
        for first, second in itertools.combinations_with_replacement(cls.names, 2):
            if FEATURES[first][0] is not None and FEATURES[second][0] is not None and {first, second} not in apart:
                file = file_with(FEATURES[first][0], FEATURES[second][0])
                if file is not None:
                    add(file, first, second)
        n_pairs = len(files)
        for rule in cls.table["rules"]:
            for first, second in itertools.product(rule["refused"], rule["with"]):
                if not any(is_on(first, file) and is_on(second, file) for file in files[:n_pairs]):
                    for file in files_of_rule(first, second):
                        add(file, first, second)
        return pair_of_text, files

    def test_pairs(self):
        pair_of_text, files = self.files()
        wrong, n_refused = [], 0
        for file, pair, error in zip(files, pair_of_text.values(), self.refusals()):
            n_refused += error is not None
            sentences = self.sentences(file)
            if error is None and sentences:
                wrong.append(f"{' with '.join(pair)}: accepted, and the table says '{sentences[0]}'")
            elif error is not None and not any(re.match("'" + sentence, error) for sentence in sentences):
                if not any(sentence in error for sentence in OF_ONE_BOUNDARY):
                    wrong.append(f"{' with '.join(pair)}: {error} [the table: {sentences}]")
        unseen = [rule["reason"] for rule in self.table["rules"]
                  if not any(any(is_on(name, file) for name in rule["refused"]) and any(is_on(name, file) for name in rule["with"]) for file in files)]
        self.assertFalse(wrong, f"{len(wrong)} of {len(files)} files\n" + "\n".join(wrong))
        self.assertEqual(set(unseen), set(ELSEWHERE))
        self.assertGreater(n_refused, 200)
        self.assertGreater(len(files) - n_refused, 500)

    def some_of(self, files):
        """Numbers of few of these files, which have each feature that one of them has."""
        features = [{name for name in self.names if is_on(name, file)} for file in files]
        numbers, missing = [], set().union(*features)
        while missing:
            numbers.append(max(range(len(files)), key=lambda number: len(features[number] & missing)))
            missing -= features[numbers[-1]]
        return numbers

    def test_runs(self):
        """What the table lets through runs to its end."""
        valid = [file for file, error in zip(self.files()[1], self.refusals()) if error is None]
        numbers = range(len(valid)) if os.environ.get("CONTINUA_ALL_PAIRS") else self.some_of(valid)
        self.assertGreater(len(numbers), 15)
        with tempfile.TemporaryDirectory() as folder:
            for number in numbers:
                # The times of responses are chosen for what they compare.
                steps = {"Time/End time": "2 ms"} if in_time(valid[number]) else {}
                with open(os.path.join(folder, f"{number}.prm"), "w", encoding="utf-8") as stream:
                    stream.write(text_of({**valid[number], **steps}))
            done = subprocess.run([PROGRAM, *(f"{number}.prm" for number in numbers), "--output", "results"], cwd=folder, capture_output=True,
                                  text=True, check=False)
            ended = [number for number in numbers if os.path.exists(os.path.join(folder, "results", str(number), "summary.json"))]
        self.assertEqual(done.returncode, 0, done.stderr[-3000:])
        self.assertEqual(ended, list(numbers))


if __name__ == "__main__":
    unittest.main()
