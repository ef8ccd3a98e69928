"""Changes of a text by chance: bytes, tokens, lines, numbers, units, sections, encodings."""

import re

NUMBERS = (b"0", b"-0", b"-1", b"1e400", b"-1e400", b"1e-400", b"nan", b"-nan", b"inf", b"1,5", b"1.5.2", b"0x10",
           b"1e", b"1e+", b".", b"1_000", b"99999999999999999999", b"4294967297", b"2147483648", b"1d3", b"\xc2\xbd",
           b"1e308", b"5e-324", b"")
UNITS = (b"mm", b"m", b"kPa", b"mPa s", b"1/s", b"%", b"mmHg", b"m^3/s", b"Pa s", b"(m", b"m)", b"m^", b"m^99", b"m//s",
         b"/", b"\xc2\xb5m", b"\xb5m", b"K", b"ms s", b"m^-1", b"((((m))))", b"m^2^3", b"mmm", b"1 m", b"m 1")
TOKENS = (b"set", b"unset", b"end", b"subsection", b"unset subsection", b"include", b"=", b"#", b"\\", b"\"", b"'", b",", b":", b"/", b"+-", b"<",
          b"true", b"include .", b"include /dev/null", b"subsection", b"\0", b"\xff", b"\xe4", b"\x1b[31m", b"%s%n",
          b"../../..", b"A" * 70000, b"$(date)")
BYTES = (b"\0", b"\r", b"\n", b"\t", b"\x0b", b"\x0c", b"\x1b", b"\x7f", b"\x80", b"\xff", b"\xc3", b"\xe2\x80\x8b",
         b"\xc2\xa0", b"\xef\xbb\xbf", b"#", b"=", b"\\\n", b"\\")
WORD = re.compile(rb"[^\s,;\[\]=]+")
NUMBER = re.compile(rb"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")
UNIT = re.compile(rb"(?<=\d )[A-Za-z%][A-Za-z0-9/^% ]*|(?<=\[)[^\]\n]+(?=\])")


def place(chance, data):
    return chance.randrange(len(data) + 1)


def replace_match(pattern, replacements):
    def change(chance, data):
        found = list(pattern.finditer(data))
        if not found:
            return data
        match = chance.choice(found)
        return data[:match.start()] + chance.choice(replacements) + data[match.end():]
    return change


def flip_bit(chance, data):
    changed = bytearray(data or b" ")
    changed[chance.randrange(len(changed))] ^= 1 << chance.randrange(8)
    return bytes(changed)


def insert_bytes(chance, data):
    at = place(chance, data)
    return data[:at] + chance.choice(BYTES) + data[at:]


def delete_bytes(chance, data):
    at = place(chance, data)
    return data[:at] + data[at + chance.choice((1, 1, 2, 5, 40)):]


def truncate(chance, data):
    return data[:place(chance, data)]


def lines(function):
    def change(chance, data):
        rows = data.splitlines(True) or [b""]
        function(chance, rows, chance.randrange(len(rows)))
        return b"".join(rows)
    return change


def delete_line(_, rows, at):
    del rows[at]


def double_line(chance, rows, at):
    rows.insert(chance.randrange(len(rows) + 1), rows[at])


def swap_lines(chance, rows, at):
    other = chance.randrange(len(rows))
    rows[at], rows[other] = rows[other], rows[at]


def join_lines(_, rows, at):
    rows[at] = rows[at].rstrip(b"\r\n")


def split_line(chance, rows, at):
    place_in_row = chance.randrange(len(rows[at]) + 1)
    rows[at] = rows[at][:place_in_row] + b"\n" + rows[at][place_in_row:]


def comment_line(_, rows, at):
    rows[at] = b"#" + rows[at]


def add_comment(chance, rows, at):
    comment = bytes(chance.randrange(32, 256) for _ in range(9)).replace(b"\\", b"/")
    rows[at] = rows[at].rstrip(b"\r\n") + b" # " + comment + b"\n"


def add_blanks(chance, rows, at):
    rows[at] = chance.choice((b"  ", b"\t", b" \t \x0b")) + rows[at].rstrip(b"\r\n") + b" \t\n"


def open_section(chance, rows, at):
    rows.insert(at, b"subsection " + chance.choice((b"Mesh", b"Output", b"unknown", b"")) + b"\n")


def close_section(_, rows, at):
    rows.insert(at, b"end\n")


def nest_sections(chance, rows, at):
    n = chance.choice((3, 300))
    rows[at:at] = [b"subsection a\n"] * n + [b"end\n"] * chance.choice((n, n - 1, n + 1))


def repeat_block(chance, rows, at):
    rows.extend(rows[at:at + chance.randrange(1, 30)])


def encode(chance, data):
    text = data.decode("utf-8", "replace")
    return chance.choice((lambda: text.encode("utf-16"), lambda: text.encode("utf-16-be"),
                          lambda: text.encode("utf-32"),
                          lambda: b"\xef\xbb\xbf" + data, lambda: data.replace(b"\n", b"\r\n"),
                          lambda: data.replace(b"\n", b"\r"), lambda: data.replace(b"\n", b"\n\r"),
                          lambda: data.rstrip(b"\n"), lambda: data + b"\0" * 100, lambda: data.upper(),
                          lambda: data.lower()))()


COMMON = (flip_bit, insert_bytes, delete_bytes, truncate, replace_match(WORD, TOKENS), replace_match(NUMBER, NUMBERS),
          replace_match(NUMBER, NUMBERS), replace_match(UNIT, UNITS), lines(delete_line), lines(double_line),
          lines(swap_lines), lines(join_lines), lines(split_line), lines(comment_line), lines(add_comment),
          lines(add_blanks), lines(repeat_block), encode)
OF_SECTIONS = (lines(open_section), lines(close_section), lines(nest_sections))


def mutate(chance, data, changes):
    """One change, sometimes more."""
    for _ in range(chance.choice((1, 1, 1, 2, 4))):
        data = chance.choice(changes)(chance, data)
    return data
