"""Mesh files (.msh) and geometries (.geo) with changes by chance, and geometries with commands that do more than
draw."""

import os
import random
import shutil

import mesh_reader
import mutations
import runs
from program import HERE, Verdict, judge_reading

CASE = "block.prm"
GEO_TOKENS = (b"1e400", b"Cos(1e400)", b"0", b"-1", b"1e9", b"{}", b"}", b"Exit;", b"Abort;", b"Error(\"stop\");",
              b"Recombine", b"1/0", b"For i In {1:1e9}", b"EndFor", b"Include \"block.geo\";", b"Mesh 2;",
              b"Delete Model;", b"Merge \"block.msh\";", b"SystemCall \"touch made.txt\";",
              b"Printf(\"made\") > \"made.txt\";", b"Save \"made.msh\";")
OF_GEO = tuple(mutations.COMMON) + (mutations.replace_match(mutations.WORD, GEO_TOKENS),) * 6


def listing(folder):
    return sorted(os.path.join(path, name) for path, folders, files in os.walk(folder) for name in folders + files)


class Attack:
    name = "meshes"
    summary = ".msh and .geo files with changes by chance, and .geo files that want to do more than draw"

    def __init__(self, program, options):
        self.program = program

    def prepare(self, folder):
        case = os.path.join(folder, "case")
        shutil.copytree(runs.CASES, case)
        done = self.program.run([os.path.join(case, CASE), "--output", os.path.join(folder, "whole")], folder)
        if done.status != 0:
            raise runs.AttackError(f"the undisturbed run failed\n{done.text()}")
        self.expected = runs.results(os.path.join(folder, "whole"))
        runs.must_be_valid(self.program, folder, self.arguments(case, "block.geo"))

    @staticmethod
    def arguments(folder, name):
        return [os.path.join(folder, CASE), "--set", f"Geometry/File={os.path.join(folder, name)}",
                "--set", "Geometry/Meshing time limit=20 s"]

    def corpus(self):
        return runs.corpus_files("meshes")

    def trials(self, number, seed):
        """Names: FILE SEED."""
        chance = random.Random(seed)
        return [f"{chance.choice(('block.msh', 'block.msh', 'block.geo'))} {chance.randrange(10**9)}"
                for _ in range(number)]

    def perform(self, trial):
        name, seed = trial.name.split(" ")
        if name == "corpus":
            with open(os.path.join(HERE, "corpus", "meshes", seed), "rb") as stream:
                data = stream.read()
            name = "block" + os.path.splitext(seed)[1]
        else:
            with open(os.path.join(runs.CASES, name), "rb") as stream:
                data = mutations.mutate(random.Random(trial.name), stream.read(),
                                        OF_GEO if name.endswith(".geo") else mutations.COMMON)
        folder = os.path.join(trial.folder, "case")
        shutil.copytree(runs.CASES, folder)
        with open(os.path.join(folder, name), "wb") as stream:
            stream.write(data)
        before = listing(trial.folder)
        arguments = self.arguments(folder, name)
        # From a folder that is watched: a command may write beside the file, or where the program runs.
        done = trial.note(self.program.run([*arguments, "--validate"], trial.folder))
        made = sorted(set(listing(trial.folder)) - set(before))
        if made:
            return Verdict("wrong",
                           f"reading the file made {', '.join(os.path.relpath(path, trial.folder) for path in made)}")
        found = judge_reading(done, {name, CASE})
        if found:
            return found
        if ": valid" not in done.output:
            return Verdict("wrong", "exit status 0, but the program did not come to the end")
        if name.endswith(".geo"):
            return Verdict("accepted", "")
        return self.compare(trial, arguments, os.path.join(folder, name), data) or Verdict("accepted", "")

    def compare(self, trial, arguments, path, data):
        """What the run computes with the mesh, and with the same one written plainly; with the undisturbed one if the
        file is not in order."""
        expected = self.expected
        status, found = self.compute(trial, arguments, "changed")
        if isinstance(found, Verdict):
            return found
        try:
            plain, reason = mesh_reader.plain(data), "the same mesh written plainly"
        except mesh_reader.Unreadable as error:
            plain, reason = None, f"the undisturbed mesh, although {error}"
        expected_status = 0
        if plain is not None:
            with open(path, "wb") as stream:
                stream.write(plain)
            expected_status, expected = self.compute(trial, arguments, "plain")
            if isinstance(expected, Verdict):
                return expected
        if (status, found) != (expected_status, expected):
            return Verdict("wrong", f"the run computes something else than with {reason}")
        return None

    def compute(self, trial, arguments, name):
        output = os.path.join(trial.folder, name)
        done = trial.note(self.program.run([*arguments, "--output", output], trial.folder))
        # A mesh may be valid and its cells such that the run fails.
        found = judge_reading(done, ()) if done.status != 1 or done.hung else None
        if found and found.kind != "refused":
            return done.status, found
        return done.status, runs.results(output) if done.status == 0 else {}
