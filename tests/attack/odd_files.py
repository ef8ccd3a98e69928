"""Odd files as input and as output folder: pipes, folders, links in a circle, devices, other encodings, huge and deep
ones."""

import itertools
import os
import random
import shutil
import socket

import runs
from program import Verdict, judge_reading

# Role: the case, and the file of it that is odd. An include and a parameter file are read before all else.
ROLES = {"parameters": ("channel.prm", "channel.prm"), "include": ("channel.prm", "wall.prm"),
         "inlet": ("channel.prm", "pulse.csv"), "relaxation": ("relaxation.prm", "relaxation.csv"),
         "measured": ("measured.prm", "measured.csv"), "shape": ("shape.prm", "shape.csv"),
         "stretch": ("stretch.prm", "stretch.csv"), "moduli": ("material-fit.prm", "moduli.csv"),
         "inflation": ("artery-fit.prm", "inflation.csv"), "vessels": ("network.prm", "vessels.csv"),
         "terminals": ("network.prm", "terminals.csv"),
         "mesh": ("block.prm", "block.msh"), "drawing": ("block.prm", "block.geo")}
KINDS = ("pipe", "folder", "circle", "dangling", "zero", "full", "null", "random", "terminal", "utf-16", "latin-1",
         "empty", "blank", "huge-line", "huge-comment", "deep-unit", "deep-sections", "deep-includes", "no-permission",
         "socket", "control")
OUTPUTS = ("file", "circle", "dangling", "full", "under-full", "under-file", "long-name", "line-break", "itself",
           "pipe", "link", "input", "no-permission", "blanks", "escape")


def make_odd(kind, path):
    """Puts the odd file where a right one stood; False if it cannot be made here."""
    with open(path, "rb") as stream:
        right = stream.read()
    os.remove(path)
    links = {"zero": "/dev/zero", "full": "/dev/full", "null": "/dev/null", "terminal": "/dev/tty",
             "circle": os.path.basename(path),
             "dangling": "nowhere"}
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "folder":
        os.mkdir(path)
    elif kind in links:
        os.symlink(links[kind], path)
    elif kind == "socket":
        # The name of a socket may have a hundred letters only.
        descriptor = os.open(os.path.dirname(path), os.O_RDONLY)
        with socket.socket(socket.AF_UNIX) as one:
            one.bind(f"/proc/self/fd/{descriptor}/{os.path.basename(path)}")
        os.close(descriptor)
    else:
        with open(path, "wb") as stream:
            stream.write(text_of(kind, right, path))
        if kind == "no-permission":
            os.chmod(path, 0)
            return os.geteuid() != 0
    return True


def text_of(kind, right, path):
    if kind == "random":
        return random.Random(1).randbytes(100000)
    if kind == "utf-16":
        return right.decode("utf-8").encode("utf-16")
    if kind == "latin-1":
        return right.replace(b"Channel", b"Kan\xe4le")
    if kind == "blank":
        return b" \t\n" * 10000
    if kind == "huge-line":
        return right.rstrip(b"\n") + b" " + b"x" * 50_000_000 + b"\n"
    if kind == "huge-comment":
        return b"# " + b"x" * 50_000_000 + b"\n" + right
    if kind == "deep-unit":
        return right.replace(b"50 mm", b"50 " + b"(" * 100000 + b"mm" + b")" * 100000).replace(
            b"[ms]", b"[" + b"(" * 100000 + b"ms" + b")" * 100000 + b"]")
    if kind == "deep-sections":
        return right + b"subsection a\n" * 30000 + b"end\n" * 30000
    if kind == "deep-includes":
        folder, name = os.path.split(path)
        for i in range(2000):
            with open(os.path.join(folder, f"deep-{i}.prm"), "w", encoding="ascii") as stream:
                stream.write(f"include deep-{i + 1}.prm\n" if i < 1999 else "set Titel = x\n")
        return b"include deep-0.prm\n" + right if name.endswith(".prm") else right
    if kind == "control":
        changed = right.replace(b"Channel", b"\x1b]0;x\x07\x1b[31mred").replace(b"set Cells", b"set \x1b[2JCells")
        return changed + b"\x1b[31m\x08\n"
    return b"" if kind == "empty" else right


def odd_output(kind, folder):
    """(the path to name as the output folder, whether it can be made here)."""
    path = os.path.join(folder, "odd")
    if kind == "file":
        with open(path, "w", encoding="ascii") as stream:
            stream.write("mine\n")
    elif kind in ("circle", "dangling", "full", "link"):
        os.symlink({"circle": "odd", "dangling": "nowhere", "full": "/dev/full", "link": "real"}[kind], path)
        if kind == "link":
            os.mkdir(os.path.join(folder, "real"))
    elif kind == "pipe":
        os.mkfifo(path)
    elif kind == "no-permission":
        os.mkdir(path, 0o555)
        return path, os.geteuid() != 0
    names = {"under-full": "/dev/full/run", "under-file": os.path.join(folder, "case", "channel.prm", "run"),
             "itself": ".",
             "long-name": os.path.join(folder, "x" * 300), "line-break": os.path.join(folder, "odd\nname"),
             "input": os.path.join(folder, "case"), "blanks": os.path.join(folder, "odd  name "),
             "escape": os.path.join(folder, "odd\x1b[31mname")}
    return names.get(kind, path), True


class Attack:
    name = "odd-files"
    summary = "pipes, devices, links in a circle, other encodings, huge and deep files as input and as output folder"

    def __init__(self, program, options):
        self.program = program

    def prepare(self, folder):
        for role, (case, _) in ROLES.items():
            if role not in ("include", "inlet"):
                runs.must_be_valid(self.program, folder, self.arguments(runs.CASES, case, role))

    @staticmethod
    def arguments(folder, parameters, role):
        drawing = ["--set", f"Geometry/File={os.path.join(folder, 'block.geo')}"]
        return [os.path.join(folder, parameters), *(drawing if role == "drawing" else [])]

    def corpus(self):
        return runs.corpus_lines("odd-files.txt")

    def trials(self, number, seed):
        """Names: KIND as ROLE. There are no more than about 300."""
        names = [f"{kind} as {role}" for kind, role in itertools.product(KINDS, ROLES)]
        names += [f"{kind} as output" for kind in OUTPUTS]
        return random.Random(seed).sample(names, min(number, len(names)))

    def perform(self, trial):
        kind, role = trial.name.split(" as ")
        case = os.path.join(trial.folder, "case")
        shutil.copytree(runs.CASES, case)
        if role == "output":
            return self.perform_output(trial, kind, os.path.join(case, "channel.prm"))
        parameters, odd = ROLES[role]
        if not make_odd(kind, os.path.join(case, odd)):
            return Verdict("skipped", "root may read every file")
        arguments = self.arguments(case, parameters, role)
        done = trial.note(self.program.run([*arguments, "--validate"], trial.folder))
        names = {odd, parameters} if kind != "deep-includes" else {".prm"}
        return judge_reading(done, names) or self.accepted(trial, kind, role, arguments)

    def accepted(self, trial, kind, role, arguments):
        """Only some odd files say what the right one says, and then the run does the same."""
        same = ["huge-comment", "latin-1", "control", "no-permission", "deep-unit"]
        if role not in ("parameters", "include"):
            same.append("deep-includes")
        # Nothing but the name of the section stands at the end of a mesh file.
        if kind in same or (kind, role) in (("blank", "include"), ("huge-line", "mesh")):
            return Verdict("accepted", "")
        return Verdict("wrong", f"{arguments[0]} was accepted with such a file")

    def perform_output(self, trial, kind, file):
        output, can_be_made = odd_output(kind, trial.folder)
        if not can_be_made:
            return Verdict("skipped", "root may write everywhere")
        before = runs.content(os.path.join(trial.folder, "case"))
        folder = os.path.join(trial.folder, "here")
        os.mkdir(folder)
        done = trial.note(self.program.run([file, "--output", output], folder))
        after = runs.content(os.path.join(trial.folder, "case"))
        if any(after.get(name) != data for name, data in before.items()):
            return Verdict("lost", "a file of the input was changed")
        names = {"odd", "channel.prm", "/dev/full", *filter(None, os.path.basename(output).split("\n"))}
        found = judge_reading(done, names)
        if found:
            return found
        if not os.path.isfile(os.path.join(folder, output, "probes.csv")):
            return Verdict("wrong", "exit status 0 without a table in the folder")
        return Verdict("accepted", "")
