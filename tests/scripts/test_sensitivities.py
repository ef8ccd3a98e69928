#!/usr/bin/python3
"""Sensitivities of harmonic responses against differences of whole runs: a tube of liquid in a wall that relaxes, whose end absorbs, in
axisymmetry; the same on a support, with a given flow rate before a windkessel; and a block in space under its weight and two pressures with
phases. Entries are changed by 0.1 % up and down, and both runs are compared with the table, for probes of all kinds: points, means, integrals,
flow rates, stresses. One call of the program performs all runs of a case, since its start takes as long as a run."""

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
    def run_cases(self, folder, texts):
        """Performs the texts by name. The folders of their results by name."""
        for name, text in texts.items():
            with open(os.path.join(folder, f"{name}.prm"), "w", encoding="utf-8") as stream:
                stream.write(text)
        command = [PROGRAM, *(os.path.join(folder, f"{name}.prm") for name in texts), "--output", folder]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return {name: os.path.join(folder, name) for name in texts}

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

    def compare(self, text, entries, n_responses):
        """`entries`: paths of entries of the text, with the value that it gives them, in the unit of the table."""
        listed = text.replace("Entries = all", "Entries = " + ", ".join(entries))
        without = re.sub(r"  subsection Sensitivities\n.*\n  end\n", "", text)
        texts = {"base": listed}
        for i, path in enumerate(entries):
            for sign in (-1, 1):
                texts[f"{'more' if sign > 0 else 'less'}-{i}"] = self.changed(without, path, 1 + sign * STEP)
        with tempfile.TemporaryDirectory() as folder:
            outputs = self.run_cases(folder, texts)
            rows = self.table(outputs["base"], "sensitivities.csv")
            for i, path in enumerate(entries):
                answers = [self.responses(outputs[f"{which}-{i}"]) for which in ("less", "more")]
                # Waves are in the table, too, but are no responses of the other one.
                of_entry = {f"{row['probe']}: {row['response']}": row for row in rows if row["entry"] == path}
                names = set(of_entry) & set(answers[0])
                self.assertEqual(len(names), n_responses, path)
                for name in names:
                    row = of_entry[name]
                    ratio = answers[1][name] / answers[0][name]
                    amplitude = (abs(answers[1][name]) - abs(answers[0][name])) / (2 * STEP * float(row["amplitude"]))
                    phase = ratio.imag / abs(ratio) / (2 * STEP)
                    self.assertAlmostEqual(float(row["logarithmic sensitivity [1]"]), amplitude, delta=2e-5 * (1 + abs(amplitude)), msg=f"{path} {name}")
                    self.assertAlmostEqual(float(row["phase by logarithm of entry [rad]"]), phase, delta=2e-5 * (1 + abs(phase)), msg=f"{path} {name}")

    @staticmethod
    def changed(text, path, factor):
        """The text with that entry times the factor; of a list the number whose place the path ends with."""
        names = path.split("/")
        key, _, place = names[-1].rpartition(" ")
        if not place.isdigit():
            key, place = names[-1], "1"
        sections, lines = [], []
        for line in text.splitlines():
            words = line.split()
            if words[:1] == ["subsection"]:
                sections.append(" ".join(words[1:]))
            elif words == ["end"]:
                sections.pop()
            elif sections == names[:-1] and re.match(rf"set {re.escape(key)}\s*=", line.strip()):
                begin, numbers = line.split("=", 1)
                items = numbers.split(",")
                number, _, unit = items[int(place) - 1].strip().partition(" ")
                items[int(place) - 1] = f" {float(number) * factor!r} {unit}"
                line = f"{begin}={','.join(items)}"
            lines.append(line)
        changed = "\n".join(lines) + "\n"
        assert changed != text, path
        return changed

    @staticmethod
    def with_section(text, name, lines):
        """The text with another section of a boundary."""
        section = f"  subsection {name}\n" + "".join(f"    set {line}\n" for line in lines) + "  end\n"
        result, n_found = re.subn(rf"  subsection {name}\n(    set .*\n)*  end\n", section, text)
        assert n_found == 1, name
        return result

    def test_absorbing_end(self):
        self.compare(TUBE, ["Materials/wall/Young's modulus", "Materials/wall/Shear moduli 2", "Materials/fluid/Density", "Materials/fluid/Viscosity"], 18)

    def test_tube_on_support(self):
        boundaries = ["inlet/Flow rate", "inlet/Phase", "outlet/Distal resistance", "outlet/Compliance", "outside/Normal stiffness",
                      "outside/Normal damping"]
        self.compare(self.tube_on_support(), [f"Boundaries/{entry}" for entry in boundaries], 18)

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
        return text

    def test_block_in_space(self):
        self.compare(BLOCK, ["Materials/body/Density", "Materials/body/Young's modulus", "Materials/body/Viscosity", "Body force/Acceleration 2",
                             "Body force/Phase", "Boundaries/right/Phase"], 5)


if __name__ == "__main__":
    unittest.main()
