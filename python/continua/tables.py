"""Tables (csv) that Continua writes."""

import csv
import io
import re
import warnings

import numpy
import pandas

from .errors import ContinuaWarning, ResultsError

# A cell of a table with texts: a text in quotes or a number without, and what ends it.
_CELL = re.compile(r'(?:"((?:[^"]|"")*)"|([^,"\r\n]*))(,|\r?\n)')


def split_unit(text):
    """("tip: pressure", "Pa") of "tip: pressure [Pa]"; without brackets the unit is "1"."""
    match = re.fullmatch(r"\s*(.*?)\s*(?:\[(.*)\])?\s*", text, re.DOTALL)
    return match.group(1), match.group(2) or "1"


def read_table(path):
    """A table that a run wrote.

    Returns a pandas.DataFrame of shape (rows, columns), named as in the file but without the units. `frame.attrs["units"]` is a dictionary
    from each name to its unit ("1" for a number without one). Columns of texts have Python texts. A cell without a number is nan. A table
    that has no rows yet has the shape (0, columns).

    A last line without a line end was cut off in the middle, as by a run that was killed: it is left out with a ContinuaWarning.
    Raises ResultsError for a file that is not there, is cut in its first line, or has a line that is no row of the table.
    """
    try:
        with open(path, encoding="utf-8", newline="") as stream:
            text = stream.read()
    except (OSError, UnicodeDecodeError) as error:
        raise ResultsError(path, f"cannot be read: {getattr(error, 'strerror', None) or error}") from error
    if not text:
        raise ResultsError(path, "the table is empty", "The run was stopped before it wrote the first line, or the copy is not complete")
    header, line_end, body = text.partition("\n")
    if not line_end:
        raise ResultsError(path, "the first line is cut short", "The run was killed as it began, or the copy is not complete")
    names, units = _read_header(path, header)
    if '"' in body:
        frame = _with_texts(path, names, body)
    else:
        frame = _of_numbers(path, names, body)
    frame.attrs["units"] = units
    return frame


def read_header(path):
    """The dictionary from the names of the columns to their units, without reading the rows."""
    try:
        with open(path, encoding="utf-8", errors="replace", newline="") as stream:
            line = stream.readline()
    except OSError as error:
        raise ResultsError(path, f"cannot be read: {error.strerror}") from error
    return _read_header(path, line)[1]


def _read_header(path, line):
    try:
        cells = next(csv.reader([line]), [])
    except csv.Error as error:
        raise ResultsError(path, f"the first line is no header: {error}", "The file is damaged: copy it again, or repeat the run") from error
    # An apostrophe shows spreadsheets that a name is no formula.
    cells = [re.sub(r"^'(?=[=+\-@])", "", cell) for cell in cells]
    named = [split_unit(cell) for cell in cells]
    names = [name for name, _ in named]
    for name in names:
        if names.count(name) > 1:
            raise ResultsError(path, f"two columns have the name '{name}'", "Rename one of the probes, and run again")
    return names, dict(named)


def _of_numbers(path, names, body):
    complete, _, rest = body.rpartition("\n")
    complete += "\n" if complete else ""
    n_rows = complete.count("\n")
    if rest.strip():
        warnings.warn(f"{path}: line {n_rows + 2} is cut short and is left out; {n_rows} rows are there", ContinuaWarning, stacklevel=2)
    if not complete.strip():
        return pandas.DataFrame(numpy.empty((0, len(names))), columns=names)
    try:
        # Too few cells are no error to pandas, too many are.
        if complete.count(",") != n_rows * (len(names) - 1):
            raise ValueError
        data = pandas.read_csv(io.StringIO(complete), header=None, names=range(len(names)), index_col=False, dtype=float, na_values=["nan"],
                               keep_default_na=False, float_precision="round_trip", skip_blank_lines=False)
    except ValueError as error:
        _find_fault(path, names, complete)
        raise ResultsError(path, f"cannot be read: {error}") from error
    data.columns = names
    return data


def _find_fault(path, names, body):
    """Raises ResultsError for the first line that is no row of numbers."""
    remedy = "The file is damaged: copy it again, or repeat the run"
    for number, line in enumerate(body.splitlines(), 2):
        cells = line.split(",")
        if len(cells) != len(names):
            raise ResultsError(f"{path}:{number}", f"the line has {len(cells)} cells, the first line has {len(names)}", remedy)
        for name, cell in zip(names, cells):
            try:
                float(cell)
            except ValueError:
                raise ResultsError(f"{path}:{number}", f"'{cell}' in the column '{name}' is no number", remedy) from None


def _with_texts(path, names, body):
    rows, row, position = [], [], 0
    while position < len(body):
        match = _CELL.match(body, position)
        if match is None:
            raise ResultsError(f"{path}:{len(rows) + 2}", "the row is cut short, or is no row of a table",
                               "The file is damaged: copy it again, or repeat the run")
        quoted, plain, end = match.groups()
        row.append((True, quoted.replace('""', '"')) if quoted is not None else (False, plain))
        position = match.end()
        if end != ",":
            if len(row) != len(names):
                raise ResultsError(f"{path}:{len(rows) + 2}", f"the row has {len(row)} cells, the first line has {len(names)}",
                                   "The file is damaged: copy it again, or repeat the run")
            rows.append(row)
            row = []
    if row:
        raise ResultsError(f"{path}:{len(rows) + 2}", "the row is cut short", "The file is damaged: copy it again, or repeat the run")
    return pandas.DataFrame({name: _column(path, name, [row[i] for row in rows]) for i, name in enumerate(names)})


def _column(path, name, cells):
    """Texts, whole numbers or numbers."""
    if any(is_text for is_text, _ in cells):
        return [text for _, text in cells]
    try:
        if all(re.fullmatch(r"-?\d+", text) for _, text in cells):
            return [int(text) for _, text in cells]
        return [float(text) if text else numpy.nan for _, text in cells]
    except ValueError as error:
        raise ResultsError(path, f"the column '{name}' has what is no number: {error}") from error
