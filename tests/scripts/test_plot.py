#!/usr/bin/python3
"""scripts/plot: the maxima of a damped cosine, what it does with missing pieces, the same files every time."""

import math
import os
import subprocess
import sys
import tempfile
import unittest

import matplotlib.image
import matplotlib.legend
import matplotlib.text
import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

SCRIPTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts")
sys.path.insert(0, os.path.join(SCRIPTS, "lib"))
import plot_field  # noqa: E402
import plot_histories  # noqa: E402
import plot_style  # noqa: E402
import plot_waves  # noqa: E402
import render_field  # noqa: E402
import wave_tables  # noqa: E402


def plot(*arguments):
    return subprocess.run([os.path.join(SCRIPTS, "plot"), *arguments], capture_output=True, text=True, check=False)


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)


def contents(folder):
    """What is in the files of a folder, by name."""
    found = {}
    for name in sorted(os.listdir(folder)):
        with open(os.path.join(folder, name), "rb") as stream:
            found[name] = stream.read()
    return found


class Envelope(unittest.TestCase):
    def test_cosine(self):
        time = numpy.linspace(0, 4.2, 1001)
        maxima, minima = plot_histories.turning_points(time, numpy.cos(2 * math.pi * time))
        self.assertTrue(numpy.allclose([t for t, _ in maxima], [1, 2, 3, 4], atol=1e-4))
        self.assertTrue(numpy.allclose([t for t, _ in minima], [0.5, 1.5, 2.5, 3.5], atol=1e-4))
        self.assertTrue(numpy.allclose([v for _, v in maxima], 1, atol=1e-6))

    def test_ripples_do_not_count(self):
        time = numpy.linspace(0, 3.2, 5001)
        maxima, _ = plot_histories.turning_points(time, numpy.cos(2 * math.pi * time)
                                                  + 0.01 * numpy.sin(80 * math.pi * time))
        self.assertEqual(len(maxima), 3)

    def test_constant(self):
        self.assertEqual(plot_histories.turning_points(numpy.arange(5.0), numpy.ones(5)), ([], []))


class Units(unittest.TestCase):
    def test_prefixes(self):
        self.assertEqual(plot_style.readable(0.012, "m"), (1000.0, "mm"))
        self.assertEqual(plot_style.readable(2.5e6, "Pa")[1], "MPa")
        self.assertEqual(plot_style.readable(0.012, "m^3/s")[1], "l/s")
        factor, unit = plot_style.readable(37e-6, "m^3/s")
        self.assertEqual(unit, "ml/s")
        self.assertAlmostEqual(factor * 37e-6, 37)
        self.assertEqual(plot_style.axis_label("flow rate", "m^3/s"), "Flow rate [m³/s]")


    def test_chosen(self):
        plot_style.chosen_units.update(plot_style.read_units("pressure=mmHg, flow=l/min"))
        try:
            factor, unit = plot_style.readable(5, "Pa", "axis pressure")
            self.assertEqual(unit, "mmHg")
            self.assertAlmostEqual(factor * 133.322387415, 1)
            self.assertEqual(plot_style.readable(1e-6, "m^3/s", "flow rate")[1], "l/min")
            self.assertEqual(plot_style.readable(0.012, "m", "displacement y"), (1000.0, "mm"))
            with self.assertRaises(plot_style.UnitError):
                plot_style.readable(1, "N/m", "pressure")
        finally:
            plot_style.chosen_units.clear()

    def test_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            write(os.path.join(folder, "probes.csv"), "time [s],tip: pressure [Pa]\n0,1\n1,2\n")
            for wanted, message in (("pressure", "is not FIELD=UNIT"), ("pressure=furlong", "there is no unit 'furlong'"),
                                    ("pressure=ml/s", "'pressure' is in Pa, and ml/s is a unit of another kind")):
                done = plot(folder, "--units", wanted)
                self.assertEqual(done.returncode, 2)
                self.assertIn(message, done.stderr)


class Looks(unittest.TestCase):
    """What the figures show, of the artists on them."""

    class Sheet(plot_style.Sheet):
        """Keeps what is on the figures, and whether each text is inside of its figure."""

        def __init__(self, folder, width):
            super().__init__(folder, width, False)
            self.legends, self.outside, self.markers, self.panels = {}, [], {}, {}

        def save(self, figure, name):
            self.look(figure, name)
            super().save(figure, name)

        def look(self, figure, name):
            figure.canvas.draw()
            # Matplotlib keeps labels of ticks that are out of the axes' range, or of axes that are off, and does not draw them.
            undrawn = [label for axes in figure.axes for axis in (axes.xaxis, axes.yaxis)
                     for tick in axis.get_major_ticks() + axis.get_minor_ticks()
                     if not axes.axison or not min(axis.get_view_interval()) <= tick.get_loc() <= max(axis.get_view_interval())
                     for label in (tick.label1, tick.label2)]
            for text in figure.findobj(matplotlib.text.Text):
                if text.get_visible() and text.get_text() and text not in undrawn:
                    box = text.get_window_extent()
                    if not (box.x0 >= -1 and box.y0 >= -1 and box.x1 <= figure.bbox.x1 + 1 and box.y1 <= figure.bbox.y1 + 1):
                        self.outside.append(f"{name}: {text.get_text()}")
            legends = figure.findobj(matplotlib.legend.Legend)
            self.legends[name] = [text.get_text() for legend in legends for text in legend.get_texts()]
            self.markers[name] = [line for line in figure.axes[0].lines if line.get_marker() == "o"]
            self.panels[name] = [(axes.get_title(loc="left"), len(axes.lines)) for axes in figure.axes]

    def run_of(self, folder, title="run", summary=None):
        return {"folder": folder, "title": title, "summary": summary or {}}

    def test_no_text_is_cut(self):
        with tempfile.TemporaryDirectory() as folder:
            write_wave(folder)
            write(os.path.join(folder, "power.csv"), "time [s],kinetic [W],loads [W],residual [W]\n0,1,2,0\n1,2,3,1e-9\n")
            write(os.path.join(folder, "probes.csv"), "time [s],a probe with a long name: flow rate [m^3/s]\n0,1e-6\n1,5e-6\n")
            plots = os.path.join(folder, "plots")
            os.mkdir(plots)
            for width in (160, 110, 85):
                sheet = self.Sheet(plots, width / 25.4)
                runs = [self.run_of(folder, "A title that is rather long, of one of the runs"), self.run_of(folder, "other")]
                plot_histories.draw_probes(sheet, runs)
                plot_histories.draw_power(sheet, runs)
                plot_waves.draw(sheet, runs, False)
                self.assertEqual(sheet.outside, [])
                self.assertEqual(len(sheet.legends), 6)

    def test_no_text_of_a_field_is_cut(self):
        ranges = [("liquid", "RdBu_r", -850.0, 850.0), ("solid", "viridis", -8.5e3, 2e3)]
        for space in (False, True):
            picture = {"field": "pressure", "label": "pressure", "ranges": ranges, "extent": [0, 0.8, 0, 0.006 if not space else 0.2],
                       "plane": not space, "axes": [[-0.9, 0.1], [0, 0.9], [0.3, -0.4]] if space else None, "deformation": 20,
                       "stretch": 1 if space else 20, "liquid": True}
            for width in (160, 110, 85):
                with tempfile.TemporaryDirectory() as folder:
                    matplotlib.image.imsave(os.path.join(folder, "picture-0.png"), numpy.zeros((25, 100, 3)))
                    sheet = self.Sheet(folder, width / 25.4)
                    sheet.choice.regions = ["the inner layer", "the outer layer"]
                    figure, _ = plot_field.compose(sheet, self.run_of(folder), picture, folder, "t = 0.05 s (the output nearest to 0.051 s)")
                    sheet.save(figure, "field")
                    self.assertEqual(sheet.outside, [], (space, width))

    def test_power_of_two_runs(self):
        with tempfile.TemporaryDirectory() as folder:
            write(os.path.join(folder, "power.csv"), "time [s],kinetic [W],loads [W],residual [W]\n0,1,2,0\n1,2,3,1e-9\n")
            sheet = self.Sheet(folder, 6)
            plot_histories.draw_power(sheet, [self.run_of(folder, "one"), self.run_of(folder, "other")])
            self.assertEqual(sheet.legends["power"], ["one", "other"])

    def test_measured(self):
        with tempfile.TemporaryDirectory() as folder:
            rows = "".join(f"{t!r},{math.sin(t)!r},{math.sin(t)!r}\n" for t in numpy.arange(0, 3, 0.01).tolist())
            write(os.path.join(folder, "wave.csv"),
                  'time [s],"tube 0 m: pressure, simulated [Pa]","tube 0 m: pressure, measured [Pa]"\n' + rows)
            sheet = self.Sheet(folder, 6)
            plot_waves.draw(sheet, [self.run_of(folder)], False)
            (line,) = sheet.markers["wave-pressure"]
            self.assertEqual(line.get_color(), plot_style.MEASURED)
            self.assertEqual(line.get_linestyle(), "None")
            self.assertEqual(line.get_markerfacecolor(), "none")
            self.assertEqual(len(line.get_markevery()), plot_waves.N_MARKERS)
        # Where there is nothing measured there is no marker.
        values = numpy.ones(300)
        values[:100] = numpy.nan
        self.assertGreaterEqual(min(plot_waves.marked(numpy.arange(300.0), values)), 100)

    def test_units_of_one_field(self):
        with tempfile.TemporaryDirectory() as folder:
            write(os.path.join(folder, "probes.csv"), "time [s],tip: stress xx [Pa],end: stress xx [N/m]\n0,1,2\n1,2,3\n")
            sheet = self.Sheet(folder, 6)
            plot_histories.draw_probes(sheet, [self.run_of(folder)])
            self.assertEqual(sorted(sheet.legends), ["history-stress-xx", "history-stress-xx-n-m"])

    def test_one_state(self):
        with tempfile.TemporaryDirectory() as folder:
            write(os.path.join(folder, "probes.csv"), "time [s],tip: pressure [Pa]\n0,1\n")
            sheet = self.Sheet(folder, 6)
            plot_histories.draw_probes(sheet, [self.run_of(folder)])
            self.assertEqual(sheet.written, [])
            self.assertEqual(sheet.notes, [f"histories of {folder} (one state: summary.json has its values)"])

    def test_a_pulse_has_no_envelope(self):
        with tempfile.TemporaryDirectory() as folder:
            rows = "".join(f"{i * 0.01!r},{math.sin(i * 0.3)!r}\n" for i in range(200))
            write(os.path.join(folder, "probes.csv"), "time [s],tip: displacement y [m]\n" + rows)
            for residual, drawn in ((0.2, False), (0.01, True)):
                summary = {"quantities": [{"name": "fit residual", "probe": "tip", "value": residual}]}
                sheet = self.Sheet(folder, 6)
                plot_histories.draw_probes(sheet, [self.run_of(folder, summary=summary)])
                self.assertEqual("envelope-displacement-y" in sheet.legends, drawn)

    def test_dispersion_up_to_what_the_load_has(self):
        report = {"pre-flight report": {"load frequency [Hz]": 17.0}}
        self.assertEqual(plot_waves.highest_frequency(report, 3000.0), 170.0)
        self.assertEqual(plot_waves.highest_frequency({}, 3000.0), 3000.0)


class Field(unittest.TestCase):
    """The picture of a liquid, y from 0 to 1, under a solid layer, y from 1 to 1.5, that moves up by 0.01 in the middle."""

    def grid(self):
        grid, points, cells = vtk.vtkUnstructuredGrid(), vtk.vtkPoints(), []
        phase, displacement, pressure = [], [], []
        for solid, ys in ((0, (0, 0.25, 0.5, 0.75, 1)), (1, (1, 1.5))):
            for x in range(4):
                for low, high in zip(ys, ys[1:]):
                    corners = []
                    for px, py in ((x, low), (x + 1, low), (x + 1, high), (x, high)):
                        corners.append(points.InsertNextPoint(px, py, 0))
                        phase.append(solid)
                        # The liquid's own displacement is large, and must not be seen.
                        displacement.append((0, 0.01 * math.sin(math.pi * px / 4), 0) if solid else (3, 0, 0))
                        pressure.append(-50.0 + px if solid else 10.0 * px)
                    cells.append(corners)
        grid.SetPoints(points)
        for corners in cells:
            grid.InsertNextCell(vtk.VTK_QUAD, 4, corners)
        for name, values in (("phase", phase), ("displacement", displacement), ("pressure", pressure)):
            array = numpy_to_vtk(numpy.array(values, float), deep=True)
            array.SetName(name)
            grid.GetPointData().AddArray(array)
        return grid

    def test_liquid_follows(self):
        grid = self.grid()
        before = vtk_to_numpy(grid.GetPoints().GetData()).copy()
        factor = render_field.deform(grid)
        # A tenth of the length 4 over 0.01 is 40, and 20 the round number below.
        self.assertEqual(factor, 20)
        moved = (vtk_to_numpy(grid.GetPoints().GetData()) - before) / factor
        solid = render_field.in_solid(grid)
        self.assertTrue(numpy.allclose(moved[solid][:, 1], 0.01 * numpy.sin(math.pi * before[solid][:, 0] / 4), atol=1e-6))
        # No gap at the interface, none at the bottom, and between them a share that grows with y.
        for x, y, low, high in ((2, 1, 0.01, 0.01), (2, 0, 0, 0), (2, 0.5, 0.002, 0.005), (2, 0.75, 0.005, 0.009), (0, 0.5, 0, 0.002)):
            here = ~solid & (abs(before[:, 0] - x) < 1e-9) & (abs(before[:, 1] - y) < 1e-9)
            self.assertTrue(here.any())
            self.assertTrue((moved[here][:, 1] >= low - 1e-6).all() and (moved[here][:, 1] <= high + 1e-6).all(), (x, y, moved[here]))
        self.assertLess(abs(moved[~solid][:, 0]).max(), 1e-6)

    def test_colours(self):
        grid = self.grid()
        solid = render_field.in_solid(grid)
        _, _, values = render_field.values_of(grid, "pressure")
        ranges = render_field.colour_ranges(values, solid, "pressure")
        self.assertEqual([(what, low, high) for what, _, low, high in ranges], [("liquid", 0, 40), ("solid", -50, -46)])
        shown = render_field.on_the_maps(values, solid, ranges)
        self.assertTrue((shown[~solid] < 1).all() and (shown[solid] > 1).all())
        # The velocity is the same on both sides, and has one range.
        self.assertEqual(len(render_field.colour_ranges(values, solid, "velocity")), 1)
        # A field of both signs is white at zero.
        _, name, low, high = render_field.colour_ranges(numpy.array([-1.0, 3.0]), None, "stress_xx")[0]
        self.assertEqual((name, low, high), ("RdBu_r", -3, 3))


def pulse(time, place, height=100.0):
    """A pulse at 2 m/s from place 0 that a closed end at 0.4 m throws back, as forward and backward wave."""
    return [height * numpy.exp(-((time - arrival - 0.05) / 0.01)**2) for arrival in (place / 2, (0.8 - place) / 2)]


def write_wave(folder, height=100.0, nonlinear=False):
    time = numpy.arange(0, 0.5, 0.001)
    header, columns = ["time [s]"], [time]
    for place in (0.0, 0.1, 0.2, 0.3, 0.35):
        forward, backward = pulse(time, place, height)
        for name, values in (("pressure, simulated", forward + backward), ("pressure, theory", forward + backward),
                             ("pressure, simulated - theory", 0 * time), ("forward wave, simulated", forward),
                             ("backward wave, simulated", backward),
                             *((("pressure, nonlinear theory", 0.9 * (forward + backward)),
                                ("pressure, simulated - nonlinear theory", 0.1 * (forward + backward))) if nonlinear else ())):
            header.append(f'"tube {place:g} m: {name} [Pa]"')
            columns.append(values)
    rows = "\n".join(",".join(f"{value:.9g}" for value in row) for row in zip(*columns))
    write(os.path.join(folder, "wave.csv"), ",".join(header) + "\n" + rows + "\n")


class Waves(unittest.TestCase):
    def test_table(self):
        with tempfile.TemporaryDirectory() as folder:
            write_wave(folder)
            fields = wave_tables.read_waves(folder)
            self.assertEqual(list(fields), ["pressure", "forward wave", "backward wave"])
            pressure = fields["pressure"]
            self.assertEqual((pressure.unit, pressure.positions), ("Pa", [0.0, 0.1, 0.2, 0.3, 0.35]))
            self.assertEqual(list(pressure.sources), ["simulated", "theory"])
            time, height = wave_tables.first_peak(pressure.time, pressure.best()[2])
            self.assertAlmostEqual(time, 0.15, delta=1e-5)
            self.assertAlmostEqual(height, 100, delta=0.1)
            self.assertAlmostEqual(wave_tables.travel_time(pressure, pressure.best()[:4]), 0.15, delta=1e-5)

    def test_nonlinear_theory(self):
        """A source of its own, behind linear theory, with a look of its own; the difference from it is no field."""
        with tempfile.TemporaryDirectory() as folder:
            write_wave(folder, nonlinear=True)
            fields = wave_tables.read_waves(folder)
            self.assertEqual(list(fields), ["pressure", "forward wave", "backward wave"])
            pressure = fields["pressure"]
            self.assertEqual(list(pressure.sources), ["simulated", "theory", "nonlinear theory"])
            self.assertAlmostEqual(wave_tables.first_peak(pressure.time, pressure.sources["nonlinear theory"][2])[1], 90, delta=0.1)
            for several in (False, True):
                looks = [plot_waves.look_of(0, source, several) for source in pressure.sources]
                self.assertEqual(len({str(look["linestyle"]) for look in looks}), 3)

    def test_first_peak_is_not_the_highest(self):
        time = numpy.linspace(0, 10, 1001)
        curve = -numpy.exp(-(time - 3)**2 * 4) + 2 * numpy.exp(-(time - 7)**2) + 0.1 * numpy.exp(-(time - 1)**2 * 9)
        when, height = wave_tables.first_peak(time, curve)
        self.assertAlmostEqual(when, 3, delta=1e-3)
        self.assertAlmostEqual(height, 1, delta=1e-3)
        self.assertTrue(math.isnan(wave_tables.first_peak(time, 0 * time)[0]))

    def test_between_stations(self):
        """Both waves are where they are between stations, not only at them."""
        with tempfile.TemporaryDirectory() as folder:
            write_wave(folder)
            places, time, values, source = plot_waves.space_time(wave_tables.read_waves(folder))
            self.assertEqual(source, "simulated")
            for place, found in zip(places, values):
                self.assertLess(numpy.abs(found - sum(pulse(time, place))).max(), 4)

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            one, other = os.path.join(folder, "one"), os.path.join(folder, "other")
            write_wave(one)
            write_wave(other, 30.0)
            done = plot(one, other, "--normalised")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(f"dispersion of {one} (no rows in dispersion.csv)", done.stdout)
            plots = os.path.join(one, "plots")
            first = contents(plots)
            self.assertEqual(list(first), [f"{kind}.{end}" for kind in ("space-time-pressure", "wave-backward-wave",
                                           "wave-forward-wave", "wave-pressure") for end in ("csv", "png", "svg")])
            self.assertEqual(plot(one, other, "--normalised").returncode, 0)
            self.assertEqual(contents(plots), first)
            with open(os.path.join(plots, "wave-pressure.csv"), encoding="utf-8") as stream:
                self.assertTrue(stream.readline().startswith('one: time / travel time,"one: 0 m: pressure, simulated [1]"'))
                rows = numpy.loadtxt(stream, delimiter=",")
            # The first pulse is 1 in both runs, and reaches the last station one travel time later.
            for start in (0, 11):
                self.assertAlmostEqual(rows[:100, start + 1].max(), 1, delta=1e-3)
                arrival = rows[:, start][[rows[:250, start + column].argmax() for column in (1, 5)]]
                self.assertAlmostEqual(arrival[1] - arrival[0], 1, delta=0.02)

    def test_nothing_travels(self):
        with tempfile.TemporaryDirectory() as folder:
            write(os.path.join(folder, "wave.csv"), 'time [s],"tube 0 m: pressure, theory [Pa]"\n0,0\n1,2\n2,1\n')
            done = plot(folder, "--normalised")
            self.assertEqual(done.returncode, 1)
            self.assertIn("no pressure pulse that travels", done.stdout)
            self.assertEqual(plot(folder).returncode, 0)

    def test_dispersion_and_spin_coating(self):
        with tempfile.TemporaryDirectory() as folder:
            write(os.path.join(folder, "dispersion.csv"),
                  "frequency [Hz],pressure wave: phase speed [m/s],pressure wave: attenuation [1/m],"
                  "membrane: phase speed [m/s],membrane: attenuation [1/m]\n1,2,0.1,2,0.1\n10,2.1,0.3,nan,-0\n")
            write(os.path.join(folder, "spin-coating.csv"),
                  "position [m],diameter [m],wall thickness [m],trolley speed [counts/s],rod speed [counts/s]\n"
                  "0,0.025,5e-5,6790,4244\n0.4,0.0125,5e-5,13000,8000\n")
            done = plot(folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(sorted(os.listdir(os.path.join(folder, "plots"))),
                             [f"{kind}.{end}" for kind in ("dispersion", "spin-coating") for end in ("csv", "png", "svg")])

    def test_about_a_loaded_state(self):
        with tempfile.TemporaryDirectory() as folder:
            write(os.path.join(folder, "dispersion.csv"), "frequency [Hz],womersley: phase speed [m/s],womersley: attenuation [1/m]\n1,2,0.1\n10,2.1,0.3\n")
            write(os.path.join(folder, "loaded-tube.csv"),
                  "pressure [Pa],inner radius [m],outer radius [m],distensibility [1/Pa],speed of long waves [m/s]\n"
                  "0,5e-4,8e-4,7e-4,1.2\n10000,1.2e-3,1.4e-3,2e-5,7\n")
            done = plot(folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(sorted(os.listdir(os.path.join(folder, "plots"))),
                             [f"{kind}.{end}" for kind in ("dispersion", "loaded-tube") for end in ("csv", "png", "svg")])
            with open(os.path.join(folder, "plots", "loaded-tube.svg"), encoding="utf-8") as stream:
                drawn = stream.read()
            for text in ("Inner radius [mm]", "Speed of long waves [m/s]", "Pressure [kPa]"):
                self.assertIn(text, drawn)


class Material(unittest.TestCase):
    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            write(os.path.join(folder, "modulus.csv"),
                  "frequency [Hz],storage modulus [Pa],loss modulus [Pa],tan delta [1]\n1,2e6,0,0\n10,2e6,0,0\n")
            write(os.path.join(folder, "relaxation.csv"),
                  "time [s],strain [1],stress [Pa],stress of the closed solution [Pa]\n0.1,0.01,2e4,2e4\n0.2,0.01,1e4,1e4\n")
            write(os.path.join(folder, "creep.csv"),
                  "time [s],stress [Pa],strain [1],strain of the closed solution [1]\n0.1,1,1e-3,1e-3\n0.2,1,2e-3,2e-3\n")
            write(os.path.join(folder, "relaxation-table.csv"),
                  "time [s],modulus [Pa],modulus of the power law [Pa],fitted [1]\n0.1,3e6,nan,0\n1,2e6,2e6,1\n2,1.9e6,1.9e6,1\n")
            write(os.path.join(folder, "harmonic.csv"),
                  "frequency [Hz],storage modulus [Pa],loss modulus [Pa],tan delta [1]\n1,2e6,2e5,0.1\n")
            # Two periods, of which the last is drawn.
            rows = "".join(f"{i / 20!r},{math.sin(math.pi * i / 10)!r},{2 * math.sin(math.pi * i / 10 + 0.1)!r}\n"
                           for i in range(1, 41))
            write(os.path.join(folder, "harmonic-1.csv"), "time [s],strain [1],stress [Pa]\n" + rows)
            done = plot(folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            plots = os.path.join(folder, "plots")
            kinds = ("creep", "hysteresis", "modulus", "relaxation", "relaxation-table")
            self.assertEqual(sorted(os.listdir(plots)),
                             sorted(f"{kind}.{end}" for kind in kinds for end in ("csv", "png", "svg")))
            with open(os.path.join(plots, "hysteresis.csv"), encoding="utf-8") as stream:
                self.assertEqual(len(stream.read().splitlines()), 1 + 21)
            # Runs over each other.
            other = os.path.join(folder, "other")
            for name in ("relaxation.csv", "modulus.csv"):
                with open(os.path.join(folder, name), encoding="utf-8") as stream:
                    write(os.path.join(other, name), stream.read())
            done = plot(folder, other, "--width", "85mm")
            self.assertEqual(done.returncode, 0, done.stderr)


class Sensitivities(unittest.TestCase):
    def test_largest_first(self):
        """Of each response and entry the frequency at which it is largest; what does not depend is left out."""
        header = "frequency [Hz],probe,response,entry,logarithmic sensitivity [1]\n"
        with tempfile.TemporaryDirectory() as folder:
            write(os.path.join(folder, "summary.json"), "{}")
            write(os.path.join(folder, "sensitivities.csv"), header
                  + "1,tip,displacement x,Materials/wall/Density,0.5\n2,tip,displacement x,Materials/wall/Density,-2.5\n"
                  + "1,tip,displacement x,Materials/wall/Young's modulus,-1\n2,tip,displacement x,Materials/wall/Young's modulus,0.25\n"
                  + "1,tip,displacement x,Boundaries/top/Pressure,0\n2,tip,displacement x,Boundaries/top/Pressure,\n")
            done = plot(folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(os.path.join(folder, "plots", "sensitivities.csv"), encoding="utf-8") as stream:
                names, values = stream.read().splitlines()
            self.assertEqual(names.split(","), ["tip: displacement x by Materials/wall/Density at 2 Hz [1]",
                                                "tip: displacement x by Materials/wall/Young's modulus at 1 Hz [1]"])
            self.assertEqual(values.split(","), ["-2.5", "-1.0"])


class Fits(unittest.TestCase):
    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            residual = "residual over the noise [1]"
            write(os.path.join(folder, "fit-relaxation.csv"),
                  f"time [s],relaxation modulus [Pa],relaxation modulus of the fit [Pa],{residual}\n0.1,6e5,6.1e5,-1\n1,5e5,5e5,0\n10,4e5,3.9e5,1\n")
            write(os.path.join(folder, "fit-creep.csv"),
                  f"time [s],compliance [1/Pa],compliance of the fit [1/Pa],{residual}\n0.1,1e-6,1e-6,0\n1,2e-6,2e-6,0\n")
            of_moduli = ",".join(f"{kind} modulus [Pa],{kind} modulus of the fit [Pa],residual of the {kind} modulus over the noise [1]"
                                 for kind in ("storage", "loss"))
            write(os.path.join(folder, "fit-moduli.csv"), f"frequency [Hz],{of_moduli}\n0.1,4e5,4e5,0,2e4,2e4,0.5\n1,5e5,5e5,0,3e4,3e4,1\n")
            # Rows of two stretches, one after the other in turn.
            rows = "".join(f"{1.5 + 0.1 * (i % 2)!r},{1e3 * i!r},{2e-3 + 1e-5 * i!r},{2e-3 + 1e-5 * i!r},0,{1e-2!r},{1e-2!r},0\n" for i in range(8))
            write(os.path.join(folder, "fit-inflation.csv"),
                  "axial stretch [1],pressure [Pa],outer diameter [m],outer diameter of the fit [m],residual of the diameter over the noise [1],"
                  "axial force [N],axial force of the fit [N],residual of the axial force over the noise [1]\n" + rows)
            write(os.path.join(folder, "correlation.csv"), "stiffness [1],exponent [1]\n1,-0.97\n-0.97,1\n")
            done = plot(folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            plots = os.path.join(folder, "plots")
            kinds = ("correlation", "fit-creep", "fit-inflation", "fit-moduli", "fit-relaxation")
            self.assertEqual(sorted(os.listdir(plots)), sorted(f"{kind}.{end}" for kind in kinds for end in ("csv", "png", "svg")))
            drawn = {}
            for kind in kinds:
                with open(os.path.join(plots, f"{kind}.svg"), encoding="utf-8") as stream:
                    drawn[kind] = stream.read()
            for kind, texts in (("fit-relaxation", ("Relaxation modulus [MPa]", "measured", "Residual / noise")),
                                ("fit-inflation", ("axial stretch 1.5", "axial stretch 1.6", "Outer diameter [mm]", "Axial force [mN]")),
                                ("correlation", ("stiffness", "exponent", "0.97"))):
                for text in texts:
                    self.assertIn(text, drawn[kind])


class Files(unittest.TestCase):
    def test_probes_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            rows = "".join(f"{i * 0.01!r},{math.sin(i * 0.3)!r}\n" for i in range(200))
            write(os.path.join(folder, "probes.csv"), "time [s],tip: displacement y [m]\n" + rows)
            done = plot(folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("no rows in power.csv", done.stdout)
            self.assertIn("no fields.pvd", done.stdout)
            plots = os.path.join(folder, "plots")
            with open(os.path.join(plots, "history-displacement-y.csv"), encoding="utf-8") as stream:
                lines = stream.read().splitlines()
            self.assertEqual(lines[0], "tip: time [s],tip: displacement y [m]")
            self.assertEqual(len(lines), 201)
            first = contents(plots)
            self.assertEqual(list(first), [f"{kind}-displacement-y.{end}" for kind in ("envelope", "history")
                                           for end in ("csv", "png", "svg")])
            self.assertEqual(plot(folder).returncode, 0)
            self.assertEqual(contents(plots), first)

    def test_nothing_there(self):
        with tempfile.TemporaryDirectory() as folder:
            done = plot(folder)
            self.assertEqual(done.returncode, 1)
            self.assertIn("none of the files that a run of Continua writes", done.stderr)
            write(os.path.join(folder, "log.txt"), "")
            done = plot(folder)
            self.assertEqual(done.returncode, 1)
            self.assertIn("nothing to draw", done.stderr)
            self.assertEqual(plot(os.path.join(folder, "missing")).returncode, 1)

    def test_broken_table(self):
        with tempfile.TemporaryDirectory() as folder:
            write(os.path.join(folder, "probes.csv"), "time [s],tip: pressure [Pa]\n0,1\n1,oops\n")
            done = plot(folder)
            self.assertEqual(done.returncode, 1)
            self.assertIn("probes.csv:3: 'oops' in the column 'tip: pressure' is no number", done.stderr)

    def test_no_room(self):
        """A folder that cannot be made and a file that cannot be written: also for root, who may write everywhere."""
        with tempfile.TemporaryDirectory() as folder:
            write(os.path.join(folder, "probes.csv"), "time [s],tip: pressure [Pa]\n0,1\n1,2\n")
            done = plot(folder, "--output", os.path.join(folder, "probes.csv", "plots"))
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, r"\Aerror: cannot write .*probes.csv/plots: Not a directory. --output DIR writes into another folder\n\Z")
            for name in ("history-pressure.png", "history-pressure.csv"):
                plots = os.path.join(folder, name.replace(".", "-"))
                os.makedirs(os.path.join(plots, name))
                done = plot(folder, "--output", plots)
                self.assertEqual(done.returncode, 1)
                self.assertRegex(done.stderr, rf"\Aerror: cannot write {plots}/{name}: Is a directory. --output DIR writes into another folder\n\Z")

    def test_no_reader(self):
        """All pictures are drawn, quietly, when the reader of the output goes (| head)."""
        with tempfile.TemporaryDirectory() as folder:
            write(os.path.join(folder, "probes.csv"), "time [s],tip: pressure [Pa]\n0,1\n1,2\n")
            for arguments, status in (([folder], 0), ([folder, "--fields", "speed"], 2)):
                reading, writing = os.pipe()
                os.close(reading)
                done = subprocess.run([os.path.join(SCRIPTS, "plot"), *arguments], stdout=writing, stderr=subprocess.PIPE, text=True, check=False)
                os.close(writing)
                self.assertEqual(done.returncode, status, done.stderr)
                self.assertEqual("Broken pipe" in done.stderr or "Traceback" in done.stderr, False, done.stderr)
            self.assertTrue(os.path.exists(os.path.join(folder, "plots", "history-pressure.png")))

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_full_disk(self):
        with tempfile.TemporaryDirectory() as folder, open("/dev/full", "w", encoding="utf-8") as full:
            write(os.path.join(folder, "probes.csv"), "time [s],tip: pressure [Pa]\n0,1\n1,2\n")
            done = subprocess.run([os.path.join(SCRIPTS, "plot"), folder], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
            self.assertEqual(done.stderr, "error: cannot write: No space left on device\n")
            self.assertEqual(done.returncode, 1)

    def test_studies(self):
        """The message names the script that draws the study, and a run that is there."""
        for script, columns in (("refinement", "way,relative error [1]"), ("comparison", "quantity,verdict")):
            with tempfile.TemporaryDirectory() as folder:
                write(os.path.join(folder, f"{script}.csv"), columns + "\n")
                write(os.path.join(folder, "other-files.txt"), "run-1/\n")
                write(os.path.join(folder, "run-1", "log.txt"), "")
                done = plot(folder)
                self.assertEqual(done.returncode, 2)
                self.assertIn(f"scripts/plot-{script} ", done.stderr)
                self.assertTrue(done.stderr.endswith(f"such as {folder}/run-1\n"), done.stderr)
                self.assertFalse(os.path.exists(os.path.join(folder, "plots")))
        # The cycles of an adaptive mesh are no study.
        with tempfile.TemporaryDirectory() as folder:
            write(os.path.join(folder, "refinement.csv"), "cycle [1],cells [1]\n")
            self.assertIn("nothing to draw", plot(folder).stderr)

    def test_options_of_movies(self):
        for option in (["--gif"], ["--frames", "10"], ["--seconds", "3"]):
            done = plot(".", *option)
            self.assertEqual(done.returncode, 2)
            self.assertIn(f"{option[0]} is for movies: add --movie field or --movie waves", done.stderr)

    def test_width(self):
        self.assertEqual(plot(".", "--width", "wide").returncode, 2)


if __name__ == "__main__":
    unittest.main()
