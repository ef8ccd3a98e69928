"""`continua --validate FILES`: right files, a wrong one among them, and none that is right."""

import os
import subprocess
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))
BEAM = os.path.join(ROOT, "parameter_files", "new", "beam.prm")
BOX = os.path.join(ROOT, "parameter_files", "new", "box.prm")


def validate(*files):
    """The finished process, and the files that it says are valid."""
    done = subprocess.run([PROGRAM, "--validate", *files], capture_output=True, text=True, check=False)
    return done, [line.removesuffix(": valid") for line in done.stdout.splitlines() if line.endswith(": valid")]


class Validate(unittest.TestCase):
    def test_right(self):
        done, valid = validate(BEAM, BOX)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(valid, [BEAM, BOX])

    def test_wrong(self):
        with tempfile.TemporaryDirectory() as folder:
            wrong = os.path.join(folder, "wrong.prm")
            with open(wrong, "w", encoding="utf-8") as stream:
                stream.write("set Titel = misspelt\n")
            for files, right in (((BEAM, wrong, BOX), [BEAM, BOX]), ((wrong,), [])):
                done, valid = validate(*files)
                self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
                self.assertEqual(valid, right)
                self.assertIn(f"{wrong}:1: ", done.stderr)


if __name__ == "__main__":
    unittest.main()
