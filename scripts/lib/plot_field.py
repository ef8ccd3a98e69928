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

import matplotlib
import matplotlib.pyplot as plt
import matplotlib.ticker
import numpy
import plot_arrows
import plot_choice
import plot_style
import plot_wall

UNITS = {"velocity": "m/s", "displacement": "m", "pressure": "Pa"}
FLATTEST = 5.0  # a longer and thinner picture is stretched across
ROOM = 1.35  # inches for title, labels and colour bar, whatever the width
BAR = 0.65  # inches for a second colour bar
BELOW = 0.16  # of the width, for the directions below a body in space
MOST_MODES = 6  # that are drawn without --times


def draw(sheet, run):
    """Of each field and time that is wanted; of a modal analysis of the first modes."""
    path = os.path.join(run["folder"], "fields.pvd")
    if not os.path.exists(path):
        sheet.notes.append(f"field picture of {run['folder']} (no fields.pvd)")
        return
    entries = plot_choice.entries_of(path)
    if not entries:
        sheet.notes.append(f"field picture of {run['folder']} (fields.pvd has no entries)")
        return
    choice = sheet.choice
    there = plot_choice.fields_of_states(run)
    # Without --fields one field, and what belongs to walls, which is not written unless it is asked for.
    fields = choice.fields_of(there) if choice.fields else [None, *(name for name in plot_wall.OF_WALLS if name in there)]
    if not fields:
        sheet.notes.append(f"field picture of {run['folder']} (no state has {', '.join(choice.fields)})")
    modes = run["summary"].get("modes", [])
    is_modal = run["summary"].get("analysis") == "modal" and modes
    for field in fields:
        if is_modal:
            draw_modes(sheet, run, entries, modes, field)
            continue
        for time in choice.times or [None]:
            at, pieces = plot_choice.nearest(entries, time)
            suffix = f"-{at:.6g}-s" if choice.times and len(choice.times) > 1 else ""
            if field in plot_wall.OF_WALLS and plot_wall.draw(sheet, run, pieces, field, caption(run, at, time), suffix):
                continue
            draw_state(sheet, run, pieces, field, caption(run, at, time), suffix)


def caption(run, at, wanted):
    """The time of a state, and the time that was asked for if there is no state of that."""
    if run["summary"].get("analysis") == "steady":
        return "steady state"
    if wanted is None or abs(at - wanted) <= 1e-6 * max(abs(at), abs(wanted)):
        return f"t = {at:.6g} s"
    return f"t = {at:.6g} s (the output nearest to {wanted:.6g} s)"


def draw_modes(sheet, run, entries, modes, field):
    """A shape has no velocity; its "time" is its number."""
    times = sheet.choice.times
    for number in map(round, times) if times else range(1, min(len(modes), MOST_MODES) + 1):
        _, pieces = plot_choice.nearest(entries, number)
        draw_state(sheet, run, pieces, field or "displacement", re.split(r"[,;(]", modes[number - 1])[0].strip(), f"-mode-{number}")
    if not times and len(modes) > MOST_MODES:
        sheet.notes.append(f"pictures of the modes {MOST_MODES + 1} to {len(modes)} (--times 7 draws the seventh)")


def check_pieces(pieces):
    missing = [piece for piece in pieces if not os.path.exists(piece)]
    if missing:
        raise plot_style.PlotError(f"fields.pvd names {missing[0]}, which is not there")


def draw_state(sheet, run, pieces, field, of, suffix=""):
    """The picture of one state; `of`: its time, or what it is."""
    with tempfile.TemporaryDirectory() as folder:
        picture = render(sheet, run, [pieces], field, folder)
        if picture is not None:
            figure, _ = compose(sheet, run, picture, folder, of)
            sheet.save(figure, "field-" + plot_style.file_name(picture["field"]) + suffix)


def render(sheet, run, states, field, folder):
    """What render_field.py says of its pictures in the folder, or None. All states have the same colours, factor and section."""
    for pieces in states:
        check_pieces(pieces)
    request = {"states": states, "field": field, "folder": folder, "flattest": FLATTEST, "pixels": int(sheet.width * 200),
               "regions": plot_choice.numbers_of_regions(sheet.choice, run), "deformation": run["summary"].get("deformation", "small"),
               "section": sheet.choice.section, "mesh": sheet.choice.mesh, "arrows": sheet.choice.arrows}
    if not rendered(request, sheet):
        return None
    with open(os.path.join(folder, "picture.json"), encoding="utf-8") as stream:
        return json.load(stream)


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
                              capture_output=True, text=True, check=False,
                              timeout=300 + 30 * len(request["states"]))
        if done.returncode == 0:
            return True
        said = (done.stderr or done.stdout).strip().splitlines()[-1:] or [f"exit status {done.returncode}"]
        if done.returncode == 4:
            break
        if done.returncode == 3:  # a fault of the data or the request, which another way would not mend
            raise plot_style.PlotError(said[0])
    sheet.notes.append(f"field picture ({said[0]})")
    return False


def compose(sheet, run, picture, folder, of):
    """(the figure of the first state, a function that shows another state: its number, and its time or what it is)."""
    unit = unit_of(run["summary"], picture["field"])
    ranges = picture["ranges"]
    left, right, bottom, top = picture.get("seen", picture["extent"])
    shape = (top - bottom) * picture["stretch"] / (right - left)
    room = ROOM + BAR * (len(ranges) - 1)
    below = 0 if picture["plane"] else BELOW
    figure, axes = plt.subplots(figsize=(sheet.width, 0.95 * sheet.width * (shape + below) + room), constrained_layout=True)
    body = draw_body(axes, picture, folder, 0)
    axes.set_xlim(left, right)
    axes.set_ylim(bottom, top)
    axes.set_aspect(picture["stretch"])
    if picture["plane"]:
        section = picture.get("section")
        names = [name for d, name in enumerate("xyz") if not section or d != section["axis"]]
        # No more marks than there is room for: a long body is low.
        room_up = 0.85 * sheet.width * shape
        for axis, name, ends, most in ((axes.xaxis, names[0], (left, right), 6), (axes.yaxis, names[1], (bottom, top), min(4, int(room_up / 0.18)))):
            place_factor, place_unit = plot_style.readable(max(map(abs, ends)), "m", name)
            label_places(axis, ends, place_factor, most)
            axis.set_label_text(plot_style.axis_label(name, place_unit)[:1].lower() + plot_style.axis_label(name, place_unit)[1:])
        if room_up < 0.5:  # the name of a low axis lies, so that it does not reach beyond the axis
            axes.yaxis.label.set(rotation=0, ha="right", va="center")
        if sheet.choice.arrows:
            plot_arrows.draw(axes, sheet.choice.arrows, picture, folder, body)
    else:
        if sheet.choice.arrows == "vectors":
            raise plot_choice.ChoiceError("--vectors: this is for plane bodies and sections (--section x=20mm); --streamlines is for bodies in space, too")
        axes.set_axis_off()
        orient(axes, picture["axes"], right - left, bottom)
    axes.set_title(title_of(sheet, picture, of), fontsize=8.5, loc="left")
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

    # The body's shape is fixed, and may leave a part of the height empty.
    figure.canvas.draw()
    used = figure.get_tightbbox(figure.canvas.get_renderer())
    figure.set_size_inches(sheet.width, used.height + 0.12)

    def show(i, of):
        for artist in body:
            artist.remove()
        body[:] = draw_body(axes, picture, folder, i)
        axes.set_title(title_of(sheet, picture, of), fontsize=8.5, loc="left")

    return figure, show


def draw_body(axes, picture, folder, i):
    """The i-th state, as VTK or as Matplotlib draws it. Returns the artists."""
    image = os.path.join(folder, f"picture-{i}.png")
    if os.path.exists(image):
        return [axes.imshow(plt.imread(image), extent=picture["extent"], interpolation="antialiased", aspect=picture["stretch"])]
    data = numpy.load(os.path.join(folder, f"picture-{i}.npz"))
    colours = numpy.concatenate([matplotlib.colormaps[name](numpy.linspace(0, 1, 256)) for _, name, _, _ in picture["ranges"]])
    faces = axes.tripcolor(data["x"], data["y"], data["triangles"], data["values"], shading="gouraud", rasterized=True,
                           cmap=matplotlib.colors.ListedColormap(colours), norm=plt.Normalize(0, len(picture["ranges"])))
    lines = axes.add_collection(matplotlib.collections.LineCollection(data["edges"], colors="black", linewidths=0.25))
    axes.set_xlim(*picture["extent"][:2])
    axes.set_ylim(*picture["extent"][2:])
    return [faces, lines]


def title_of(sheet, picture, of):
    remarks = [of]
    if picture.get("section"):
        factor, unit = plot_style.readable(abs(picture["section"]["at"]), "m")
        remarks.append(f"section {'xyz'[picture['section']['axis']]} = {factor * picture['section']['at']:g} {unit}")
    if sheet.choice.regions:
        remarks.append(("regions " if len(sheet.choice.regions) > 1 else "region ") + ", ".join(sheet.choice.regions))
    if picture["deformation"] not in (0, 1):
        remarks.append(f"displacement{' of the solids' if picture['liquid'] else ''} × {picture['deformation']:g}")
    if picture["stretch"] != 1:
        remarks.append(f"y\u00a0drawn\u00a0×\u00a0{picture['stretch']:g}")  # on one line
    return textwrap.fill(", ".join(remarks), int((sheet.width - 0.8) / 0.066))


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


def label_places(axis, ends, factor, most):
    """At most so many round numbers, and at least one, of another unit on an axis in metres."""
    ticks = matplotlib.ticker.MaxNLocator(max(1, most)).tick_values(factor * ends[0], factor * ends[1])
    ticks = [tick for tick in ticks if factor * ends[0] - 1e-9 <= tick <= factor * ends[1] + 1e-9]
    axis.set_ticks([tick / factor for tick in ticks], [f"{tick:g}" for tick in ticks])


def unit_of(summary, field):
    """The unit the summary gives, else that of the fields every run has."""
    return summary.get("field units", {}).get(field, UNITS.get(field, "1"))


if __name__ == "__main__":
    sys.exit("this is a part of scripts/plot")
