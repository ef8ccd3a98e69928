"""Arrows or streamlines of the velocity over the picture of a plane body or of a section."""

import os

import numpy

SPACING = 1.1  # of the longest arrow, in its room
LINES = 1.2  # density of streamlines, as Matplotlib counts it, along the longer side


def draw(axes, kind, picture, folder, artists):
    """`kind`: "vectors" or "streamlines", of the first state; what is drawn is added to `artists`."""
    data = numpy.load(os.path.join(folder, "velocity-0.npz"))
    x, y = data["x"], data["y"]
    # In the picture, which may be stretched, an arrow points as the flow does.
    u, v = data["velocity"][..., 0], picture["stretch"] * data["velocity"][..., 1]
    largest = numpy.nanmax(numpy.hypot(u, v)) if numpy.isfinite(u).any() else 0.0
    if not largest > 0:
        return
    limits = axes.get_xlim(), axes.get_ylim()
    if kind == "streamlines":
        before = set(axes.patches)
        shape = len(y) / len(x)
        density = (LINES, max(0.4, LINES * shape)) if shape <= 1 else (max(0.4, LINES / shape), LINES)
        lines = axes.streamplot(x, y, u, v / picture["stretch"], color="#000000", linewidth=0.6, arrowsize=0.6, density=density)
        artists += [lines.lines, *(patch for patch in axes.patches if patch not in before)]
    else:
        artists.append(axes.quiver(x, y, u, v, color="#000000", width=0.0018, angles="uv", pivot="mid", units="width",
                                   scale=SPACING * max(len(x), 20) * largest))
    axes.set_xlim(*limits[0])
    axes.set_ylim(*limits[1])
