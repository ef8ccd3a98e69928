"""Reads a mesh file of gmsh (MSH 4.1) strictly and independently of the program, and writes it plainly."""


class Unreadable(Exception):
    """The text is no such file."""


def sections(text):
    """{name: lines}; each must be closed and none may come twice."""
    result, name = {}, None
    for line in text.splitlines():
        line = line.strip()
        if not line:
            continue
        if name is None:
            if not line.startswith("$") or line[1:] in result:
                raise Unreadable(f"'{line[:40]}' between sections, or a section twice")
            name = line[1:]
            result[name] = []
        elif line == "$End" + name:
            name = None
        elif line.startswith("$"):
            raise Unreadable(f"'{line[:40]}' within ${name}")
        else:
            result[name].append(line)
    if name is not None:
        raise Unreadable(f"${name} is not closed")
    return result


def numbers(line, n):
    try:
        values = [float(word) for word in line.split()]
    except ValueError as error:
        raise Unreadable(str(error)) from error
    if len(values) < n or any(value != value or abs(value) == float("inf") for value in values):
        raise Unreadable(f"'{line[:40]}' should have {n} numbers")
    return values


def whole(value):
    if value != int(value):
        raise Unreadable(f"{value} should be a whole number")
    return int(value)


def check_blocks(lines, n_lines):
    """Blocks whose header ends with the number of their members, of `n_lines` lines each."""
    at = 1
    for _ in range(whole(numbers(lines[0], 4)[0])):
        at += 1 + n_lines * whole(numbers(lines[at], 4)[3])
    if at != len(lines):
        raise Unreadable(f"{len(lines)} lines where {at} are announced")


def plain(data):
    """The same file, its numbers written in one form, without what is not read."""
    found = sections(data.decode("latin-1"))
    try:
        check_blocks(found["Nodes"], 2)
        check_blocks(found["Elements"], 1)
        if sum(whole(value) for value in numbers(found["Entities"][0], 4)) != len(found["Entities"]) - 1:
            raise Unreadable("another number of entities than announced")
        if whole(numbers(found["PhysicalNames"][0], 1)[0]) != len(found["PhysicalNames"]) - 1:
            raise Unreadable("another number of names than announced")
    except (KeyError, IndexError, OverflowError) as error:
        raise Unreadable(f"a section or a line is missing: {error}") from error
    text = ""
    for name in ("MeshFormat", "PhysicalNames", "Entities", "Nodes", "Elements"):
        if name not in found:
            raise Unreadable(f"no ${name}")
        lines = found[name]
        if name != "PhysicalNames":
            lines = [" ".join(str(int(value)) if value == int(value) else repr(value) for value in numbers(line, 1))
                     for line in lines]
        text += f"${name}\n" + "".join(line + "\n" for line in lines) + f"$End{name}\n"
    return text.encode("latin-1")
