"""Reads the states of fields that runs write (fields.pvd, *.pvtu, *.vtu) and compares those of two runs.

A cell is its points and its values at them. In one order: the n-th cells of two files are compared. In any order: cells
are sorted by their centres first, so that files whose cells stand in another order, or in several pieces, are compared
as sets.
"""

import base64
import math
import os
import struct
import xml.etree.ElementTree as ElementTree
import zlib

import driver

FORMATS = {"Float32": "f", "Float64": "d", "Int8": "b", "UInt8": "B", "Int32": "i", "UInt32": "I", "Int64": "q",
           "UInt64": "Q"}
# A state of a run on several ranks or of a run in pieces may say which rank holds a cell.
LEFT_OUT = ("rank",)


def decode(array, header, compressed):
    """The numbers of one DataArray, ascii or binary."""
    text = "".join((array.text or "").split()) if array.get("format") == "binary" else (array.text or "")
    number_format = FORMATS[array.get("type")]
    if array.get("format") == "ascii":
        return [float(word) if number_format in "fd" else int(word) for word in text.split()]
    if array.get("format") != "binary":
        raise driver.TestFailure(f"the format '{array.get('format')}' of a field cannot be read")
    head_size = struct.calcsize("<" + header)
    if not compressed:
        content = base64.b64decode(text)
        data = content[head_size:head_size + struct.unpack_from("<" + header, content)[0]]
    else:
        # The head (number of blocks, size, size of the last, compressed sizes) and the blocks are coded each by itself.
        n_blocks, = struct.unpack_from("<" + header, base64.b64decode(text[:4 * math.ceil(head_size / 3)]))
        length = 4 * math.ceil(head_size * (3 + n_blocks) / 3)
        sizes = struct.unpack_from(f"<{3 + n_blocks}{header}", base64.b64decode(text[:length]))[3:]
        blocks, data, position = base64.b64decode(text[length:]), b"", 0
        for size in sizes:
            data += zlib.decompress(blocks[position:position + size])
            position += size
    return list(struct.unpack(f"<{len(data) // struct.calcsize(number_format)}{number_format}", data))


def tuples(array, header, compressed):
    """The numbers of one DataArray, those of a point together."""
    numbers, width = decode(array, header, compressed), int(array.get("NumberOfComponents", "1"))
    return [tuple(numbers[i:i + width]) for i in range(0, len(numbers), width)]


def read_vtu(path):
    """(names of the fields, whether they are of single precision, cells); a cell is [(point, values)]."""
    try:
        root = ElementTree.parse(path).getroot()
    except ElementTree.ParseError as error:
        raise driver.TestFailure(f"{path} cannot be read: {error}") from error
    header = FORMATS[root.get("header_type", "UInt32")]
    compressed = root.get("compressor") is not None
    names, single, cells = None, False, []
    for piece in root.iter("Piece"):
        if int(piece.get("NumberOfCells")) == 0:
            continue
        points = tuples(piece.find("Points/DataArray"), header, compressed)
        arrays = {array.get("Name"): array for array in piece.findall("PointData/DataArray")}
        of_cells = {array.get("Name"): array for array in piece.findall("CellData/DataArray")}
        fields = {name: tuples(array, header, compressed) for name, array in arrays.items() if name not in LEFT_OUT}
        single = single or any(arrays[name].get("type") == "Float32" for name in fields)
        if any(len(values) != len(points) for values in fields.values()):
            raise driver.TestFailure(f"{path} has another number of values than of points")
        topology = {array.get("Name"): decode(array, header, compressed) for array in piece.findall("Cells/DataArray")}
        if [name for name in of_cells if name not in LEFT_OUT]:
            raise driver.TestFailure(f"{path} has values of cells ({', '.join(of_cells)}), which are not compared")
        if names not in (None, list(fields)):
            raise driver.TestFailure(f"the pieces in {path} have different fields")
        names, start = list(fields), 0
        for end in topology["offsets"]:
            cells.append([(points[node], [fields[name][node] for name in names])
                          for node in topology["connectivity"][start:end]])
            start = end
    return names, single, cells


def read_state(path):
    """As read_vtu, of one state: a file, or all pieces that a .pvtu lists."""
    if not path.endswith(".pvtu"):
        return read_vtu(path)
    pieces = [piece.get("Source") for piece in ElementTree.parse(path).getroot().iter("Piece")]
    states = [read_vtu(os.path.join(os.path.dirname(path), piece)) for piece in pieces]
    with_cells = [state for state in states if state[2]]
    if any(state[0] != with_cells[0][0] for state in with_cells):
        raise driver.TestFailure(f"the pieces of {path} have different fields")
    return with_cells[0][0], with_cells[0][1], [cell for state in states for cell in state[2]]


def sorted_by_place(cells):
    """Cells in the order of their centres. These are rounded to what is far below a cell's size, at odd places, so that
    round-off hardly ever moves one past a limit."""
    corners = [[point[i] for cell in cells for point, _ in cell] for i in range(3)]
    size = max(max(values) - min(values) for values in corners)

    def key(cell):
        centre = [sum(point[i] for point, _ in cell) / len(cell) for i in range(3)]
        return tuple(math.floor(x / (1e-5 * size) + 0.3183) for x in centre)

    return sorted(cells, key=key)


def compare_states(first, second, tolerance=0.0, floor=0.0, any_order=False):
    """Each field of the second within `tolerance` of that field's largest magnitude in the first, or of `floor`."""
    names, single, cells = read_state(first)
    other_names, _, other_cells = read_state(second)
    if names != other_names:
        raise driver.TestFailure(f"{first} has the fields {names}, {second} has {other_names}")
    if len(cells) != len(other_cells) or not cells:
        raise driver.TestFailure(f"{first} has {len(cells)} cells, {second} has {len(other_cells)}")
    if any_order:
        cells, other_cells = sorted_by_place(cells), sorted_by_place(other_cells)
    # Two numbers of double precision that hardly differ may be rounded to neighbours of single precision.
    share = max(tolerance, 2.4e-7 if single else 0.0) if tolerance > 0 else 0.0
    way = share * max(abs(coordinate) for cell in cells for point, _ in cell for coordinate in point)
    largest = [max(abs(x) for cell in cells for _, values in cell for x in values[field])
               for field in range(len(names))]
    for cell, other in zip(cells, other_cells):
        if len(cell) != len(other) or any(not abs(a - b) <= way for (point, _), (other_point, _) in zip(cell, other)
                                      for a, b in zip(point, other_point)):
            raise driver.TestFailure(f"the cell at {cell[0][0]} in {first} is another one, at {other[0][0]}, in "
                                     f"{second}")
        for (point, values), (_, other_values) in zip(cell, other):
            for name, size, value, other_value in zip(names, largest, values, other_values):
                allowed = share * max(size, floor)
                # A number that is not finite differs from everything.
                if not all(abs(a - b) <= allowed for a, b in zip(value, other_value)):
                    raise driver.TestFailure(
                        f"field '{name}' at {point}: {value} in {first}, {other_value} in {second}; the largest "
                        f"magnitude is {size:.6g}, the tolerance {share:g} of it")
    return len(cells)


def states_of(output):
    """[(time, path)] of fields.pvd."""
    path = os.path.join(output, "fields.pvd")
    if not os.path.exists(path):
        return []
    return [(float(state.get("timestep")), os.path.join(output, state.get("file")))
            for state in ElementTree.parse(path).getroot().iter("DataSet")]


def compare_runs(first, second, tolerance=0.0, floor=0.0, any_order=False):
    """Compares all states of two runs; returns how many there are."""
    states, others = states_of(first), states_of(second)
    if len(states) != len(others):
        raise driver.TestFailure(f"{first} has {len(states)} states of fields, {second} has {len(others)}")
    for (_, state), (_, other) in zip(states, others):
        compare_states(state, other, tolerance, floor, any_order)
    return len(states)
