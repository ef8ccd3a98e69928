#!/usr/bin/python3
"""Checks the templates of `continua --new`: new_file.py PROGRAM TEMPLATE WORKING_FOLDER.

TEMPLATE is a file of parameter_files/new, or this folder. Of the folder: there is a template for each geometry and each analysis of --print-parameters=json, and what is refused is
refused. A template is written and runs: exit status 0, no warning, files in the output folder. Where
MEASURES has the template, `--mesh` writes its mesh, and the boundaries have the sizes that the file states.
"""

import json
import math
import os
import subprocess

import driver

QUARTER_TURN = 50 * math.pi / 2
# Template -> boundary -> length [mm] or, in three dimensions, area [mm^2]; relative tolerance of polygons. By hand from the numbers
# that stand in the template.
MEASURES = {
    "box": ({"left": 20, "right": 20, "bottom": 40, "top": 40}, 1e-12),
    "beam": ({"clamped end": 10, "free end": 10, "bottom": 100, "top": 100}, 1e-12),
    "layered channel": ({"inlet": 5, "wall inlet end": 1, "bottom": 100, "top": 100}, 1e-12),
    # 0.41 m high, a circle of 50 mm, a beam 20 mm high.
    "channel with cylinder": ({"inlet": 410, "bottom": 1200, "cylinder": 2 * 50 * (math.pi - math.asin(10 / 50)), "beam root": 20}, 2e-2),
    "tube": ({"inlet": 5, "wall inlet end": 1, "axis": 500, "outside": 500}, 1e-12),
    # A circle of 4 mm as a polygon, and a ring of 0.8 mm around it along a quarter of a circle of 50 mm.
    "curved vessel": ({"inlet": math.pi * 4**2, "wall outlet end": math.pi * (4.8**2 - 4**2),
                       "outside": 2 * math.pi * 4.8 * QUARTER_TURN}, 0.12),
    "bifurcation": ({"inlet": math.pi * 3**2 / 2, "first outlet": math.pi * 2.25**2 / 2,
                     "second outlet": math.pi * 1.75**2 / 2}, 0.12),
    "hollow cylinder": ({"inside": 20, "outside": 20, "left": 10, "right": 10}, 1e-12),
    "cook membrane": ({"clamped end": 44, "loaded end": 16, "bottom": math.hypot(48, 44), "top": math.hypot(48, 16)}, 1e-12),
    "gmsh": ({"inlet": 5, "outlet": 5, "axis": 200, "wall ends": 2}, 1e-9),
    "transient": ({"left": 100, "right": 100, "top": 1000, "back": 1000}, 1e-12),
}


def listed(program):
    """Geometries and analyses of the program's own documentation."""
    entries = json.loads(driver.run_to_the_end(program, ["--print-parameters=json"]).stdout)
    values = {entry["path"]: entry["values"].split(", ") for entry in entries if entry["path"] in ("Geometry/Type", "Analysis")}
    return values["Geometry/Type"], values["Analysis"]


def refused(program, arguments, folder, *texts):
    done = driver.run(program, arguments, folder=folder)
    if done.returncode != 2 or any(text not in done.stderr for text in texts):
        raise driver.TestFailure(f"{arguments}: status {done.returncode}, {done.stderr}; expected status 2 and {texts}")


def full_disk(program, arguments, folder):
    """What is there to be printed, into a full disk: exit status 1. Into a pipe that nobody reads any more: no error."""
    with open("/dev/full", "w", encoding="utf-8") as full:
        done = subprocess.run([program, *arguments], cwd=folder, env=driver.environment(), stdout=full, stderr=subprocess.PIPE, text=True,
                              check=False)
    if done.returncode != 1 or "error: cannot write to the standard output: No space left on device" not in done.stderr:
        raise driver.TestFailure(f"{arguments} > /dev/full: status {done.returncode}, {done.stderr}")
    reading, writing = os.pipe()
    os.close(reading)
    done = subprocess.run([program, *arguments], cwd=folder, env=driver.environment(), stdout=writing, stderr=subprocess.PIPE, text=True,
                          check=False)
    os.close(writing)
    if done.returncode != 0 or "error" in done.stderr:
        raise driver.TestFailure(f"{arguments} without a reader: status {done.returncode}, {done.stderr}")


def check_list(program, folder):
    text = driver.run_to_the_end(program, ["--new"]).stdout
    geometries, analyses = listed(program)
    for kind, names in (("Type", geometries), ("Analysis", analyses)):
        for name in names:
            if f"\n  {name} " not in text:
                raise driver.TestFailure(f"--new does not list '{name}':\n{text}")
            template = driver.run_to_the_end(program, ["--new", name.replace(" ", "-")]).stdout
            if not any(line.split("#")[0].split() == ["set", kind, "=", *name.split()] for line in template.splitlines()):
                raise driver.TestFailure(f"the template '{name}' does not set {kind} = {name}:\n{template}")
    shown = driver.run(program, ["--new", "gmsh"])
    if "continua --new gmsh.geo > gmsh.geo" not in shown.stderr:
        raise driver.TestFailure(f"nothing about the drawing that the template reads: {shown.stderr}")
    if "Physical Surface" not in driver.run_to_the_end(program, ["--new", "gmsh.geo"]).stdout:
        raise driver.TestFailure("--new gmsh.geo does not print the drawing")

    refused(program, ["--new", "tub"], folder, "'--new tub'", "Did you mean 'tube'?")
    refused(program, ["--new", "tube", "--overwrite"], folder, "no other option")
    refused(program, ["--new", "curved-vessel", "curved-vessel.csv"], folder, "reads a file of this name")
    refused(program, ["--new", "tube", "none/my.prm"], folder, "none/my.prm", "the folder 'none/' does not exist")
    for existing in ("my.prm", "my.geo"):
        path = os.path.join(folder, existing)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write("mine\n")
        refused(program, ["--new", "gmsh", "my.prm"], folder, existing, "overwrites nothing")
        if sorted(os.listdir(folder)) != [existing] or open(path, encoding="utf-8").read() != "mine\n":
            raise driver.TestFailure(f"something was written beside {existing}")
        os.remove(path)

    # Beside the files of another user's template, and with a name that an entry cannot have.
    with open(os.path.join(folder, "gmsh.geo"), "w", encoding="utf-8") as stream:
        stream.write("mine\n")
    driver.run_to_the_end(program, ["--new", "gmsh", "other.prm"], folder=folder)
    if sorted(os.listdir(folder)) != ["gmsh.geo", "other.geo", "other.prm"]:
        raise driver.TestFailure(f"--new gmsh other.prm wrote {os.listdir(folder)}")
    driver.run_to_the_end(program, ["other.prm", "--mesh", "other.vtu"], folder=folder)
    os.remove(os.path.join(folder, "gmsh.geo"))
    driver.run_to_the_end(program, ["--new", "gmsh", "# mine.prm"], folder=folder)
    driver.run_to_the_end(program, ["# mine.prm", "--mesh", "mine.vtu"], folder=folder)

    driver.run_to_the_end(program, ["--new", "beam", "my.prm"], folder=folder)
    for arguments in (["--new"], ["--new", "tube"], ["--print-parameters"], ["my.prm", "--print-parameters=json"], ["my.prm", "--validate"],
                      ["--examples"], ["--version"], ["--help"]):
        full_disk(program, arguments, folder)
    # A wrong file does not keep those behind it from being checked.
    with open(os.path.join(folder, "wrong.prm"), "w", encoding="utf-8") as stream:
        stream.write("set Titel = misspelt\n")
    for ranks in (1, 2):
        done = driver.run(program, ["my.prm", "wrong.prm", "my.prm", "--validate"], ranks=ranks, folder=folder)
        if done.returncode != 2 or done.stdout.count("my.prm: valid\n") != 2 or done.stderr.count("error: wrong.prm:1: ") != 1:
            raise driver.TestFailure(f"--validate of three files: status {done.returncode}, {done.stdout}{done.stderr}")
    if not driver.run_to_the_end(program, ["my.prm", "wrong.prm", "--validate", "--help"], folder=folder).stdout.startswith("Usage:"):
        raise driver.TestFailure("--help beside several files prints no help")
    refused(program, ["my.prm", "--mesh", "none/mesh.vtu"], folder, "none/mesh.vtu", "the folder 'none/' does not exist")
    refused(program, ["my.prm", "--mesh", "mesh.vtk"], folder, ".vtu")
    refused(program, ["my.prm", "--mesh", "mesh.vtu", "--validate"], folder, "excludes --validate")
    refused(program, ["--mesh", "mesh.vtu"], folder, "the parameter file is missing")
    refused(program, ["my.prm", "--mesh", "mesh.vtu", "--set", "Analysis=comparison"], folder, "has no mesh, or several")
    with open(os.path.join(folder, "mesh.vtu"), "w", encoding="utf-8") as stream:
        stream.write("<?xml version=\"1.0\"?>\nother\n")
    refused(program, ["my.prm", "--mesh", "mesh.vtu"], folder, "mesh.vtu", "--mesh did not write it")
    done = driver.run(program, ["my.prm", "--mesh", "of-ranks.vtu"], ranks=2, folder=folder)
    if done.returncode == 0 or "without mpirun" not in done.stderr:
        raise driver.TestFailure(f"--mesh on two ranks: status {done.returncode}, {done.stderr}")


def sizes(path):
    """Boundary -> length [mm] or area [mm^2] of a mesh."""
    import vtk  # of tests of meshes alone
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    names = grid.GetFieldData().GetAbstractArray("boundaries")
    boundary = grid.GetCellData().GetArray("boundary")
    region = grid.GetCellData().GetArray("region")
    n_regions = grid.GetFieldData().GetAbstractArray("regions").GetNumberOfValues()
    quality = vtk.vtkCellSizeFilter()
    quality.SetInputData(grid)
    quality.Update()
    measured = quality.GetOutput().GetCellData()
    result = {}
    for cell in range(grid.GetNumberOfCells()):
        of_boundary = int(boundary.GetTuple1(cell))
        if of_boundary < 0:
            if not 0 <= region.GetTuple1(cell) < n_regions:
                raise driver.TestFailure(f"cell {cell} has no region")
            continue
        is_line = grid.GetCellType(cell) == vtk.VTK_LINE
        size = measured.GetArray("Length" if is_line else "Area").GetTuple1(cell) * (1e3 if is_line else 1e6)
        name = names.GetValue(of_boundary)
        result[name] = result.get(name, 0) + size
    return result


def check_template(program, name, folder):
    driver.run_to_the_end(program, ["--new", name, "my.prm"], folder=folder)
    if name in MEASURES:
        driver.run_to_the_end(program, ["my.prm", "--mesh", "mesh.vtu"], folder=folder)
        found = sizes(os.path.join(folder, "mesh.vtu"))
        expected, tolerance = MEASURES[name]
        for boundary, size in expected.items():
            print(f"{boundary}: {found.get(boundary)}, expected {size}")
            if abs(found.get(boundary, 0) - size) > tolerance * size:
                raise driver.TestFailure(f"the boundary '{boundary}' has the size {found.get(boundary)} instead of {size}")
    done = driver.run_to_the_end(program, ["my.prm"], folder=folder)
    if "warning" in done.stderr + done.stdout:
        raise driver.TestFailure(f"the run of the template warns:\n{done.stderr}")
    with open(os.path.join(folder, "output", "my", "summary.json"), encoding="utf-8") as stream:
        status = json.load(stream)["status"]
    if status != "finished":
        raise driver.TestFailure(f"the summary says '{status}'")


def case(program, template, folder):
    if os.path.isdir(template):
        check_list(program, folder)
    else:
        check_template(program, os.path.splitext(os.path.basename(template))[0].replace("-", " "), folder)


if __name__ == "__main__":
    driver.main(case)
