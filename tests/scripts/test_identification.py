"""Analysis = identification from start to end: an interrupted fit goes on, profiles, candidates of a design, a bad region of a number."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))
COMMON = os.path.join(ROOT, "tests", "runs", "studies", "common")
sys.path.insert(0, os.path.join(ROOT, "python"))

import continua  # noqa: E402

# The clock and the place of a station need no new dispersion.
FIT = f"""include {COMMON}/small-tube.prm
set Analysis = identification
subsection Probes
  subsection stations
    set Measured = {COMMON}/small-tube-theory.csv
  end
end
subsection Wave theory
  set Spectral tolerance = 1e-3
end
subsection Identification
  subsection Parameters
    subsection clock
      set Entry = Probes/stations/Measured shift
      set Lower = -2 ms
      set Upper = 2 ms
      set Start = 0.5 ms
    end
    subsection place
      set Entry = Probes/stations/Stations 2
      set Lower = 0.06 m
      set Upper = 0.2 m
      set Start = 0.14 m
    end
  end
  subsection Noise
    set pressure        = 5 Pa
    set wall distension = 0.3 um
  end
  set Correlated noise = as given
  set Tolerance        = 0.1
  set Parallel runs    = 1
end
"""


class Identification(unittest.TestCase):
    def setUp(self):
        self.folder = self.enterContext(tempfile.TemporaryDirectory())

    def run_program(self, text, *arguments):
        file = os.path.join(self.folder, "fit.prm")
        with open(file, "w", encoding="utf-8") as stream:
            stream.write(text)
        return subprocess.run([PROGRAM, file, *arguments], capture_output=True, text=True, check=False, cwd=self.folder,
                              env=continua.program.environment())

    def rows(self, output):
        with open(os.path.join(self.folder, output, "evaluations.csv"), encoding="utf-8") as stream:
            return stream.read().splitlines()

    def test_restart(self):
        """What stands in the checkpoint is not computed again, and the end is the same."""
        whole = self.run_program(FIT, "--output", "whole")
        self.assertEqual(whole.returncode, 0, whole.stdout + whole.stderr)
        rows = self.rows("whole")
        self.assertGreater(len(rows), 12)
        shutil.copytree(os.path.join(self.folder, "whole"), os.path.join(self.folder, "pieces"))
        checkpoint = os.path.join(self.folder, "pieces", "checkpoint", "evaluations")
        with open(checkpoint, encoding="utf-8") as stream:
            lines = stream.readlines()
        # Killed within the tenth evaluation.
        with open(checkpoint, "w", encoding="utf-8") as stream:
            stream.writelines(lines[:10] + [lines[10][:40]])
        done = self.run_program(FIT, "--output", "pieces", "--restart")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("9 evaluations were made before", done.stdout)
        # Those that were kept come without a misfit anew: all rows are as in one piece.
        self.assertEqual(self.rows("pieces"), rows)
        self.assertEqual(*(continua.open(os.path.join(self.folder, output)).quantity("estimate", "place") for output in ("whole", "pieces")))
        other = self.run_program(FIT.replace("0.06 m", "0.07 m").replace("Stations 2", "Stations 1"), "--output", "pieces", "--restart")
        self.assertEqual(other.returncode, 2)
        self.assertIn("it was begun with another input or another program", other.stderr)

    def test_profiles(self):
        """The model is nearly linear in the place: the interval of its profile is that of the standard error."""
        done = self.run_program(FIT, "--set", "Identification/Profiles=true")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        results = continua.open(os.path.join(self.folder, "output", "fit"))
        profiles = results.table("profiles")
        self.assertEqual(sorted(set(profiles["parameter"])), ["clock", "place"])
        of_place = profiles[profiles["parameter"] == "place"].sort_values("value")
        within = of_place[of_place["misfit"] <= of_place["threshold"]]["value"]
        lower, upper = (results.quantity(f"{end} limit", "place") for end in ("lower", "upper"))
        self.assertLess(len(within), len(of_place))
        self.assertGreaterEqual(within.min(), lower - 0.05 * (upper - lower))
        self.assertLessEqual(within.max(), upper + 0.05 * (upper - lower))
        # The bound that is crossed lies close to the end of the interval of the linear model.
        self.assertGreater(of_place["value"].max(), upper - 0.1 * (upper - lower))

    def test_candidates(self):
        """Each pair of three stations is ranked, by the error of the place of the second one, which that station alone shows."""
        done = self.run_program(FIT.replace("Measured = " + COMMON + "/small-tube-theory.csv", "Fields = pressure").replace("  subsection Noise\n", "  subsection Expected noise\n"),
                                "--unset", "Identification/Parameters/clock", "--unset", "Identification/Expected noise/wall distension",
                                "--set", "Probes/stations/Stations=50 mm, 0.1 m, 0.15 m", "--set", "Identification/Correlation time=1 ms",
                                "--set", "Identification/Candidates=stations", "--set", "Identification/Records to add=2",
                                "--set", "Identification/Criterion=place")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        table = continua.open(os.path.join(self.folder, "output", "fit")).table("expected-errors")
        ranked = table[table["rank"] > 0]
        self.assertEqual(len(ranked), 3)
        errors = ranked["place: standard error"].tolist()
        self.assertEqual(errors, sorted(errors))
        # Two pairs have it, and are alike.
        self.assertAlmostEqual(errors[0], errors[1], delta=1e-6 * errors[0])
        self.assertFalse(errors[2] < 1e6)
        for added in ranked["added"].tolist()[:2]:
            self.assertIn("0.1 m: pressure", added)

    def test_bad_region(self):
        """A station beyond the end of the tube: the evaluation is a row with the reason, and the fit goes on without it."""
        # Pressures alone, since the distension falls to zero in a few millimetres before the clamped end of the tube at 0.2 m. The first
        # difference reaches beyond it.
        with open(os.path.join(COMMON, "small-tube-theory.csv"), encoding="utf-8") as stream:
            rows = [line.rsplit(", ", 2)[0] + "\n" for line in stream.readlines()[1:]]
        with open(os.path.join(self.folder, "pressures.csv"), "w", encoding="utf-8") as stream:
            stream.writelines(rows)
        done = self.run_program(FIT.replace(f"{COMMON}/small-tube-theory.csv", "pressures.csv").replace("Upper = 0.2 m", "Upper = 0.3 m")
                                .replace("Start = 0.14 m", "Start = 0.19 m"), "--set", "Identification/Difference step=0.06",
                                "--unset", "Identification/Noise/wall distension")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        failed = [row for row in self.rows("output/fit") if "is outside the tube" in row]
        self.assertTrue(failed, done.stdout)
        self.assertIn(f"{len(failed)} evaluation", done.stdout)
        self.assertIn("of the model failed, and the fit went around", done.stdout)
        self.assertAlmostEqual(continua.open(os.path.join(self.folder, "output", "fit")).quantity("estimate", "place"), 0.15, delta=1e-3)


if __name__ == "__main__":
    unittest.main()
