"""The places of C++ sources at which scripts/measure/mutants may change one operator, constant, index or condition.

This is no compiler: it relies on the layout of clang-format. A binary operator has blanks on both sides, the bracket of a template
argument follows its name without a blank, and a brace that begins a block has a blank before it. A wrong guess does not compile.
"""

import dataclasses
import re

TOKEN = re.compile(r"""(?P<blank>\s+|//[^\n]*|/\*.*?\*/)
    |(?P<text>(?:u8|[uUL])?R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"|(?:u8|[uUL])?"(?:[^"\\\n]|\\.)*"|(?:u8|[uUL])?'(?:[^'\\\n]|\\.)+')
    |(?P<number>\.?\d(?:[eEpP][+-]|'(?=\w)|[\w.])*)
    |(?P<word>[A-Za-z_]\w*)
    |(?P<sign><<=|>>=|\.\.\.|->\*|::|->|\+\+|--|<<|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|.)""", re.VERBOSE | re.DOTALL)
DIRECTIVE = re.compile(r"^[ \t]*#(?:\\\n|[^\n])*", re.MULTILINE)

BINDS = {"*": 10, "/": 10, "%": 10, "+": 9, "-": 9, "<<": 8, ">>": 8, "<": 7, "<=": 7, ">": 7, ">=": 7, "==": 6, "!=": 6,
         "&": 5, "^": 4, "|": 3, "&&": 2, "||": 1}
ASSIGNMENTS = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="}
OTHERS = {"+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"], "+=": ["-="], "-=": ["+="], "*=": ["/="], "/=": ["*="],
          "<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"], "==": ["!="], "!=": ["=="],
          "&&": ["||"], "||": ["&&"]}
KINDS = {**dict.fromkeys(["+", "-", "*", "/", "+=", "-=", "*=", "/="], "arithmetic"),
         **dict.fromkeys(["<", "<=", ">", ">=", "==", "!="], "comparison"), "&&": "logical", "||": "logical"}
# What follows in parentheses is a statement's own, and the statement after it begins anew.
HEADS = {"if", "while", "for", "switch", "catch"}
# Programmer's checks, and what must be constant when the program is compiled.
UNTOUCHED_CALLS = {"Assert", "AssertThrow", "AssertDimension", "AssertIndexRange", "AssertIsFinite", "AssertThrowMPI", "AssertCuda",
                   "static_assert", "alignas", "alignof", "decltype", "noexcept", "sizeof", "offsetof", "__attribute__"}


@dataclasses.dataclass
class Token:
    kind: str
    text: str
    start: int
    end: int
    blank_before: bool = True
    blank_after: bool = True
    partner: int = -1  # of a bracket, the other one
    is_template: bool = False  # a bracket of template arguments
    is_touched: bool = False  # may be part of a site


@dataclasses.dataclass
class Site:
    """One change: the characters `start` to `end` of the file become `after`."""

    file: str
    line: int
    kind: str
    start: int
    end: int
    before: str
    after: str

    def replacement(self, text, number):
        """Both forms, of the same type; the original keeps its lines."""
        switch = f"::continua_mutants::is_on({number})"
        original = text[self.start:self.end]
        if self.kind == "condition":
            return f"({switch} ? {self.after} : bool({original}))"
        return f"({switch} ? ({self.after}) : ({original}))"


def read_tokens(text):
    """Without comments and directives of the preprocessor; brackets know their partners."""
    text = DIRECTIVE.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)
    tokens, open_brackets, position, is_after_blank = [], [], 0, True
    while position < len(text):
        match = TOKEN.match(text, position)
        kind, part = match.lastgroup, match[0]
        kind = "text" if kind == "mark" else kind
        inside_template = open_brackets and tokens[open_brackets[-1]].is_template
        if kind == "sign" and part[0] == ">" and inside_template:
            part = ">"  # of >> or >=, the first
        position += len(part)
        if kind == "blank":
            if tokens:
                tokens[-1].blank_after = True
            is_after_blank = True
            continue
        token = Token(kind, part, position - len(part), position, is_after_blank, False)
        is_after_blank = False
        before = tokens[-1] if tokens else None
        tokens.append(token)
        if part in "([{" or (part == "<" and before and before.kind == "word" and
                             (not token.blank_before or before.text == "template")):
            token.is_template = part == "<"
            open_brackets.append(len(tokens) - 1)
        elif part in ")]}" or (part == ">" and inside_template):
            # A sign that only looked like the bracket of a template.
            while open_brackets and part != ">" and tokens[open_brackets[-1]].is_template:
                tokens[open_brackets.pop()].is_template = False
            if not open_brackets:
                raise ValueError(f"the bracket {part} at character {token.start} closes nothing")
            token.partner = open_brackets.pop()
            token.is_template = part == ">"
            tokens[token.partner].partner = len(tokens) - 1
    if open_brackets:
        raise ValueError(f"the bracket at character {tokens[open_brackets[-1]].start} is not closed")
    return tokens


def is_initialiser(tokens, brace):
    """Whether a brace belongs to an expression: a block's stands after a blank."""
    return not tokens[brace].blank_before or tokens[brace - 1].text in ("=", "(", ",", "{", "return")


def mark_functions(tokens, first, last):
    """Marks what stands in the bodies of functions and in the lists of initialisers of constructors."""
    begin = position = first
    while position < last:
        token = tokens[position]
        if token.text == ";":
            begin = position + 1
        elif token.text == "{":
            outer, inner = [], begin
            while inner < position:
                outer.append(inner)
                inner = tokens[inner].partner + 1 if tokens[inner].partner > inner else inner + 1
            words = [tokens[i].text for i in outer]
            has_arguments = "(" in words
            if "namespace" in words or "extern" in words and not has_arguments:
                mark_functions(tokens, position + 1, token.partner)
            elif "enum" in words or "=" in words and "operator" not in words or is_initialiser(tokens, position):
                # A value: a variable that is made before main, or one item of a constructor's list.
                position = token.partner + 1
                continue
            elif not has_arguments and {"class", "struct", "union"} & set(words):
                mark_functions(tokens, position + 1, token.partner)
            elif has_arguments and "constexpr" not in words:
                arguments = outer[words.index("(")]
                colons = [i for i in outer if i > arguments and tokens[i].text == ":"]
                for i in range(colons[0] if colons else position, token.partner):
                    tokens[i].is_touched = True
            position = begin = token.partner + 1
            continue
        position = token.partner + 1 if token.partner > position else position + 1


def unmark(tokens, first, last):
    for i in range(first, last):
        tokens[i].is_touched = False


def end_of_statement(tokens, position, ends=(";",)):
    while tokens[position].text not in ends and tokens[position].text not in ("}", ")"):
        position = tokens[position].partner + 1 if tokens[position].partner > position else position + 1
    return position


def unmark_what_stays(tokens):
    """Messages, programmer's checks, and what must be constant or is made once for the whole process."""
    for i, token in enumerate(tokens):
        if not token.is_touched:
            continue
        following = tokens[i + 1]
        if token.is_template and token.text == "<":
            unmark(tokens, i, token.partner + 1)
        elif token.kind == "word":
            if following.text == "(" and (token.text in UNTOUCHED_CALLS or token.text == "constexpr"):
                unmark(tokens, i + 1, following.partner + 1)
            elif token.text in ("throw", "constexpr", "static", "using", "typedef"):
                unmark(tokens, i, end_of_statement(tokens, i))
            elif token.text == "case":
                unmark(tokens, i, end_of_statement(tokens, i, (":",)))
            elif token.text in ("struct", "class", "enum", "union"):
                brace = end_of_statement(tokens, i, (";", "{"))
                if tokens[brace].text == "{":
                    unmark(tokens, i, tokens[brace].partner)


def is_binary(token):
    return token.kind == "sign" and token.text in BINDS and token.blank_before and token.blank_after and not token.is_template


def left_end(tokens, position, binding):
    """The first token of the expression whose operator binds as `binding` and stands at `position`."""
    while position > 0:
        token = tokens[position - 1]
        if token.partner >= 0 and token.partner < position - 1:
            if token.text == "}" and not is_initialiser(tokens, token.partner):
                return position
            before = tokens[token.partner - 1]
            if token.text == ")" and (before.text in HEADS or before.text == "constexpr"):
                return position
            position = token.partner
        elif token.text in ("(", "[", "{", ",", ";", "?", ":", "return", "else", "do", "case") or token.text in ASSIGNMENTS:
            return position
        elif is_binary(token) and BINDS[token.text] < binding:
            return position
        else:
            position -= 1
    return position


def right_end(tokens, position, binding):
    """One past the last token of that expression. An assignment, which binds as 0, takes all of its right side."""
    position += 1
    while True:
        token = tokens[position]
        if token.text in (")", "]", "}", ",", ";") or binding > 0 and (token.text in ("?", ":") or token.text in ASSIGNMENTS):
            return position
        if is_binary(token) and BINDS[token.text] <= binding:
            return position
        position = token.partner + 1 if token.partner > position else position + 1


def joined(tokens):
    return "".join((" " if i > 0 and token.blank_before else "") + token.text for i, token in enumerate(tokens))


def other_constants(text, is_index):
    """What a numeric constant may become, in the same type."""
    match = re.fullmatch(r"(\d+)([uUlL]*)", text)
    if match and not (len(match[1]) > 1 and match[1][0] == "0"):
        value = int(match[1])
        return [f"{other}{match[2]}" for other in (value + 1, value - 1) if other >= 0]
    match = re.fullmatch(r"(\d+\.\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?|\d+[eE][+-]?\d+)([fFlL]?)", text)
    if match and not is_index:
        value = float(match[1])
        others = [value + 1, 2 * value, value / 2] if value else [1.]
        return [f"{other!r}{match[2]}" for other in dict.fromkeys(others)]
    return []


def condition_range(tokens, i):
    """(first, end) of the condition of `if`, `while` and `?`; an `if` may have an initialiser before."""
    if tokens[i].text == "?":
        return left_end(tokens, i, 0), i
    first, last = i + 2, tokens[i + 1].partner
    for j in range(first, last):
        if tokens[j].text == ";":
            first = j + 1
    return first, last


def joins_text(tokens, first, end):
    """Whether a text in quotes is an operand: then the expression is a message or a name."""
    while first < end:
        if tokens[first].kind == "text":
            return True
        first = tokens[first].partner + 1 if tokens[first].partner > first else first + 1
    return False


def declares_array(tokens, bracket):
    """Whether a type stands before the name before the bracket."""
    before = tokens[bracket - 2]
    return tokens[bracket - 1].blank_before and tokens[bracket - 1].kind == "word" and \
        (before.is_template or before.kind == "word" and before.text not in ("return", "else", "do"))


def sites_of(file, text, choose):
    """The sites of one file, in their order; `choose` picks one of several changes of a site."""
    tokens = read_tokens(text)
    mark_functions(tokens, 0, len(tokens))
    unmark_what_stays(tokens)
    sites = []

    def add(kind, first, end, after, at):
        if all(token.is_touched or token.is_template for token in (tokens[first], tokens[end - 1])):
            sites.append(Site(file, text.count("\n", 0, at.start) + 1, kind, tokens[first].start, tokens[end - 1].end,
                              joined(tokens[first:end]), after))

    for i, token in enumerate(tokens):
        if not token.is_touched:
            continue
        before, following = tokens[i - 1], tokens[i + 1]
        if token.text in OTHERS and (is_binary(token) or token.text in ASSIGNMENTS) and before.text != "operator":
            binding = BINDS.get(token.text, 0)
            first, end = left_end(tokens, i, binding), right_end(tokens, i, binding)
            if first == i or end == i + 1 or joins_text(tokens, first, end):
                continue
            other = dataclasses.replace(token, text=choose(OTHERS[token.text]))
            add(KINDS[token.text], first, end, joined([*tokens[first:i], other, *tokens[i + 1:end]]), token)
        elif token.kind == "number":
            is_index = before.text == "[" and following.text == "]"
            others = other_constants(token.text, is_index)
            if others and not (is_index and declares_array(tokens, i - 1)):
                add("index" if is_index else "constant", i, i + 1, choose(others), token)
        elif token.kind == "word" and before.text == "[" and following.text == "]" and not before.blank_before and \
                token.text not in ("true", "false", "this") and not declares_array(tokens, i - 1) and \
                (tokens[i - 2].kind == "word" or tokens[i - 2].text in (")", "]")):
            add("index", i, i + 1, f"{token.text} + 1", token)
        elif token.text in ("if", "while") and following.text == "(" or token.text == "?":
            first, end = condition_range(tokens, i)
            if first < end:
                add("condition", first, end, f"!({joined(tokens[first:end])})", token)
    return sites
