"""Reads csv tables as doc/inlets.md describes them, strictly and independently of the program, and writes them
plainly."""

import re

# The exponent may be that of Fortran.
NUMBER = re.compile(rb"([+-]?(?:\d+\.?\d*|\.\d+))(?:[eEdD]([+-]?\d+))?$")


class Unreadable(Exception):
    """The text is no table."""


def split(line, separator):
    """Cells; a separator in brackets or quotes does not count."""
    cells, depth, quoted = [b""], False, False
    for byte in (line.strip(b" \t") if separator == b" " else line):
        letter = bytes([byte])
        quoted ^= letter == b'"'
        if letter in b"[]":
            depth = letter == b"["
        separates = letter == separator or (separator == b" " and letter == b"\t")
        if not separates or depth or quoted:
            cells[-1] += letter
        elif separator != b" " or cells[-1]:
            cells.append(b"")
    return [cell.strip(b" \t") for cell in cells]


def without_quotes(cell):
    return cell[1:-1].replace(b'""', b'"').strip(b" \t") if len(cell) > 1 and cell[:1] == cell[-1:] == b'"' else cell


def without_end(cells, n):
    """Without empty cells at the end, beyond the first n."""
    while len(cells) > n and without_quotes(cells[-1]) == b"":
        cells = cells[:-1]
    return cells


def separator_of(line):
    return next((letter for letter in (b";", b",", b"\t") if len(split(line, letter)) > 1), b" ")


def number(cell):
    """A cell as a plain number; None if it is none."""
    match = NUMBER.match(without_quotes(cell))
    if not match:
        return None
    text = match.group(1) + (b"e" + match.group(2) if match.group(2) else b"")
    return None if float(text) in (float("inf"), float("-inf")) else text


def read(data):
    """(header as a list of cells, rows of cells)."""
    if data.startswith(b"\xef\xbb\xbf"):
        data = data[3:]
    lines = [line.strip(b" \t") for line in data.replace(b"\r\n", b"\n").replace(b"\r", b"\n").split(b"\n")]
    lines = [line for line in lines if line]
    rows = [line for line in lines if not line.startswith(b"#")]
    if not rows:
        raise Unreadable("no header")
    if all(number(cell) is not None for cell in without_end(split(rows[0], separator_of(rows[0])), 1)):
        before = lines[lines.index(rows[0]) - 1] if lines[0] != rows[0] else b""
        rows.insert(0, before.lstrip(b"# \t"))
        if not rows[0]:
            raise Unreadable("no header")
    separator = separator_of(rows[0])
    header = without_end(split(rows[0], separator), 1)
    if separator == b" ":
        # Units are cells of their own.
        joined = []
        for cell in header:
            if joined and cell[:1] in (b"[", b"(") and joined[-1][-1:] not in (b"]", b")"):
                joined[-1] += b" " + cell
            else:
                joined.append(cell)
        header = joined
    if len(rows) > 1 and not any(b"[" in cell or b"(" in cell for cell in header):
        # The units may be a line of their own.
        units = without_end(split(rows[1], separator_of(rows[1])), 1)
        if len(units) == len(header) and all(number(cell) is None for cell in units):
            header = [name + b" [" + without_quotes(unit).strip(b"[]() ") + b"]" for name, unit in zip(header, units)]
            del rows[1]
    if len(rows) > 1 and len(header) > 1:
        if len(without_end(split(rows[1], separator), len(header))) == 1 and len(split(rows[1], b" ")) == len(header):
            separator = b" "
    cells = [without_end(split(row, separator), len(header)) for row in rows[1:]]
    for row in cells:
        if len(row) != len(header):
            raise Unreadable(f"{len(row)} cells for {len(header)} columns")
    return header, cells


def plain(data, columns):
    """The same table, written without anything that need not be there; only its first `columns` must be numbers."""
    header, rows = read(data)
    for row in rows:
        for i, cell in enumerate(row[:columns]):
            row[i] = number(cell)
            if row[i] is None:
                raise Unreadable(f"{cell[:40]!r} is no number")
    return b"\n".join([b"; ".join(header), *(b"; ".join(row) for row in rows)]) + b"\n"
