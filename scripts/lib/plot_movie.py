"""Movies: the states of a run one after the other, and the waves that run along a tube."""

import argparse
import contextlib
import io
import math
import os
import shutil
import subprocess
import tempfile

import matplotlib.animation
import matplotlib.pyplot as plt
import numpy
import PIL.Image
import plot_choice
import plot_field
import plot_style
import plot_waves
import render_field
import vtk
import wave_tables
from vtk.util.numpy_support import numpy_to_vtk
from vtk_part import part_of

N_PLACES = 400  # of a curve along a tube
N_ANGLES = 16  # of the samples round its axis in space
FASTEST = 50  # frames in a second
WALL = "wall distension"


class Settings:
    """As GIF in place of MP4; at most how many frames; how many seconds in all; (width, height) of a frame in pixels or None."""

    def __init__(self, gif, frames, seconds, size=None):
        self.gif, self.frames, self.seconds, self.size = gif, frames, seconds, size


def read_frames(text):
    """What --frames takes."""
    if not text.isdigit() or int(text) < 2:
        raise argparse.ArgumentTypeError(f"'{text}' is not a number of frames: 2 or more")
    return int(text)


def read_size(text):
    """What --size takes."""
    width, times, height = text.partition("x")
    if not times or not width.isdigit() or not height.isdigit() or not 100 <= int(width) <= 8000 or not 100 <= int(height) <= 8000:
        raise argparse.ArgumentTypeError(f"'{text}' is not a size in pixels such as 1920x1080, 100 to 8000 each")
    return int(width), int(height)


def read_seconds(text):
    """What --seconds takes."""
    try:
        seconds = float(text.removesuffix("s").strip())
    except ValueError:
        seconds = math.nan
    if not 0 < seconds < math.inf:
        raise argparse.ArgumentTypeError(f"'{text}' is not a length such as 8 or 8 s")
    return seconds


def check(choice, kind, gif, runs):
    """Throws ChoiceError if there is nothing to move, or nothing that writes MP4."""
    if not gif and shutil.which("ffmpeg") is None:
        raise plot_choice.ChoiceError("--movie needs ffmpeg, which is not installed (Debian: apt-get install ffmpeg); "
                                      "--gif writes an animated GIF without it")
    if kind == "waves":
        check_waves(choice, runs)
        return
    n_states = len(states_of(runs[0]))
    if n_states < 2:
        said = "one output time" if n_states == 1 else "no states of fields"
        raise plot_choice.ChoiceError(f"--movie field: {runs[0]['folder']} has {said}; a movie needs two or more "
                                      "(`Output/Field interval`)")
    if runs[0]["summary"].get("analysis") == "modal":
        raise plot_choice.ChoiceError("--movie field: a modal analysis has shapes and no time")
    if choice.fields and not choice.fields_of(plot_choice.fields_of_states(runs[0])):
        raise plot_choice.ChoiceError(f"--movie field: no state has {', '.join(choice.fields)}; there are "
                                      f"{', '.join(plot_choice.fields_of_states(runs[0]))}")


def check_waves(choice, runs):
    if not quantities_of(choice):
        raise plot_choice.ChoiceError(f"--movie waves --fields {','.join(choice.fields)}: there are pressure and {WALL}")
    for run in runs:
        fields = wave_tables.read_waves(run["folder"])
        if len(states_of(run)) > 1 and is_straight_tube(run) or any(len(field.positions) > 1 for field in fields.values()):
            return
    raise plot_choice.ChoiceError("--movie waves: no run has states of a straight tube at two times or more, nor two stations in wave.csv")


def quantities_of(choice):
    return choice.fields_of(["pressure", WALL]) if choice.fields else ["pressure"]


def states_of(run):
    path = os.path.join(run["folder"], "fields.pvd")
    return plot_choice.entries_of(path) if os.path.exists(path) else []


def draw(sheet, runs, kind, settings):
    if kind == "field":
        draw_states(sheet, runs[0], settings)
    else:
        draw_waves(sheet, runs, settings)


def evenly(n, at_most):
    """Numbers from 0 to n - 1, evenly, with both ends."""
    return sorted({round(i * (n - 1) / (min(n, at_most) - 1)) for i in range(min(n, at_most))})


class TimeLabel:
    """Times with the same unit and digits in all frames, so that nothing jumps."""

    def __init__(self, times):
        self.factor, self.unit = plot_style.readable(max(times), "s")
        steps = numpy.diff(numpy.unique(times)) * self.factor
        self.digits = min(6, max(0, 1 - math.floor(math.log10(steps.min())))) if len(steps) else 3

    def __call__(self, time):
        return f"t = {self.factor * time:.{self.digits}f} {self.unit}"


def draw_states(sheet, run, settings):
    entries = states_of(run)
    entries = [entries[i] for i in evenly(len(entries), settings.frames)]
    label = TimeLabel([time for time, _ in entries])
    fields = sheet.choice.fields_of(plot_choice.fields_of_states(run)) if sheet.choice.fields else [None]
    for field in fields:
        with tempfile.TemporaryDirectory() as folder:
            picture = plot_field.render(sheet, run, [pieces for _, pieces in entries], field, folder)
            if picture is None:
                continue
            figure, show = plot_field.compose(sheet, run, picture, folder, label(entries[0][0]))

            def show_frame(i, show=show):
                show(i, label(entries[i][0]))

            write(sheet, figure, show_frame, len(entries), "movie-" + plot_style.file_name(picture["field"]), settings)


def along_tube(grid, places):
    """{"pressure": values, "wall distension": values} at these places [m] of a straight tube along x: the mean of the pressure over the
    liquid's section, and the change of the inner diameter. What there is of it."""
    points, solid = vtk_points(grid), render_field.in_solid(grid)
    data = grid.GetPointData()
    if solid is None or solid.all():
        return {}
    radius = numpy.hypot(points[:, 1], points[:, 2])
    length = points[:, 0].max() - points[:, 0].min()
    numbers, n_places = render_field.as_one(points)
    is_common = numpy.zeros((2, n_places), bool)
    is_common[0, numbers[solid]] = True
    is_common[1, numbers[~solid]] = True
    inner = is_common.all(axis=0)[numbers] & (radius > 0)
    found = {}
    if data.GetArray("pressure") is not None:
        if inner.any():
            x, inner_radius = by_place(points[inner, 0], radius[inner], length)
        else:  # a tube without a wall
            x, inner_radius = largest_by_place(points[:, 0], radius, length)
        means = section_means(grid, places, numpy.interp(places, x, inner_radius))
        if numpy.isfinite(means).all():
            found["pressure"] = means
    inner &= solid
    if inner.any() and data.GetArray("displacement") is not None:
        displacement = render_field.vtk_to_numpy(data.GetArray("displacement")).astype(float)[inner]
        radial = (displacement[:, 1] * points[inner, 1] + displacement[:, 2] * points[inner, 2]) / radius[inner]
        found[WALL] = numpy.interp(places, *by_place(points[inner, 0], 2 * radial, length))
    return found


def section_means(grid, places, radii):
    """The means of the pressure over the circles about the x axis, by Gauss's formula in r^2 and, in space, along the circles: of as
    much of them as there is."""
    nodes, weights = numpy.polynomial.legendre.leggauss(5)
    shares = numpy.sqrt((1 + nodes) / 2)
    is_plane = numpy.ptp(vtk_points(grid)[:, 2]) < 1e-9 * places.max()
    angles = numpy.array([0.0]) if is_plane else (numpy.arange(N_ANGLES) + 0.5) * 2 * math.pi / N_ANGLES
    r = radii[:, None, None] * shares[None, :, None]
    sample = numpy.stack(numpy.broadcast_arrays(places[:, None, None], r * numpy.cos(angles), r * numpy.sin(angles)), axis=-1)
    polydata, at = vtk.vtkPolyData(), vtk.vtkPoints()
    at.SetData(numpy_to_vtk(sample.reshape(-1, 3), deep=True))
    polydata.SetPoints(at)
    probe = vtk.vtkProbeFilter()
    probe.SetInputData(polydata)
    probe.SetSourceData(part_of(grid))
    probe.Update()
    data = probe.GetOutput().GetPointData()
    valid = render_field.vtk_to_numpy(data.GetArray(probe.GetValidPointMaskArrayName())).reshape(sample.shape[:3]) > 0
    values = numpy.where(valid, render_field.vtk_to_numpy(data.GetArray("pressure")).astype(float).reshape(valid.shape), 0)
    # Of each circle the mean of what is modelled, of the circles the mean over the area.
    n_valid = valid.sum(axis=2)
    rings = values.sum(axis=2) / numpy.maximum(n_valid, 1)
    weight = numpy.where(n_valid > 0, weights, 0)
    with numpy.errstate(invalid="ignore"):
        return (weight * rings).sum(axis=1) / weight.sum(axis=1)


def vtk_points(grid):
    return render_field.vtk_to_numpy(grid.GetPoints().GetData()).astype(float)


def by_place(x, values, length):
    """(places in order, the mean of the values at each)."""
    places, numbers = numpy.unique(numpy.round(x / (1e-7 * length)), return_inverse=True)
    return places * 1e-7 * length, numpy.bincount(numbers, values) / numpy.bincount(numbers)


def largest_by_place(x, values, length):
    """(places in order, the largest of the values at each)."""
    places, numbers = numpy.unique(numpy.round(x / (1e-7 * length)), return_inverse=True)
    largest = numpy.zeros(len(places))
    numpy.maximum.at(largest, numbers, values)
    return places * 1e-7 * length, largest


class Line:
    """A quantity along the tube of one run: places [m], times [s], values (place, time), and where they are from."""

    def __init__(self, places, times, values, source):
        self.places, self.times, self.values, self.source = places, times, values, source

    def at(self, time):
        """Linear between two states; nothing after the end."""
        if time > self.times[-1] * (1 + 1e-9):
            return numpy.full(len(self.places), numpy.nan)
        return numpy.array([numpy.interp(time, self.times, values) for values in self.values])


def is_straight_tube(run):
    """Whether the states show a tube along x: its radius is measured from the x axis."""
    return run["summary"].get("model") == "axisymmetric" or "tube" in geometry_of(run)


def geometry_of(run):
    """The type of the geometry that parameters.prm has."""
    path = os.path.join(run["folder"], "parameters.prm")
    if not os.path.exists(path):
        return ""
    with open(path, encoding="utf-8") as stream:
        text = stream.read()
    section = text.partition("subsection Geometry")[2].partition("\nend")[0]
    types = [line.partition("=")[2].split("#")[0].strip() for line in section.splitlines() if line.split("=")[0].split() == ["set", "Type"]]
    return types[0] if types else ""


def lines_of(run, quantities):
    """{quantity: Line}: of a straight tube from its states, which have every node; otherwise from the stations."""
    found = {}
    entries = states_of(run)
    if len(entries) > 1 and is_straight_tube(run):
        collected, places = {}, None
        for _, pieces in entries:
            plot_field.check_pieces(pieces)
            grid = read(pieces)
            if places is None:
                low, high = grid.GetBounds()[:2]
                places = numpy.linspace(low, high, N_PLACES)
                sampled = places.clip(low + 1e-6 * (high - low), high - 1e-6 * (high - low))
            for name, values in along_tube(grid, sampled).items():
                collected.setdefault(name, []).append(values)
        times = numpy.array([time for time, _ in entries])
        for name, states in collected.items():
            if name in quantities and len(states) == len(entries):
                found[name] = Line(places, times, numpy.array(states).T, "simulated")
    waves = wave_tables.read_waves(run["folder"])
    for name in quantities:
        if name not in found and name in waves and len(waves[name].positions) > 1 and numpy.isfinite(waves[name].best()).all():
            found[name] = Line(*plot_waves.space_time(waves, name))
    return found


def read(pieces):
    try:
        return render_field.read(pieces)
    except SystemExit as error:  # which has said why
        raise plot_style.PlotError(f"cannot read {pieces[0]}") from error


def draw_waves(sheet, runs, settings):
    quantities = quantities_of(sheet.choice)
    lines = [(run, lines_of(run, quantities)) for run in runs]
    for run, found in lines:
        if not found:
            sheet.notes.append(f"waves of {run['folder']} (neither states of a straight tube nor two stations in wave.csv)")
    for quantity in quantities:
        there = [(run, found[quantity]) for run, found in lines if quantity in found]
        if there and max(len(line.times) for _, line in there) > 1:
            draw_line(sheet, quantity, there, len(runs) > 1, settings)


def draw_line(sheet, quantity, there, several, settings):
    """The movie of one quantity."""
    si = "m" if quantity == WALL else "Pa"
    stations = [(i, wave_tables.read_waves(run["folder"]).get(quantity)) for i, (run, _) in enumerate(there)]
    stations = [(i, field) for i, field in stations if field is not None]
    values = [line.values for _, line in there] + [curves for _, field in stations for curves in field.sources.values()]
    low, high = min(0.0, *(numpy.nanmin(v) for v in values)), max(0.0, *(numpy.nanmax(v) for v in values))
    factor, unit = plot_style.readable(max(-low, high), si, quantity)
    place_factor, place_unit = plot_style.readable(max(line.places[-1] for _, line in there), "m")
    first = there[0][1].times
    times = numpy.array([first[i] for i in evenly(len(first), settings.frames)])
    label = TimeLabel(times)

    figure, axes = sheet.figure(0.5)
    curves, points = [], []
    for i, (run, line) in enumerate(there):
        look = plot_style.of_run(i, len(line.places)) if several else {"color": plot_style.COLOURS[0]}
        name = f"{run['title']}: {line.source}" if several else line.source
        curves += axes.plot(place_factor * line.places, factor * line.at(times[0]), label=name, **look)
        for source in (*plot_waves.THEORIES, "measured"):
            field = dict(stations).get(i)
            if field is not None and source in field.sources and line.source != source:
                look = {**plot_waves.look_of(i, "measured", several), "markersize": 5}
                if source in plot_waves.THEORIES:
                    look.update(color="#000000" if i == 0 else look["color"], marker="x" if source == "theory" else "+")
                (drawn,) = axes.plot(place_factor * numpy.array(field.positions), numpy.zeros(len(field.positions)),
                                     label=f"{run['title']}: {source}" if several else source, **look)
                points.append((drawn, field, source))
    axes.set_xlim(place_factor * min(line.places[0] for _, line in there), place_factor * max(line.places[-1] for _, line in there))
    margin = 0.05 * (high - low if high > low else 1)
    axes.set_ylim(factor * (low - margin), factor * (high + 3 * margin))  # the time stands above the curve
    axes.set_xlabel(plot_style.axis_label("axial position", place_unit))
    axes.set_ylabel(plot_style.axis_label(quantity, unit))
    clock = axes.text(0.99, 0.97, label(times[-1]), transform=axes.transAxes, ha="right", va="top")
    sheet.legend(axes, len(curves) + len(points))

    def show_frame(i):
        for curve, (_, line) in zip(curves, there):
            curve.set_ydata(factor * line.at(times[i]))
        for drawn, field, source in points:
            drawn.set_ydata([factor * numpy.interp(times[i], field.time, values, right=numpy.nan) for values in field.sources[source]])
        clock.set_text(label(times[i]))

    write(sheet, figure, show_frame, len(times), f"movie-waves-{plot_style.file_name(quantity)}", settings)


def write(sheet, figure, show_frame, n_frames, name, settings):
    """Writes the frames as MP4 or GIF."""
    path = os.path.join(sheet.folder, f"{name}.{'gif' if settings.gif else 'mp4'}")
    figure.canvas.draw()
    figure.set_layout_engine("none")  # nothing moves from frame to frame but what is drawn
    sheet.check_frame(figure, name)
    if settings.gif:
        write_gif(figure, show_frame, n_frames, path, settings.seconds, settings.size)
    else:
        write_mp4(figure, show_frame, n_frames, path, settings.seconds, settings.size)
    plt.close(figure)
    sheet.written.append(path)


def resolution_for(figure, size):
    """Dots per inch with which the figure fills a frame of (width, height) pixels as far as its shape allows."""
    return min(pixels / length for pixels, length in zip(size, figure.get_size_inches()))


def write_mp4(figure, show_frame, n_frames, path, seconds, size):
    """In the format that browsers and slides show: H.264 with an even number of pixels each way, white around the figure."""
    width, height = (2 * -(-pixels // 2) for pixels in size) if size else ("ceil(iw/2)*2", "ceil(ih/2)*2")
    part = f"{path[:-4]}.part.mp4"
    writer = matplotlib.animation.FFMpegWriter(
        fps=min(FASTEST, n_frames / seconds), codec="libx264",
        extra_args=["-pix_fmt", "yuv420p", "-crf", "18", "-vf", f"pad={width}:{height}:-1:-1:color=white", "-movflags", "+faststart"])
    try:
        with writer.saving(figure, part, dpi=math.floor(100 * resolution_for(figure, size)) / 100 if size else plt.rcParams["savefig.dpi"]):
            for i in range(n_frames):
                show_frame(i)
                writer.grab_frame()
        os.replace(part, path)
    except subprocess.CalledProcessError as error:
        said = (error.stderr or b"").decode("utf-8", "replace") if isinstance(error.stderr, bytes) else str(error.stderr or "")
        raise plot_style.PlotError(f"ffmpeg ended with exit status {error.returncode}: "
                                   f"{said.strip().splitlines()[-1] if said.strip() else 'it did not say why'}") from error
    except OSError as error:
        raise plot_style.PlotError(f"cannot write {path} by ffmpeg: {error.strerror or error}") from error
    finally:
        with contextlib.suppress(FileNotFoundError):
            os.remove(part)


def write_gif(figure, show_frame, n_frames, path, seconds, size):
    """All frames have the same colours, so that none flickers and the file stays small."""
    frames = []
    for i in range(n_frames):
        show_frame(i)
        data = io.BytesIO()
        figure.savefig(data, format="png", dpi=resolution_for(figure, size) if size else plt.rcParams["savefig.dpi"])
        frames.append(filled(PIL.Image.open(data).convert("RGB"), size))
    palette = common_palette([frames[i] for i in evenly(n_frames, 8)])
    frames = [in_colours(frame, palette) for frame in frames]
    each = max(20, round(100 * seconds / n_frames) * 10)  # ms; browsers show no shorter ones
    try:
        frames[0].save(path, save_all=True, append_images=frames[1:], duration=each, loop=0, optimize=False)
    except OSError as error:
        raise plot_style.cannot_write(path, error) from error


def filled(frame, size):
    """The frame in the middle of a white one of that size."""
    if size is None:
        return frame
    result = PIL.Image.new("RGB", size, "white")
    result.paste(frame, ((size[0] - frame.width) // 2, (size[1] - frame.height) // 2))
    return result


def common_palette(frames):
    """White, black and 254 colours for those of the frames, of which each counts once: most of a frame is white."""
    colours = numpy.unique(numpy.concatenate([numpy.asarray(frame).reshape(-1, 3) >> 2 for frame in frames]), axis=0) << 2
    image = PIL.Image.fromarray(colours[None, :, :].astype(numpy.uint8), "RGB").quantize(254, PIL.Image.Quantize.MEDIANCUT)
    palette = PIL.Image.new("P", (1, 1))
    palette.putpalette(([255, 255, 255, 0, 0, 0] + image.getpalette()[:3 * 254] + [0] * 768)[:768])
    return palette


def in_colours(frame, palette):
    """The frame in the nearest colours; Pillow, which is quick and not exact, may miss white."""
    nearest = numpy.array(frame.quantize(palette=palette, dither=PIL.Image.Dither.NONE))
    nearest[(numpy.asarray(frame) == 255).all(axis=-1)] = 0
    result = PIL.Image.fromarray(nearest, "P")
    result.putpalette(palette.getpalette())
    return result
