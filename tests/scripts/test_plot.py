#!/usr/bin/python3
"""scripts/plot: the maxima of a damped cosine, what it does with missing pieces, the same files every time."""

import math
import os
import subprocess
import sys
import tempfile
import unittest

import numpy

SCRIPTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts")
sys.path.insert(0, os.path.join(SCRIPTS, "lib"))
import plot_histories  # noqa: E402
import plot_style  # noqa: E402
import plot_waves  # noqa: E402
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
        self.assertEqual(plot_style.readable(0.012, "m^3/s"), (1.0, "m^3/s"))
        self.assertEqual(plot_style.axis_label("flow rate", "m^3/s"), "Flow rate [m³/s]")


def pulse(time, place, height=100.0):
    """A pulse at 2 m/s from place 0 that a closed end at 0.4 m throws back, as forward and backward wave."""
    return [height * numpy.exp(-((time - arrival - 0.05) / 0.01)**2) for arrival in (place / 2, (0.8 - place) / 2)]


def write_wave(folder, height=100.0):
    time = numpy.arange(0, 0.5, 0.001)
    header, columns = ["time [s]"], [time]
    for place in (0.0, 0.1, 0.2, 0.3, 0.35):
        forward, backward = pulse(time, place, height)
        for name, values in (("pressure, simulated", forward + backward), ("pressure, theory", forward + backward),
                             ("pressure, simulated - theory", 0 * time), ("forward wave, simulated", forward),
                             ("backward wave, simulated", backward)):
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
            self.assertIn("nothing to draw", done.stderr)
            self.assertEqual(plot(os.path.join(folder, "missing")).returncode, 1)

    def test_broken_table(self):
        with tempfile.TemporaryDirectory() as folder:
            write(os.path.join(folder, "probes.csv"), "time [s],tip: pressure [Pa]\n0,1\n1,oops\n")
            done = plot(folder)
            self.assertEqual(done.returncode, 1)
            self.assertIn("cannot read", done.stderr)

    def test_width(self):
        self.assertEqual(plot(".", "--width", "wide").returncode, 2)


if __name__ == "__main__":
    unittest.main()
