"""How the figures look and where they go."""

import argparse
import csv
import math
import os
import re
import textwrap

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import matplotlib.ticker  # noqa: E402
import plot_choice  # noqa: E402

# Okabe and Ito's palette, which colour-blind readers can tell apart.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]
LINES = ["-", "--", ":", "-."]
# Up to eight runs in one picture: a dash of its own each, since colours look alike in grey, and a marker.
COLOURS_OF_RUNS = [*COLOURS[:6], "#7F7F7F", "#000000"]
DASHES = ["-", (0, (5, 1.5)), (0, (1, 1.2)), (0, (6, 1.5, 1, 1.5)), (0, (9, 2.5)), (0, (3, 1.2, 1, 1.2, 1, 1.2)), (0, (2.5, 2.5)),
          (0, (8, 1.5, 3, 1.5))]
MARKERS = ["", "s", "^", "D", "v", "x", "+", "*"]

plt.rcParams.update({
    "font.family": "sans-serif",
    "font.size": 8.5,
    "axes.linewidth": 0.6,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.prop_cycle": plt.cycler(color=COLOURS),
    "axes.formatter.useoffset": False,
    "lines.linewidth": 1.1,
    "legend.frameon": False,
    "legend.fontsize": 8,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.direction": "out",
    "ytick.direction": "out",
    "svg.hashsalt": "continua",
    "svg.fonttype": "none",
    "pdf.fonttype": 42,
    "savefig.dpi": 200,
})

# Measured data, and what is drawn beside the runs of Continua: not a colour of a run.
MEASURED = "#B00020"

# Units that take a prefix on an axis.
SCALABLE = {"m", "s", "Pa", "W", "N", "J", "m/s", "Hz", "W/m", "N/m", "J/m", "N/m^3"}
PREFIXES = {-12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}


# Units of --units: the SI unit and how many of it one is.
UNITS = {"mmHg": ("Pa", 133.322387415), "cmH2O": ("Pa", 98.0665), "bar": ("Pa", 1e5), "mbar": ("Pa", 100.0),
         "dyn/cm^2": ("Pa", 0.1), "ml/s": ("m^3/s", 1e-6), "l/min": ("m^3/s", 1e-3 / 60), "l/s": ("m^3/s", 1e-3),
         "cm^3/s": ("m^3/s", 1e-6), "ml": ("m^3", 1e-6), "l": ("m^3", 1e-3), "cm": ("m", 1e-2), "cm/s": ("m/s", 1e-2),
         "min": ("s", 60.0), "%": ("1", 1e-2)}
# Of a flow rate and a volume, from small to large: what their size is best read in.
VOLUMES = ((1e-9, "µl"), (1e-6, "ml"), (1e-3, "l"), (1.0, "m^3"))
chosen_units = {}  # --units: name of a field, or a word of it -> unit
used_units = set()  # names of these that a field was drawn with


class PlotError(Exception):
    """Something that is there cannot be read, or a picture cannot be written."""


class UnitError(PlotError):
    """--units asks for what a field cannot be in."""


def cannot_write(path, error):
    """The PlotError for an OSError."""
    return PlotError(f"cannot write {path}: {error.strerror or error}. --output DIR writes into another folder")


def unit_in_si(unit):
    """(SI unit, how many of it), or None for a unit that is not known."""
    if unit in UNITS:
        return UNITS[unit]
    for base in SCALABLE | {"m^3/s", "m^3", "1"}:
        for exponent, prefix in PREFIXES.items():
            if unit == prefix + base or unit == prefix.replace("µ", "u") + base:
                return (base, 10.0**exponent) if base in SCALABLE or not prefix else None
    return None


def read_units(text):
    """What --units takes: pressure=mmHg,flow=ml/s."""
    chosen = {}
    for part in text.split(","):
        name, equals, unit = (piece.strip() for piece in part.partition("="))
        if not equals or not name:
            raise argparse.ArgumentTypeError(f"'{part}' is not FIELD=UNIT, such as pressure=mmHg")
        if unit_in_si(unit) is None:
            raise argparse.ArgumentTypeError(f"there is no unit '{unit}'; some are kPa, mm, ms, {', '.join(UNITS)}")
        chosen[name.lower()] = unit
    return chosen


def read_times(text):
    """What --times takes: 0.2 s,5 ms; in s. A number alone is in s, or the number of a mode."""
    times = []
    for part in text.split(","):
        match = re.fullmatch(r"\s*([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s*(\S*)\s*", part)
        unit = unit_in_si(match.group(2) or "s") if match else None
        try:
            number = float(match.group(1)) if match else math.nan
        except ValueError:
            unit = None
        if unit is None or unit[0] != "s":
            raise argparse.ArgumentTypeError(f"'{part.strip()}' is not a time such as 0.2 s or 5 ms")
        times.append(number * unit[1])
    return times


def chosen_unit(field, unit):
    """(factor, unit) that --units wants for a field, or None."""
    words = field.lower().replace("_", " ").split()
    for name, wanted in chosen_units.items():
        if name != " ".join(words) and not set(name.split()) <= set(words):
            continue
        used_units.add(name)
        si, size = unit_in_si(wanted)
        if si != unit:
            raise UnitError(f"--units {name}={wanted}: '{field}' is in {unit}, and {wanted} is a unit of another kind")
        return 1 / size, wanted
    return None


def readable(largest, unit, field=""):
    """(factor, unit) that make the largest magnitude a number between 0.5 and 500 or so, or those that --units wants for
    the field."""
    wanted = chosen_unit(field, unit) if field else None
    if wanted is not None:
        return wanted
    if not largest > 0 or not math.isfinite(largest):
        return 1.0, unit
    if unit in ("m^3", "m^3/s"):
        size, name = max([entry for entry in VOLUMES if largest >= 0.5 * entry[0]], default=VOLUMES[0])
        return 1 / size, name + unit[3:]
    if unit not in SCALABLE:
        return 1.0, unit
    exponent = 3 * math.floor((math.log10(largest) + 0.3) / 3)
    exponent = min(max(exponent, -12), 9)
    return 10.0**-exponent, PREFIXES[exponent] + unit


def readable_logarithm(axes):
    """Marks of a logarithmic axis that has less than two decades: plain numbers, some of them, in place of 2.4 x 10^-2."""
    for axis in (axes.xaxis, axes.yaxis):
        low, high = sorted(axis.get_view_interval())
        if axis.get_scale() == "log" and 0 < low and high < 30 * low:
            axis.set_major_locator(matplotlib.ticker.MaxNLocator(5, steps=[1, 2, 2.5, 5, 10]) if high < 8 * low
                                   else matplotlib.ticker.LogLocator(subs=(1, 2, 5)))
            axis.set_major_formatter(matplotlib.ticker.FuncFormatter(lambda value, _: f"{value:g}"))
            axis.set_minor_locator(matplotlib.ticker.NullLocator())


def whole_decades(axes):
    """Logarithmic axes from one power of ten to another, labelled at these alone."""
    axes.set_xscale("log")
    axes.set_yscale("log")
    for axis, data in ((axes.xaxis, "get_xdata"), (axes.yaxis, "get_ydata")):
        values = [value for line in axes.lines for value in getattr(line, data)() if value > 0]
        if values:
            low, high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
            axis.set_view_interval(10.0**low, 10.0**max(high, low + 1), ignore=True)
        axis.set_minor_formatter(plt.NullFormatter())


def axis_label(name, unit):
    name = name[:1].upper() + name[1:]
    # Powers as the reader knows them, "m^3/s" as m³/s.
    unit = re.sub(r"\^(-?\d+)", lambda match: match.group(1).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")),
                  unit)
    return name if unit in ("", "1") else f"{name} [{unit}]"


def file_name(text):
    return re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-")


def width_in_inches(text):
    """What --width takes."""
    match = re.fullmatch(r"\s*([\d.]+)\s*(mm|cm|in)\s*", text)
    if not match or float(match.group(1)) <= 0:
        raise argparse.ArgumentTypeError(f"'{text}' is not a width such as 85mm, 8.5cm or 3.3in")
    return float(match.group(1)) / {"mm": 25.4, "cm": 2.54, "in": 1.0}[match.group(2)]


def of_run(i, n_points=0):
    """How the curve of the i-th of several runs looks; with markers at about sixteen of its points, which differ from run to run."""
    look = {"color": COLOURS_OF_RUNS[i % 8], "linestyle": DASHES[i % 8]}
    if MARKERS[i % 8] and n_points:
        every = max(1, n_points // 16)
        look.update(marker=MARKERS[i % 8], markersize=3.5, markeredgewidth=0.8, markevery=(every * (i % 8) // 8, every))
    return look


def legend_above(figure, handles, width):
    """The legend of a figure with several panels, above them in room added for it. The letters' width limits the columns."""
    letter, line, row = 0.066, 0.6, 0.18  # inches
    labels = [textwrap.fill(handle.get_label(), int((width - 1) / letter)) for handle in handles]
    longest = max(len(part) for label in labels for part in label.splitlines())
    columns = max(1, min(4, len(labels), int((width - 0.3) / (letter * longest + line))))
    room = row * math.ceil(sum(label.count("\n") + 1 for label in labels) / columns) + 0.08
    height = figure.get_size_inches()[1]
    figure.set_size_inches(width, height + room)
    figure.get_layout_engine().set(rect=(0, 0, 1, height / (height + room)))
    figure.legend(handles, labels, loc="upper left", ncol=columns, borderaxespad=0.2, handlelength=2.8)


class Sheet:
    """Where figures go: the folder, which is made, the width and the formats; which fields, regions and times; remembers what was
    written and what left out. Raises PlotError if something cannot be written."""

    def __init__(self, folder, width, pdf, choice=None):
        try:
            os.makedirs(folder, exist_ok=True)
        except OSError as error:
            raise cannot_write(folder, error) from error
        self.choice = choice or plot_choice.Choice()
        self.folder = folder
        self.width = width
        self.formats = ["png", "svg"] + (["pdf"] if pdf else [])
        self.written = []
        self.notes = []

    def figure(self, height_ratio=0.55, **arguments):
        return plt.subplots(figsize=(self.width, self.width * height_ratio), constrained_layout=True, **arguments)

    def legend(self, axes, n_entries, handles=None):
        """None for one curve alone; above the axes otherwise, in room added for it, so that it hides nothing. Of the
        axes' labelled curves, or of the handles."""
        if n_entries < 2:
            return
        handles = handles or axes.get_legend_handles_labels()[0]
        labels = [handle.get_label() for handle in handles]
        letter, line, row = 0.066, 0.55, 0.17  # inches
        labels = [textwrap.fill(label, int((self.width - 1.2) / letter)) for label in labels]
        longest = max(len(part) for label in labels for part in label.splitlines())
        columns = min(len(labels), max(1, int((self.width - 0.6) / (letter * longest + line))), 4)
        rows = math.ceil(sum(label.count("\n") + 1 for label in labels) / columns)
        figure = axes.get_figure()
        figure.set_size_inches(self.width, figure.get_size_inches()[1] + row * rows)
        axes.legend(handles, labels, loc="lower left", bbox_to_anchor=(0, 1.0), ncol=columns, borderaxespad=0.3,
                    handlelength=2.8)

    def check_frame(self, figure, name):
        """For the tests, which look at the frames of a movie."""

    def save(self, figure, name):
        # Without dates, so that the same data make the same file.
        metadata = {"png": {"Software": None}, "svg": {"Date": None}, "pdf": {"CreationDate": None}}
        for kind in self.formats:
            path = os.path.join(self.folder, f"{name}.{kind}")
            try:
                figure.savefig(path, metadata=metadata[kind])
            except OSError as error:
                raise cannot_write(path, error) from error
            self.written.append(path)
        plt.close(figure)

    def save_data(self, name, header, columns):
        """Columns of different length are filled up with empty cells."""
        path = os.path.join(self.folder, f"{name}.csv")
        try:
            with open(path, "w", encoding="utf-8", newline="") as stream:
                writer = csv.writer(stream, lineterminator="\n")
                writer.writerow(header)
                for i in range(max((len(column) for column in columns), default=0)):
                    writer.writerow([repr(float(column[i])) if i < len(column) else "" for column in columns])
        except OSError as error:
            raise cannot_write(path, error) from error
        self.written.append(path)
