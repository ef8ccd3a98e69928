"""Shows the fields of the run in this folder. For ParaView 5.10 or later.

    paraview --script=OUTPUT_DIR/view-in-paraview.py
    pvpython --force-offscreen-rendering OUTPUT_DIR/view-in-paraview.py PICTURE.png   (without a display: xvfb-run -a pvpython ...)

Solids are deformed by their displacement times a factor, which the picture shows. Liquids stay where they were: their
displacement is the way of their particles. In finite deformation their mesh moves, and they are deformed like solids. Each colour range is that of up to MOST_STATES states of the whole run. A field of
both signs has white at zero. The second command writes the last state as a picture. Change the three lines below as you like.
"""

FIELD = None  # that gives the colours, such as "velocity"; None: the pressure, or of a body that is all solid the displacement
FACTOR = None  # of the displacement; None: a round number that makes it visible, or 1 in finite deformation
MOST_STATES = 20  # that the ranges and the factor are taken from

import json
import math
import os
import sys

import paraview.simple as pv

# ParaView's window does not say where the script is; then it is where the run wrote it.
FOLDER = os.path.dirname(os.path.abspath(globals().get("__file__") or "@FILE@"))


def states_of(times):
    """At most MOST_STATES of the times, the last one among them."""
    n_states = min(len(times), MOST_STATES)
    return sorted({times[-1 - round(i * (len(times) - 1) / max(n_states - 1, 1))] for i in range(n_states)})


def range_of(source, times, field, component=-1):
    """The smallest and the largest value over the times; of a vector its magnitude or the component."""
    ranges = []
    for time in times:
        source.UpdatePipeline(time)
        array = source.PointData[field]
        ranges.append(array.GetRange(component if array.GetNumberOfComponents() > 1 else 0))
    return min(low for low, _ in ranges), max(high for _, high in ranges)


def nice(number):
    """The largest of 1, 2, 5, 10, ... that is not above the number."""
    power = 10.0**math.floor(math.log10(number))
    return max(step * power for step in (1, 2, 5) if step * power <= number * (1 + 1e-9))


def factor_of(solids, times, bounds):
    """A tenth of the body's length, but not more than 0.4 of its width along it: a thin body must not fold over itself. In finite
    deformation 1."""
    if is_finite():
        return 1.0
    size = [bounds[2 * d + 1] - bounds[2 * d] for d in range(3)]
    ranges = [range_of(solids, times, "displacement", d) for d in range(3)]
    largest = [max(-low, high) for low, high in ranges]
    if not max(largest) > 0:
        return 1.0
    factor = nice(min(min(0.1 * max(size), 0.4 * size[d]) / largest[d] for d in range(3)
                      if largest[d] > 1e-3 * max(largest) and size[d] > 1e-9 * max(size)))
    return 1.0 if 0.5 <= factor <= 2 else factor


def summary():
    """summary.json, or nothing before the end of the run."""
    try:
        with open(os.path.join(FOLDER, "summary.json"), encoding="utf-8") as stream:
            return json.load(stream)
    except (OSError, ValueError):
        return {}


def is_finite():
    return summary().get("deformation") == "finite"


def unit_of(field):
    return summary().get("field units", {}).get(field, "")


def annotate(fields, further):
    """A note of each state: its time, or of a modal analysis, whose states are modes, the mode and its frequency."""
    if summary().get("analysis") == "modal":
        # "Mode 1: 3.36 Hz, moves along y: ..."
        notes = [mode.split(", ")[0] + further for mode in summary()["modes"]]
        return pv.PythonAnnotation(registrationName="note", Input=fields, Expression=f"{notes}[int(round(time_value)) - 1]")
    return pv.AnnotateTimeFilter(registrationName="note", Input=fields, Format="Time: {time:.6g} s" + further)


def colour(display, view, source, times, field, what, of_both_signs, of_one_sign, place):
    """Colours a part of the body over its own range, with a scalar bar that begins at this part of the width."""
    low, high = range_of(source, times, field)
    largest = max(-low, high)
    is_signed = low < -0.05 * largest and high > 0.05 * largest
    pv.ColorBy(display, ("POINTS", field), separate=True)
    table = pv.GetColorTransferFunction(field, display, separate=True)
    table.ApplyPreset(of_both_signs if is_signed else of_one_sign, True)
    if is_signed:
        low, high = -largest, largest
    table.RescaleTransferFunction(low, high if high > low else low + 1)
    table.AutomaticRescaleRangeMode = "Never"
    bar = pv.GetScalarBar(table, view)
    bar.Title = f"{field}{f' [{unit_of(field)}]' if unit_of(field) not in ('', '1') else ''}, {what}"
    bar.ComponentTitle = "magnitude" if source.PointData[field].GetNumberOfComponents() > 1 else ""
    for part in ("TitleColor", "LabelColor"):
        setattr(bar, part, [0.0, 0.0, 0.0])
    bar.AutomaticLabelFormat = 0
    bar.LabelFormat, bar.RangeLabelFormat = "%g", "%.3g"
    bar.TitleFontSize = bar.LabelFontSize = 14
    bar.Orientation, bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Horizontal", "Any Location", [place, 0.06], 0.33
    bar.Visibility = 1
    display.SetScalarBarVisibility(view, True)


def main():
    fields = pv.PVDReader(registrationName="fields", FileName=os.path.join(FOLDER, "fields.pvd"))
    fields.UpdatePipeline()
    times = fields.TimestepValues
    times = list(times) if hasattr(times, "__len__") else [times]
    chosen = states_of(times)
    bounds = fields.GetDataInformation().GetBounds()
    is_plane = bounds[5] - bounds[4] < 1e-9 * max(bounds[1] - bounds[0], bounds[3] - bounds[2])
    there = fields.PointData.keys()

    view = pv.GetActiveViewOrCreate("RenderView")
    view.Background = [1.0, 1.0, 1.0]
    view.UseColorPaletteForBackground = 0
    view.OrientationAxesLabelColor = [0.0, 0.0, 0.0]
    parts = {}
    for name, method in (("liquids", "Below Lower Threshold"), ("solids", "Above Upper Threshold")):
        part = pv.Threshold(registrationName=name, Input=fields, Scalars=["POINTS", "phase"], LowerThreshold=0.5,
                            UpperThreshold=0.5, ThresholdMethod=method)
        part.UpdatePipeline(times[-1])
        if part.GetDataInformation().GetNumberOfPoints() > 0:
            parts[name] = part
        else:
            pv.Delete(part)

    preferred = ("displacement", "pressure") if list(parts) == ["solids"] else ("pressure", "velocity")
    field = FIELD or next((name for name in preferred if name in there), there[0])
    if field not in there:
        sys.exit(f"error: there is no field {field}; there are {', '.join(there)}")
    factor = 0.0
    moving = list(parts) if is_finite() else [name for name in parts if name == "solids"]
    if moving and "displacement" in there:
        factor = FACTOR if FACTOR is not None else factor_of(parts[moving[-1]], chosen, bounds)
        for name in moving:
            parts[name] = pv.WarpByVector(registrationName=f"{name}, displacement times {factor:g}", Input=parts[name],
                                          Vectors=["POINTS", "displacement"], ScaleFactor=factor)

    if not is_plane and len(parts) == 2:  # cells have points of their own, and one sees through the wall: their faces would show
        parts["solids"] = pv.CleantoGrid(registrationName="solids without inner faces", Input=parts["solids"])

    maps = {"liquids": ("Cool to Warm", "Viridis (matplotlib)", 0.15),
            "solids": ("Cool to Warm (Extended)", "Inferno (matplotlib)", 0.56)}
    for name, part in parts.items():
        display = pv.Show(part, view)
        display.SetRepresentationType("Surface With Edges" if is_plane else "Surface")
        display.EdgeColor = [0.3, 0.3, 0.3]
        display.NonlinearSubdivisionLevel = 2
        if is_plane:
            display.Ambient, display.Diffuse = 1.0, 0.0
        elif name == "solids" and "liquids" in parts:
            display.Opacity = 0.3  # or the liquid inside would not be seen
        colour(display, view, part, chosen, field, name, *maps[name])

    note_display = pv.Show(annotate(fields, f", displacement of the {' and '.join(moving)} times {factor:g}" if factor else ""), view)
    note_display.Color = [0.0, 0.0, 0.0]
    note_display.FontSize = 16

    scene = pv.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.AnimationTime = times[-1]
    view.ViewTime = times[-1]
    if is_plane:
        view.InteractionMode = "2D"
        view.ResetActiveCameraToNegativeZ()
    else:
        view.ApplyIsometricView()
    pv.SetActiveSource(fields)
    pv.Render(view)  # the first time this moves the camera, too
    view.ResetCamera()
    if is_plane:  # the body fills the width, or a half of the height: below it are the scalar bars
        view.CameraParallelScale = max((bounds[1] - bounds[0]) / 2.8, bounds[3] - bounds[2])
    pv.Render(view)
    if len(sys.argv) > 1 and sys.argv[-1].endswith(".png"):
        pv.SaveScreenshot(sys.argv[-1], view, ImageResolution=[1600, 900], FontScaling="Do not scale fonts")


main()
