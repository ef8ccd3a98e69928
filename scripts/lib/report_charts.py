"""What scripts/plot draws, kept for the page: each picture, and the curves in it as numbers that the browser draws (report/report.js)."""

import base64
import io
import os
import zlib

import continua.tables
import manual_picture
import numpy
import plot_style
from PIL import Image

MOST_POINTS = (6000, 2000, 700, 200)  # of a curve in the page: as many as there is room for
MOST_COLOURS = 128  # of a picture
# Curves that hide each other in one chart, or whose picture says more. (The picture of an envelope repeats the history.)
PICTURES_ALONE = ("space-time", "field", "wall")
WITHOUT = ("envelope",)
# One chart for each quantity of these.
BY_QUANTITY = ("dispersion", "loaded-tube", "spin-coating", "load-", "modulus", "wall")


class Album(plot_style.Sheet):
    """A sheet whose pictures and data are kept."""

    def __init__(self, folder, width, choice):
        super().__init__(folder, width, False, choice)
        self.formats = []
        self.pictures, self.data, self.scales = {}, {}, {}

    def save(self, figure, name):
        axes = [one for one in figure.axes if one.lines] or figure.axes
        self.scales[name] = [bool(axes) and axes[0].get_xscale() == "log", bool(axes) and axes[0].get_yscale() == "log"]
        self.pictures[name] = png_of(figure)

    def save_data(self, name, header, columns):
        self.data[name] = header, [numpy.asarray(column, float) for column in columns]


def png_of(figure):
    """The figure as a PNG, which is closed."""
    stream = io.BytesIO()
    figure.savefig(stream, format="png", dpi=130, bbox_inches="tight", pad_inches=0.06, metadata={"Software": None})
    plot_style.plt.close(figure)
    return fewer_colours(stream.getvalue())


def fewer_colours(data):
    stream = io.BytesIO()
    with Image.open(io.BytesIO(data)) as image:
        manual_picture.fewer_colours(image.convert("RGB"), MOST_COLOURS).save(stream, format="png", optimize=True)
    return stream.getvalue()


def packed(values, kind):
    """Numbers of 8 bytes (d) or 4 (f) in zlib's format and base64."""
    data = numpy.asarray(values, "<f8" if kind == "d" else "<f4").tobytes()
    return kind + base64.b64encode(zlib.compress(data, 9)).decode("ascii")


def parts_of(header):
    """[(label, quantity, unit)] of "LABEL: QUANTITY [UNIT]"."""
    found = []
    for text in header:
        name, unit = continua.tables.split_unit(text)
        label, _, quantity = name.rpartition(": ")
        found.append((label, quantity, unit))
    return found


def charts_of(name, header, columns, scales, most):
    """The charts of one picture: one for each unit, or for each quantity."""
    if name.startswith((*PICTURES_ALONE, *WITHOUT)) or not columns or not header:
        return []
    parts = parts_of(header)
    first = parts[0][1].split()[0]
    groups, x = {}, None
    for i, (label, quantity, unit) in enumerate(parts):
        if quantity.split()[:1] == [first]:
            x = i
            continue
        if not numpy.isfinite(columns[i]).any():
            continue
        kind = quantity if name.startswith(BY_QUANTITY) else "difference" if " - " in quantity else ""
        groups.setdefault((unit, kind), []).append((x, i, label, quantity))
    return [chart(name, kind, unit, lines, parts, columns, scales, most) for (unit, kind), lines in groups.items()]


def chart(name, kind, unit, lines, parts, columns, scales, most):
    quantities = list(dict.fromkeys(quantity for _, _, _, quantity in lines))
    largest = max(numpy.nanmax(numpy.abs(columns[i])) for _, i, _, _ in lines)
    field = quantities[0].partition(",")[0]
    factor, shown = plot_style.readable(largest, unit, field)
    x_name, x_unit = parts[lines[0][0]][1:]
    ends = [numpy.nanmax(numpy.abs(columns[x])) for x, _, _, _ in lines if len(columns[x])]
    x_factor, x_shown = plot_style.readable(max(ends, default=1), x_unit, x_name)
    common = quantities[0] if len(quantities) == 1 else ""
    result = {"name": name + ("-" + plot_style.file_name(kind) if kind else ""), "x": plot_style.axis_label(x_name, x_shown),
              "y": plot_style.axis_label(kind or common or title_of(name), shown), "log": scales, "columns": [], "groups": [], "lines": []}
    by_label, kept = name.startswith(("wave-", "last-beat")), {}
    labels = list(dict.fromkeys(label.partition(", beat ")[0] for _, _, label, _ in lines))
    last = max((label.partition(", beat ")[2] for _, _, label, _ in lines), key=lambda text: (len(text), text), default="")
    for x, i, label, quantity in lines:
        step = max(1, -(-len(columns[i]) // most))
        places = columns[x][:len(columns[i]):step] * x_factor
        key = places.tobytes()
        if key not in kept:
            kept[key] = len(result["groups"])
            result["columns"].append(packed(places, "d"))
            result["groups"].append({"x": len(result["columns"]) - 1, "ys": [], "of": []})
        group = result["groups"][kept[key]]
        result["columns"].append(packed(columns[i][::step] * factor, "f"))
        group["ys"].append(len(result["columns"]) - 1)
        text = ", ".join(filter(None, [label, "" if quantity == common else quantity.partition(", ")[2] if common == "" and name.startswith("wave-")
                                       else quantity])) or quantity
        # The curves of one station have one colour.
        number = labels.index(label.partition(", beat ")[0]) if by_label else sum(len(one["ys"]) for one in result["groups"]) - 1
        measured = quantity.endswith(", measured")
        is_thin = quantity.endswith((", theory", ", nonlinear theory")) or name.startswith("last-beat") and label.partition(", beat ")[2] != last
        group["of"].append({"label": text, "colour": plot_style.COLOURS_OF_RUNS[number % 8],
                            "dash": [3, 4] if is_thin else [[], [8, 3], [2, 3], [8, 3, 2, 3]][number // 8 % 4], "points": measured})
    result["lines"] = [line for group in result["groups"] for line in group.pop("of")]
    return result


def title_of(name):
    """What a picture is called."""
    kind, _, rest = name.partition("-")
    rest = rest.replace("-", " ")
    text = {"history": rest, "wave": f"waves of {rest}", "field": f"state: {rest}", "power": "power", "wall": rest}.get(kind, name.replace("-", " "))
    return text[:1].upper() + text[1:]


def assets():
    """(script, style) of the library that draws charts, or None: scripts/build/report-assets brings it."""
    here = os.path.dirname(os.path.abspath(__file__))
    build = os.environ.get("CONTINUA_BUILD_ROOT", os.path.join(here, "..", "..", "build"))
    for folder in (os.environ.get("CONTINUA_REPORT_ASSETS"), os.path.join(build, "report-assets"), os.path.join(here, "report", "assets")):
        if folder and os.path.exists(os.path.join(folder, "uPlot.iife.min.js")):
            texts = []
            for name in ("LICENSE", "uPlot.iife.min.js", "uPlot.min.css"):
                with open(os.path.join(folder, name), encoding="utf-8") as stream:
                    texts.append(stream.read())
            return f"/* {texts[0].replace('*/', '')} */\n{texts[1]}", texts[2]
    return None
