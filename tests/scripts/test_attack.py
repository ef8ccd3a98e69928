#!/usr/bin/python3
"""The tools of scripts/attack/run: their own readers, the failing operations, the loss of power, the verdicts."""

import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "..", "..")
sys.path.insert(0, os.path.join(HERE, "..", "attack"))
sys.dont_write_bytecode = True

import archive  # noqa: E402
import files  # noqa: E402
import mesh_reader  # noqa: E402
import parameter_reader  # noqa: E402
import power  # noqa: E402
import program  # noqa: E402
import runs  # noqa: E402
import table_reader  # noqa: E402

WRITE = ("import os; f = os.open('work/file', os.O_WRONLY | os.O_CREAT | os.O_TRUNC); n = os.write(f, b'0123456789'); "
         "os.close(f); print(n)")


def write(path, text):
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)


def read(path):
    with open(path, encoding="utf-8") as stream:
        return stream.read()


class Readers(unittest.TestCase):
    def test_parameters(self):
        with tempfile.TemporaryDirectory() as folder:
            write(os.path.join(folder, "base.prm"), "subsection A\n  set B = 1 \\\n 2 # comment\nset C = 3\nend\n")
            path = os.path.join(folder, "case.prm")
            write(path, "include base.prm\nsubsection A\n set  B=7\nend\n")
            self.assertEqual(parameter_reader.read(path), {b"A/B": b"7", b"A/C": b"3"})
            for text in ("set A = 1\nset A = 2\n", "end\n", "subsection A\n", "sett A = 1\n", "include case.prm\n",
                         "set = 1\n"):
                write(path, text)
                with self.assertRaises(parameter_reader.Unreadable, msg=text):
                    parameter_reader.read(path)

    def test_misfits(self):
        for value in ("1,5 mm", "0x10", "1e", "nan", "-1 mm", "0"):
            self.assertTrue(parameter_reader.misfit(value, "number > 0"), value)
        for value in ("1.5 mm", "2e-3", ".5 m/s^2", "3 %"):
            self.assertEqual(parameter_reader.misfit(value, "number > 0"), "", value)
        self.assertTrue(parameter_reader.misfit("2.5", "whole number >= 1"))

    def test_tables(self):
        self.assertEqual(table_reader.plain(b"\xef\xbb\xbf# c\r\ntime [ms];\tp [kPa, x]\r\n\r\n0; 1\r\n", 2),
                         b"time [ms]; p [kPa, x]\n0; 1\n")
        for data in (b"", b"a, b\n1, 2, 3\n", b"a, b\n1, x\n", b"a, b\n1, 1e400\n"):
            with self.assertRaises(table_reader.Unreadable):
                table_reader.plain(data, 2)

    def test_meshes(self):
        with open(os.path.join(runs.CASES, "block.msh"), "rb") as stream:
            data = stream.read()
        plain = mesh_reader.plain(data)
        self.assertEqual(mesh_reader.plain(plain), plain)
        with self.assertRaises(mesh_reader.Unreadable):
            mesh_reader.plain(data.replace(b"$EndNodes\n", b""))
        with self.assertRaises(mesh_reader.Unreadable):
            mesh_reader.plain(data.replace(b"$EndElements", b"7 1 2 3 4\n$EndElements"))

    def test_archives(self):
        one = archive.Archive.__new__(archive.Archive)
        one.head, one.records = archive.MAGIC + bytes(8), [[b"t", b"name", b"text"], [b"d", b"time", bytes(8)]]
        data = one.sealed()
        self.assertEqual(archive.Archive(data).records, one.records)
        with self.assertRaises(ValueError):
            archive.Archive(data[:-9] + b"x" + data[-8:])
        self.assertNotEqual(one.sealed({(0, 2): 5}), data)


class Faults(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.library = files.build_library(cls.folder.name)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def run_with(self, fault, code=WRITE):
        """(exit status, what was printed, what the file holds) of a small program in whose folder an operation
        fails."""
        with tempfile.TemporaryDirectory(dir=self.folder.name) as folder:
            work = os.path.join(folder, "work")
            os.mkdir(work)
            environment = {**os.environ, "LD_PRELOAD": self.library, "CONTINUA_FAULT": fault,
                           "CONTINUA_FAULT_FOLDERS": f"out={os.path.realpath(work)}",
                           "CONTINUA_FAULT_LOG": os.path.join(folder, "log")}
            done = subprocess.run(["/usr/bin/python3", "-c", code], cwd=folder, env=environment, capture_output=True,
                                  text=True,
                                  check=False)
            path = os.path.join(work, "file")
            self.log = power.read_log(os.path.join(folder, "log"))
            return done.returncode, done.stdout + done.stderr, read(path) if os.path.exists(path) else None

    def test_kinds(self):
        self.assertEqual(self.run_with(""), (0, "10\n", "0123456789"))
        self.assertEqual([entry[:3] for entry in self.log],
                         [("open", "out/file", 1), ("write", "out/file", 1), ("close", "out/file", 1)])
        status, text, content = self.run_with("once write 1 out/file")
        self.assertEqual((status, content), (1, ""))
        self.assertIn("No space left", text)
        self.assertEqual(self.log[1][0], "fault")
        self.assertEqual(self.run_with("short write 1 out/file"), (0, "5\n", "01234"))
        self.assertEqual(self.run_with("kill write 1 out/file")[::2], (-9, ""))
        self.assertEqual(self.run_with("half write 1 out/file")[::2], (-9, "01234"))
        self.assertEqual(self.run_with("once open 1 out/file")[::2], (1, None))
        self.assertEqual(self.run_with("once write 2 out/file")[0], 0)

    def test_for_ever(self):
        twice = WRITE.replace("print(n)", "f = os.open('work/file', os.O_RDONLY); print(os.read(f, 3))")
        self.assertEqual(self.run_with("once write 2 out/file", twice)[0], 0)
        self.assertEqual(self.run_with("once read 1 out/file", twice)[0], 1)
        status, text, _ = self.run_with("ever write 1 out/file", "import os\ntry:\n  " + WRITE.replace("; ", "\n  ")
                                        + "\nexcept OSError: os.open('work/file', os.O_RDONLY)")
        self.assertEqual(status, 1)
        self.assertIn("Input/output error", text)


class Power(unittest.TestCase):
    def test_what_is_not_flushed_is_lost(self):
        with tempfile.TemporaryDirectory() as folder:
            out, shadow = os.path.join(folder, "out"), os.path.join(folder, "shadow")
            os.mkdir(out)
            os.mkdir(shadow)
            write(os.path.join(out, "old"), "old")
            disk = power.Disk(out)
            for name in ("flushed", "half", "never", "old"):
                write(os.path.join(out, name), "0123456789")
            write(os.path.join(shadow, "0"), "old")
            log = [("open", "out/flushed", 1, ["new"]), ("write", "out/flushed", 1, ["0"]), ("fsync", "out/flushed",
                                                                                             1, ["10"]),
                   ("open", "out/half", 1, ["new"]), ("write", "out/half", 1, ["0"]), ("fsync", "out/half", 1, ["4"]),
                   ("write", "out/half", 2, ["4"]), ("fsync", "out", 1, ["4096"]), ("open", "out/never", 1, ["new"]),
                   ("write", "out/never", 1, ["0"]), ("open", "out/old.new", 1, ["new"]), ("write", "out/old.new", 1,
                                                                                           ["0"]),
                   ("fsync", "out/old.new", 1, ["10"]), ("rename", "out/old.new", 1, ["out/old", "0"])]
            disk.follow(log).lose_power(True, shadow)
            self.assertEqual({name: data for name, data in runs.content(out).items()},
                             {"flushed": b"0123456789", "half": b"0123", "old": b"old"})

    def test_complete_checkpoints(self):
        log = [("rename", "out/checkpoint/current.new", 1, ["out/checkpoint/current", "-1"])]
        self.assertTrue(power.has_complete_checkpoint(log, False))
        self.assertFalse(power.has_complete_checkpoint(log, True))
        self.assertTrue(power.has_complete_checkpoint(log + [("fsync", "out/checkpoint", 1, [""])], True))


class Runs(unittest.TestCase):
    def test_many_trials_disturb_each_run(self):
        self.assertEqual(set(runs.runs_of_trials(20, 1)), set(runs.RUNS))

    def test_few_trials_disturb_one_run_that_the_seed_chooses(self):
        chosen = [runs.runs_of_trials(4, seed) for seed in range(1, len(runs.RUNS))]
        self.assertTrue(all(len(set(names)) == 1 and len(names) == 4 for names in chosen))
        self.assertEqual([names[0] for names in chosen], [name for name in runs.RUNS if name != "channel"])

    def test_each_run_has_its_file(self):
        for name, run in runs.RUNS.items():
            self.assertTrue(os.path.isfile(os.path.join(runs.CASES, run.file)), name)

    def state(self, folder, cells):
        """A run with one state of fields, of lines from x to x + 1 whose value is x."""
        os.makedirs(os.path.join(folder, "fields"))
        write(os.path.join(folder, "summary.json"), "{}")
        write(os.path.join(folder, "fields.pvd"), '<VTKFile><Collection><DataSet timestep="0" file="fields/0.vtu"/></Collection></VTKFile>')

        def array(name, kind, numbers, width=1):
            return f'<DataArray Name="{name}" type="{kind}" NumberOfComponents="{width}" format="ascii">' \
                   f'{" ".join(map(str, numbers))}</DataArray>'
        points = [number for x in cells for number in (x, 0, 0, x + 1, 0, 0)]
        write(os.path.join(folder, "fields", "0.vtu"),
              f'<VTKFile><UnstructuredGrid><Piece NumberOfCells="{len(cells)}"><Points>{array("", "Float64", points, 3)}</Points>'
              f'<PointData>{array("p", "Float64", [x for x in cells for _ in range(2)])}</PointData><Cells>'
              f'{array("connectivity", "Int32", range(2 * len(cells)))}{array("offsets", "Int32", range(2, 2 * len(cells) + 1, 2))}'
              '</Cells></Piece></UnstructuredGrid></VTKFile>')
        return folder

    def test_cells_in_any_order(self):
        with tempfile.TemporaryDirectory() as folder:
            whole, turned, other = (self.state(os.path.join(folder, name), cells)
                                    for name, cells in (("whole", (0, 1)), ("turned", (1, 0)), ("other", (0, 1.001))))
            expected = runs.results(whole)
            self.assertIn("differs from byte", runs.difference(expected, turned))
            self.assertEqual(runs.difference(expected, turned, whole), "")
            self.assertNotEqual(runs.difference(expected, other, whole), "")

    def test_tables_within_a_tolerance(self):
        self.assertEqual(runs.numbers_differ(b"p [Pa]\n1\n2\n", b"p [Pa]\n1\n2.0000001\n", 1e-7), "")
        self.assertNotEqual(runs.numbers_differ(b"p [Pa]\n1\n2\n", b"p [Pa]\n1\n2.00001\n", 1e-7), "")


class Verdicts(unittest.TestCase):
    def judge(self, script, names=("case.prm",)):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "program")
            write(path, "#!/bin/sh\n" + script + "\n")
            os.chmod(path, 0o755)
            return program.judge_reading(program.Program(path, time_limit=1).run([], folder), names)

    def test_readings(self):
        self.assertIsNone(self.judge("exit 0"))
        self.assertEqual(self.judge("echo 'error: case.prm:1: no' >&2; exit 2").kind, "refused")
        for script in ("exit 2", "echo 'error: other.prm' >&2; exit 2", "echo 'error: case.prm' >&2; exit 1",
                       "echo 'case.prm: std::bad_alloc' >&2; exit 2", "printf 'case.prm \\033[31m' >&2; exit 2"):
            self.assertEqual(self.judge(script).kind, "wrong", script)
        self.assertEqual(self.judge("kill -SEGV $$").kind, "crash")
        self.assertEqual(self.judge("exit 99").kind, "crash")
        self.assertEqual(self.judge("echo 'ERROR: AddressSanitizer: x' >&2; exit 1").kind, "crash")
        self.assertEqual(self.judge("sleep 30").kind, "hang")

    def attack(self, script, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "program")
            write(path, "#!/bin/sh\n" + script + "\n")
            os.chmod(path, 0o755)
            done = subprocess.run([os.path.join(ROOT, "scripts", "attack", "run"), *arguments, "--program", path, "--folder",
                                   os.path.join(folder, "work"), "--jobs", "4"], capture_output=True, text=True,
                                  check=False)
            failures = os.path.join(folder, "work", arguments[0], "failures")
            kept = [read(os.path.join(failures, name, "trial.txt")) for name in os.listdir(failures)] \
                if os.path.isdir(failures) else []
            return done.returncode, done.stdout + done.stderr, kept

    def test_a_program_that_accepts_everything(self):
        status, text, kept = self.attack("exit 0", "odd-files", "--trials", "0", "--markdown")
        self.assertEqual(status, 1, text)
        self.assertIn("| odd-files |", text)
        self.assertTrue(any("again: scripts/attack/run" in record and "--trial" in record for record in kept), text)

    def test_a_program_that_refuses_everything(self):
        status, text, _ = self.attack("echo 'error: channel.prm' >&2; exit 2", "odd-files", "--trials", "0")
        self.assertEqual(status, 2, text)
        self.assertIn("the undisturbed input is refused", text)

    def test_help(self):
        done = subprocess.run([os.path.join(ROOT, "scripts", "attack", "run"), "--help"], capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 0)
        self.assertIn("two-runs", done.stdout)


if __name__ == "__main__":
    unittest.main()
