"""What is installed and said of the program agrees: the manual page has every option, --examples lists shipped files."""

import os
import re
import subprocess
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))


def printed(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=True).stdout


class Installed(unittest.TestCase):
    def test_manual_page(self):
        with open(os.path.join(ROOT, "doc", "continua.1.in"), encoding="utf-8") as stream:
            page = stream.read().replace("\\-", "-")
        options = set(re.findall(r"--[a-z][a-z-]+", printed("--help")))
        self.assertGreater(len(options), 10)
        self.assertEqual({option for option in options if option not in page}, set())

    def test_scripts(self):
        """continua report and continua plot are the scripts, with their arguments and their exit status."""
        for name in ("report", "plot"):
            done = subprocess.run([PROGRAM, name, "/nonexistent"], capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stderr.partition(":")[0]), (1, "error"))
            self.assertIn("/nonexistent: there is no such folder", done.stderr)
            self.assertIn(f"scripts/{name} OUTPUT_DIR", printed(name, "--help"))

    def test_file_of_the_command_line(self):
        """The remedy names what a file on the command line is relative to."""
        template = os.path.join(ROOT, "parameter_files", "new", "gmsh.prm")
        done = subprocess.run([PROGRAM, template, "--set", "Geometry/File=nothere.geo", "--validate"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("on the command line it is relative to the working directory", done.stderr)

    def test_examples(self):
        text = printed("--examples")
        folder = re.match(r"Parameter files in (.*):\n", text).group(1)
        listed = set(re.findall(r"^  (\S.*\.prm)$", text, re.M))
        shipped = {os.path.relpath(os.path.join(at, name), folder) for at, _, names in os.walk(folder) for name in names
                   if name.endswith(".prm") and os.path.basename(at) != "common"}
        self.assertEqual(listed, shipped)
        self.assertIn(os.path.join("examples", "own-tube.prm"), listed)
        self.assertIn("      A silicone tube and a pressure pulse that was measured at its inlet: copy this file to begin with a tube of your own.\n", text)
        # A sentence of two lines.
        self.assertIn("      A pressure pulse in an artery with an aneurysm whose wall is stiffer: a mesh of one's own, drawn in own-mesh.geo and meshed by "
                      "gmsh as the run begins.\n", text)


if __name__ == "__main__":
    unittest.main()
