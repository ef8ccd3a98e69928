#!/usr/bin/python3
"""Sensitivities of harmonic responses against differences of whole runs: a tube of liquid in a wall that relaxes, whose end absorbs, in
axisymmetry; the same on a support, with a given flow rate before a windkessel; and a block in space under its weight and two pressures with
phases. Entries are changed by 0.1 % up and down, and both runs are compared with the table, for probes of all kinds: points, means, integrals,
flow rates, stresses."""

import csv
import os
import re
import subprocess
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))
STEP = 1e-3

TUBE = """
set Analysis = harmonic
set Model    = axisymmetric
subsection Geometry
  set Type           = tube
  set Law            = uniform
  set Inner diameter = 20 mm
  set Wall thickness = 2 mm
  set Length         = 60 mm
end
subsection Mesh
  set Axial cells  = 4
  set Radial cells = 2
  set Wall cells   = 1
end
subsection Materials
  subsection fluid
    set Type         = newtonian
    set Density      = 1060 kg/m^3
    set Viscosity    = 40 mPa s
    set Bulk modulus = 0.1 GPa
  end
  subsection wall
    set Type                  = prony
    set Density               = 1100 kg/m^3
    set Young's modulus       = 1.2 MPa
    set Poisson's ratio       = 0.45
    set Shear moduli          = 0.2 MPa, 0.1 MPa
    set Relaxation times      = 5 ms, 50 ms
    set Volumetric relaxation = own branches
    set Bulk moduli           = 3 MPa
    set Bulk relaxation times = 10 ms
  end
end
subsection Boundaries
  subsection inlet
    set Type     = pressure
    set Pressure = 100 Pa
  end
  subsection wall inlet end
    set Type = fixed
  end
  subsection outlet
    set Type = absorbing
  end
  subsection wall outlet end
    set Type = absorbing
  end
  subsection outside
    set Type = free
  end
  subsection axis
    set Type = axis
  end
end
subsection Harmonic
  set Frequencies = 7 Hz
  subsection Sensitivities
    set Entries = all
  end
end
subsection Probes
  subsection tube
    set Stations = 20 mm, 25 mm, 30 mm, 35 mm, 40 mm
    set Fields   = pressure, flow rate, wall distension
  end
  subsection wall
    set Point  = 25 mm, 11 mm
    set Region = wall
    set Fields = stress xx, stress zz, strain xx
  end
end
"""

BLOCK = """
set Analysis = harmonic
set Model    = three-dimensional
subsection Geometry
  set Type = box
  set Size = 30 mm, 10 mm, 10 mm
end
subsection Mesh
  set Cells = 2, 1, 1
end
subsection Materials
  subsection body
    set Type            = kelvin-voigt
    set Density         = 1100 kg/m^3
    set Young's modulus = 1 MPa
    set Poisson's ratio = 0.5
    set Viscosity       = 200 Pa s
  end
end
subsection Body force
  set Acceleration = 1 m/s^2, 3 m/s^2, 0
  set Phase        = 10 deg
end
subsection Boundaries
  subsection left
    set Type = fixed
  end
  subsection right
    set Type     = pressure
    set Pressure = 20 Pa
    set Phase    = 90 deg
  end
  subsection bottom
    set Type = roller
  end
  subsection top
    set Type     = pressure
    set Pressure = 5 Pa
  end
  subsection front
    set Type = free
  end
  subsection back
    set Type = free
  end
end
subsection Harmonic
  set Frequencies = 4 Hz
  subsection Sensitivities
    set Entries = all
  end
end
subsection Probes
  subsection tip
    set Point  = 30 mm, 5 mm, 5 mm
    set Fields = displacement x, velocity y, pressure, stress xy
  end
  subsection face
    set Boundary = right
    set Fields   = displacement x
  end
end
"""


class Sensitivities(unittest.TestCase):
    def run_case(self, folder, text, name, changes=()):
        file = os.path.join(folder, "case.prm")
        with open(file, "w", encoding="utf-8") as stream:
            stream.write(text)
        output = os.path.join(folder, name)
        command = [PROGRAM, file, "--output", output, "--overwrite"]
        for change in changes:
            command += ["--set", change]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return output

    @staticmethod
    def table(folder, name):
        with open(os.path.join(folder, name), encoding="utf-8", newline="") as stream:
            return list(csv.DictReader(stream))

    def responses(self, folder):
        """Complex responses by "PROBE: FIELD"."""
        row, = self.table(folder, "response.csv")
        result = {}
        for column, text in row.items():
            if " real part [" in column:
                name, unit = column.split(" real part [")
                result[name] = complex(float(text), float(row[f"{name} imaginary part [{unit}"]))
        return result

    def compare(self, text, least_entries, bound=""):
        with tempfile.TemporaryDirectory() as folder:
            rows = self.table(self.run_case(folder, text, "base"), "sensitivities.csv")
            without = re.sub(r"  subsection Sensitivities\n.*\n  end\n", "", text)
            entries = {row["entry"]: row for row in rows}
            self.assertGreaterEqual(len(entries), least_entries)
            n_compared = 0
            for path, any_row in entries.items():
                if path == bound:
                    continue
                answers = []
                for sign in (-1, 1):
                    value = float(any_row["value"]) * (1 + sign * STEP)
                    unit = "" if any_row["unit of the entry"] == "1" else " " + any_row["unit of the entry"]
                    answers.append(self.responses(self.run_case(folder, without, "changed", [self.setting(path, value, unit, text)])))
                for row in rows:
                    name = f"{row['probe']}: {row['response']}"
                    if row["entry"] != path or name not in answers[0]:
                        continue
                    n_compared += 1
                    ratio = answers[1][name] / answers[0][name]
                    amplitude = (abs(answers[1][name]) - abs(answers[0][name])) / (2 * STEP * float(row["amplitude"]))
                    phase = ratio.imag / abs(ratio) / (2 * STEP)
                    self.assertAlmostEqual(float(row["logarithmic sensitivity [1]"]), amplitude, delta=2e-5 * (1 + abs(amplitude)), msg=f"{path} {name}")
                    self.assertAlmostEqual(float(row["phase by logarithm of entry [rad]"]), phase, delta=2e-5 * (1 + abs(phase)), msg=f"{path} {name}")
            # Each file has five responses or more (a tube 18, so that not all adjoint solutions are there at once); only waves are none of
            # the other table.
            self.assertGreaterEqual(n_compared, 5 * (least_entries - (1 if bound else 0)))

    @staticmethod
    def setting(path, value, unit, text):
        key, _, place = path.rpartition(" ")
        if not place.isdigit():
            return f"{path}={value!r}{unit}"
        last = key.rsplit("/", 1)[1]
        line = next(line for line in text.splitlines() if line.strip().startswith("set " + last + " "))
        items = [item.strip() for item in line.split("=", 1)[1].split(",")]
        items[int(place) - 1] = f"{value!r}{unit}"
        return f"{key}={', '.join(items)}"

    @staticmethod
    def with_section(text, name, lines):
        """The text with another section of a boundary."""
        section = f"  subsection {name}\n" + "".join(f"    set {line}\n" for line in lines) + "  end\n"
        result, n_found = re.subn(rf"  subsection {name}\n(    set .*\n)*  end\n", section, text)
        assert n_found == 1, name
        return result

    def test_absorbing_end(self):
        self.compare(TUBE, 12)

    def test_tube(self):
        self.compare(self.tube_on_support(), 6)

    def tube_on_support(self):
        sections = {"inlet": ["Type = flow rate", "Profile = parabolic", "Flow rate = 2 ml/s", "Phase = 20 deg"],
                    "outlet": ["Type = windkessel", "Proximal resistance = 2e7 Pa s/m^3", "Distal resistance = 5e7 Pa s/m^3",
                               "Compliance = 1e-9 m^3/Pa"],
                    "wall outlet end": ["Type = fixed"],
                    "outside": ["Type = support", "Normal stiffness = 20 MPa/m", "Normal damping = 10 kPa s/m",
                                "Tangential stiffness = 1 MPa/m"]}
        text = TUBE
        for name, lines in sections.items():
            text = self.with_section(text, name, lines)
        # The materials are those of the other tube.
        entries = ["inlet/Flow rate", "inlet/Phase", "outlet/Distal resistance", "outlet/Compliance", "outside/Normal stiffness",
                   "outside/Normal damping"]
        return text.replace("Entries = all", "Entries = " + ", ".join("Boundaries/" + entry for entry in entries))

    def test_block_in_space(self):
        """Poisson's ratio 0.5 is at its bound, so that no run has more."""
        self.compare(BLOCK, 10, bound="Materials/body/Poisson's ratio")


if __name__ == "__main__":
    unittest.main()
