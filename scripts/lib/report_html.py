"""HTML whose texts are escaped, and the page around it: it loads nothing, and runs its own scripts alone."""

import base64
import hashlib
import html
import json


class Markup(str):
    """A text that is HTML already. Every other text is escaped."""


def escaped(child):
    if isinstance(child, Markup):
        return child
    if isinstance(child, (list, tuple)):
        return Markup("".join(escaped(one) for one in child))
    return Markup("" if child is None else html.escape(str(child), quote=True))


def tag(element, *children, **attributes):
    """An element. `class_` is the attribute class, `data_chart` is data-chart; one that is None is left out."""
    text = "".join(f' {key.rstrip("_").replace("_", "-")}="{html.escape(str(value), quote=True)}"'
                   for key, value in attributes.items() if value is not None)
    if element in ("img", "meta", "link", "br", "hr"):
        return Markup(f"<{element}{text}>")
    return Markup(f"<{element}{text}>{escaped(children)}</{element}>\n")


def table(head, rows, numbers=(), classes=None):
    """Columns in `numbers` stand to the right. `classes`: {(row, column): class}."""
    classes = classes or {}

    def cell(kind, i, j, child):
        name = " ".join(filter(None, ["number" if j in numbers else "", classes.get((i, j), "")]))
        return tag(kind, child, class_=name or None)

    body = [tag("tr", *(cell("td", i, j, child) for j, child in enumerate(row))) for i, row in enumerate(rows)]
    first = tag("tr", *(cell("th", -1, j, child) for j, child in enumerate(head)))
    return tag("div", tag("table", tag("thead", first), tag("tbody", body)), class_="scroll")


def section(name, title, *children):
    """Empty if it has no content."""
    inside = escaped(children)
    return tag("section", tag("h2", title), inside, id=name) if inside.strip() else Markup("")


def picture(data, text, **attributes):
    """A figure of a PNG."""
    address = "data:image/png;base64," + base64.b64encode(data).decode("ascii")
    return tag("figure", tag("img", src=address, alt=text), tag("figcaption", text), **attributes)


def data_element(data):
    """The data that the scripts read. No text in it can end the element."""
    text = json.dumps(data, allow_nan=False, ensure_ascii=True, separators=(",", ":")).replace("<", "\\u003c").replace(">", "\\u003e")
    return Markup(f'<script type="application/json" id="data">{text}</script>\n')


def source_of(text):
    """How a Content-Security-Policy names a script or style that stands in the page."""
    return "'sha256-" + base64.b64encode(hashlib.sha256(text.encode("utf-8")).digest()).decode("ascii") + "'"


def page(title, body, data, styles, scripts, refresh=None):
    """The whole file. Its policy forbids every address outside of it, and every script and style but these. `refresh`: seconds after which
    a browser reads it again."""
    for text in [*styles, *scripts]:
        if "</script" in text.lower() or "</style" in text.lower():
            raise ValueError("a script or style would end its own element")
    policy = ["default-src 'none'", "img-src data:", "base-uri 'none'", "form-action 'none'", "style-src " + " ".join(map(source_of, styles)),
              "script-src " + (" ".join(map(source_of, scripts)) or "'none'")]
    head = [Markup('<meta charset="utf-8">\n'), tag("meta", http_equiv="Content-Security-Policy", content="; ".join(policy)),
            tag("meta", name="viewport", content="width=device-width, initial-scale=1"), tag("meta", name="referrer", content="no-referrer"),
            tag("meta", http_equiv="refresh", content=refresh) if refresh else None, tag("title", title),
            Markup("".join(f"<style>{text}</style>\n" for text in styles))]
    end = Markup("".join(f"<script>{text}</script>\n" for text in scripts))
    return "<!DOCTYPE html>\n" + tag("html", tag("head", head), tag("body", body, data_element(data), end), lang="en")
