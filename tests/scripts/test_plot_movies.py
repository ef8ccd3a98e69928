#!/usr/bin/python3
"""scripts/plot --movie; the liquid's mesh in space; the script for ParaView."""

import itertools
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy
import PIL.Image
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import test_plot  # noqa: E402
from test_plot import SCRIPTS, plot  # noqa: E402
from test_plot_options import TIMES, Run, wave, write_run  # noqa: E402

import plot_movie  # noqa: E402
import render_field  # noqa: E402


class Movies(Run):
    STUB = """#!/usr/bin/python3
import json, sys
data = sys.stdin.buffer.read()
width, height = map(int, sys.argv[sys.argv.index("-s") + 1].split("x"))
frames = [data[i:i + 4 * width * height] for i in range(0, len(data), 4 * width * height)]
with open(sys.argv[-1], "w") as stream:
    json.dump({"arguments": sys.argv, "size": [width, height], "lengths": [len(frame) for frame in frames],
               "different": len(set(frames)), "white": [frame[:4].hex() for frame in frames]}, stream)
sys.exit(STATUS)
"""

    def with_stub(self, *arguments, status=0):
        """scripts/plot with an ffmpeg that writes what it gets as json."""
        folder = os.path.join(self.temporary.name, "bin")
        os.makedirs(folder, exist_ok=True)
        path = os.path.join(folder, "ffmpeg")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(self.STUB.replace("STATUS", str(status)))
        os.chmod(path, 0o755)
        return subprocess.run([os.path.join(SCRIPTS, "plot"), self.folder, *arguments], capture_output=True, text=True, check=False,
                              env={**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"})

    def test_frames(self):
        write_run(self.folder)
        # No table and no state has the wall distension by this name.
        for kind, field, name in (("field", "pressure", "movie-pressure"), ("waves", "pressure", "movie-waves-pressure"),
                                  ("waves", "wall distension", "movie-waves-wall-distension")):
            done = self.with_stub("--movie", kind, "--fields", field, "--seconds", "2", "--width", "85mm")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(os.listdir(self.plots), [f"{name}.mp4"])
            with open(os.path.join(self.plots, f"{name}.mp4"), encoding="utf-8") as stream:
                got = json.load(stream)
            width, height = got["size"]
            self.assertEqual(got["lengths"], 4 * [4 * width * height])
            self.assertEqual(got["different"], 4)
            self.assertEqual(got["white"], 4 * ["ffffffff"])
            self.assertEqual(width, int(85 / 25.4 * 200))
            rate = "-framerate" if "-framerate" in got["arguments"] else "-r"  # from matplotlib 3.10 on, and before
            self.assertEqual(float(got["arguments"][got["arguments"].index(rate) + 1]), 2)  # 4 frames in 2 s
            self.assertIn("yuv420p", got["arguments"])
            os.remove(os.path.join(self.plots, f"{name}.mp4"))

    def test_failing_ffmpeg(self):
        write_run(self.folder)
        done = self.with_stub("--movie", "waves", status=7)
        self.assertEqual(done.returncode, 1)
        self.assertIn("ffmpeg ended with exit status 7", done.stderr)
        self.assertEqual(os.listdir(self.plots), [])

    @unittest.skipUnless(shutil.which("ffmpeg") and shutil.which("ffprobe"), "ffmpeg is not installed")
    def test_mp4(self):
        write_run(self.folder)
        done = plot(self.folder, "--movie", "waves", "--width", "85mm", "--seconds", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        (name,) = os.listdir(self.plots)
        found = subprocess.run(["ffprobe", "-loglevel", "error", "-show_entries", "stream=codec_name,pix_fmt,width,height,nb_frames",
                                "-of", "json", os.path.join(self.plots, name)], capture_output=True, text=True, check=True)
        (stream,) = json.loads(found.stdout)["streams"]
        self.assertEqual((stream["codec_name"], stream["pix_fmt"], stream["nb_frames"]), ("h264", "yuv420p", "4"))
        self.assertEqual((stream["width"] % 2, stream["height"] % 2), (0, 0))

    def test_gif(self):
        write_run(self.folder)
        done = plot(self.folder, "--movie", "field", "--gif", "--fields", "pressure", "--frames", "3", "--seconds", "1.5", "--width", "85mm")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(os.listdir(self.plots), ["movie-pressure.gif"])
        with PIL.Image.open(os.path.join(self.plots, "movie-pressure.gif")) as image:
            self.assertEqual((image.n_frames, image.info["duration"]), (3, 500))
            self.assertEqual(image.width, round(85 / 25.4 * 200))  # 200 pixels an inch
            for i in range(3):
                image.seek(i)
                self.assertEqual(image.convert("RGB").getpixel((1, 1)), (255, 255, 255))

    def test_evenly(self):
        self.assertEqual(plot_movie.evenly(4, 200), [0, 1, 2, 3])
        self.assertEqual(plot_movie.evenly(101, 5), [0, 25, 50, 75, 100])

    def test_along_the_tube(self):
        write_run(self.folder)
        run = {"folder": self.folder, "title": "run", "summary": {"model": "axisymmetric"}}
        lines = plot_movie.lines_of(run, ["pressure", plot_movie.WALL])
        for name, i, largest in (("pressure", 0, 100), (plot_movie.WALL, 1, 1e-5)):
            line = lines[name]
            self.assertEqual(line.values.shape, (plot_movie.N_PLACES, len(TIMES)))
            for t, values in zip(line.times, line.values.T):
                exact = numpy.array([wave(x, t)[i] for x in line.places])
                # The means of sections of linear cells, 40 a wavelength and 4 in the radius: 2 % of the largest value.
                self.assertLess(abs(values - exact).max(), 0.02 * largest, (name, t))
        # Half of the way between two states.
        self.assertTrue(numpy.allclose(lines["pressure"].at(0.005), (lines["pressure"].values[:, 0] + lines["pressure"].values[:, 1]) / 2))
        self.assertTrue(numpy.isnan(lines["pressure"].at(1.0)).all())

    def test_same_scale_in_all_frames(self):
        write_run(self.folder)
        states = [[os.path.join(self.folder, "fields", f"{i}.vtu")] for i in range(4)]
        scale = render_field.Scale({"states": states, "field": "velocity", "regions": None})
        self.assertEqual([(what, round(low, 9), round(high, 9)) for what, _, low, high in scale.ranges], [("", 0, 0.03)])
        # 5 um of the wall in a tube of 12 mm: 0.1 m / 10 / 5 um = 2000, and not more than 0.4 * 12 mm / 5 um = 960.
        self.assertEqual(scale.deformation, 500)
        # In finite deformation the body is drawn as it is.
        scale = render_field.Scale({"states": states, "field": "velocity", "regions": None, "deformation": "finite"})
        self.assertEqual(scale.deformation, 1)

    def test_nothing_is_cut(self):
        write_run(self.folder)
        os.mkdir(self.plots)
        for width in (160, 85):
            sheet = Frames(self.plots, width / 25.4)
            runs = [{"folder": self.folder, "title": f"a run with a long title, number {i}", "summary": {"model": "axisymmetric"}}
                    for i in range(3)]
            settings = plot_movie.Settings(True, 2, 1.0)
            plot_movie.draw_waves(sheet, runs, settings)
            plot_movie.draw_states(sheet, runs[0], settings)
            self.assertEqual(sheet.frames, ["movie-waves-pressure", "movie-velocity"])
            self.assertEqual(sheet.outside, [], width)


class Frames(test_plot.Looks.Sheet):
    """Looks at the frames of movies as at figures."""

    def __init__(self, folder, width):
        super().__init__(folder, width)
        self.frames = []

    def check_frame(self, figure, name):
        self.frames.append(name)
        self.look(figure, name)


class Space(unittest.TestCase):
    """The liquid's mesh in space: 6 x 4 x 5 cells of liquid of size 1, and a solid layer on top (z = 5) that moves along z."""

    NX, NY, NZ = 6, 4, 5

    def grid(self, top):
        grid, points = vtk.vtkUnstructuredGrid(), vtk.vtkPoints()
        phase, displacement, cells = [], [], []
        for solid, layers in ((0, range(self.NZ)), (1, (self.NZ,))):
            for x, y, z in itertools.product(range(self.NX), range(self.NY), layers):
                corners = []
                for dx, dy, dz in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)):
                    corners.append(points.InsertNextPoint(x + dx, y + dy, z + dz))
                    phase.append(solid)
                    displacement.append((0, 0, top(x + dx)) if solid else (7, 8, 9))  # the liquid's own must not be seen
                cells.append(corners)
        grid.SetPoints(points)
        for corners in cells:
            grid.InsertNextCell(vtk.VTK_HEXAHEDRON, 8, corners)
        for name, values in (("phase", phase), ("displacement", displacement)):
            array = numpy_to_vtk(numpy.array(values, float), deep=True)
            array.SetName(name)
            grid.GetPointData().AddArray(array)
        return grid

    def moved(self, top):
        grid = self.grid(top)
        before = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
        solid = render_field.in_solid(grid)
        render_field.deform(grid, 1)
        return before[~solid], (vtk_to_numpy(grid.GetPoints().GetData()) - before)[~solid]

    def test_uniform(self):
        """A lid that is lifted by d: the displacement is d z / 5."""
        before, moved = self.moved(lambda x: 0.1)
        self.assertLess(abs(moved[:, 2] - 0.1 * before[:, 2] / self.NZ).max(), 1e-5)
        self.assertLess(abs(moved[:, :2]).max(), 1e-6)

    def test_wave(self):
        """A lid that moves by cos(k (x + 1/2)) with k = pi / 7: on a mesh of cubes with springs along their edges, whose sides are free
        in z, the displacement is cos(k (x + 1/2)) sinh(a z) / sinh(5 a) with cosh a = 2 - cos k, the known discrete solution."""
        k = math.pi / (self.NX + 1)
        a = math.acosh(2 - math.cos(k))
        before, moved = self.moved(lambda x: 0.1 * math.cos(k * (x + 0.5)))
        exact = 0.1 * numpy.cos(k * (before[:, 0] + 0.5)) * numpy.sinh(a * before[:, 2]) / math.sinh(a * self.NZ)
        self.assertLess(abs(moved[:, 2] - exact).max(), 1e-5)
        self.assertLess(abs(moved[:, :2]).max(), 1e-6)


class ParaView(unittest.TestCase):
    """view-in-paraview.py, as a run writes it but for its place; scripts/check/paraview runs it in ParaView, by hand."""

    def test_script(self):
        with open(os.path.join(SCRIPTS, "..", "source", "postprocess", "view_in_paraview.py"), encoding="utf-8") as stream:
            text = stream.read()
        self.assertEqual(text.count("@FILE@"), 1)
        code = compile(text, "view-in-paraview.py", "exec")
        # With a ParaView that has nothing to show, it gets to the first of its calls: the file of states beside the script.
        asked = []

        class Reader:
            def __call__(self, **arguments):
                asked.append(arguments["FileName"])
                raise LookupError

        class Simple:
            PVDReader = Reader()

        sys.modules["paraview"], sys.modules["paraview.simple"] = type(sys)("paraview"), Simple
        sys.modules["paraview"].simple = Simple
        try:
            for given in ({"__file__": "/run of mine/view-in-paraview.py"}, {}):
                with self.assertRaises(LookupError):
                    exec(code, {"__name__": "__main__", **given})
        finally:
            del sys.modules["paraview"], sys.modules["paraview.simple"]
        self.assertEqual(asked, ["/run of mine/fields.pvd", os.path.join(os.getcwd(), "fields.pvd")])

    def functions(self):
        """The names of the script, which is not run, and the module in the place of ParaView's."""
        with open(os.path.join(SCRIPTS, "..", "source", "postprocess", "view_in_paraview.py"), encoding="utf-8") as stream:
            text = stream.read()
        names = {}
        simple = type(sys)("paraview.simple")
        sys.modules["paraview"], sys.modules["paraview.simple"] = type(sys)("paraview"), simple
        sys.modules["paraview"].simple = simple
        try:
            exec(text.rpartition("main()")[0], names)
        finally:
            del sys.modules["paraview"], sys.modules["paraview.simple"]
        return names, simple

    def test_notes(self):
        """Of a mode its number and frequency; of a state its time."""
        names, simple = self.functions()
        simple.PythonAnnotation = lambda Expression, **_: Expression
        simple.AnnotateTimeFilter = lambda Format, **_: Format
        with tempfile.TemporaryDirectory() as folder:
            names["FOLDER"] = folder
            self.assertEqual(names["annotate"](None, ", times 2"), "Time: {time:.6g} s, times 2")
            with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as stream:
                json.dump({"analysis": "modal", "modes": ["Mode 1: 3.36 Hz, moves along y: 99 %", "Mode 2: 21 Hz, turns about z: 1 %"]}, stream)
            expression = names["annotate"](None, ", times 2")
            self.assertEqual([eval(expression, {"time_value": number}) for number in (1.0, 2.0)],
                             ["Mode 1: 3.36 Hz, times 2", "Mode 2: 21 Hz, times 2"])

    def test_states(self):
        names, _ = self.functions()
        self.assertEqual(names["states_of"]([3.0]), [3.0])
        chosen = names["states_of"]([float(i) for i in range(101)])
        self.assertEqual((len(chosen), chosen[0], chosen[-1]), (20, 0.0, 100.0))
        self.assertEqual([names["nice"](number) for number in (0.7, 1, 19, 20, 49)], [0.5, 1, 10, 20, 20])


if __name__ == "__main__":
    unittest.main()
