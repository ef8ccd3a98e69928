"""Draws a mesh of `continua --mesh` with the names of its regions and boundaries: of scripts/manual/draw-geometries and scripts/report.

A plane or axisymmetric body is drawn to scale across, and, where it is long, shortened along x; a body in space is seen from a corner.
"""

import re

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy  # noqa: E402
import vtk  # noqa: E402
from matplotlib.collections import LineCollection, PolyCollection  # noqa: E402
from matplotlib.path import Path  # noqa: E402
from mpl_toolkits.mplot3d import proj3d  # noqa: E402
from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # noqa: E402
from vtk.util.numpy_support import vtk_to_numpy  # noqa: E402

WIDTH, DPI = 6.3, 130  # inches: 160 mm
LIQUID, SOLIDS = "#d5e6f5", ["#f3dcc2", "#e3c19a", "#cfe0a8"]
# Colours that can be told apart also by readers who see no red or green (Okabe and Ito).
BOUNDARY_COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#999933"]
LARGEST_RATIO = 5  # of the body's length over its height in a drawing


class Mesh:
    """points [m], cells by type and their regions, faces of the boundary by name."""

    def __init__(self, path):
        reader = vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(path)
        reader.Update()
        grid = reader.GetOutput()
        names = grid.GetFieldData()
        self.regions = self._texts(names.GetAbstractArray("regions"))
        boundaries = self._texts(names.GetAbstractArray("boundaries"))
        self.points = vtk_to_numpy(grid.GetPoints().GetData())
        region = vtk_to_numpy(grid.GetCellData().GetArray("region"))
        boundary = vtk_to_numpy(grid.GetCellData().GetArray("boundary"))
        self.cells, self.cell_regions, self.faces = [], [], {name: [] for name in boundaries}
        for index in range(grid.GetNumberOfCells()):
            ids = grid.GetCell(index).GetPointIds()
            vertices = [ids.GetId(i) for i in range(ids.GetNumberOfIds())]
            if region[index] >= 0:
                self.cells.append(vertices)
                self.cell_regions.append(int(region[index]))
            elif boundary[index] >= 0:
                self.faces[boundaries[boundary[index]]].append(vertices)
        self.faces = {name: faces for name, faces in self.faces.items() if faces}
        self.dim = 3 if len(self.cells[0]) == 8 else 2

    @staticmethod
    def _texts(array):
        return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def liquids_of(text):
    """Region -> whether it is a liquid, from the section Materials of a parameter file's text."""
    found, names = {}, []
    for line in text.splitlines():
        words = line.split("#")[0].split(maxsplit=1)
        if words[:1] == ["subsection"]:
            names.append(words[1].strip())
        elif words[:1] == ["end"]:
            names = names[:-1]
        elif words[:1] == ["set"] and len(names) == 2 and names[0] == "Materials" and re.match(r"Type\s*=", words[1]):
            found[names[1]] = words[1].partition("=")[2].strip().startswith(("newtonian", "carreau"))
    return found


def colours_of(mesh, liquids):
    solids = [region for region in mesh.regions if not liquids.get(region, False)]
    return [LIQUID if liquids.get(region, False) else SOLIDS[solids.index(region) % len(SOLIDS)] for region in mesh.regions]


def longest_run_middle(segments):
    """The middle of a boundary in the plane: of its segments the one nearest to the mean point."""
    middles = segments.mean(axis=1)
    return middles[numpy.argmin(numpy.linalg.norm(middles - middles.mean(axis=0), axis=1))]


def draw_plane(mesh, liquids, axes_names):
    """The figure of a body in the plane."""
    points = mesh.points[:, :2].copy()
    low, high = points.min(axis=0), points.max(axis=0)
    extent = high - low
    ratio = extent[0] / extent[1]
    shortened = max(1, ratio / LARGEST_RATIO)
    points[:, 0] /= shortened
    low, high = points.min(axis=0), points.max(axis=0)
    extent = high - low
    centre = (low + high) / 2
    scale = max(extent[0], extent[1])

    figure = plt.figure(figsize=(WIDTH, WIDTH * min(0.8, extent[1] / extent[0]) * 0.72 + 1.5), dpi=DPI)
    axes = figure.add_axes([0.0, 0.0, 1.0, 1.0])
    colours = colours_of(mesh, liquids)
    axes.add_collection(PolyCollection([points[cell] for cell in mesh.cells], linewidths=0.25, edgecolors="#9a9a9a",
                                       facecolors=[colours[region] for region in mesh.cell_regions]))
    for number, region in enumerate(mesh.regions):
        cells = [cell for cell, of in zip(mesh.cells, mesh.cell_regions) if of == number]
        if not cells:
            continue
        place = roomiest(points, mesh, number)
        thin = numpy.ptp(numpy.concatenate([points[cell][:, 1] for cell in cells])) < 0.12 * scale
        if thin:
            # The name stands beside the body, at the end of a line.
            up = place[1] >= centre[1]
            target = (place[0] + 0.18 * extent[0], (high[1] + 0.13 * scale) if up else (low[1] - 0.13 * scale))
            axes.annotate(region, place, target, fontsize=9, style="italic", ha="center", va="center",
                          arrowprops=dict(arrowstyle="-", color="#777777", linewidth=0.7))
        else:
            axes.text(*place, region, fontsize=9, style="italic", ha="center", va="center",
                      bbox=dict(facecolor=colours[number], edgecolor="none", pad=1.5))
    n_holes = 0
    for index, (name, faces) in enumerate(mesh.faces.items()):
        colour = BOUNDARY_COLOURS[index % len(BOUNDARY_COLOURS)]
        segments = points[numpy.array(faces)]
        axes.add_collection(LineCollection(segments, colors=colour, linewidths=2.4, capstyle="butt"))
        middle = longest_run_middle(segments)
        outward = outward_of(mesh, faces, points, middle)
        target = middle + 0.075 * scale * outward
        horizontal = "left" if outward[0] > 0.5 else "right" if outward[0] < -0.5 else "center"
        vertical = "bottom" if outward[1] > 0.5 else "top" if outward[1] < -0.5 else "center"
        if is_in_hole(mesh, points, middle, outward, scale):
            # A hole: the names stand above and below the body in turn.
            side = 1 if n_holes % 2 == 0 else -1
            middles = segments.mean(axis=1)
            middle = middles[numpy.argmax(side * middles[:, 1])]
            target = numpy.array([middle[0] - 0.08 * scale, (high[1] if side > 0 else low[1]) + side * 0.08 * scale])
            horizontal, vertical = "center", "bottom" if side > 0 else "top"
            n_holes += 1
        axes.annotate(name, middle, target, color=colour, fontsize=9, ha=horizontal, va=vertical,
                      arrowprops=dict(arrowstyle="-", color=colour, linewidth=0.8))
    # Directions, below on the left.
    corner = numpy.array([low[0] - 0.2 * scale, low[1] - 0.2 * scale])
    for direction, text in ((numpy.array([1, 0]), axes_names[0]), (numpy.array([0, 1]), axes_names[1])):
        axes.annotate("", corner + 0.09 * scale * direction, corner, arrowprops=dict(arrowstyle="->", color="black"))
        axes.text(*(corner + 0.105 * scale * direction), text, fontsize=8, ha="left" if direction[0] else "center",
                  va="center" if direction[0] else "bottom")
    axes.set_xlim(low[0] - 0.28 * scale, high[0] + 0.28 * scale)
    axes.set_ylim(low[1] - 0.26 * scale, high[1] + 0.22 * scale)
    axes.set_aspect("equal")
    axes.set_axis_off()
    if shortened > 1:
        axes.text(0.99, 0.01, f"shortened {shortened:.3g} times along x", transform=axes.transAxes, fontsize=7, ha="right",
                  va="bottom", color="#555555")
    return figure


def is_in_hole(mesh, points, middle, outward, scale):
    """Whether the way out of the body at this place comes back into it."""
    way = middle + numpy.linspace(0.02, 1, 50)[:, None] * scale * outward
    return any(Path(points[cell]).contains_points(way).any() for cell in mesh.cells)


def roomiest(points, mesh, region):
    """The middle of the region's cell that is farthest from boundaries and other regions."""
    middles = numpy.array([points[cell].mean(axis=0) for cell, of in zip(mesh.cells, mesh.cell_regions) if of == region])
    others = [points[cell] for cell, of in zip(mesh.cells, mesh.cell_regions) if of != region]
    limits = numpy.concatenate([points[numpy.unique([i for faces in mesh.faces.values() for face in faces for i in face])], *others])
    distances = numpy.linalg.norm(middles[:, None, :] - limits[None, :, :], axis=2).min(axis=1)
    # Of places with as much room the one nearest to the middle, as in a long pipe.
    good = middles[distances > 0.9 * distances.max()]
    return good[numpy.argmin(numpy.linalg.norm(good - middles.mean(axis=0), axis=1))]


def outward_of(mesh, faces, points, middle):
    """The unit vector out of the body at the face whose middle is given."""
    face = min(faces, key=lambda one: numpy.linalg.norm(points[one].mean(axis=0) - middle))
    cell = next(cell for cell in mesh.cells if set(face) <= set(cell))
    tangent = points[face[1]] - points[face[0]]
    normal = numpy.array([tangent[1], -tangent[0]])
    if normal @ (points[face].mean(axis=0) - points[cell].mean(axis=0)) < 0:
        normal = -normal
    return normal / numpy.linalg.norm(normal)


def draw_space(mesh):
    """The figure of a body in space: the faces of the boundary in their colours. The outside is clear, so that the ends are seen through it."""
    figure = plt.figure(figsize=(WIDTH, 0.62 * WIDTH), dpi=DPI)
    axes = figure.add_axes([0, 0, 1, 1], projection="3d", computed_zorder=True)
    light = numpy.array([0.4, -0.6, 0.7])
    light /= numpy.linalg.norm(light)
    colours = {}
    all_points = mesh.points
    for index, (name, faces) in enumerate(mesh.faces.items()):
        is_outside = name == "outside"
        colour = numpy.array(matplotlib.colors.to_rgb("#aaaaaa" if is_outside else BOUNDARY_COLOURS[index % len(BOUNDARY_COLOURS)]))
        opacity = 0.18 if is_outside else 1
        polygons = [all_points[face] for face in faces]
        normals = [numpy.cross(p[2] - p[0], p[3] - p[1]) for p in polygons]
        shade = [0.55 + 0.45 * abs(n @ light) / max(numpy.linalg.norm(n), 1e-300) for n in normals]
        axes.add_collection3d(Poly3DCollection(polygons, linewidths=0.15, edgecolors="#55555580",
                                               facecolors=[(*numpy.clip(colour * s, 0, 1), opacity) for s in shade]))
        colours[name] = "#555555" if is_outside else BOUNDARY_COLOURS[index % len(BOUNDARY_COLOURS)]
    low, high = all_points.min(axis=0), all_points.max(axis=0)
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])
    axes.set_zlim(low[2], high[2])
    axes.set_box_aspect(high - low, zoom=0.92)
    axes.view_init(elev=30, azim=-62)
    axes.set_axis_off()
    length = 0.12 * (high - low).max()
    for direction, text in zip(numpy.eye(3), "xyz"):
        start = low - numpy.array([0.1, 0.1, 0.24]) * (high - low).max()  # below the names of the ends
        axes.quiver(*start, *(length * direction), color="black", linewidth=0.9, arrow_length_ratio=0.2)
        axes.text(*(start + 1.25 * length * direction), text, fontsize=8)
    for artist in axes.get_children():
        artist.set_clip_on(False)
    name_ends(axes, mesh, colours, (low + high) / 2, (high - low).max())
    name_regions(axes, mesh)
    return figure


def name_regions(axes, mesh):
    """The names of the regions in space, above the body: of the wall at its outside, of others at their first end."""
    project = axes.get_proj()
    for number, region in enumerate(mesh.regions):
        corners = [set(cell) for cell, of in zip(mesh.cells, mesh.cell_regions) if of == number]
        own = {}
        for name, faces in mesh.faces.items():
            own[name] = [face for face in faces if any(set(face) <= cell for cell in corners)]
        own = {name: faces for name, faces in own.items() if faces}
        if not own:
            continue
        middles = numpy.array([mesh.points[face].mean(axis=0) for face in own.get("outside", next(iter(own.values())))])
        seen = numpy.array([proj3d.proj_transform(*middle, project)[:2] for middle in middles])
        if "outside" in own:
            # Of the faces at a third of the length the uppermost.
            along = numpy.argsort(seen[:, 0])[int(0.3 * len(seen)):int(0.4 * len(seen)) + 1]
            point = seen[along[numpy.argmax(seen[along, 1])]]
        else:
            point = seen.mean(axis=0)
        axes.annotate(region, point, xycoords="data", xytext=(14, 40), textcoords="offset points", fontsize=9, style="italic",
                      ha="center", va="center", arrowprops=dict(arrowstyle="-", color="#777777", linewidth=0.7))


def name_ends(axes, mesh, colours, centre, size):
    """The names of boundaries in space, away from the body's centre; those of one end, such as liquid and wall, stand together."""
    ends = []
    for name, faces in mesh.faces.items():
        middles = numpy.array([mesh.points[face].mean(axis=0) for face in faces])
        place = middles.mean(axis=0)
        if name == "outside" or name.startswith("side"):
            # These have no end: the face nearest to their middle.
            place = middles[numpy.argmin(numpy.linalg.norm(middles - place, axis=1))]
        for end in ends:
            if numpy.linalg.norm(end[0] - place) < 0.05 * size:
                end[1].append(name)
                break
        else:
            ends.append((place, [name]))
    project = axes.get_proj()
    middle = numpy.array(proj3d.proj_transform(*centre, project)[:2])
    for place, names in ends:
        point = numpy.array(proj3d.proj_transform(*place, project)[:2])
        away = point - middle
        is_below = names[0] == "outside"
        if is_below or names[0].startswith("side"):
            away = numpy.array([0.15, -1 if is_below else 1])
        away /= max(numpy.linalg.norm(away), 1e-12)
        for i, name in enumerate(names):
            axes.annotate(name, point, xycoords="data", xytext=(34 * away[0], 34 * away[1] - 12 * i), textcoords="offset points",
                          fontsize=9, color=colours[name], ha="left" if away[0] > 0.3 else "right" if away[0] < -0.3 else "center",
                          va="center", arrowprops=dict(arrowstyle="-", color=colours[name], linewidth=0.8) if i == 0 else None)
