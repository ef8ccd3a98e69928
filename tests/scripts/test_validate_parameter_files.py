"""scripts/validate-parameter-files: right files, a wrong one among them, and none that is right."""

import os
import subprocess
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))
BEAM = os.path.join(ROOT, "parameter_files", "new", "beam.prm")
BOX = os.path.join(ROOT, "parameter_files", "new", "box.prm")


def validate(*files):
    return subprocess.run([os.path.join(ROOT, "scripts", "validate-parameter-files"), *files], capture_output=True, text=True,
                          env={**os.environ, "CONTINUA_PROGRAM": PROGRAM}, check=False)


class ValidateParameterFiles(unittest.TestCase):
    def test_right(self):
        done = validate(BEAM, BOX)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("2 of 2 parameter files are valid", done.stdout)

    def test_wrong(self):
        with tempfile.TemporaryDirectory() as folder:
            wrong = os.path.join(folder, "wrong.prm")
            with open(wrong, "w", encoding="utf-8") as stream:
                stream.write("set Titel = misspelt\n")
            for files, n_valid in (((BEAM, wrong, BOX), 2), ((wrong,), 0)):
                done = validate(*files)
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(f"{n_valid} of {len(files)} parameter files are valid", done.stdout)
                self.assertEqual([line.split()[-1] for line in done.stdout.splitlines() if "FAILED" in line], [wrong])
                self.assertIn(f"{wrong}:1: ", done.stderr)


if __name__ == "__main__":
    unittest.main()
