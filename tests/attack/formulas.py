"""Formulas of loads: odd ones are refused or computed; constant ones give what their value gives."""

import math
import os
import random
import shutil

import runs
from program import Verdict, defect, judge_reading

# Where the formula stands: sections, keys with what stands before it, and what a message may name.
PLACES = {"traction": ("  subsection right\n    set Type     = traction\n    set Traction = 0, {}\n  end\n",
                       "Boundaries",
                       ("Traction", "Boundaries")),
          "pressure": ("  subsection right\n    set Type     = pressure\n    set Pressure = {}\n  end\n", "Boundaries",
                       ("Pressure", "Boundaries")),
          "body force": ("    set Force density = {}, 0\n", "Body force", ("Force density", "Body force"))}
ODD = ("1/0", "0/0", "t/0", "1/t", "1/(t-0.25)", "sqrt(-1)", "log(0)", "log(-1)", "ln(0)", "asin(2)", "exp(1000)",
       "exp(exp(9))", "1e400", "1e308*10", "0*exp(1000)", "nan", "inf", "-inf", "NaN", "1/(x-1)", "x/(y-y)",
       "if(t>0, 1, 0)", "if(t>0,1)", "t>0 ? 1 : 0", "t>0 ? 1", "((((((((1))))))))", "(", ")", "()", "1+", "*2", "2**3",
       "2^^3", "2^3^4^5", "--1", "-+-1", "1 2", "x y", "t t", "sin", "sin()", "sin(1,2)", "sinus(1)", "unknown", "t.x",
       "x[0]", "\"text\"", "'x'", "1,5", "1;2", "1e", "0x1F", "#1", "1e-400", "5e-324", "rnd", "rand()", "rand_seed(1)",
       "a=1", "x=2", "t:=1", "pi", "_pi", "e", "_e", "min()", "max(1,2,3,4,5,6,7,8,9,10)", "sum()", "avg(1)", "1&&0",
       "1||0", "1==1", "t<x", "!1", "1%2", "int(2.7)", "ceil(1e300)", "floor(-0.5)", "mod(1,0)", "pow(0,-1)", "0^0",
       "0^-1", "(-8)^(1/3)", "tan(1.5707963267948966)", "erf(1)", "jn(0,1)", "m", "1 m", "1 Pa", "1 kPa*t", "\u00b5",
       "\u03c0", "1\u00a0+1", "\u22121", "t\u00b2", "%s%n", "$(date)", "`date`", "1\\", "", " ", "x" * 3000,
       "+".join(["t"] * 3000), "(" * 3000 + "1" + ")" * 3000, "(" * 100000, "-" * 20000 + "1",
       "sin(" * 2000 + "t" + ")" * 2000)
FUNCTIONS = {"sin": math.sin, "cos": math.cos, "tan": math.tan, "exp": math.exp, "sqrt": math.sqrt, "abs": abs}
OPERATIONS = {"+": lambda a, b: a + b, "-": lambda a, b: a - b, "*": lambda a, b: a * b, "/": lambda a, b: a / b,
              "^": lambda a, b: a ** b}


def random_formula(chance, depth):
    """(text, value) of a formula without variables; may raise ArithmeticError or ValueError."""
    if depth == 0 or chance.random() < 0.2:
        text = chance.choice((f"{chance.uniform(0, 10):.3f}", str(chance.randrange(9)), f"{chance.uniform(1, 9):.2e}"))
        return text, float(text)
    if chance.random() < 0.3:
        name = chance.choice(sorted(FUNCTIONS))
        text, value = random_formula(chance, depth - 1)
        return f"{name}({text})", FUNCTIONS[name](value)
    symbol = chance.choice(sorted(OPERATIONS))
    (left, a), (right, b) = random_formula(chance, depth - 1), random_formula(chance, depth - 1)
    value = OPERATIONS[symbol](a, b)
    if isinstance(value, complex) or not math.isfinite(value):
        raise ArithmeticError
    return f"({left}){symbol}({right})", value


class Attack:
    name = "formulas"
    summary = "odd formulas of loads; constant formulas against their value"

    def __init__(self, program, options):
        self.program = program

    def prepare(self, folder):
        self.case = os.path.join(folder, "case")
        shutil.copytree(runs.CASES, self.case)
        for place in PLACES:
            runs.must_be_valid(self.program, folder, [self.file(folder, "formula.prm", place, "1")])

    def corpus(self):
        return runs.corpus_lines("formulas.txt")

    def trials(self, number, seed):
        """Names: `odd PLACE NUMBER`, of the list above, and `constant PLACE SEED`."""
        chance = random.Random(seed)
        odd = [f"odd {place} {number}" for place in PLACES for number in range(len(ODD))]
        chance.shuffle(odd)
        constant = [f"constant {chance.choice(sorted(PLACES))} {chance.randrange(10**9)}" for _ in range(number)]
        if number > 2 * len(odd):
            return odd + constant
        return [name for pair in zip(odd, constant) for name in pair][:number]

    def file(self, folder, name, place, formula):
        entry, section, _ = PLACES[place]
        text = f"include {os.path.join(os.path.relpath(self.case, folder), 'box.prm')}\nsubsection {section}\n"
        text += entry.format(formula) + "end\n"
        if section != "Boundaries":
            text += "subsection Boundaries\n  subsection right\n    set Type = free\n  end\nend\n"
        path = os.path.join(folder, name)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)
        return path

    def perform(self, trial):
        kind, rest = trial.name.split(" ", 1)
        place, number = rest.rsplit(" ", 1)
        value = None
        if kind == "formula":
            # In the corpus the formula itself stands last.
            place, number = next((place, rest[len(place) + 1:]) for place in PLACES if rest.startswith(place))
            formula = number
        elif kind == "odd":
            formula = ODD[int(number)]
        else:
            chance = random.Random(trial.name)
            while value is None:
                try:
                    formula, value = random_formula(chance, 4)
                except (ArithmeticError, ValueError):
                    pass
        done, output = self.run(trial, "formula.prm", place, formula)
        names = {"formula.prm", *PLACES[place][2]}
        found = defect(done, names) if done.status == 1 else judge_reading(done, names)
        if found:
            return found if value is None or found.kind != "refused" else Verdict("wrong", f"'{formula}' was refused")
        if done.status == 1:
            return Verdict("refused", "") if value is None else Verdict("wrong", f"the run with '{formula}' failed")
        table = runs.results(output).get("probes.csv", b"")
        if b"nan" in table.lower() or b"inf" in table.lower():
            return Verdict("wrong", "exit status 0, but probes.csv has what is no number")
        return self.compare(trial, place, formula, value, output) if value is not None else Verdict("accepted", "")

    def run(self, trial, name, place, formula):
        output = os.path.join(trial.folder, name + "-run")
        path = self.file(trial.folder, name, place, formula)
        return trial.note(self.program.run([path, "--output", output], trial.folder)), output

    def compare(self, trial, place, formula, value, output):
        done, other = self.run(trial, "value.prm", place, repr(value))
        if done.status != 0:
            return Verdict("wrong", f"the run with {value!r} ends with {done.status}")
        one, two = (self.numbers(folder) for folder in (output, other))
        scale = max(map(abs, two)) or 1.
        if len(one) != len(two) or any(abs(a - b) > 1e-9 * scale for a, b in zip(one, two)):
            return Verdict("wrong", f"'{formula}' gives something else than its value {value!r}")
        return Verdict("accepted", "")

    @staticmethod
    def numbers(output):
        with open(os.path.join(output, "probes.csv"), encoding="utf-8") as stream:
            return [float(cell) for row in stream.read().splitlines()[1:] for cell in row.split(",")[1:]]
