"""The picture of the mesh at one time: deformed by the displacement, coloured by a field.

VTK draws the mesh off-screen in a process of its own (render_field.py), since without a display it does not fail but
aborts; then Xvfb lends one. When neither works, Matplotlib draws plane meshes. Matplotlib adds axes and colour bar.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

import matplotlib
import matplotlib.pyplot as plt
import numpy
import plot_style

UNITS = {"velocity": "m/s", "displacement": "m", "pressure": "Pa"}
FLATTEST = 5.0  # a longer and thinner picture is stretched across
ROOM = 1.35  # inches for title, labels and colour bar, whatever the width


def draw(sheet, run, field, time):
    path = os.path.join(run["folder"], "fields.pvd")
    if not os.path.exists(path):
        sheet.notes.append(f"field picture of {run['folder']} (no fields.pvd)")
        return
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
        compose(sheet, run, picture, folder, at)


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


def compose(sheet, run, picture, folder, at):
    unit = unit_of(run["summary"], picture["field"])
    low, high = picture["range"]
    factor, unit = plot_style.readable(max(abs(low), abs(high)), unit)
    left, right, bottom, top = picture["extent"]
    shape = (top - bottom) * picture["stretch"] / (right - left)
    figure, axes = plt.subplots(figsize=(sheet.width, 0.95 * sheet.width * shape + ROOM), constrained_layout=True)
    colours = matplotlib.colormaps["viridis"]
    scale = plt.Normalize(low * factor, high * factor if high > low else low * factor + 1)
    image = os.path.join(folder, "picture.png")
    if os.path.exists(image):
        axes.imshow(plt.imread(image), extent=picture["extent"], aspect=picture["stretch"], interpolation="antialiased")
    else:
        data = numpy.load(os.path.join(folder, "picture.npz"))
        axes.tripcolor(data["x"], data["y"], data["triangles"], factor * data["values"], cmap=colours, norm=scale,
                       shading="gouraud", rasterized=True)
        axes.add_collection(matplotlib.collections.LineCollection(data["edges"], colors="black", linewidths=0.25))
        axes.set_aspect(picture["stretch"])
    if picture["plane"]:
        axes.set_xlabel("x [m]")
        axes.set_ylabel("y [m]")
    else:
        axes.set_axis_off()
    remarks = [f"t = {at:.6g} s"]
    if picture["deformation"] not in (0, 1):
        remarks.append(f"displacement × {picture['deformation']:g}")
    if picture["stretch"] != 1:
        remarks.append(f"y drawn × {picture['stretch']:g}")
    axes.set_title(", ".join(remarks), fontsize=8.5, loc="left")
    bar = figure.colorbar(plt.cm.ScalarMappable(scale, colours), ax=axes, location="bottom", shrink=0.6, aspect=40,
                          pad=0.04)
    bar.set_label(plot_style.axis_label(picture["label"], unit))
    bar.outline.set_linewidth(0.4)
    sheet.save(figure, "field-" + plot_style.file_name(picture["field"]))


def unit_of(summary, field):
    """The unit the summary gives, else that of the fields every run has."""
    return summary.get("field units", {}).get(field, UNITS.get(field, "1"))


if __name__ == "__main__":
    sys.exit("this is a part of scripts/plot")
