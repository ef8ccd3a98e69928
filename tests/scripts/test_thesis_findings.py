#!/usr/bin/python3
"""scripts/manual/thesis-findings: verdicts on waves that were made to have or not to have the findings' sign."""

import os
import subprocess
import tempfile
import unittest

import numpy

SCRIPTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts")
PLACES = (0.005, 0.155, 0.305, 0.355, 0.405, 0.455)


def findings(*folders):
    return subprocess.run([os.path.join(SCRIPTS, "manual", "thesis-findings"), *folders], capture_output=True, text=True, check=False)


def write_wave(folder, growth, speed):
    """Pulses by theory that grow by a factor of each field over the tube."""
    time = numpy.arange(0, 0.6, 0.002)
    header, columns = ["time [s]"], [time]
    for place in PLACES:
        for name, unit in (("pressure", "Pa"), ("flow rate", "m^3/s"), ("pressure gradient", "N/m^3"),
                           ("wall distension", "m")):
            header.append(f'"stations {place:g} m: {name}, theory [{unit}]"')
            height = 7.0 * growth.get(name, 1.0)**((place - PLACES[0]) / (PLACES[-1] - PLACES[0]))
            columns.append(height * numpy.exp(-((time - 0.04 - place / speed) / 0.01)**2))
    os.makedirs(folder)
    with open(os.path.join(folder, "wave.csv"), "w", encoding="utf-8") as stream:
        stream.write(",".join(header) + "\n")
        stream.writelines(",".join(f"{value:.9g}" for value in row) + "\n" for row in zip(*columns))


def rows_of(text):
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines() if line.startswith("|")]


class Findings(unittest.TestCase):
    def test_signs(self):
        with tempfile.TemporaryDirectory() as folder:
            folders = [os.path.join(folder, name) for name in "ABCDEF"]
            growth = {"A": 1.0, "B": 1.0, "C": 1.2, "D": 2.0, "E": 2.2, "F": 1.5}
            for name, path in zip("ABCDEF", folders):
                write_wave(path, {"pressure": growth[name], "wall distension": 1 / growth[name]},
                           2.5 if name in "DEF" else 2.0)
            done = findings(*folders)
            self.assertEqual(done.returncode, 0, done.stderr)
            found = {row[1]: row[2:] for row in rows_of(done.stdout)}
            self.assertEqual(found["measure"], ["linear theory", ""])
            self.assertEqual(found["pressure, end: C over A and B"], ["+20.0 %", "agrees"])
            self.assertEqual(found["pressure, end: D over E, matches"], ["-9.1 %", "disagrees"])
            self.assertEqual(found["pressure, end: D and E over F"], ["+33.3 %", "agrees"])
            self.assertEqual(found["speed: F over A"], ["+25.0 %", "agrees"])
            self.assertEqual(found["flow rate, far: A over F"][1].split(",")[1], " weak")
            self.assertEqual(found["wall distension, end: F over D and E"], ["+33.3 %", "agrees"])
            # The same tubes in another order have the other signs.
            turned = {row[1]: row[2:] for row in rows_of(findings(*folders[5:], *folders[1:5], folders[0]).stdout)}
            self.assertEqual(turned["speed: F over A"], ["-20.0 %", "disagrees"])

    def test_missing(self):
        with tempfile.TemporaryDirectory() as folder:
            done = findings(*[folder] * 6)
            self.assertEqual(done.returncode, 1)
            self.assertIn("has no pressure in wave.csv", done.stderr)
        self.assertEqual(findings("one").returncode, 2)
        self.assertEqual(findings("--help").returncode, 0)


if __name__ == "__main__":
    unittest.main()
