#!/usr/bin/python3
"""scripts/measure/harmonics-of-a-network: a tube that ends in its own impedance, the mean pressure of a windkessel, and what is refused."""

import math
import os
import re
import subprocess
import tempfile
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SCRIPT = os.path.join(ROOT, "scripts", "measure", "harmonics-of-a-network")
RADIUS, THICKNESS, MODULUS, DENSITY = 0.01, 0.001, 4e5, 1000.0
AREA = math.pi * RADIUS**2
SPEED = math.sqrt(MODULUS * THICKNESS / (1.5 * DENSITY * RADIUS))  # of a thin wall with Poisson's ratio 0.5, held along its axis
IMPEDANCE = DENSITY * SPEED / AREA
AMPLITUDE = 1000.0 / IMPEDANCE
MATCHED = f"set Type = resistance\nset Resistance = {IMPEDANCE!r} Pa s/m^3"
WINDKESSEL = "set Type = windkessel\nset Proximal resistance = 20 MPa s/m^3\nset Distal resistance = 80 MPa s/m^3\nset Compliance = 10 mm^3/Pa"


class HarmonicsOfANetwork(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def run_script(self, end, mean=0.0, further=""):
        with open(os.path.join(self.folder.name, "flow.csv"), "w", encoding="utf-8") as table:
            table.write("time [s], flow [m^3/s]\n")
            for i in range(101):
                table.write(f"{i / 100}, {mean + AMPLITUDE * math.sin(2 * math.pi * i / 100)!r}\n")
        file = os.path.join(self.folder.name, "tube.prm")
        with open(file, "w", encoding="utf-8") as text:
            text.write(f"""set Analysis = nonlinear wave theory
subsection Network
  set Density = {DENSITY} kg/m^3
  set Viscosity = 0 Pa s
  set Period = 1 s
  set Wall theory = thin
  {further}
  subsection Vessels
    subsection tube
      set From = start
      set To = end
      set Length = 1 m
      set Radius at start = {RADIUS} m
      set Wall thickness at start = 1 mm
      set Young's modulus = 400 kPa
    end
  end
  subsection Terminals
    subsection start
      set Type = flow rate
      set Waveform = table
      set Table = flow.csv
    end
    subsection end
      {end}
    end
  end
  subsection Stations
    subsection end
      set Vessel = tube
      set Position = 1 m
    end
  end
end
""")
        return subprocess.run([SCRIPT, file, "--harmonics", "20", "--pieces", "3"], capture_output=True, text=True)

    def numbers(self, run):
        self.assertEqual(run.returncode, 0, run.stderr)
        found = re.search(r"pressure mean (\S+) Pa.*range (\S+) Pa; flow rate mean (\S+) ml/s, range (\S+) ml/s", run.stdout)
        return [float(number) for number in found.groups()]

    def test_matched_tube(self):
        _, pressure, _, flow = self.numbers(self.run_script(MATCHED))
        self.assertAlmostEqual(pressure, 2000.0, delta=2.0)
        self.assertAlmostEqual(flow, 2e6 * AMPLITUDE, delta=2e3 * AMPLITUDE)

    def test_windkessel(self):
        mean, _, flow, _ = self.numbers(self.run_script(WINDKESSEL, mean=1e-5))
        self.assertAlmostEqual(mean, 1000.0, delta=1.0)
        self.assertAlmostEqual(flow, 10.0, delta=0.01)

    def test_what_is_refused(self):
        for end, further, message in ((MATCHED, "set Friction = womersley", "'Network/Friction = womersley' is not in this linear check"),
                                      (MATCHED, "set Damping time = 1 ms", "'Network/Damping time = 1 ms' is not"),
                                      (MATCHED + "\nset Pressure behind = 1 kPa", "", "'Network/Terminals/end/Pressure behind = 1 kPa' is not"),
                                      ("set Type = absorbing", "", "a terminal of the type 'absorbing' is not"),
                                      (MATCHED, "set Reference pressure = 70 mmHg", "'70 mmHg' is no number with a unit of this script"),
                                      (MATCHED, "include other.prm", "'include other.prm': this script reads no other file")):
            run = self.run_script(end, further=further)
            self.assertEqual(run.returncode, 1)
            self.assertTrue(run.stderr.startswith("error: ") and message in run.stderr, run.stderr)
            self.assertNotIn("Traceback", run.stderr)
        self.numbers(self.run_script(MATCHED + "\nset Pressure behind = 0 kPa", further="set Poisson's ratio = 0.50"))


if __name__ == "__main__":
    unittest.main()
