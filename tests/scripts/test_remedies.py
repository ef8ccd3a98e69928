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


if __name__ == "__main__":
    unittest.main()
