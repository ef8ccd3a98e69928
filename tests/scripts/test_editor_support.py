"""scripts/editor-support: the JSON schema takes every entry of shipped files and refuses a misspelt key and a wrong word; Vim marks an
unknown key and completes one."""

import glob
import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest

import jsonschema

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))
# One of each kind: geometries, analyses, studies, Expected, Reference, painted regions.
FILES = ["new/*", "verification/refinement-cook-membrane", "verification/comparison-lame-cylinder", "examples/own-tube",
         "verification/cell-wise-transmission", "thesis/chapter-4/beam"]


def nested(file):
    """The entries of a parameter file as the schema has them."""
    done = subprocess.run([PROGRAM, file, "--print-parameters=json"], capture_output=True, text=True, check=True)
    root = {}
    for entry in json.loads(done.stdout):
        # A name with a slash stands between quotes, as the entries of a sweep.
        *sections, key = [name.strip('"') for name in re.findall(r'"[^"]*"|[^/]+', entry["path"])]
        place = root
        for section in sections:
            place = place.setdefault(section, {})
        if entry["value"]:
            place[key] = entry["value"]
    return root


class EditorSupport(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp()
        subprocess.run([os.path.join(ROOT, "scripts", "editor-support"), cls.folder, "--program", PROGRAM], check=True,
                       stdout=subprocess.DEVNULL)
        with open(os.path.join(cls.folder, "continua.schema.json"), encoding="utf-8") as stream:
            cls.schema = json.load(stream)
        # Debian 12 has no checker of the draft 2020-12 with patternProperties in all its versions; the words used are those of draft 7.
        cls.validator = jsonschema.Draft7Validator(cls.schema)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def test_shipped_files(self):
        files = [file for pattern in FILES for file in glob.glob(os.path.join(ROOT, "parameter_files", pattern + ".prm"))]
        self.assertGreater(len(files), 20)
        for file in files:
            errors = [f"{list(error.path)}: {error.message}" for error in self.validator.iter_errors(nested(file))]
            self.assertEqual(errors, [], file)

    def test_mistakes(self):
        good = nested(os.path.join(ROOT, "parameter_files", "new", "tube.prm"))
        for section, key, value in (("Time", "Time stepp", "1 s"), ("Time", "Scheme", "runge kutta"), ("Timing", "End time", "1 s")):
            bad = json.loads(json.dumps(good))
            bad.setdefault(section, {})[key] = value
            self.assertFalse(self.validator.is_valid(bad), f"{section}/{key} = {value}")
        time = self.schema["properties"]["Time"]["properties"]["End time"]
        self.assertIn("[s]", time["description"])

    def test_no_program(self):
        script = os.path.join(ROOT, "scripts", "editor-support")
        with tempfile.TemporaryDirectory() as folder:
            empty = {**os.environ, "PATH": folder, "CONTINUA_BUILD_ROOT": folder}
            empty.pop("CONTINUA_PROGRAM", None)
            for program, message in (([], "there is no program of Continua"), (["--program", "missing"], "missing cannot be run: No such file"),
                                     (["--program", shutil.which("true")], "is no program of Continua")):
                done = subprocess.run(["/usr/bin/python3", script, os.path.join(folder, "editor"), *program], env=empty, capture_output=True,
                                      text=True, check=False)
                self.assertEqual(done.returncode, 1)
                self.assertRegex(done.stderr, rf"\Aerror: .*{message}")
                self.assertFalse(os.path.exists(os.path.join(folder, "editor")))

    @unittest.skipUnless(shutil.which("vim") and b"+syntax" in subprocess.run(["vim", "--version"], capture_output=True, check=False).stdout,
                         "needs vim with +syntax")
    def test_vim(self):
        file = os.path.join(self.folder, "case.prm")
        with open(file, "w", encoding="utf-8") as stream:
            stream.write("subsection Time\n  set Time step = 1 s\n  set Time stepp = 1 s\nend\nsubsection Expected\n"
                         "  set tip: frequency = 1 Hz +- 1 %\nend\n")
        output = os.path.join(self.folder, "groups")
        groups = "[synIDattr(synID(2, 7, 1), 'name'), synIDattr(synID(3, 7, 1), 'name'), synIDattr(synID(6, 7, 1), 'name')]"
        words = "map(continua#complete(0, 'Time st'), {_, key -> key.word})"
        subprocess.run(["vim", "-u", "NONE", "-es", "-N", "--cmd", f"set runtimepath^={self.folder}/vim", "-c", "filetype plugin on",
                        "-c", "syntax on", "-c", f"edit {file}", "-c", f"call writefile([json_encode({groups}), json_encode({words})], '{output}')",
                        "-c", "qa!"], check=False, stdin=subprocess.DEVNULL, timeout=60)
        with open(output, encoding="utf-8") as stream:
            found, completed = map(json.loads, stream)
        self.assertEqual(found, ["continuaKey", "continuaUnknownKey", "continuaFreeKey"])
        self.assertIn("Time step", completed)
        self.assertTrue(all(word.startswith("Time st") for word in completed))


if __name__ == "__main__":
    unittest.main()
