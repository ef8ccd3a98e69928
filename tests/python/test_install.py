#!/usr/bin/python3
"""What `cmake --install` puts below a prefix: the package, its version, the program that it finds, and the scripts that use it.
CONTINUA_BUILD is the build."""

import os
import subprocess
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


class Install(unittest.TestCase):
    def test_install(self):
        with tempfile.TemporaryDirectory() as prefix:
            subprocess.run(["cmake", "--install", os.environ["CONTINUA_BUILD"], "--prefix", prefix], check=True, stdout=subprocess.DEVNULL)
            folder = os.path.join(prefix, "lib", "python3", "dist-packages")
            environment = {key: value for key, value in os.environ.items() if key != "CONTINUA_PROGRAM"}
            done = subprocess.run(["/usr/bin/python3", "-B", "-c", "import continua; print(continua.__version__, continua.__file__, "
                                   "continua.find_program(), sep='\\n')"], env={**environment, "PYTHONPATH": folder}, cwd=prefix,
                                  capture_output=True, text=True, check=True)
            with open(os.path.join(ROOT, "VERSION"), encoding="utf-8") as stream:
                version = stream.read().strip()
            self.assertEqual(done.stdout.split(), [version, os.path.join(folder, "continua", "__init__.py"),
                                                   os.path.join(prefix, "bin", "continua")])
            # The commands that draw find the package below any prefix.
            with open(os.path.join(prefix, "probes.csv"), "w", encoding="utf-8") as stream:
                stream.write("time [s],tip: pressure [Pa]\n0,1\n1,2\n")
            environment.pop("PYTHONPATH", None)
            done = subprocess.run([os.path.join(prefix, "bin", "continua-plot"), prefix], env=environment, capture_output=True, text=True,
                                  check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue(os.path.exists(os.path.join(prefix, "plots", "history-pressure.png")), done.stdout)
            installed = set(os.listdir(os.path.join(folder, "continua"))) - {"__pycache__"}
            self.assertEqual(installed, {name for name in os.listdir(os.path.join(ROOT, "python", "continua")) if name.endswith(".py")}
                             | {"VERSION"})


if __name__ == "__main__":
    unittest.main()
