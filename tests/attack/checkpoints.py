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
CURRENT = ("", "0\n", "-1\n", "99999999999999999999\n", "../../../shared/whole/checkpoint/8\n", "5/../5\n", ".\n",
           "..\n", "5 6\n", "5\0\n", "/\n", "current\n", "5" * 5000 + "\n", "5\n")


class Attack:
    name = "checkpoints"
    summary = "damaged, exchanged and forged checkpoints and tables, then a restart"

    def __init__(self, program, options):
        self.program = program

    def prepare(self, folder):
        self.reference = runs.Reference(self.program, folder).make_partly()
        self.others = {}
        for name, overrides in (("step", ["Time/End time=1.5 ms"]),
                                ("case", [runs.PARTLY, "Materials/fluid/Density=900 kg/m^3"]),
                                ("numbers", [runs.PARTLY, "Output/Probe interval=1 ms"])):
            self.others[name] = os.path.join(folder, "of-another-" + name)
            self.reference.to_the_end([self.reference.case, "--output", self.others[name],
                                       *runs.as_options(overrides)])
        files = sorted(runs.content(self.reference.partly))
        self.of_checkpoint = [name for name in files if name.startswith("checkpoint/")]
        self.archives = [name for name in self.of_checkpoint if os.path.basename(name) in ("state", "rank-0")]
        self.tables = [name for name in files if name.endswith(".csv") and "/" not in name] + ["fields.pvd"]

    def corpus(self):
        return runs.corpus_lines("checkpoints.txt")

    def trials(self, number, seed):
        chance = random.Random(seed)
        files = self.of_checkpoint + self.tables
        found = []
        while len(found) < number:
            kind = chance.choice(("truncate", "flip", "flip", "remove", "digit", "row", "exchange", "length", "resize",
                                  "type", "drop", "current"))
            archive, table, file = chance.choice(self.archives), chance.choice(self.tables), chance.choice(files)
            place = f"{chance.random():.6f}"
            if kind == "truncate":
                found.append(f"truncate {file} {chance.choice(('0', place, place, '0.999999'))}")
            elif kind == "flip":
                found.append(f"flip {file} {place} {chance.randrange(8)}")
            elif kind == "remove":
                found.append(f"remove {file}")
            elif kind == "digit":
                found.append(f"digit {table} {place}")
            elif kind == "row":
                found.append(f"row {table} {place} {chance.choice(('delete', 'double', 'swap', 'empty', 'end'))}")
            elif kind == "exchange":
                found.append(f"exchange {file} {chance.choice(sorted(self.others))}")
            elif kind == "length":
                found.append(f"length {archive} {place} {chance.choice((1, 2))} {chance.choice(LENGTHS)}")
            elif kind == "resize":
                found.append(f"resize {archive} {place} {chance.choice((-8, -1, 1, 8, 800))}")
            elif kind == "type":
                found.append(f"type {archive} {place} {chance.choice('tvndix')}")
            elif kind == "drop":
                found.append(f"drop {archive} {place}")
            else:
                found.append(f"current {chance.randrange(len(CURRENT))}")
        return found

    def perform(self, trial):
        output = os.path.join(trial.folder, "run")
        shutil.copytree(self.reference.partly, output)
        words = trial.name.split()
        if words[0] == "current":
            with open(os.path.join(output, "checkpoint", "current"), "w", encoding="utf-8") as stream:
                stream.write(CURRENT[int(words[1])])
        else:
            # The step in the names of a corpus may be another one.
            path = os.path.join(output, words[1])
            if not os.path.isfile(path):
                return Verdict("skipped", f"there is no {words[1]}")
            getattr(self, words[0])(path, *words[2:])
        before = runs.content(output)
        done = trial.note(self.program.run(self.reference.arguments(output, "--restart"), trial.folder))
        found = judge_reading(done, self.reference.names(output))
        if found is None:
            found = runs.difference(self.reference.expected, output)
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
        source, name = self.others[other], os.path.basename(path)
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
