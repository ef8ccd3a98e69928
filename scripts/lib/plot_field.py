"""The picture of the mesh at one time: deformed by the displacement, coloured by a field.

VTK draws the mesh off-screen in a process of its own (render_field.py), since without a display it does not fail but
aborts; then Xvfb lends one. When neither works, Matplotlib draws plane meshes. Matplotlib adds axes and colour bar.
"""

import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import textwrap
import xml.etree.ElementTree

import matplotlib
import matplotlib.pyplot as plt
import matplotlib.ticker
import numpy
import plot_style

UNITS = {"velocity": "m/s", "displacement": "m", "pressure": "Pa"}
FLATTEST = 5.0  # a longer and thinner picture is stretched across
ROOM = 1.35  # inches for title, labels and colour bar, whatever the width
BAR = 0.65  # inches for a second colour bar
BELOW = 0.16  # of the width, for the directions below a body in space
MOST_MODES = 6  # that are drawn without --time


def draw(sheet, run, field, time):
    path = os.path.join(run["folder"], "fields.pvd")
    if not os.path.exists(path):
        sheet.notes.append(f"field picture of {run['folder']} (no fields.pvd)")
        return
    modes = run["summary"].get("modes", [])
    if run["summary"].get("analysis") != "modal" or not modes:
        draw_state(sheet, run, path, field, time)
        return
    # A shape has no velocity; its "time" is its number.
    chosen = [round(time)] if time is not None else range(1, min(len(modes), MOST_MODES) + 1)
    for number in chosen:
        if not 1 <= number <= len(modes):
            raise plot_style.PlotError(f"--time {number}: there are the modes 1 to {len(modes)}")
        draw_state(sheet, run, path, field or "displacement", number, re.split(r"[,;(]", modes[number - 1])[0].strip(),
                   f"-mode-{number}")
    if time is None and len(modes) > MOST_MODES:
        sheet.notes.append(f"pictures of the modes {MOST_MODES + 1} to {len(modes)} (--time 7 draws the seventh)")


def draw_state(sheet, run, path, field, time, title=None, suffix=""):
    """The picture of the state at a time, or of the last one; `title` in place of the time."""
    at, pieces = entry_of(path, time)
    if not pieces:
        sheet.notes.append(f"field picture of {run['folder']} (fields.pvd has no entries)")
        return
    missing = [piece for piece in pieces if not os.path.exists(piece)]
    if missing:
        raise plot_style.PlotError(f"{path} names {missing[0]}, which is not there")
    with tempfile.TemporaryDirectory() as folder:
        request = {"pieces": pieces, "field": field, "folder": folder, "flattest": FLATTEST,
                   "pixels": int(sheet.width * 200)}
        if not rendered(request, sheet):
            return
        with open(os.path.join(folder, "picture.json"), encoding="utf-8") as stream:
            picture = json.load(stream)
        steady = run["summary"].get("analysis") == "steady"
        picture["of"] = title or ("steady state" if steady else f"t = {at:.6g} s")
        compose(sheet, run, picture, folder, suffix)


def entry_of(path, time):
    """(time, files) of the last entry of a .pvd file, or of the one nearest to the time."""
    try:
        tree = xml.etree.ElementTree.parse(path)
    except xml.etree.ElementTree.ParseError as error:
        raise plot_style.PlotError(f"cannot read {path}: {error}") from error
    entries = {}
    for element in tree.iter("DataSet"):
        at = float(element.get("timestep", "0"))
        entries.setdefault(at, []).append(os.path.join(os.path.dirname(path), element.get("file")))
    if not entries:
        return 0.0, []
    at = max(entries) if time is None else min(entries, key=lambda t: abs(t - time))
    return at, entries[at]


def rendered(request, sheet):
    """Whether render_field.py made the picture, one way or the other; what it cannot do is noted."""
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "render_field.py")
    ways = []
    if os.environ.get("DISPLAY"):
        ways.append(("gl", []))
    if shutil.which("xvfb-run") and shutil.which("xauth"):
        ways.append(("gl", ["xvfb-run", "-a"]))
    ways.append(("plain", []))
    said = ""
    for way, prefix in ways:
        done = subprocess.run([*prefix, "/usr/bin/python3", "-B", script], input=json.dumps({**request, "way": way}),
                              capture_output=True, text=True, check=False, timeout=300)
        if done.returncode == 0:
            return True
        said = (done.stderr or done.stdout).strip().splitlines()[-1:] or [f"exit status {done.returncode}"]
        if done.returncode == 3:  # a fault of the data or the request, which another way would not mend
            raise plot_style.PlotError(said[0])
    sheet.notes.append(f"field picture ({said[0]})")
    return False


def compose(sheet, run, picture, folder, suffix):
    unit = unit_of(run["summary"], picture["field"])
    ranges = picture["ranges"]
    left, right, bottom, top = picture["extent"]
    shape = (top - bottom) * picture["stretch"] / (right - left)
    room = ROOM + BAR * (len(ranges) - 1)
    below = 0 if picture["plane"] else BELOW
    figure, axes = plt.subplots(figsize=(sheet.width, 0.95 * sheet.width * (shape + below) + room), constrained_layout=True)
    image = os.path.join(folder, "picture.png")
    if os.path.exists(image):
        axes.imshow(plt.imread(image), extent=picture["extent"], interpolation="antialiased")
    else:
        data = numpy.load(os.path.join(folder, "picture.npz"))
        colours = numpy.concatenate([matplotlib.colormaps[name](numpy.linspace(0, 1, 256)) for _, name, _, _ in ranges])
        axes.tripcolor(data["x"], data["y"], data["triangles"], data["values"], shading="gouraud", rasterized=True,
                       cmap=matplotlib.colors.ListedColormap(colours), norm=plt.Normalize(0, len(ranges)))
        axes.add_collection(matplotlib.collections.LineCollection(data["edges"], colors="black", linewidths=0.25))
    axes.set_aspect(picture["stretch"])
    if picture["plane"]:
        for axis, name, ends in ((axes.xaxis, "x", (left, right)), (axes.yaxis, "y", (bottom, top))):
            place_factor, place_unit = plot_style.readable(max(map(abs, ends)), "m", name)
            label_places(axis, ends, place_factor)
            axis.set_label_text(plot_style.axis_label(name, place_unit).replace("X", "x").replace("Y", "y"))
    else:
        axes.set_axis_off()
        orient(axes, picture["axes"], right - left, bottom)
    remarks = [picture["of"]]
    if picture["deformation"] not in (0, 1):
        remarks.append(f"displacement{' of the solids' if picture['liquid'] else ''} × {picture['deformation']:g}")
    if picture["stretch"] != 1:
        remarks.append(f"y drawn × {picture['stretch']:g}")
    axes.set_title(textwrap.fill(", ".join(remarks), int((sheet.width - 0.8) / 0.066)), fontsize=8.5, loc="left")
    for what, name, low, high in ranges:
        factor, bar_unit = plot_style.readable(max(abs(low), abs(high)), unit, picture["field"])
        scale = plt.Normalize(low * factor, high * factor if high > low else low * factor + 1)
        bar = figure.colorbar(plt.cm.ScalarMappable(scale, matplotlib.colormaps[name]), ax=axes, location="bottom", shrink=0.6,
                              aspect=40, pad=0.04)
        label = f"{picture['label']} in the {what}" if what else picture["label"]
        bar.set_label(plot_style.axis_label(label.replace("_", " "), bar_unit))
        bar.outline.set_linewidth(0.4)
        bar.locator = matplotlib.ticker.MaxNLocator(7 if sheet.width > 5 else 4)
        bar.update_ticks()
    sheet.save(figure, "field-" + plot_style.file_name(picture["field"]) + suffix)


def orient(axes, directions, width, bottom):
    """Below the picture of a body in space: where x, y and z point to, and a bar of a round length."""
    place = axes.get_xlim()[0] + 0.06 * width, bottom - 0.08 * width
    for name, (across, up) in zip("xyz", directions):
        length = 0.07 * width
        axes.annotate(name, place, (place[0] + length * across, place[1] + length * up), fontsize=8, ha="center", va="center",
                      arrowprops={"arrowstyle": "<-", "linewidth": 0.7, "shrinkA": 3, "shrinkB": 0}, annotation_clip=False)
    value = 10.0**math.floor(math.log10(0.3 * width))
    value *= max(step for step in (1, 2, 5) if step * value <= 0.3 * width)
    factor, unit = plot_style.readable(value, "m", "length")
    start = axes.get_xlim()[0] + 0.2 * width
    axes.plot([start, start + value], [place[1], place[1]], "-", color="#000000", linewidth=1.5, clip_on=False)
    axes.annotate(f"{factor * value:g} {unit}", (start + value / 2, place[1]), xytext=(0, 3), textcoords="offset points",
                  ha="center", va="bottom", fontsize=8, annotation_clip=False)
    axes.set_ylim(bottom - BELOW * width, axes.get_ylim()[1])


def label_places(axis, ends, factor):
    """Round numbers of another unit on an axis in metres."""
    ticks = matplotlib.ticker.MaxNLocator(6 if axis.axis_name == "x" else 4).tick_values(factor * ends[0], factor * ends[1])
    ticks = [tick for tick in ticks if factor * ends[0] - 1e-9 <= tick <= factor * ends[1] + 1e-9]
    axis.set_ticks([tick / factor for tick in ticks], [f"{tick:g}" for tick in ticks])


def unit_of(summary, field):
    """The unit the summary gives, else that of the fields every run has."""
    return summary.get("field units", {}).get(field, UNITS.get(field, "1"))


if __name__ == "__main__":
    sys.exit("this is a part of scripts/plot")
