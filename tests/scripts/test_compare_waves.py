#!/usr/bin/python3
"""scripts/compare-waves takes the stations that two runs share, the times of the run, and simulated or theoretical values."""

import os
import subprocess
import tempfile
import unittest

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "compare-waves")


def table(times, columns):
    lines = [",".join(['"time [s]"'] + [f'"{name}"' for name in columns])]
    lines += [",".join(str(column[i]) for column in [times, *columns.values()]) for i in range(len(times))]
    return "\n".join(lines) + "\n"


class CompareWaves(unittest.TestCase):
    def compare(self, tables, *options):
        """(exit status, what it printed) for the wave.csv of runs, the first one being the reference."""
        with tempfile.TemporaryDirectory() as root:
            folders = []
            for name, text in tables.items():
                folders.append(os.path.join(root, name))
                os.makedirs(folders[-1])
                with open(os.path.join(folders[-1], "wave.csv"), "w", encoding="utf-8") as stream:
                    stream.write(text)
            done = subprocess.run([SCRIPT, *options, *folders], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    REFERENCE = table([0, 2, 4], {"tube 0.1 m: pressure, simulated [Pa]": [0, 100, 0],
                                  "tube 0.1 m: pressure, theory [Pa]": [0, 200, 0],
                                  "tube 0.1 m: backward wave, simulated [Pa]": [9, 9, 9],
                                  "tube 0.2 m: pressure, simulated [Pa]": [0, -200, 0]})

    def test_between_the_times_of_the_reference(self):
        # At 1 s the reference is 50: 10 of 200.
        status, text = self.compare({"reference": self.REFERENCE, "run": table(
            [1, 2], {"tube 0.1 m: pressure, simulated [Pa]": [60, 100], "tube 0.3 m: pressure, simulated [Pa]": [7, 7]})})
        self.assertEqual(status, 0)
        self.assertIn("| run | pressure |\n", text)
        self.assertIn("| run | 10.00 % |", text)

    def test_theory(self):
        status, text = self.compare({"reference": self.REFERENCE, "run": table(
            [2], {"tube 0.1 m: pressure, simulated [Pa]": [190]})}, "--theory")
        self.assertEqual(status, 0)
        self.assertIn("| run | 5.00 % |", text)

    def test_nothing_in_common(self):
        status, text = self.compare({"reference": self.REFERENCE, "run": table(
            [2], {"tube 0.3 m: pressure, simulated [Pa]": [190]})})
        self.assertEqual(status, 1)
        self.assertIn("no station in common", text)

    def test_no_table(self):
        done = subprocess.run([SCRIPT, "/nowhere", "/nowhere"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("/nowhere: there is no such folder", done.stderr)


if __name__ == "__main__":
    unittest.main()
