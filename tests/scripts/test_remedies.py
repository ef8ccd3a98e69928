"""Remedies of messages, followed to the letter: what a message says is written into the input, which is then valid."""

import os
import re
import subprocess
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))

SQUARE = """Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {1, 1, 0}; Point(4) = {0, 1, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve{1 : 4} = 3; Transfinite Surface{1}; Recombine Surface{1};
Physical Surface("NAME") = {1}; Physical Curve("left") = {4}; Physical Curve("others") = {1, 2, 3};
"""
CASE = """set Analysis = steady
set Model    = plane strain
subsection Geometry
  set Type = gmsh
  set File = square.geo
end
subsection Materials
  subsection WRITTEN
    set Type            = hookean
    set Density         = 1000 kg/m^3
    set Young's modulus = 1 MPa
    set Poisson's ratio = 0.3
  end
end
subsection Boundaries
  subsection left
    set Type = fixed
  end
  subsection others
    set Type     = pressure
    set Pressure = PRESSURE
  end
end
"""
TUBE = """set Analysis = transient
set Model    = axisymmetric
subsection Geometry
  set Type           = tube
  set Law            = uniform
  set Inner diameter = 20 mm
  set Length         = 50 mm
  set Wall layers    = none
end
subsection Mesh
  set Axial cells  = 2
  set Radial cells = 2
end
subsection Materials
  subsection fluid
    set Type         = newtonian
    set Density      = 1060 kg/m^3
    set Viscosity    = 4 mPa s
    set Bulk modulus = 2.2 GPa
  end
end
subsection Boundaries
  subsection inlet
    set Type     = flow rate
    set Waveform = table
    set Table    = flow.csv
  end
  subsection outlet
    set Type       = resistance
    set Resistance = 100 MPa s/m^3
  end
  subsection outside
    set Type = fixed
  end
  subsection axis
    set Type = axis
  end
end
subsection Time
  set Scheme    = backward differencing
  set Time step = 5 ms
  set End time  = 50 ms
end
subsection Probes
  subsection out
    set Boundary = outlet
    set Fields   = pressure
  end
end
"""
MESH = """$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
9
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0.5 0 0
6 1 0.5 0
7 0.5 1 0
8 0 0.5 0
9 0.5 0.5 0
$EndNodes
$Elements
5
1 1 2 1 1 1 2
2 1 2 2 2 2 3
3 1 2 2 2 3 4
4 1 2 2 2 4 1
5 3 2 3 3 1 2 3 4
$EndElements
"""
PLATE = """set Analysis = steady
set Model    = plane strain
subsection Geometry
  set Type = gmsh
  set File = plate.msh
end
subsection Materials
  subsection 3
    set Type            = hookean
    set Density         = 1000 kg/m^3
    set Young's modulus = 1 MPa
    set Poisson's ratio = 0.3
  end
end
subsection Boundaries
  subsection 1
    set Type = fixed
  end
  subsection 2
    set Type = free
  end
end
"""
ROWS = "0.000 2.0\n0.025 2.5\n0.050 3.0\n"


def replaced(text, *pairs):
    for old, new in pairs:
        if old not in text:
            raise ValueError(f"'{old}' is not there")
        text = text.replace(old, new)
    return text


def of_table(table):
    return {"case.prm": TUBE, "flow.csv": table}


def with_factor(files):
    return replaced(files["case.prm"], ("flow.csv\n", "flow.csv\n    set Table factor = -1\n"))


def below_a_comment(files, found):
    """A header in the unit that the message lists, below the lines that get a '#', and the sign by the entry that it names."""
    first, rest = files["flow.csv"].split("\n", 1)
    header = found[1].replace("[ml/s]", "[cm^3/s]")
    assert "cm^3/s" in found[2] and found[3] == "Table factor"
    return {"case.prm": with_factor(files), "flow.csv": f"#{first}\n{header}\n{rest}"}


def above_the_rows(files, found):
    assert "cm^3/s" in found[2] and found[3] == "Table factor"
    return {"case.prm": with_factor(files), "flow.csv": found[1].replace("[ml/s]", "[cm^3/s]") + "\n" + files["flow.csv"]}


def below_comments(files, found):
    lines = files["flow.csv"].splitlines()
    n = int(found[1])
    return {**files, "flow.csv": "\n".join(["#" + line for line in lines[:n]] + [found[2]] + lines[n:]) + "\n"}


def by_command(files, found):
    """What the command of the message makes of the table."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "FILE"), "w", encoding="utf-8") as stream:
            stream.write(files["flow.csv"])
        subprocess.run(found[1], shell=True, check=True, cwd=folder)
        with open(os.path.join(folder, "NEW"), encoding="utf-8") as stream:
            return {**files, "flow.csv": stream.read()}


def in_the_geometry(files, found):
    return {**files, "case.prm": replaced(files["case.prm"], ("plate.msh\n", f"plate.msh\n  set {found[1]}\n"))}


def with_boundary(name):
    def change(files, found):
        entry = found[1].replace("NAME", name)
        text = in_the_geometry(files, {1: entry})["case.prm"]
        return {**files, "case.prm": replaced(text, ("Boundaries\n", f"Boundaries\n  subsection {name}\n    set Type = free\n  end\n"))}

    return change


def of_mesh(*pairs):
    return {"case.prm": PLATE, "plate.msh": replaced(MESH, *pairs)}


# 16 nodes: nothing but the corners is looked at.
THIRD_ORDER = ("5 3 2 3 3 1 2 3 4", "5 36 2 3 3 1 2 3 4 5 6 7 8 9 5 6 7 8 9 5 6")

# Name, files, what the message says, what is made of the files.
CASES = [
    ("a table that counts its rows, in cm^3/s and out of the body", of_table("3 16\n" + ROWS),
     r"Write '#' before this line, insert a line such as '(.*?)' with the names and units of the columns \((.*?)\) below it, and "
     r"keep all rows\. '(.*?)' multiplies the values: -1", below_a_comment),
    ("a table without a header, in cm^3/s and out of the body", of_table(ROWS),
     r"Insert a line such as '(.*?)' with the names and units of the columns \((.*?)\) above this line, and keep this line\. "
     r"'(.*?)' multiplies the values: -1", above_the_rows),
    ("lines before the rows", of_table("Interval=\t0.025 s\nRange=\t1 ml/s\n" + ROWS.replace(" ", "\t")),
     r"the (\d) lines before .* '#' before each of them, and insert a line such as '(.*?)' with", below_comments),
    ("decimal commas", of_table("t [s]; Q [ml/s]\n" + ROWS.replace(" ", "; ").replace(".", ",")),
     r"has a decimal comma\. .*'(tr .*?)' does", by_command),
    ("rows in brackets", of_table("time [s] flow [ml/s]\n" + ROWS.replace("0.", "(0.").replace("\n", ")\n")),
     r'brackets, as "(tr .*?)" does', by_command),
    ("an index before the time", of_table(",t [s],Q [ml/s]\n0,0,2\n1,0.05,3\n"),
     r"Remove this column, as '(cut .*?)' does", by_command),
    ("a header without units", of_table("t,Q\n0,2\n0.05,3\n"), r"Write the header as '(t) \[UNIT\]' with .*\((s), ",
     lambda files, found: {**files, "flow.csv": replaced(files["flow.csv"], ("t,Q", f"{found[1]} [{found[2]}],Q [ml/s]"))}),
    ("an unknown unit", of_table("t [s], Q [gpm]\n0,2\n0.05,3\n"), r"unit 'gpm' is unknown.*\(.*(ml/s).*'(Table factor)'.*converts a unit",
     lambda files, found: {"case.prm": with_factor(files), "flow.csv": replaced(files["flow.csv"], ("gpm", found[1]))}),
    ("a mesh of third order", of_mesh(THIRD_ORDER), r"or '(Straighten curved elements = true)'", in_the_geometry),
    ("a cell in no group", of_mesh(("5 3 2 3 3 1", "5 3 2 0 3 1")), r"set '(Ungrouped cells = )NAME'",
     lambda files, found: in_the_geometry(files, {1: found[1] + "3"})),
    ("a face in no group", of_mesh(("4 1 2 2 2 4 1", "4 1 2 0 2 4 1")), r"set '(Ungrouped faces = NAME)'", with_boundary("rest")),
    ("a group inside", of_mesh(("5\n1 1", "6\n6 1 2 7 7 2 4\n1 1")), r"Set '(Ignored groups = 7)'", in_the_geometry),
    ("a face in two groups", of_mesh(("$Elements\n5", "$Elements\n6"), ("3 3 1 2 3 4\n", "3 3 1 2 3 4\n6 1 2 8 8 1 2\n")),
     r"set '(Ignored groups = 8)'", in_the_geometry),
]


class Remedies(unittest.TestCase):
    def setUp(self):
        self.folder = self.enterContext(tempfile.TemporaryDirectory())

    def validate(self, region, written, pressure="1 Pa", *options):
        for name, text in (("square.geo", SQUARE.replace("NAME", region)),
                           ("case.prm", CASE.replace("WRITTEN", written).replace("PRESSURE", pressure))):
            with open(os.path.join(self.folder, name), "w", encoding="utf-8") as stream:
                stream.write(text)
        return subprocess.run([PROGRAM, "case.prm", "--validate", *options], capture_output=True, text=True, check=False, cwd=self.folder)

    def follow(self, run, pattern):
        """What a message of a run tells to write."""
        self.assertEqual(run.returncode, 2, run.stdout + run.stderr)
        found = re.search(pattern, run.stderr)
        self.assertIsNotNone(found, run.stderr)
        return found.group(1)

    def accept(self, run):
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_name_that_a_comment_cuts(self):
        written = self.follow(self.validate("wall#1", "wall#1"), "Did you mean '(.*?)'\\?")
        self.accept(self.validate("wall#1", written))

    def test_name_with_a_slash_on_the_command_line(self):
        region = "Wand/innen"
        given = self.validate(region, region, "1 Pa", "--set", f"Materials/{region}/Density=900 kg/m^3")
        self.follow(given, "(A name that has a '/' or a '=' stands between double quotes)")
        self.accept(self.validate(region, region, "1 Pa", "--set", f'Materials/"{region}"/Density=900 kg/m^3'))

    def test_name_with_an_equals_sign_on_the_command_line(self):
        region = "x=1"
        given = self.validate(region, region, "1 Pa", "--unset", f"Materials/{region}/Density")
        self.follow(given, "(a name with a '=' stands between double quotes)")
        self.accept(self.validate(region, region, "1 Pa", "--unset", f'Materials/"{region}"/Density',
                                  "--set", f'Materials/"{region}"/Density=900 kg/m^3'))

    def test_name_that_is_a_comment(self):
        written = self.follow(self.validate("#1", "#1"), "'subsection (\"#1\")'")
        self.accept(self.validate("#1", written))

    def test_comparison_of_three(self):
        pattern = "if({}, 1000, 0)"
        remedy = self.follow(self.validate("wall", "wall", pattern.format("0.5 < t < 0.9")), "Write (.*?), or brackets")
        condition = remedy.replace("a <", "0.5 <").replace("< b", "< 0.9")
        # The steady state is that of the loads at t = 0 then.
        self.accept(self.validate("wall", "wall", pattern.format(condition)))

    def answers(self, files_of_cases):
        """What the program says of each of many cases, of which it checks all in one call."""
        for name, files in files_of_cases.items():
            os.makedirs(os.path.join(self.folder, name), exist_ok=True)
            for file, text in files.items():
                with open(os.path.join(self.folder, name, file), "w", encoding="utf-8") as stream:
                    stream.write(text)
        run = subprocess.run([PROGRAM, "--validate", *(f"{name}/case.prm" for name in files_of_cases)], stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, text=True, check=False, cwd=self.folder)
        answers = re.split(r"^(?=error: |\S.*: valid$)", run.stdout, flags=re.M)[1:]
        self.assertEqual(len(answers), len(files_of_cases), run.stdout)
        return dict(zip(files_of_cases, answers))

    def test_remedies_of_tables_and_meshes(self):
        before = self.answers({name: files for name, files, _, _ in CASES})
        changed = {}
        for name, files, pattern, change in CASES:
            with self.subTest(name):
                self.assertTrue(before[name].startswith("error: "), before[name])
                found = re.search(pattern, before[name])
                self.assertIsNotNone(found, before[name])
                changed[name] = change(files, found)
        for name, answer in self.answers(changed).items():
            with self.subTest(name):
                self.assertFalse(answer.startswith("error: "), answer)


if __name__ == "__main__":
    unittest.main()
