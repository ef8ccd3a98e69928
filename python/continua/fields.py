"""The fields over the body: fields.pvd, and the .vtu and .pvtu files that it lists."""

import functools
import os
import re
import xml.etree.ElementTree
from collections.abc import Sequence

import numpy
import xarray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

from .errors import ResultsError

_DAMAGED = "The file is damaged or was copied in part: copy it again, or repeat the run"


class Fields(Sequence):
    """The states that a run wrote, in their order; fields[0] is the first and fields[-1] the last State.

    times   [s], shape (states,); of a modal analysis the number of each mode
    """

    def __init__(self, path):
        self.path = str(path)
        try:
            tree = xml.etree.ElementTree.parse(path)
        except (OSError, xml.etree.ElementTree.ParseError) as error:
            raise ResultsError(path, f"cannot be read: {error}", _DAMAGED) from error
        files = {}
        try:
            for element in tree.iter("DataSet"):
                files.setdefault(float(element.attrib["timestep"]), []).append(os.path.join(os.path.dirname(self.path), element.attrib["file"]))
        except (KeyError, ValueError) as error:
            raise ResultsError(path, f"has a state without a time or a file: {error}", _DAMAGED) from error
        self.times = numpy.array(sorted(files))
        self._files = [files[time] for time in self.times]

    def __len__(self):
        return len(self.times)

    def __getitem__(self, index):
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        return State(float(self.times[index]), self._files[index])

    def at(self, time):
        """The State of a time [s]. Raises ResultsError if there is none: `nearest` takes another one."""
        if not len(self) or not numpy.isclose(self.nearest(time).time, time, rtol=1e-9, atol=1e-15):
            there = f"the nearest of the {len(self)} states is at {self.nearest(time).time:g} s" if len(self) else "there is no state"
            raise ResultsError(self.path, f"there is no state at {time:g} s; {there}",
                               "Use nearest() for it, or run again with another Output/Field interval")
        return self.nearest(time)

    def nearest(self, time):
        """The State whose time is nearest to a time [s]."""
        if not len(self):
            raise ResultsError(self.path, "there is no state")
        return self[int(numpy.argmin(abs(self.times - time)))]

    def __repr__(self):
        of = f", {self.times[0]:g} s to {self.times[-1]:g} s" if len(self) else ""
        return f"Fields of {self.path}: {len(self)} states{of}"


class State:
    """The fields at one time. They are read when `grid` or `dataset` is first asked for, and kept as long as this object.

    time    [s]; of a modal analysis the number of the mode
    files   the paths of its .vtu files, one for each rank or group of ranks
    """

    def __init__(self, time, files):
        self.time = time
        self.files = [piece for file in files for piece in _pieces(file)]

    def __repr__(self):
        return f"State at {self.time:g} s in {', '.join(self.files)}"

    @functools.cached_property
    def grid(self):
        """A vtkUnstructuredGrid of the whole body, undeformed. Raises ResultsError for a file that is not there or cut short."""
        append = vtkAppendFilter()
        for file in self.files:
            piece = _read(file)
            if piece.GetPoints() is None:
                raise ResultsError(file, "the file has no points", _DAMAGED)
            append.AddInputData(piece)
        append.Update()
        grid = vtkUnstructuredGrid()
        grid.ShallowCopy(append.GetOutput())
        return grid

    @functools.cached_property
    def dataset(self):
        """An xarray.Dataset.

        Each field is a variable of shape (points,) or, for a vector, (points, 3), with its unit in `attrs["units"]`. The coordinates `x`, `y`
        and `z` of the points have the shape (points,) and are in m, before the deformation. `cells` of shape (cells, corners) has the numbers
        of the points of each cell in VTK's order; where cells have fewer corners than others the rest is -1. A cell of the mesh may be several
        cells here. Cells of the mesh share no points, so that a field may jump between them. `attrs["time"]` is the time.
        """
        grid, units = self.grid, {}
        for file in self.files:
            units.update(_units(file))
        data = grid.GetPointData()
        variables = {}
        for i in range(data.GetNumberOfArrays()):
            name = data.GetArrayName(i)
            if data.GetArray(i) is None or not name:
                raise ResultsError(", ".join(self.files), f"the field '{name}' has no numbers or no name", _DAMAGED)
            values = vtk_to_numpy(data.GetArray(i))
            variables[name] = (("point", "component")[:values.ndim], values, {"units": units.get(name, "1")})
        points = vtk_to_numpy(grid.GetPoints().GetData())
        places = {name: ("point", points[:, i], {"units": "m"}) for i, name in enumerate("xyz")}
        variables["cells"] = (("cell", "corner"), _corners(grid))
        return xarray.Dataset(variables, {**places, "component": ["x", "y", "z"]}, {"time": self.time})


def _pieces(file):
    """The .vtu files of an entry of the list, which may itself be a list."""
    if not file.endswith(".pvtu"):
        return [file]
    try:
        tree = xml.etree.ElementTree.parse(file)
    except (OSError, xml.etree.ElementTree.ParseError) as error:
        raise ResultsError(file, f"cannot be read: {error}", _DAMAGED) from error
    pieces = [piece.get("Source") for piece in tree.iter("Piece")]
    if not pieces or not all(pieces):
        raise ResultsError(file, "lists no files, or one without a name", _DAMAGED)
    return [os.path.join(os.path.dirname(file), piece) for piece in pieces]


def _read(file):
    if not os.path.exists(file):
        raise ResultsError(file, "the file is missing, and fields.pvd lists it", "Copy the whole folder 'fields', or repeat the run")
    # VTK prints its errors and goes on; what it prints shows that there was one.
    usual, verbosity, printed = vtkOutputWindow.GetInstance(), vtkLogger.GetCurrentVerbosityCutoff(), vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(printed)
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    try:
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(file)
        reader.Update()
    finally:
        vtkLogger.SetStderrVerbosity(verbosity)
        vtkOutputWindow.SetInstance(usual)
    if printed.GetOutput().strip():
        said = re.search(r"(?:Error parsing XML|Cannot read|Zlib error|Error reading)[^\n]*", printed.GetOutput())
        raise ResultsError(file, "VTK cannot read it" + (f": {said.group().rstrip('. ')}" if said else ""), _DAMAGED)
    return reader.GetOutput()


def _units(file):
    """{field: unit} as the file itself has it; VTK drops it."""
    units = {}
    with open(file, "rb") as stream:
        for attributes in re.findall(rb"<DataArray\s([^>]*)>", stream.read()):
            found = dict(re.findall(r'(\w+)="([^"]*)"', attributes.decode("utf-8", "replace")))
            if "units" in found and "Name" in found:
                units[found["Name"]] = found["units"]
    return units


def _corners(grid):
    cells = grid.GetCells()
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    connectivity = vtk_to_numpy(cells.GetConnectivityArray())
    counts = numpy.diff(offsets)
    corners = numpy.full((len(counts), counts.max(initial=0)), -1, dtype=numpy.int64)
    corners[numpy.arange(corners.shape[1]) < counts[:, None]] = connectivity
    return corners
