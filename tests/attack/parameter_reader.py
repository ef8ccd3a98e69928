"""Reads parameter files as doc/command-line.md describes them, independently of the program, to see whether what it
accepts is what the file says."""

import os
import re


class Unreadable(Exception):
    """The text is no parameter file."""


def logical_lines(data):
    """Lines without comments, joined at backslashes. A carriage return ends a line, too."""
    if data.startswith(b"\xef\xbb\xbf"):
        data = data[3:]
    lines, continued = [], False
    for line in data.replace(b"\r\n", b"\n").replace(b"\r", b"\n").split(b"\n"):
        words = b" ".join(line.split(b"#")[0].split())
        if not continued:
            lines.append(b"")
        continued = words.endswith(b"\\")
        lines[-1] += words[:-1] if continued else words
    return [b" ".join(line.split()) for line in lines]


UNSET = object()  # the value of an entry that is taken back


def includes(chain, other):
    """Whether the file of one chain of inclusions includes that of the other."""
    return len(chain) < len(other) and other[:len(chain)] == chain


class Reader:
    """{path: [(chain of inclusions, value)]} of a file and what it includes."""

    def __init__(self, path):
        self.settings, self.n_inclusions, self.unset_sections = {}, 0, []
        self.read(path, (), (0,), [])

    def read(self, path, section, chain, stack):
        real = os.path.realpath(path)
        if real in stack or len(stack) > 100:
            raise Unreadable("includes itself")
        try:
            with open(path, "rb") as stream:
                data = stream.read()
        except OSError as error:
            raise Unreadable(str(error)) from error
        depth = len(section)
        for line in logical_lines(data):
            if not line:
                continue
            keyword, _, rest = line.partition(b" ")
            if keyword in (b"subsection", b"SUBSECTION") and rest:
                section += (rest,)
            elif line in (b"end", b"END") and len(section) > depth:
                section = section[:-1]
            elif keyword in (b"set", b"SET") and b"=" in rest:
                key, _, value = rest.partition(b"=")
                self.set(section + (b" ".join(key.split()),), chain, b" ".join(value.split()))
            elif keyword in (b"unset", b"UNSET") and rest and b"=" not in rest and rest != b"subsection":
                if rest.startswith(b"subsection "):
                    self.unset_sections.append((section + (rest[len(b"subsection "):],), chain))
                else:
                    self.set(section + (rest,), chain, UNSET)
            elif keyword in (b"include", b"INCLUDE") and rest:
                self.n_inclusions += 1
                self.read(os.path.normpath(os.path.join(os.path.dirname(path), os.fsdecode(rest))), section,
                          chain + (self.n_inclusions,), stack + [real])
            else:
                raise Unreadable(f"'{line[:80]!r}' cannot be understood")
        if len(section) > depth:
            raise Unreadable("a subsection is not closed")

    def set(self, path, chain, value):
        if not path[-1]:
            raise Unreadable("no key")
        settings = self.settings.setdefault(path, [])
        if any(earlier == chain for earlier, _ in settings):
            raise Unreadable(f"{path[-1]!r} is set twice")
        settings.append((chain, value))

    def values(self):
        """{path: value}: a file holds against those that it includes."""
        result = {}
        for place, chain in self.unset_sections:
            if not any(path[:len(place)] == place and includes(chain, other)
                       for path, settings in self.settings.items() for other, _ in settings):
                raise Unreadable(f"nothing to unset in {place[-1]!r}")
        for path, settings in self.settings.items():
            for chain, value in settings:
                if value is UNSET and not any(includes(chain, other) for other, _ in settings):
                    raise Unreadable(f"nothing to unset by {path[-1]!r}")
            settings = [(chain, value) for chain, value in settings
                        if not any(path[:len(place)] == place and len(path) > len(place) and includes(unset, chain)
                                   for place, unset in self.unset_sections)]
            if not settings:
                continue
            highest = [(chain, value) for chain, value in settings
                       if not any(includes(other, chain) for other, _ in settings)]
            if len({value for _, value in highest}) > 1:
                raise Unreadable("two files disagree")
            if highest[0][1] is not UNSET:
                result[b"/".join(path)] = highest[0][1]
        return result


def read(path):
    return Reader(path).values()


QUANTITY = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?(\s*(?![eExX_])[^\d\s.,+-][^,]*)?$")
WHOLE = re.compile(r"[+-]?\d+$")


def misfit(value, accepted):
    """Why a value is not what the entry accepts, by a strict reading of it; empty if it is."""
    if not value:
        return ""
    if accepted.startswith("whole number"):
        return "" if WHOLE.match(value) else "no whole number"
    if accepted.startswith("number"):
        if not QUANTITY.match(value):
            return "no number with a unit"
        positive = re.match(r"[+-]?[\d.]+", value).group(0)
        if accepted.startswith("number > 0") and float(positive) <= 0:
            return "not above 0"
        return "not 0 or more" if accepted.startswith("number >= 0") and float(positive) < 0 else ""
    if accepted.startswith("list of numbers"):
        return "" if all(QUANTITY.match(part.strip()) for part in value.split(",")) else "no list of numbers"
    return ""
