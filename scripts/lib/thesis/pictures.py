"""The thesis's figures, drawn from runs in its arrangement."""

import math
import os

import chapter_4
import continua
import plot_amplification
import plot_style
import plot_waves
import wave_tables

from .results import Broken, NotThere, parameter_file

WIDTH = 160 / 25.4  # inches


class SomeCurves:
    """A wave_tables.Field with some of its sources."""

    def __init__(self, field, sources):
        self.unit, self.time, self.positions = field.unit, field.time, field.positions
        self.sources = {source: field.sources[source] for source in sources if source in field.sources}

    def best(self):
        return wave_tables.Field.best(self)


def sheet_of(folder, figure):
    """A sheet in a folder of the figure's own."""
    folder = os.path.join(folder, figure.replace(" ", "-"))
    os.makedirs(folder, exist_ok=True)
    sheet = plot_style.Sheet(folder, WIDTH, False)
    sheet.formats = ["png", "svg"]
    return sheet


def run_of(results, name):
    """A run as the plots take it. Throws NotThere."""
    run = results.run(name)
    return {"folder": results.folder_of(name), "title": run.summary.get("title") or name, "summary": run.summary}


class Amplification:
    """Figures 3.8 and 3.10."""

    files = ("chapter-3/amplification",)

    def __init__(self, schemes):
        self.schemes = schemes

    def draw(self, sheet, results):
        schemes = plot_amplification.read(run_of(results, *self.files))
        chosen = {scheme: schemes[scheme] for scheme in self.schemes}
        if len(chosen) > 1:
            plot_amplification.draw_comparison(sheet, chosen)
        else:
            plot_amplification.draw_portrait(sheet, *next(iter(chosen.items())))


class Beam:
    """Figures 4.2 to 4.15, as scripts/manual/chapter-4 has them."""

    def __init__(self, number):
        names = {os.path.splitext(name)[0] for name in os.listdir(os.path.dirname(parameter_file("chapter-4/beam")))}
        self.number = number
        self.figure = chapter_4.figures({name for name in names if name.startswith("fv-")})[number]
        self.files = tuple(f"chapter-4/{name}" for name in self.figure.runs)

    def draw(self, sheet, results):
        runs, missing = [], []
        for name in self.files:
            try:
                runs.append(results.run(name))
            except NotThere as error:
                missing.append(str(error))
        if not runs and self.files:
            raise NotThere(missing[0])
        sheet.notes += missing
        self.figure.draw(sheet, self.number, self.figure, runs)


class Tubes:
    """Figures 5.6 to 5.21: one field of some tubes, normalised, with the elastic and with the viscoelastic wall."""

    def __init__(self, field, tubes):
        self.field, self.tubes = field, tubes
        self.walls = [[f"chapter-5/{wall}tube-{tube.lower()}" for tube in tubes] for wall in ("", "viscoelastic/")]
        self.files = tuple(name for wall in self.walls for name in wall)

    def draw(self, sheet, results):
        drawn, reason = False, None
        for names, kind in zip(self.walls, ("elastic", "viscoelastic")):
            try:
                entries = []
                for name in names:
                    run, waves = run_of(results, name), results.wave(name)
                    entries.append((run, SomeCurves(waves[self.field], ["simulated"]), plot_waves.time_scale(sheet, run, waves)))
            except NotThere as error:
                reason = error
                continue
            written = len(sheet.written)
            plot_waves.draw_stations(sheet, self.field, [entry for entry in entries if entry[2]], True, True)
            rename(sheet, written, kind)
            drawn = True
        if not drawn:
            raise reason


class Inflation:
    """Figure 5.4: the diameter of tube B over the static pressure, in the thesis's axes. The run has one pressure; it is linear, also in 1/Y."""

    files = ("chapter-5/tube-b-inflation",)
    pressures, diameters = (1e3, 4.5e3), (23.8e-3, 25.6e-3)  # the axes
    at_rest, pressure, modulus, design = 2.94e3, 3.5e3, 1.72e6, 10e6

    def draw(self, sheet, results):
        slope = 2 * results.quantity(self.files[0], "inner surface: final displacement y") / self.pressure
        corners = (self.diameters[1] - self.diameters[0]) / (self.pressures[1] - self.pressures[0])
        figure, axes = sheet.figure(0.6)
        header, columns = ["pressure [Pa]"], [list(self.pressures)]
        middle = 25e-3 / math.sqrt(1.03)
        for modulus, name in ((self.modulus, "of table 6.3"), (self.design, "of the design"),
                              (self.modulus * slope / corners, "by the slope of the dotted line")):
            values = [middle + slope * self.modulus / modulus * (p - self.at_rest) for p in self.pressures]
            axes.plot([1e-3 * p for p in self.pressures], [1e3 * value for value in values], label=f"{1e-6 * modulus:.3g} MPa, {name}")
            header.append(f"diameter with {modulus:.4g} Pa [m]")
            columns.append(values)
        axes.plot([1e-3 * p for p in self.pressures], [1e3 * d for d in self.diameters], ":", color="#000000",
                  label="corner to corner of the thesis's axes")
        axes.set_xlim([1e-3 * p for p in self.pressures])
        axes.set_ylim([1e3 * d for d in self.diameters])
        axes.set_xlabel("Static pressure [kPa]")
        axes.set_ylabel("Diameter [mm]")
        sheet.legend(axes, 4)
        sheet.save(figure, "inflation")
        sheet.save_data("inflation", header, columns)


class Waves:
    """Figures 6.4 to 6.15: one field of one tube by linear theory. In place of the measurement stands the simulation with the viscoelastic
    wall; with the elastic wall that wall's simulation is there, too. Without the simulations: the theory."""

    def __init__(self, field, tube, wall):
        self.field, self.viscoelastic = field, wall == "viscoelastic"
        runs = [f"chapter-6/experiment-{tube}"] * (not self.viscoelastic) + [f"chapter-6/experiment-{tube}-viscoelastic"]
        self.files = tuple(runs + [f"{runs[0]}-theory"])

    def draw(self, sheet, results):
        # Of each catheter a picture: (a) P0, (b) P1.
        for probe, ending in (("stations", "P0"), ("trailing catheter", "P1")) if self.field == "pressure" else (("stations", None),):
            entries = self.entries(results, probe)
            written = len(sheet.written)
            plot_waves.draw_stations(sheet, self.field, entries, False, len(entries) > 1)
            if ending:
                rename(sheet, written, ending)

    def entries(self, results, probe):
        found = []
        for name, sources, title in self.curves():
            try:
                field = SomeCurves(results.wave(name, probe)[self.field], sources)
            except NotThere:
                continue
            run = run_of(results, name)
            found.append(({**run, "title": title or run["title"]}, field, 1.0))
        if not found:
            theory = self.files[-1]
            found.append((run_of(results, theory), results.wave(theory, probe)[self.field], 1.0))
        return found

    def curves(self):
        if self.viscoelastic:
            return [(self.files[0], ["simulated", "theory"], None)]
        return [(self.files[0], ["simulated", "theory"], "elastic wall"),
                (self.files[1], ["simulated"], "viscoelastic wall, in place of the measurement")]


class SpinCoating:
    """Figures 5.1, A.4, A.6 and A.7."""

    def __init__(self, *names):
        self.files = names

    def draw(self, sheet, results):
        plot_waves.draw_spin_coating(sheet, [run_of(results, name) for name in self.files])


def rename(sheet, first, ending):
    """Gives what was written last another name, so that the next of its kind does not overwrite it."""
    for i in range(first, len(sheet.written)):
        stem, kind = os.path.splitext(sheet.written[i])
        os.replace(sheet.written[i], f"{stem}-{ending}{kind}")
        sheet.written[i] = f"{stem}-{ending}{kind}"


def all_drawings():
    drawings = {"figure 3.8": Amplification(["displacement euler"]),
                "figure 3.10": Amplification(["displacement euler", "velocity euler"])}
    for number in ("4.2", "4.3", "4.4", "4.5", "4.6", "4.7", "4.8", "4.9", "4.10", "4.11", "4.12", "4.13", "4.14", "4.15"):
        drawings[f"figure {number}"] = Beam(number)
    drawings["figure 5.1"] = SpinCoating("appendix-a/tube-f", "appendix-a/tube-c")
    drawings["figure 5.4"] = Inflation()
    for i, field in enumerate(("pressure", "flow rate", "pressure gradient", "wall distension")):
        for j, tubes in enumerate(("ABC", "DEF", "AF", "CE")):
            drawings[f"figure 5.{6 + 4 * i + j}"] = Tubes(field, tubes)
    for i, (wall, tube) in enumerate((wall, tube) for wall in ("elastic", "viscoelastic") for tube in "ab"):
        for j, field in enumerate(("pressure", "flow rate", "wall distension")):
            drawings[f"figure 6.{4 + 3 * i + j}"] = Waves(field, tube, wall)
    for number, names in (("A.4", ("tube-c",)), ("A.6", ("tube-e-figure", "tube-e")), ("A.7", ("tube-f",))):
        drawings[f"figure {number}"] = SpinCoating(*(f"appendix-a/{name}" for name in names))
    return drawings


def needed_files(figures):
    """The parameter files behind the drawings of these figures."""
    drawings = all_drawings()
    found = {}
    for figure in figures:
        for name in getattr(drawings.get(figure.id), "files", ()):
            found.setdefault(parameter_file(name), None)
    return list(found)


def draw(figures, results, folder):
    """({figure: PNG files}, what could not be drawn and why)."""
    drawings = all_drawings()
    drawn, notes = {}, []
    for figure in figures:
        if figure.id not in drawings:
            continue
        sheet = sheet_of(folder, figure.id)
        try:
            drawings[figure.id].draw(sheet, results)
        except (NotThere, Broken, KeyError, plot_style.PlotError, continua.ResultsError) as error:
            notes.append(f"{figure.id} ({error})")
        notes += [f"{figure.id} (in part: {note})" for note in sheet.notes]
        pictures = [path for path in sheet.written if path.endswith(".png")]
        if pictures:
            drawn[figure.id] = pictures
    return drawn, notes
