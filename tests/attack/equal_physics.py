"""A file is varied in ways that must not change the answer, or change it in a known way: units, order, mirror, turn, similarity, superposition."""

import csv
import math
import os
import random
import re
import shutil

import parameter_reader
import runs
from program import Verdict

# Round-off of another order of operations, far below what any physics does.
TOLERANCE = 1e-9
# [SI value, powers of length, time and mass].
UNITS = {"m": (1., 1, 0, 0), "cm": (1e-2, 1, 0, 0), "mm": (1e-3, 1, 0, 0), "um": (1e-6, 1, 0, 0),
         "s": (1., 0, 1, 0), "ms": (1e-3, 0, 1, 0), "us": (1e-6, 0, 1, 0), "min": (60., 0, 1, 0),
         "Pa": (1., -1, -2, 1), "kPa": (1e3, -1, -2, 1), "MPa": (1e6, -1, -2, 1), "GPa": (1e9, -1, -2, 1), "mmHg": (133.322387415, -1, -2, 1),
         "Pa s": (1., -1, -1, 1), "mPa s": (1e-3, -1, -1, 1),
         "kg/m^3": (1., -3, 0, 1), "g/cm^3": (1e3, -3, 0, 1),
         "m/s": (1., 1, -1, 0), "mm/s": (1e-3, 1, -1, 0), "m/s^2": (1., 1, -2, 0)}
QUANTITY = re.compile(r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?) ?([A-Za-z][A-Za-z ^/0-9]*)?")
# Formulas in the cases, with the powers of what they give.
FORMULAS = {"Traction": (-1, -2, 1), "Pressure": (-1, -2, 1), "Acceleration": (1, -2, 0)}

# A block with a load that varies in time and along the side, of a material that relaxes.
BLOCK = {"Title": "Block", "Model": "plane strain",
         "Geometry/Type": "box", "Geometry/Size": "20 mm, 10 mm", "Mesh/Cells": "4, 2",
         "Materials/body/Type": "prony", "Materials/body/Density": "1100 kg/m^3", "Materials/body/Young's modulus": "1 MPa",
         "Materials/body/Poisson's ratio": "0.3", "Materials/body/Shear moduli": "0.2 MPa", "Materials/body/Relaxation times": "1.5 ms",
         "Boundaries/left/Type": "fixed", "Boundaries/bottom/Type": "free", "Boundaries/top/Type": "free",
         "Boundaries/right/Type": "traction", "Boundaries/right/Traction": "800*sin(500*t)^2, 300*sin(400*t)",
         "Body force/Acceleration": "3*sin(300*t), -9.81",
         "Time/Scheme": "crank nicolson", "Time/Time step": "0.5 ms", "Time/End time": "5 ms",
         "Probes/corner/Point": "19 mm, 8 mm", "Probes/corner/Fields": "displacement, velocity",
         "Probes/inside/Point": "6 mm, 4 mm", "Probes/inside/Fields": "pressure, displacement",
         "Output/Final fields": "false"}


def channel():
    """The channel of the other attacks, all in one."""
    entries = parameter_reader.read(os.path.join(runs.CASES, runs.CASE))
    return {path.decode(): value.decode() for path, value in entries.items()}


def tree_of(entries):
    tree = {}
    for path, value in entries.items():
        *sections, key = path.split("/")
        place = tree
        for section in sections:
            place = place.setdefault(section, {})
        place[key] = value
    return tree


def lines_of(tree, chance=None, depth=0):
    """The text of sections and entries; with `chance` in any order, spaced in any way, a section in several pieces."""
    def blank():
        return " " * chance.randrange(1, 4) if chance else " "

    items, lines = list(tree.items()), []
    if chance:
        chance.shuffle(items)
    for key, value in items:
        indent = "\t" * depth if chance and chance.random() < 0.3 else "  " * depth
        if isinstance(value, dict):
            parts = [value]
            if chance and len(value) > 1 and chance.random() < 0.5:
                keys = list(value)
                parts = [{key: value[key] for key in half} for half in (keys[::2], keys[1::2])]
            for part in parts:
                lines += [f"{indent}subsection{blank()}{key}", *lines_of(part, chance, depth + 1), f"{indent}end"]
        elif chance and chance.random() < 0.2:
            lines += [f"{indent}set {key}{blank()}=\\", f"{indent}  {value} # a comment"]
        else:
            lines.append(f"{indent}set{blank()}{key}{blank()}={blank()}{value}")
        if chance and chance.random() < 0.2:
            lines += ["", "# set Title = in a comment"]
    return lines


def text_of(entries, chance=None):
    return "\n".join(lines_of(tree_of(entries), chance)) + "\n"


def each_quantity(value, change):
    """The value with each of its quantities changed; those without a unit of UNITS, words and formulas stay."""
    parts = []
    for part in value.split(","):
        match = QUANTITY.fullmatch(part.strip())
        parts.append(change(match.group(1), match.group(2)) if match and match.group(2) in UNITS else part.strip())
    return ", ".join(parts)


def in_another_unit(chance):
    def change(number, unit):
        same = [other for other in UNITS if UNITS[other][1:] == UNITS[unit][1:]]
        other = chance.choice(same)
        return f"{float(number) * UNITS[unit][0] / UNITS[other][0]!r} {other}"
    return change


def in_another_format(chance):
    def change(number, unit):
        value = float(number)
        return chance.choice([f"{value:.17e} {unit}", f"{value * 1e3!r}e-3 {unit}", f"+{value!r} {unit}" if value > 0 else f"{value!r} {unit}",
                              f"{number}{unit}" if chance.random() < 0.5 else f"{number}   {unit}"])
    return change


def factor(powers, scale):
    return math.prod(base ** power for base, power in zip(scale, powers))


def similar(entries, scale):
    """The case with lengths, times and masses that are so many times as large: all answers scale by the powers of their units."""
    length, time, _ = scale

    def change(number, unit):
        value, *powers = UNITS[unit]
        base = next(name for name in UNITS if UNITS[name] == (1., *powers))
        return f"{float(number) * value * factor(powers, scale)!r} {base}"

    scaled = {}
    for path, value in entries.items():
        key = path.split("/")[-1]
        if key in FORMULAS and re.search(r"[a-z]\(|\bt\b", value):
            size = factor(FORMULAS[key], scale)
            parts = [re.sub(r"\bt\b", f"(t/{time!r})", re.sub(r"\bx\b", f"(x/{length!r})", part.strip())) for part in value.split(",")]
            scaled[path] = ", ".join(f"{size!r}*({part})" for part in parts)
        elif key in FORMULAS and not re.search("[A-Za-z]", value.replace("e", "")):
            scaled[path] = ", ".join(repr(float(part) * factor(FORMULAS[key], scale)) for part in value.split(","))
        else:
            scaled[path] = each_quantity(value, change)
    return scaled


def powers_of_column(name):
    unit = name[name.rfind("[") + 1:-1]
    return (0, 0, 0) if unit == "1" else UNITS[unit][1:]


def read_table(path):
    """{column: numbers}."""
    with open(path, encoding="utf-8", newline="") as stream:
        rows = list(csv.reader(stream))
    return {name: [float(cell) for cell in column] for name, column in zip(rows[0], zip(*rows[1:]))}


def difference(expected, found, tolerance):
    """In what two tables differ, relative to the largest number of a probe's unit; empty if in nothing."""
    if set(expected) != set(found):
        return "other columns: " + ", ".join(sorted(set(expected) ^ set(found)))
    for name, column in expected.items():
        other = found[name]
        if len(column) != len(other):
            return f"{len(other)} rows for {len(column)}"
        unit = name[name.rfind("["):]
        size = max(abs(x) for one, numbers in expected.items() if one.endswith(unit) for x in numbers)
        worst = max(abs(a - b) for a, b in zip(column, other))
        if not worst <= tolerance * size:
            return f"'{name}' is off by {worst:.3g}; the largest number is {size:.3g}"
    return ""


def mesh_text(chance, move):
    """The block's 4 x 2 cells as gmsh writes them, with nodes and cells in any order and their corners begun anywhere."""
    points = {(i, j): move((0.005 * i, 0.005 * j)) for i in range(5) for j in range(3)}
    names = list(points)
    chance.shuffle(names)
    tags = {name: 1 + i for i, name in enumerate(names)}
    sides = {"left": [((0, j), (0, j + 1)) for j in range(2)], "right": [((4, j), (4, j + 1)) for j in range(2)],
             "bottom": [((i, 0), (i + 1, 0)) for i in range(4)], "top": [((i, 2), (i + 1, 2)) for i in range(4)]}
    cells = []
    for i in range(4):
        for j in range(2):
            corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            begin = chance.randrange(4)
            cells.append(corners[begin:] + corners[:begin])
    # A mirror turns the sense of the corners round.
    (ax, ay), (bx, by), (cx, cy) = move((0., 0.)), move((1., 0.)), move((0., 1.))
    if (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) < 0.:
        cells = [cell[::-1] for cell in cells]
    chance.shuffle(cells)
    xs, ys = [point[0] for point in points.values()], [point[1] for point in points.values()]
    box = f"{min(xs)!r} {min(ys)!r} 0 {max(xs)!r} {max(ys)!r} 0"
    lines = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(sides) + 1)]
    lines += [f'1 {2 + i} "{name}"' for i, name in enumerate(sides)] + ['2 1 "body"', "$EndPhysicalNames"]
    lines += ["$Entities", f"0 {len(sides)} 1 0"] + [f"{1 + i} {box} 1 {2 + i} 0" for i in range(len(sides))]
    lines += [f"1 {box} 1 1 0", "$EndEntities", "$Nodes", f"1 {len(points)} 1 {len(points)}", f"2 1 0 {len(points)}"]
    lines += [str(tags[name]) for name in names] + [f"{points[name][0]!r} {points[name][1]!r} 0" for name in names] + ["$EndNodes"]
    n_elements = len(cells) + sum(map(len, sides.values()))
    lines += ["$Elements", f"{len(sides) + 1} {n_elements} 1 {n_elements}"]
    element = 0
    for i, edges in enumerate(sides.values()):
        lines.append(f"1 {1 + i} 1 {len(edges)}")
        for a, b in edges:
            element += 1
            lines.append(f"{element} {tags[a]} {tags[b]}")
    lines.append(f"2 1 3 {len(cells)}")
    for cell in cells:
        element += 1
        lines.append(f"{element} " + " ".join(str(tags[corner]) for corner in cell))
    return "\n".join(lines + ["$EndElements", ""])


class Attack:
    name = "equal-physics"
    summary = "a file varied in 27 ways that must not change the answer, or change it as similarity and superposition say"

    BOTH = ("units", "order", "format", "include", "override", "options", "printed", "parameters", "in-odd-folder", "probes", "restart", "shorter",
            "crlf", "lengths", "times", "masses", "all-scales", "refined", "alias")
    BLOCK_ONLY = ("numbering", "moved", "turned", "mirrored", "load", "superposition", "space", "sum-of-formulas")
    CHANNEL_ONLY = ("table",)

    def __init__(self, program, options):
        self.program = program

    def prepare(self, folder):
        self.folder = folder
        runs.copy_case(folder)
        self.bases = {"block": BLOCK, "channel": channel()}
        self.wholes = runs.Made(self.make_whole)

    def corpus(self):
        return runs.corpus_lines("equal-physics.txt")

    def trials(self, number, seed):
        """Names: CASE VARIATION SEED."""
        chance = random.Random(seed)
        every = [f"{case} {way}" for case, own in (("block", self.BLOCK_ONLY), ("channel", self.CHANNEL_ONLY)) for way in self.BOTH + own]
        # Each once before any comes again.
        names = [f"{name} {chance.randrange(1000)}" for _ in range(-(-number // len(every))) for name in chance.sample(every, len(every))]
        return names[:number]

    def make_whole(self, case):
        output = self.perform_text(text_of(self.bases[case]), self.folder, "whole-" + case)
        return output, read_table(os.path.join(output, "probes.csv"))

    def perform_text(self, text, folder, name, trial=None, options=(), files=None):
        """Writes the file and runs it; the output folder."""
        path, output = os.path.join(folder, name + ".prm"), os.path.join(folder, name)
        for file, content in {**(files or {}), path: text}.items():
            with open(os.path.join(folder, file), "w", encoding="utf-8", newline="") as stream:
                stream.write(content)
        return self.perform_file(path, output, folder, trial, options)

    def perform_file(self, path, output, folder, trial=None, options=()):
        done = self.program.run([path, "--output", output, *options], folder)
        if trial:
            trial.note(done)
        if done.status != 0:
            raise runs.AttackError(f"a right file ends with {done.status}\n{done.text()}")
        return output

    def perform(self, trial):
        case, way, seed = trial.name.split()
        chance = random.Random(int(seed))
        for file in ("pulse.csv",):
            shutil.copy(os.path.join(self.folder, file), trial.folder)
        _, expected = self.wholes[case]
        try:
            change = getattr(self, way.replace("-", "_"))
            problem = difference(*change(trial, dict(self.bases[case]), dict(expected), chance))
        except runs.AttackError as error:
            return Verdict("wrong", str(error).replace("\n", " | "))
        return Verdict("wrong", problem) if problem else Verdict("accepted", "")

    def table(self, trial, entries, expected, chance):
        """The same table with other units, separators and points that lie on its lines."""
        with open(os.path.join(trial.folder, "pulse.csv"), encoding="utf-8") as stream:
            rows = [line.split(",") for line in stream.read().splitlines()[1:] if line.strip() and not line.startswith("#")]
        points = [(1e-3 * float(a), 1e3 * float(b)) for a, b in rows]
        more = []
        for (t, p), (end, q) in zip(points, points[1:]):
            share = chance.choice((0.25, 0.5, 0.75))
            more += [(t, p), (t + share * (end - t), p + share * (q - p))]
        text = "time [us];pressure [Pa]\r\n" + "".join(f"{1e6 * t!r};{p!r}\r\n" for t, p in [*more, points[-1]])
        return self.simple(trial, text_of(entries), expected, files={"pulse.csv": text})

    def simple(self, trial, text, expected, tolerance=TOLERANCE, **more):
        output = self.perform_text(text, trial.folder, "run", trial, **more)
        return expected, read_table(os.path.join(output, "probes.csv")), tolerance

    def units(self, trial, entries, expected, chance):
        return self.simple(trial, text_of({path: each_quantity(value, in_another_unit(chance)) for path, value in entries.items()}), expected)

    def format(self, trial, entries, expected, chance):
        return self.simple(trial, text_of({path: each_quantity(value, in_another_format(chance)) for path, value in entries.items()}), expected)

    def order(self, trial, entries, expected, chance):
        return self.simple(trial, text_of(entries, chance), expected)

    def crlf(self, trial, entries, expected, chance):
        return self.simple(trial, "\ufeff" + text_of(entries, chance).replace("\n", "\r\n"), expected)

    def include(self, trial, entries, expected, chance):
        parts = [{}, {}, {}]
        for path, value in entries.items():
            chance.choice(parts)[path] = value
        return self.simple(trial, "include two.prm\n" + text_of(parts[0]), expected,
                           files={"two.prm": text_of(parts[1]) + "include three.prm\n", "three.prm": text_of(parts[2])})

    def override(self, trial, entries, expected, chance):
        """The included file has other numbers, which the one that includes it sets right."""
        wrong = {path: each_quantity(value, lambda number, unit: f"{2. * float(number)!r} {unit}") for path, value in entries.items()}
        right = {path: value for path, value in entries.items() if wrong[path] != value}
        return self.simple(trial, text_of(right, chance) + "include wrong.prm\n", expected, files={"wrong.prm": text_of(wrong)})

    def options(self, trial, entries, expected, chance):
        kept = {path for path in entries if chance.random() < 0.5 or path.split("/")[-1] in ("Table", "Type") or "/" not in path}
        options = [text for path, value in entries.items() if path not in kept for text in ("--set", f"{path}={value}")]
        # Sections keep their order.
        return self.simple(trial, text_of({path: value if path in kept else "" for path, value in entries.items()}), expected, options=options)

    def printed(self, trial, entries, expected, chance):
        """What --print-parameters prints."""
        with open(os.path.join(trial.folder, "first.prm"), "w", encoding="utf-8") as stream:
            stream.write(text_of(entries))
        done = trial.note(self.program.run(["first.prm", "--print-parameters"], trial.folder))
        return self.simple(trial, done.output, expected)

    def parameters(self, trial, entries, expected, chance):
        """What a run writes."""
        output = self.perform_text(text_of(entries), trial.folder, "first", trial, options=("--set", "Time/End time=1 ms"))
        output = self.perform_file(os.path.join(output, "parameters.prm"), os.path.join(trial.folder, "again"), "/", trial,
                                   ("--set", f"Time/End time={entries['Time/End time']}"))
        return expected, read_table(os.path.join(output, "probes.csv")), TOLERANCE

    def in_odd_folder(self, trial, entries, expected, chance):
        """A folder with an odd name, and what the run wrote there."""
        odd = os.path.join(trial.folder, "a #1,  b; c's \u00e4")
        os.mkdir(odd)
        shutil.copy(os.path.join(trial.folder, "pulse.csv"), odd)
        output = self.perform_text(text_of(entries), odd, "first", trial)
        output = self.perform_file(os.path.join(output, "parameters.prm"), os.path.join(odd, "again"), trial.folder, trial)
        return expected, read_table(os.path.join(output, "probes.csv")), TOLERANCE

    def probes(self, trial, entries, expected, chance):
        """Whatever else is written."""
        more = {"Probes/more/Point": entries["Probes/inside/Point"], "Probes/more/Fields": "pressure, velocity",
                "Output/Field interval": "1 ms", "Output/Checkpoint steps": str(chance.randrange(1, 4)), "Output/Final fields": "true"}
        expected, found, tolerance = self.simple(trial, text_of({**entries, **more}), expected)
        return expected, {name: column for name, column in found.items() if not name.startswith("more:")}, tolerance

    def restart(self, trial, entries, expected, chance):
        """In pieces."""
        steps = sorted(chance.sample(range(1, 8), 2))
        keeping = text_of({**entries, "Output/Checkpoint at end": "true"})
        step = float(entries["Time/Time step"].split()[0])
        output = self.perform_text(keeping, trial.folder, "run", trial, options=("--set", f"Time/End time={step * steps[0]!r} ms"))
        path = os.path.join(trial.folder, "run.prm")
        self.perform_file(path, output, trial.folder, trial, ("--restart", "--set", f"Time/End time={step * steps[1]!r} ms"))
        self.perform_file(path, output, trial.folder, trial, ("--restart",))
        return expected, read_table(os.path.join(output, "probes.csv")), TOLERANCE

    def shorter(self, trial, entries, expected, chance):
        """What comes later does not act on what was before."""
        steps = chance.randrange(3, 8)
        step = float(entries["Time/Time step"].split()[0])
        first = {name: column[:steps + 1] for name, column in expected.items()}
        return self.simple(trial, text_of({**entries, "Time/End time": f"{steps * step!r} ms"}), first)

    def scaled(self, trial, entries, expected, scale):
        files = {}
        if "Boundaries/inlet/Table" in entries:
            with open(os.path.join(trial.folder, "pulse.csv"), encoding="utf-8") as stream:
                rows = [line.split(",") for line in stream.read().splitlines()[1:] if line.strip() and not line.startswith("#")]
            files["pulse.csv"] = "time [s], pressure [Pa]\n" + "".join(
                f"{1e-3 * float(t) * scale[1]!r}, {1e3 * float(p) * factor((-1, -2, 1), scale)!r}\n" for t, p in rows)
        expected, found, tolerance = self.simple(trial, text_of(similar(entries, scale)), expected, files=files)
        return expected, {name: [x / factor(powers_of_column(name), scale) for x in column] for name, column in found.items()}, tolerance

    def lengths(self, trial, entries, expected, chance):
        return self.scaled(trial, entries, expected, (2. ** chance.choice((-10, -5, 5, 10)), 1., 1.))

    def times(self, trial, entries, expected, chance):
        return self.scaled(trial, entries, expected, (1., 2. ** chance.choice((-10, -5, 5, 10)), 1.))

    def masses(self, trial, entries, expected, chance):
        return self.scaled(trial, entries, expected, (1., 1., 2. ** chance.choice((-20, -10, 10, 20))))

    def all_scales(self, trial, entries, expected, chance):
        return self.scaled(trial, entries, expected, tuple(2. ** chance.randrange(-8, 9) for _ in range(3)))

    def refined(self, trial, entries, expected, chance):
        """The same cells, divided by the program: two runs of their own."""
        keys = [key for key in entries if key.startswith("Mesh/") and key.endswith("ells")]
        finer = {key: ", ".join(str(2 * int(part)) for part in entries[key].split(",")) for key in keys}
        if "Geometry/Layer thicknesses" in entries:
            finer["Mesh/Wall cells"] = "2"
        one = self.perform_text(text_of({**entries, "Mesh/Refinements": "1"}), trial.folder, "divided", trial)
        other = self.perform_text(text_of({**entries, **finer}), trial.folder, "finer", trial)
        return read_table(os.path.join(one, "probes.csv")), read_table(os.path.join(other, "probes.csv")), TOLERANCE

    def alias(self, trial, entries, expected, chance):
        """Conditions that are not called after their boundaries."""
        boundaries = sorted({path.split("/")[1] for path in entries if path.startswith("Boundaries/")})
        other = {}
        for path, value in entries.items():
            parts = path.split("/")
            if parts[0] == "Boundaries":
                parts[1] = f"condition {boundaries.index(parts[1])}"
            other["/".join(parts)] = value
        for i, boundary in enumerate(boundaries):
            other[f"Boundaries/condition {i}/Boundary"] = boundary
        return self.simple(trial, text_of(other), expected)

    def by_mesh(self, trial, entries, expected, chance, matrix, shift):
        """The block from a mesh that is turned, mirrored and moved, with its loads; the answer turned back."""
        def move(point):
            return tuple(matrix[i][0] * point[0] + matrix[i][1] * point[1] + shift[i] for i in range(2))

        def turned(formulas):
            parts = [part.strip() for part in formulas.split(",")]
            return ", ".join(f"{matrix[i][0]!r}*({parts[0]}) + {matrix[i][1]!r}*({parts[1]})" for i in range(2))

        other = {path: value for path, value in entries.items() if not path.startswith(("Geometry/", "Mesh/"))}
        other.update({"Geometry/Type": "gmsh", "Geometry/File": "own.msh"})
        for path in ("Boundaries/right/Traction", "Body force/Acceleration"):
            other[path] = turned(other[path])
        for probe in ("corner", "inside"):
            point = [1e-3 * float(part.split()[0]) for part in entries[f"Probes/{probe}/Point"].split(",")]
            other[f"Probes/{probe}/Point"] = ", ".join(f"{x!r} m" for x in move(point))
        expected, found, tolerance = self.simple(trial, text_of(other), expected, files={"own.msh": mesh_text(chance, move)})
        back = dict(found)
        for name in found:
            if name.split(" [")[0].endswith((" x", " y")):
                parts = [found[re.sub(r" [xy] \[", f" {axis} [", name)] for axis in "xy"]
                i = 0 if " x [" in name else 1
                back[name] = [matrix[0][i] * a + matrix[1][i] * b for a, b in zip(*parts)]
        return expected, back, tolerance

    def numbering(self, trial, entries, expected, chance):
        return self.by_mesh(trial, entries, expected, chance, ((1., 0.), (0., 1.)), (0., 0.))

    def moved(self, trial, entries, expected, chance):
        return self.by_mesh(trial, entries, expected, chance, ((1., 0.), (0., 1.)), (chance.uniform(-1., 1.), chance.uniform(-1., 1.)))

    def turned(self, trial, entries, expected, chance):
        angle = chance.choice((math.pi / 2, math.pi, chance.uniform(0., 6.)))
        return self.by_mesh(trial, entries, expected, chance, ((math.cos(angle), -math.sin(angle)), (math.sin(angle), math.cos(angle))), (0., 0.))

    def mirrored(self, trial, entries, expected, chance):
        matrix = chance.choice((((-1., 0.), (0., 1.)), ((1., 0.), (0., -1.)), ((0., 1.), (1., 0.))))
        return self.by_mesh(trial, entries, expected, chance, matrix, (0., 0.))

    LOADS = ("Boundaries/right/Traction", "Body force/Acceleration")

    def load(self, trial, entries, expected, chance):
        """So many times the loads, so many times the answer."""
        size = chance.choice((-1., 1e-6, 1e6))
        for path in self.LOADS:
            entries[path] = ", ".join(f"{size!r}*({part.strip()})" for part in entries[path].split(","))
        expected, found, tolerance = self.simple(trial, text_of(entries), expected)
        return expected, {name: [x / size for x in column] if name != "time [s]" else column for name, column in found.items()}, tolerance

    def superposition(self, trial, entries, expected, chance):
        """Each load alone; their answers are added. One is ten thousand times as small as the other."""
        both = dict(entries)
        both[self.LOADS[1]] = ", ".join(f"1e-4*({part.strip()})" for part in entries[self.LOADS[1]].split(","))
        tables = []
        for i, name in enumerate(("both", "first", "second")):
            of_run = dict(both)
            if i > 0:
                of_run[self.LOADS[2 - i]] = "0, 0"
            tables.append(read_table(os.path.join(self.perform_text(text_of(of_run), trial.folder, name, trial), "probes.csv")))
        total = {name: [a + b for a, b in zip(column, tables[2][name])] if name != "time [s]" else column for name, column in tables[1].items()}
        return tables[0], total, TOLERANCE

    def space(self, trial, entries, expected, chance):
        """Plane strain as a slab between rollers."""
        entries.update({"Model": "three-dimensional", "Geometry/Size": "20 mm, 10 mm, 5 mm", "Mesh/Cells": "4, 2, 1",
                        "Boundaries/front/Type": "roller", "Boundaries/back/Type": "roller",
                        "Boundaries/right/Traction": entries["Boundaries/right/Traction"] + ", 0",
                        "Body force/Acceleration": entries["Body force/Acceleration"] + ", 0"})
        for probe in ("corner", "inside"):
            entries[f"Probes/{probe}/Point"] += ", 2 mm"
        expected, found, tolerance = self.simple(trial, text_of(entries), expected)
        return expected, {name: column for name, column in found.items() if " z [" not in name}, tolerance

    def sum_of_formulas(self, trial, entries, expected, chance):
        """The same formula, written in another way."""
        entries["Boundaries/right/Traction"] = "400 - 400*cos(1000*t), 600*sin(200*t)*cos(200*t)"
        return self.simple(trial, text_of(entries), expected)
