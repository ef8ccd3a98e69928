"""Tables (csv) with changes by chance: of an inlet, of a relaxation test, of measured waves, of a tube's shape, of a stretched
rubber, of moduli over frequency, of an inflated artery."""

import os
import random
import shutil

import mutations
import runs
import table_reader
from program import HERE, Verdict, judge_reading

# Table: the case that reads it, and how many of its columns it reads. The first is run, too.
CASES = {"pulse.csv": ("channel.prm", 2), "relaxation.csv": ("relaxation.prm", 2), "measured.csv": ("measured.prm", 2),
         "shape.csv": ("shape.prm", 3), "stretch.csv": ("stretch.prm", 2), "moduli.csv": ("material-fit.prm", 3),
         "inflation.csv": ("artery-fit.prm", 4)}


class Attack:
    name = "tables"
    summary = "tables of inlets, tests of materials, measured waves and tubes with changes by chance"

    def __init__(self, program, options):
        self.program = program

    def prepare(self, folder):
        for case, _ in CASES.values():
            runs.must_be_valid(self.program, folder, [os.path.join(runs.CASES, case)])

    def corpus(self):
        return runs.corpus_files("tables")

    def trials(self, number, seed):
        """Names: TABLE SEED."""
        chance = random.Random(seed)
        return [f"{chance.choice(sorted(CASES))} {chance.randrange(10**9)}" for _ in range(number)]

    def table(self, trial):
        """The name of the table, and what it holds now. Of a file of the corpus the name ends with that of its
        table."""
        name, seed = trial.name.split(" ")
        if name == "corpus":
            with open(os.path.join(HERE, "corpus", "tables", seed), "rb") as stream:
                return next(table for table in CASES if seed.endswith(table)), stream.read()
        with open(os.path.join(runs.CASES, name), "rb") as stream:
            return name, mutations.mutate(random.Random(trial.name), stream.read(), mutations.COMMON)

    def perform(self, trial):
        table, data = self.table(trial)
        case, columns = CASES[table]
        folder = os.path.join(trial.folder, "case")
        shutil.copytree(runs.CASES, folder)
        self.write(os.path.join(folder, table), data)
        file = os.path.join(folder, case)
        found = judge_reading(trial.note(self.program.run([file, "--validate"], trial.folder)), {table, case})
        if found:
            return found
        try:
            plain = table_reader.plain(data, columns)
        except table_reader.Unreadable as error:
            return Verdict("wrong", f"accepted, but {error}")
        found = self.compare(trial, folder, file, table, plain) if case == runs.CASE else None
        return found or Verdict("accepted", "")

    def compare(self, trial, folder, file, table, plain):
        """What the run computes with the table, and with the same numbers written plainly."""
        results = []
        for name, data in (("changed", None), ("plain", plain)):
            if data is not None:
                self.write(os.path.join(folder, table), data)
            output = os.path.join(trial.folder, name)
            done = trial.note(self.program.run([file, "--output", output, "--set", runs.PARTLY], trial.folder))
            found = judge_reading(done, {table})
            if found and found.kind != "refused":
                return Verdict(found.kind, f"the run with the {name} table: {found.note}")
            results.append((done.status, runs.results(output)))
        if results[0] != results[1]:
            return Verdict("wrong", "the run computes something else with the same table written plainly")
        return None

    @staticmethod
    def write(path, data):
        with open(path, "wb") as stream:
            stream.write(data)
