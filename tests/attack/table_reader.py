"""Reads csv tables as doc/inlets.md describes them, strictly and independently of the program, and writes them
plainly."""

import re

NUMBER = re.compile(rb"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$")


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
        if letter != separator or depth or quoted:
            cells[-1] += letter
        elif separator != b" " or cells[-1]:
            cells.append(b"")
    return [cell.strip(b" \t") for cell in cells]


def read(data):
    """(header as a list of cells, rows of texts of numbers)."""
    if data.startswith(b"\xef\xbb\xbf"):
        data = data[3:]
    rows = []
    for line in data.replace(b"\r\n", b"\n").replace(b"\r", b"\n").split(b"\n"):
        content = line.strip(b" \t")
        if content and not content.startswith(b"#"):
            rows.append(content)
    if not rows:
        raise Unreadable("no header")
    separator = next((letter for letter in (b";", b",", b"\t") if len(split(rows[0], letter)) > 1), b" ")
    header = split(rows[0], separator)
    cells = [split(row, separator) for row in rows[1:]]
    for row in cells:
        if len(row) != len(header):
            raise Unreadable(f"{len(row)} cells for {len(header)} columns")
    return header, cells


def plain(data, columns):
    """The same table, written without anything that need not be there; only its first `columns` must be numbers."""
    header, rows = read(data)
    for row in rows:
        for cell in row[:columns]:
            if not NUMBER.match(cell) or float(cell) in (float("inf"), float("-inf")):
                raise Unreadable(f"{cell[:40]!r} is no number")
    return b"\n".join([b"; ".join(header), *(b"; ".join(row) for row in rows)]) + b"\n"
