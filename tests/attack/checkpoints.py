"""Damaged, exchanged and forged checkpoints, and tables beside them: a restart is refused, or goes on to the same
bytes."""

import os
import random
import shutil

import runs
from archive import Archive
from program import Verdict, judge_reading

LENGTHS = (0, 1, 7, -1, -8, 1 << 20, 1 << 40, (1 << 63) - 1, 1 << 63, (1 << 64) - 8)
FORGED = ("length", "resize", "type", "drop")
CURRENT = ("", "0\n", "-1\n", "99999999999999999999\n", "../../../shared/channel/whole/checkpoint/8\n", "5/../5\n", ".\n",
           "..\n", "5 6\n", "5\0\n", "/\n", "current\n", "5" * 5000 + "\n", "5\n")


class Disturbed:
    """A run up to a checkpoint, what can be damaged of it, and folders whose files are exchanged for its own."""

    def __init__(self, program, folder, run):
        os.makedirs(folder)
        self.reference = runs.Reference(program, folder, run=run).make_partly()
        self.others = {}
        of_run = runs.RUNS[run]
        for name, overrides in (("step", [f"Time/End time={of_run.shorter}"]),
                                ("case", [runs.PARTLY, f"Materials/{of_run.region}/Density=900 kg/m^3"]),
                                ("numbers", [runs.PARTLY, "Output/Power interval=1 ms"])):
            self.others[name] = os.path.join(folder, "of-another-" + name)
            self.reference.to_the_end([self.reference.case, "--output", self.others[name], *runs.as_options(overrides)])
        files = sorted(runs.content(self.reference.partly))
        self.of_checkpoint = [name for name in files if name.startswith("checkpoint/")]
        self.archives = [name for name in self.of_checkpoint if os.path.basename(name).startswith(("state", "rank-"))]
        self.tables = [name for name in files if name.endswith(".csv") and "/" not in name] + ["fields.pvd"]


class Attack:
    name = "checkpoints"
    summary = "damaged, exchanged and forged checkpoints and tables, then a restart"

    def __init__(self, program, options):
        self.program = program

    def prepare(self, folder):
        self.disturbed = runs.Made(lambda run: Disturbed(self.program, os.path.join(folder, run), run))

    def corpus(self):
        return runs.corpus_lines("checkpoints.txt")

    def trials(self, number, seed):
        """Names: [RUN: ]KIND FILE [HOW]."""
        chance = random.Random(seed)
        found = []
        for run in runs.runs_of_trials(number, seed):
            disturbed = self.disturbed[run]
            kind = chance.choice(("truncate", "flip", "flip", "remove", "digit", "row", "exchange", "length", "resize",
                                  "type", "drop", "current"))
            archive, table = chance.choice(disturbed.archives), chance.choice(disturbed.tables)
            file, place = chance.choice(disturbed.of_checkpoint + disturbed.tables), f"{chance.random():.6f}"
            name = {"truncate": lambda: f"{file} {chance.choice(('0', place, place, '0.999999'))}",
                    "flip": lambda: f"{file} {place} {chance.randrange(8)}",
                    "remove": lambda: file,
                    "digit": lambda: f"{table} {place}",
                    "row": lambda: f"{table} {place} {chance.choice(('delete', 'double', 'swap', 'empty', 'end'))}",
                    "exchange": lambda: f"{file} {chance.choice(sorted(disturbed.others))}",
                    "length": lambda: f"{archive} {place} {chance.choice((1, 2))} {chance.choice(LENGTHS)}",
                    "resize": lambda: f"{archive} {place} {chance.choice((-8, -1, 1, 8, 800))}",
                    "type": lambda: f"{archive} {place} {chance.choice('tvndix')}",
                    "drop": lambda: f"{archive} {place}",
                    "current": lambda: str(chance.randrange(len(CURRENT)))}[kind]()
            found.append(runs.joined_name(run, f"{kind} {name}"))
        return found

    def perform(self, trial):
        run, rest = runs.split_name(trial.name)
        reference = self.disturbed[run].reference
        output = os.path.join(trial.folder, "run")
        shutil.copytree(reference.partly, output)
        words = rest.split()
        if words[0] == "current":
            with open(os.path.join(output, "checkpoint", "current"), "w", encoding="utf-8") as stream:
                stream.write(CURRENT[int(words[1])])
        else:
            # The step in the names of a corpus may be another one.
            path = os.path.join(output, words[1])
            if not os.path.isfile(path):
                return Verdict("skipped", f"there is no {words[1]}")
            if words[0] == "exchange":
                self.exchange(path, self.disturbed[run].others[words[2]])
            else:
                getattr(self, words[0])(path, *words[2:])
        before = runs.content(output)
        done = trial.note(reference.perform(reference.arguments(output, "--restart"), trial.folder))
        found = judge_reading(done, reference.names(output))
        if found is None:
            found = reference.difference(output)
            return Verdict("wrong", "exit status 0, but " + found) if found else Verdict("accepted", "")
        if found.kind != "refused" and words[0] in FORGED and done.status == 1 \
                and "right checksums but cannot be used" in done.errors:
            # Whoever forges all checksums, too, is found out while the state is read, which is later.
            return Verdict("refused", "")
        if found.kind == "refused":
            after = runs.content(output)
            changed = [name for name in before if after.get(name) != before[name]]
            if changed:
                return Verdict("wrong", f"the restart that was refused changed {', '.join(changed)}")
        return found

    @staticmethod
    def read(path):
        with open(path, "rb") as stream:
            return stream.read()

    @staticmethod
    def write(path, data):
        with open(path, "wb") as stream:
            stream.write(data)

    def truncate(self, path, place):
        os.truncate(path, int(float(place) * os.path.getsize(path)))

    def flip(self, path, place, bit):
        data = bytearray(self.read(path))
        data[int(float(place) * len(data))] ^= 1 << int(bit)
        self.write(path, data)

    def remove(self, path):
        os.remove(path)

    def digit(self, path, place):
        """Another digit for one of the table's."""
        data = bytearray(self.read(path))
        begin = data.find(b"\n") + 1
        places = [i for i in range(begin, len(data)) if chr(data[i]).isdigit()]
        at = places[int(float(place) * len(places))]
        data[at] = ord("0") + (data[at] - ord("0") + 1) % 10
        self.write(path, data)

    def row(self, path, place, how):
        """A row deleted, doubled, exchanged with the next, emptied, or one more at the end."""
        rows = self.read(path).splitlines(True)
        at = 1 + int(float(place) * (len(rows) - 2))
        if how == "delete":
            del rows[at]
        elif how == "double":
            rows.insert(at, rows[at])
        elif how == "swap":
            rows[at], rows[at - 1] = rows[at - 1], rows[at]
        elif how == "empty":
            rows[at] = b"\n"
        else:
            rows.append(rows[-1])
        self.write(path, b"".join(rows))

    def exchange(self, path, other):
        """The file of another step, or of another case, for this one."""
        source, name = other, os.path.basename(path)
        if "/checkpoint/" in path:
            source = os.path.join(source, "checkpoint")
            if name != "current":
                source = os.path.join(source, self.read(os.path.join(source, "current")).decode().strip())
        shutil.copyfile(os.path.join(source, name), path)

    def seal(self, path, archive, lengths=None):
        """Writes a forged archive; the state knows the checksums of its pieces."""
        data = archive.sealed(lengths)
        self.write(path, data)
        if os.path.basename(path) != "state":
            state_file = os.path.join(os.path.dirname(path), "state")
            state = Archive(self.read(state_file))
            state.record(b"checksums of the pieces")[2] = data[-8:]
            self.write(state_file, state.sealed())

    def length(self, path, place, part, length):
        """A record says another length than it has."""
        archive = Archive(self.read(path))
        number = int(float(place) * len(archive.records))
        length = int(length) if int(length) > 8 else len(archive.records[number][int(part)]) + int(length)
        self.seal(path, archive, {(number, int(part)): length})

    def resize(self, path, place, size):
        """A record has more or less than it should."""
        archive = Archive(self.read(path))
        record = archive.records[int(float(place) * len(archive.records))]
        record[2] = record[2] + bytes(int(size)) if int(size) > 0 else record[2][:int(size)]
        self.seal(path, archive)

    def type(self, path, place, letter):
        archive = Archive(self.read(path))
        archive.records[int(float(place) * len(archive.records))][0] = letter.encode()
        self.seal(path, archive)

    def drop(self, path, place):
        """A record is missing."""
        archive = Archive(self.read(path))
        del archive.records[int(float(place) * len(archive.records))]
        self.seal(path, archive)
