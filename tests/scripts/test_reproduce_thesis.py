#!/usr/bin/python3
"""scripts/reproduce-thesis: what it refuses, how it judges, and that its data fit together."""

import ast
import json
import os
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
SCRIPT = os.path.join(ROOT, "scripts", "reproduce-thesis")
sys.path.insert(0, os.path.join(ROOT, "scripts", "lib"))
sys.dont_write_bytecode = True

import continua  # noqa: E402
import numpy  # noqa: E402

from thesis import functions, functions_6, judge, page, pictures, reference, results  # noqa: E402


def call(*arguments):
    return subprocess.run(["/usr/bin/python3", "-B", SCRIPT, *arguments], capture_output=True, text=True, check=False)


def write_run(folder, name, quantities, status="finished"):
    """A finished run of parameter_files/NAME in the folder of runs."""
    os.makedirs(os.path.join(folder, name))
    with open(os.path.join(folder, name, "summary.json"), "w", encoding="utf-8") as stream:
        json.dump({"version": continua.__version__, "status": status, "title": name, "wall time [s]": {"total": 2.0},
                   "quantities": [{"probe": probe, "name": quantity, "value": value, "unit": "1"}
                                  for (probe, quantity), value in quantities.items()]}, stream)


def entry(kind="number", measure=None, **data):
    made = reference.Entry(kind, {"id": "4.3-test", "chapter": "4", "text": "a value", "place": "somewhere", **data})
    made.measure = measure or {}
    return made


FOLDERS = ("chapter-", "appendix-a/", "verification/", "examples/")
BEAM = "quantity('chapter-4/beam', 'tip: maximum displacement y')"


class Judging(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        write_run(self.temporary.name, "thesis/chapter-4/beam", {("tip", "maximum displacement y"): 0.62, ("", "steps"): 10.0})
        self.results = results.Results(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def verdict(self, **arguments):
        return judge.Row(entry(**arguments), self.results)

    def test_numbers(self):
        measure = {"taylor_hood": BEAM}
        row = self.verdict(measure=measure, value=0.6, band=0.05, unit="m")
        self.assertEqual((row.verdict, row.value, row.cost), (judge.AGREES, 0.62, 2.0))
        self.assertAlmostEqual(row.deviation(), 0.62 / 0.6 - 1)
        self.assertEqual(self.verdict(measure=measure, value=0.6, band=0.03).verdict, judge.DIFFERS)
        explained = {**measure, "ours": 0.621, "ours_band": 0.002}
        row = self.verdict(measure=explained, value=0.5, band=0.03, deviation="a reason")
        self.assertEqual((row.verdict, row.why), (judge.EXPLAINED, "a reason"))
        self.assertEqual(self.verdict(measure={**explained, "ours": 0.63}, value=0.5, band=0.03).verdict, judge.CHANGED)
        # Also where the deviation is gone.
        self.assertEqual(self.verdict(measure={**explained, "ours": 0.63}, value=0.62, band=0.03).verdict, judge.CHANGED)
        self.assertEqual(self.verdict(measure=explained, value=0.62, band=0.03).verdict, judge.AGREES)
        self.assertEqual(self.verdict(measure={**measure, "holds": "< 0.63"}, value=0.5, band=0.0).verdict, judge.AGREES)

    def test_findings(self):
        for holds, verdict in (("> 0.6", judge.AGREES), ("> 0.7", judge.DIFFERS), ("0.5 .. 0.7", judge.AGREES),
                               ("0.7 .. 0.8", judge.DIFFERS)):
            self.assertEqual(self.verdict(kind="finding", measure={"cell_wise": BEAM, "holds": holds}).verdict, verdict)
        with self.assertRaises(ValueError):
            judge.criterion("about 3")

    def test_reasons_and_notes(self):
        texts = {"deviation": "a reason", "note": "a note"}
        measure = {"taylor_hood": BEAM, "ours": 0.62, "why": "another"}
        self.assertEqual(self.verdict(measure=measure, value=0.5, band=0.03, **texts).why, "a reason another a note")
        self.assertEqual(self.verdict(measure=measure, value=0.62, band=0.03, **texts).why, "a note")

    def test_what_cannot_be_judged(self):
        self.assertEqual(self.verdict(comparable=False, why_not="lost").verdict, judge.NOT_COMPARABLE)
        self.assertEqual(self.verdict().verdict, judge.NOT_MEASURED)
        row = self.verdict(measure={"taylor_hood": "quantity('chapter-4/beam-3d', 'x')"}, value=1.0, band=0.1)
        self.assertEqual((row.verdict, row.why), (judge.NOT_RUN, "chapter-4/beam-3d: the run was not made"))
        # What is wrong with the measure itself is a failure.
        for expression, why in (("quantity('chapter-4/beam', 'drag')", "has no 'drag'"), ("1 / 0", "ZeroDivisionError"),
                                ("quantity('chapter-4/bean', 'x')", "no parameter file"), ("run('chapter-4/beam').summary['x']", "KeyError"),
                                ("np.nan", "no finite number")):
            row = self.verdict(measure={"taylor_hood": expression}, value=1.0, band=0.1)
            self.assertEqual(row.verdict, judge.BROKEN)
            self.assertIn(why, row.why)
        row = self.verdict(measure={"taylor_hood": BEAM, "unjudged": "a time"}, value=1.0, band=0.1)
        self.assertEqual((row.verdict, row.why), (judge.SHOWN, "a time"))
        for kind, verdict in (("formula", judge.FORMULA), ("input", judge.INPUT)):
            self.assertEqual(self.verdict(measure={"theory": "sqrt(4)", "kind": kind}, value=2.0, band=0.1).verdict, verdict)
            self.assertEqual(self.verdict(measure={"theory": "sqrt(4)", "kind": kind}, value=3.0, band=0.1).verdict, judge.DIFFERS)
        self.assertIn(judge.BROKEN, judge.FAILURES)
        write_run(self.temporary.name, "thesis/chapter-4/beam-euler-30s", {}, "running")
        row = self.verdict(measure={"taylor_hood": "quantity('chapter-4/beam-euler-30s', 'x')"}, value=1.0, band=0.1)
        self.assertEqual(row.verdict, judge.NOT_RUN)

    def test_runs_older_than_the_program(self):
        program = os.path.join(self.temporary.name, "program")
        with open(program, "w", encoding="utf-8"):
            pass
        os.utime(program, (2e9, 2e9))
        row = judge.Row(entry(measure={"taylor_hood": BEAM}, value=0.6, band=0.05), results.Results(self.temporary.name, program))
        self.assertEqual(row.verdict, judge.NOT_RUN)
        self.assertIn("older", row.why)

    def test_guards(self):
        for holds, verdict in (("0.61 .. 0.63", judge.GUARD), ("0.63 .. 0.65", judge.CHANGED)):
            row = self.verdict(measure={"taylor_hood": BEAM, "kind": "guard", "holds": holds}, unit="m")
            self.assertEqual((row.verdict, page.thesis_value(row.entry), row.deviation()), (verdict, "-", None))

    def test_an_old_run_that_failed(self):
        program = os.path.join(self.temporary.name, "program")
        with open(program, "w", encoding="utf-8"):
            pass
        measure = {"cell_wise": "diverges('chapter-4/blow-up/fv-pressure-shear')"}
        write_run(self.temporary.name, "thesis/chapter-4/blow-up/fv-pressure-shear", {}, "failed")
        path = os.path.join(self.temporary.name, "thesis/chapter-4/blow-up/fv-pressure-shear", "summary.json")
        with open(path, "w", encoding="utf-8") as stream:
            json.dump({"version": continua.__version__, "status": "failed", "failure": "the loop diverges"}, stream)
        for age, verdict in ((1e9, judge.AGREES), (4e9, judge.NOT_RUN)):
            os.utime(program, (age, age))
            os.utime(path, (3e9, 3e9))
            found = results.Results(self.temporary.name, program)
            self.assertEqual(judge.Row(entry(measure=measure, value=1.0, band=0.0), found).verdict, verdict)
            parameters = os.path.join(judge.case_runs.ROOT, "parameter_files/thesis/chapter-4/blow-up/fv-pressure-shear.prm")
            self.assertEqual(found.is_there(parameters), verdict == judge.AGREES)

    def test_quantities_of_several_probes(self):
        write_run(self.temporary.name, "thesis/chapter-4/beam-3d", {("tip", "height"): 1.0, ("middle", "height"): 2.0, ("tip", "width"): 3.0})
        for name, value in (("tip: height", 1.0), ("middle: height", 2.0), ("width", 3.0)):
            self.assertEqual(self.results.quantity("chapter-4/beam-3d", name), value)
        with self.assertRaisesRegex(results.Broken, "several probes have 'height'"):
            self.results.quantity("chapter-4/beam-3d", "height")

    def test_repeated_measures(self):
        rows = [self.verdict(id=name, measure={"taylor_hood": BEAM, **same}, value=value, band=0.05)
                for name, same, value in (("one", {}, 0.6), ("two", {"same_as": "one"}, 0.6), ("three", {"same_as": "one"}, 0.5))]
        self.assertEqual([row.entry.id for row in judge.repeated(rows)], ["two"])
        self.assertEqual((judge.counts(rows)[judge.AGREES], judge.counts(rows)[judge.DIFFERS]), (1, 1))

    def test_waves_of_a_probe(self):
        folder = os.path.join(self.temporary.name, "thesis/chapter-4/beam")
        for probe, value in (("one", 1.0), ("two", 2.0)):
            with open(os.path.join(folder, f"wave-{probe}.csv"), "w", encoding="utf-8") as stream:
                stream.write(f'time [s],"{probe} 0.1 m: pressure, simulated [Pa]"\n0,{value}\n1,{value}\n')
        for probe, value in ((None, 1.0), ("one", 1.0), ("two", 2.0)):
            self.assertEqual(self.results.wave("chapter-4/beam", probe)["pressure"].best()[0][1], value)
        with self.assertRaisesRegex(results.Broken, "no probe 'three'"):
            self.results.wave("chapter-4/beam", "three")

    def test_page(self):
        rows = [self.verdict(measure={"taylor_hood": BEAM}, value=0.5, band=0.03, unit="m", slip="a <slip>")]
        figure = reference.Figure({"id": "figure 4.3", "chapter": "4", "caption": "what it shows", "reproduced": True})
        path = os.path.join(self.temporary.name, "page.html")
        page.write(path, [figure], rows, {}, ["made so"])
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
        for part in ("Figure 4.3", "a &lt;slip&gt;", "+24 %", 'class="DIFFERS"', "made so", "continua parameter_files/thesis/chapter-4/beam.prm"):
            self.assertIn(part, text)
        self.assertNotIn("<script", text)


class Data(unittest.TestCase):
    def test_expressions(self):
        _, entries = reference.read()
        names = {"quantity", "column", "run", "wave", *functions.ALL, "abs", "min", "max", "sum", "range", "len", "sorted", "sqrt", "exp",
                 "log", "sin", "cos", "gamma", "atan"}
        measured = [item for item in entries if item.sources]
        self.assertGreater(len(measured), 0)
        for item in measured:
            if "holds" in item.measure:
                judge.criterion(item.measure["holds"])
            for expression in item.sources.values():
                with self.subTest(item.id):
                    for node in ast.walk(ast.parse(expression, mode="eval")):
                        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                            self.assertIn(node.func.id, names)
                        if isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value.startswith(FOLDERS):
                            self.assertIsNotNone(results.parameter_file(node.value), node.value)
                    files = results.files_of(expression)
                    if expression == item.sources[item.judged] and not files:
                        self.assertEqual(item.measure.get("kind"), "formula")
                    if any(f"{name}(" in expression for name in ("quantity", "column", "wave")):
                        self.assertTrue(files, f"{expression} names no parameter file")

    def test_kinds_and_repetitions(self):
        data = "".join(f'[[number]]\nid = "{name}"\nchapter = "2"\nvalue = 1.0\n' for name in "nm")
        data = '[[figure]]\nid = "f"\nchapter = "2"\n[[finding]]\nid = "g"\nchapter = "2"\n' + data
        for measures, refused in (('[n]\ntheory = "1"\n[m]\ntheory = "1"\n', 'needs same_as = "n"'),
                                  ('[n]\ntheory = "1"\n[m]\nsame_as = "n"\ntheory = "1"\n', ""),
                                  ('[n]\ntheory = "1"\n[m]\nsame_as = "n"\ntheory = "2"\n', "not judged by the expression of 'n'"),
                                  ('[n]\nkind = "guess"\ntheory = "1"\n', "not 'input', 'formula' or 'guard'")):
            with tempfile.TemporaryDirectory() as folder:
                paths = [os.path.join(folder, name) for name in ("thesis.toml", "chapter_2.toml")]
                for path, content in zip(paths, (data, measures)):
                    with open(path, "w", encoding="utf-8") as stream:
                        stream.write(content)
                with unittest.mock.patch.multiple(reference, FILE=paths[0], HERE=folder):
                    if refused:
                        self.assertRaisesRegex(reference.DataError, refused, reference.read)
                    else:
                        reference.read()

    def test_drawings_name_files(self):
        figures, _ = reference.read()
        known = {figure.id for figure in figures}
        for name, drawing in pictures.all_drawings().items():
            self.assertIn(name, known)
            for file in drawing.files:
                self.assertIsNotNone(results.parameter_file(file), file)

    def test_reasons_need_an_explained_value(self):
        # Beside an agreement the reason of a deviation is wrong, or it is a note.
        data = '[[figure]]\nid = "f"\nchapter = "2"\n[[finding]]\nid = "g"\nchapter = "2"\n[[number]]\nid = "n"\nchapter = "2"\nvalue = 1.0\n'
        for text, measure, refused in (("", "", False), ('deviation = "why"', "", True), ('note = "so"', "", False),
                                       ('deviation = "why"', "ours = 2", False), ("", 'why = "so"', True)):
            with tempfile.TemporaryDirectory() as folder:
                paths = [os.path.join(folder, name) for name in ("thesis.toml", "chapter_2.toml")]
                for path, content in zip(paths, (f"{data}{text}\n", f'[n]\ntheory = "1"\n{measure}\n')):
                    with open(path, "w", encoding="utf-8") as stream:
                        stream.write(content)
                with unittest.mock.patch.multiple(reference, FILE=paths[0], HERE=folder):
                    if refused:
                        self.assertRaisesRegex(reference.DataError, "without the value 'ours'", reference.read)
                    else:
                        reference.read()

    def test_the_calculation_of_chapter_6(self):
        # A short pulse at the first station: the closed end doubles the pressure and stops the flow, and the wave travels at the speed of
        # Moens and Korteweg, 2.6256 m/s, less 3 % for the viscosity at most.
        time = numpy.arange(0, 0.5, 1e-3)
        pulse = numpy.where(time < 0.05, numpy.sin(numpy.pi * time / 0.05)**2, 0.0)
        length = 1.03 * functions_6.LENGTH
        waves = functions_6.Calculation("a", "elastic", numpy.array([0.005, 0.205, length]), time, pulse, 0.08)
        forward, backward, pressure, flow = (waves.fields[name] for name in ("forward wave", "backward wave", "pressure", "flow rate"))
        until = waves.time < 0.08
        self.assertLess(numpy.max(numpy.abs(forward[0][until] - numpy.interp(waves.time[until], time, pulse))), 0.01)
        self.assertLess(numpy.max(numpy.abs(forward[2] - backward[2])), 1e-9)
        self.assertLess(numpy.max(numpy.abs(pressure[2] - 2 * forward[2])), 1e-9)
        self.assertLess(numpy.max(numpy.abs(flow[2])), 1e-9 * numpy.max(numpy.abs(flow[1])))
        early = waves.time < 0.15
        speed = 0.2 / (waves.time[early][numpy.argmax(forward[1][early])] - 0.025)
        self.assertTrue(0.97 * 2.6256 < speed < 2.6256, speed)

    def test_formulas_need_no_runs(self):
        value = results.Results("/nowhere").value("bernoulli_root(1)")
        self.assertAlmostEqual(value, 1.875104, places=6)


class Calls(unittest.TestCase):
    def test_refusals(self):
        with tempfile.TemporaryDirectory() as folder:
            for arguments, text in ((("--chapter", "8"), "no chapter '8'"), (("--jobs", "0"), "at least 1"),
                                    (("--quick", "--all"), "not allowed"), (("--program", "/nowhere"), "no program")):
                done = call(*arguments, "--output", os.path.join(folder, "new"))
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn(text, done.stderr)
            self.assertFalse(os.path.exists(os.path.join(folder, "new")))
            with open(os.path.join(folder, "letter.txt"), "w", encoding="utf-8"):
                pass
            done = call("--report", "--output", folder)
            self.assertEqual(done.returncode, 2)
            self.assertIn("holds something else", done.stderr)

    def test_report_without_runs(self):
        with tempfile.TemporaryDirectory() as folder:
            done = call("--report", "--no-pdf", "--chapter", "2", "--output", folder)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertIn("0 of ", done.stdout)
            # A part does not take the place of the whole.
            self.assertTrue(os.path.exists(os.path.join(folder, "thesis-chapter-2.html")))
            self.assertTrue(os.path.exists(os.path.join(folder, "thesis-chapter-2.csv")))
            self.assertFalse(os.path.exists(os.path.join(folder, "thesis.html")))
            again = call("--report", "--no-pdf", "--chapter", "2", "--output", folder)
            self.assertEqual(again.returncode, 0, again.stderr)


if __name__ == "__main__":
    unittest.main()
