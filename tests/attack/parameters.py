"""Parameter files with changes by chance: refused with the file's name, or accepted as what they say."""

import glob
import json
import os
import random
import re
import shutil

import mutations
import parameter_reader
import runs
from program import HERE, Verdict, defect, judge_reading

ROOT = os.path.dirname(os.path.dirname(HERE))
# Where the files come from. Small ones are run, too, when they are accepted.
SHIPPED, SMALL = "parameter_files", ("tests/tiny_runs", "tests/attack/cases")
RUN_EVERY = 4


def plain(text):
    """Without what is no ASCII: a byte that is no UTF-8 is shown as something else."""
    return re.sub(r"[^\x20-\x7e]+", "", text)


class Attack:
    name = "parameters"
    summary = "parameter files with changes by chance, read by --validate; some are run"

    def __init__(self, program, options):
        self.program = program

    def prepare(self, folder):
        self.tree = os.path.join(folder, "files")
        for name in (SHIPPED, *SMALL):
            shutil.copytree(os.path.join(ROOT, name), os.path.join(self.tree, name),
                            ignore=shutil.ignore_patterns("*.output"))

    def corpus(self):
        return runs.corpus_files("parameters")

    def trials(self, number, seed):
        """Names: FILE SEED."""
        chance = random.Random(seed)
        files = sorted(os.path.relpath(path, self.tree) for folder in (SHIPPED, *SMALL)
                       for path in glob.glob(os.path.join(self.tree, folder, "**", "*.prm"), recursive=True))
        small = [file for file in files if not file.startswith(SHIPPED)]
        return [f"{chance.choice(chance.choice((files, files, small)))} {chance.randrange(10**9)}"
                for _ in range(number)]

    def place_mutant(self, trial):
        """Writes the mutant beside what it includes; the file, and a number for what is made by chance of it."""
        file, seed = trial.name.rsplit(" ", 1)
        if file == "corpus":
            path = os.path.join(self.tree, SMALL[1], seed)
            shutil.copyfile(os.path.join(HERE, "corpus", "parameters", seed), path)
            return path, 1
        chance = random.Random(trial.name)
        path = os.path.join(self.tree, file)
        with open(path, "rb") as stream:
            data = mutations.mutate(chance, stream.read(), mutations.COMMON + mutations.OF_SECTIONS)
        mutant = os.path.join(os.path.dirname(path), f"mutant-{seed}.prm")
        with open(mutant, "wb") as stream:
            stream.write(data)
        return mutant, int(seed)

    def perform(self, trial):
        mutant, seed = self.place_mutant(trial)
        shutil.copyfile(mutant, os.path.join(trial.folder, "mutant.prm"))
        try:
            return self.judge(trial, mutant, seed)
        finally:
            os.remove(mutant)

    def judge(self, trial, mutant, seed):
        done = trial.note(self.program.run([mutant, "--validate"], trial.folder))
        # An error may stand in a file that is included, or in one of its tables.
        found = judge_reading(done, {os.path.basename(mutant), *self.read_by(mutant)})
        if found:
            return found
        printed = trial.note(self.program.run([mutant, "--print-parameters=json"], trial.folder))
        found = defect(printed, ())
        if found or printed.status != 0:
            return found or Verdict("wrong", f"valid, but --print-parameters ends with {printed.status}")
        values = {entry["path"]: entry for entry in json.loads(printed.output)}
        found = self.substitution(mutant, values)
        if found:
            return Verdict("wrong", found)
        return self.run(trial, mutant, values, seed) or Verdict("accepted", "")

    @staticmethod
    def read_by(mutant):
        """The names of the files that the mutant names, and of those that these name."""
        names, left = set(), [mutant]
        while left:
            path = left.pop()
            with open(path, "rb") as stream:
                found = re.findall(r"[\w./-]+\.(?:prm|csv|geo|msh)", stream.read().decode("latin-1"))
            for name in found:
                other = os.path.normpath(os.path.join(os.path.dirname(path), name))
                if os.path.basename(name) not in names and name.endswith(".prm") and os.path.isfile(other):
                    left.append(other)
                names.add(os.path.basename(name))
        return names

    @staticmethod
    def substitution(mutant, values):
        """What the program takes for another value than stands in the file; empty if nothing."""
        try:
            written = parameter_reader.read(mutant)
        except parameter_reader.Unreadable as error:
            return f"accepted, but {error}"
        left = set(values)
        for path, value in written.items():
            name, text = plain(path.decode("utf-8", "replace")), plain(value.decode("utf-8", "replace"))
            entry = values.get(path.decode("utf-8", "replace")) or next(
                (entry for other, entry in values.items() if plain(other) == name), None)
            if entry is None:
                return f"'{name}' was accepted, but is no parameter of the run"
            left.discard(entry["path"])
            shown = plain(entry["value"])
            if shown != text and not (entry["values"] == "file" and shown.endswith(os.path.basename(text))) \
                    and not (not text and shown == plain(entry["default"])):
                return f"'{name}' is '{text[:80]}' in the file and '{shown[:80]}' in the run"
            reason = parameter_reader.misfit(text, entry["values"])
            if reason:
                return f"'{name}' takes '{entry['values']}', but '{text[:80]}' was accepted ({reason})"
        for path in left:
            if values[path]["value"] != values[path]["default"]:
                return f"'{path}' is not in the file, but '{values[path]['value']}' instead of its default in the run"
        return ""

    def run(self, trial, mutant, values, seed):
        """Some of the small ones that were accepted are run: to the end, or to a failure with its reason."""
        if seed % RUN_EVERY != 0 or f"/{SHIPPED}/" in mutant:
            return None
        if any(path.startswith(("Mesh", "Time/", "Adaptivity", "Output")) and self.is_large(entry["value"])
               for path, entry in values.items()):
            return None
        output = os.path.join(trial.folder, "run")
        done = trial.note(self.program.run([mutant, "--output", output], trial.folder))
        found = defect(done, ())
        if found:
            return found
        tables = [name for name, data in runs.content(output).items() if name.endswith(".csv")
                  and b"nan" in data.lower()]
        if done.status == 0 and tables:
            return Verdict("wrong", f"exit status 0, but {tables[0]} has a NaN")
        return None

    @staticmethod
    def is_large(text):
        """A number that makes a run long."""
        numbers = [float(number) for number in re.findall(r"\d+\.?\d*(?:[eE][-+]?\d{1,3})?", text)]
        return any(number > 1000 or 0 < number < 1e-3 for number in numbers)
