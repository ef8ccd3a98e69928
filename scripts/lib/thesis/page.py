"""The report as one HTML page that needs nothing else: pictures inside, no scripts."""

import base64
import html
import os

from . import judge
from .reference import CHAPTERS, ROOT, SOURCES

TITLES = {"2": "One set of equations", "3": "Numerical method", "4": "Beam", "5": "Experiments on tubes", "6": "Linear waves",
          "7": "Future work", "A": "How the tubes are made"}
STYLE = """
@page { size: A4 landscape; margin: 12mm; @bottom-center { content: counter(page); font: 8pt sans-serif } }
body { font: 10pt/1.4 sans-serif; color: #222; max-width: 270mm; margin: 1em auto; padding: 0 1em }
h1 { font-size: 18pt } h2 { font-size: 14pt; border-bottom: 1px solid #999; margin-top: 2em } h3 { font-size: 11pt; margin-bottom: .3em }
table { border-collapse: collapse; width: 100%; font-size: 8pt; margin: .5em 0 1em }
table.rows { table-layout: fixed }
th, td { border-bottom: 1px solid #ddd; padding: 2px 5px; text-align: left; vertical-align: top; overflow-wrap: break-word }
th { background: #f0f0f0 } td.n { text-align: right } tr { break-inside: avoid }
figure { margin: .5em 0; break-inside: avoid } figure img { max-width: 160mm; max-height: 150mm }
figcaption, .small { font-size: 8.5pt; color: #444 } table .small { font-size: 7pt } code { font-size: 6.5pt; overflow-wrap: anywhere }
.agrees, .formula, .input, .guard { background: #d9efd9 } .explained { background: #fdf1cc } .DIFFERS, .CHANGED, .BROKEN { background: #f6c9c4; font-weight: bold }
.not { color: #777 }
nav a { margin-right: 1em }
"""


def escaped(text):
    return html.escape(str(text if text is not None else ""))


def picture(path):
    with open(path, "rb") as stream:
        data = base64.b64encode(stream.read()).decode("ascii")
    return f'<img alt="" src="data:image/png;base64,{data}">'


def duration(seconds):
    if seconds is None:
        return "-"
    return f"{seconds:.2g} s" if seconds < 100 else f"{seconds / 60:.3g} min"


def thesis_value(entry):
    if entry.kind == "finding":
        return "-"
    text = judge.text_of(entry.value, entry.unit)
    # A band of rounding alone is no band to a reader.
    return text + (f" ± {100 * entry.band:.2g} %" if entry.band and entry.band > 1e-6 else "")


def cell_of(row, source):
    if source in row.values:
        text = escaped(judge.text_of(row.values[source], row.entry.unit if row.entry.kind == "number" else ""))
        return f"<b>{text}</b>" if source == row.entry.judged and len(row.entry.sources) > 1 else text
    return "-"


# Widths of a table's columns [%].
WIDTHS = (22, 9, 7, 7, 7, 7, 8, 17, 11, 5)


def table(rows):
    columns = "".join(f'<col style="width:{width}%">' for width in WIDTHS)
    head = "".join(f"<th>{name}</th>" for name in ("what, and where", "thesis", *SOURCES.values(), "deviation", "verdict",
                                                    "why", "command", "cost"))
    lines = []
    for row in rows:
        entry = row.entry
        deviation = row.deviation()
        holds = f"<br>true if {escaped(entry.measure['holds'])}" if "holds" in entry.measure else ""
        if not holds and entry.band and entry.band_why:
            holds = f'<br><span class="small">{escaped(entry.band_why)}</span>'
        why = escaped(row.why) + (f" <i>Slip: {escaped(entry.slip)}</i>" if entry.slip else "")
        same = entry.measure.get("same_as") if entry.comparable is not False else None
        why += f' The measure is that of <a href="#{escaped(same)}">{escaped(same)}</a>.' if same else ""
        commands = "<br>".join(f"<code>{escaped(command)}</code>" for command in commands_of(row)) or "-"
        measured = f'<br><span class="small">Measured: {escaped(entry.measurable)}</span>' if entry.measurable and entry.sources else ""
        lines.append(
            f'<tr id="{escaped(entry.id)}"><td>{escaped(entry.text)}<br><span class="small">{escaped(entry.place)}</span>{measured}</td>'
            f'<td class="n">{escaped(thesis_value(entry))}{holds}</td>'
            + "".join(f'<td class="n">{cell_of(row, source)}</td>' for source in SOURCES)
            + f'<td class="n">{"-" if deviation is None else f"{100 * deviation:+.2g} %"}</td>'
            f'<td class="{row.verdict}">{row.verdict}</td><td>{why}</td><td>{commands}</td><td class="n">{duration(row.cost)}</td></tr>')
    return f'<table class="rows"><colgroup>{columns}</colgroup>' f"<thead><tr>{head}</tr></thead><tbody>{''.join(lines)}</tbody></table>"


def commands_of(row):
    """What runs the parameter files behind the judged value, from the folder of the sources."""
    if row.entry.comparable is False:
        return []
    return [f"continua {os.path.relpath(path, ROOT)}" for path in row.files()]


def owner(entry, figures):
    """The figure or table that an entry belongs to by its name, or none."""
    prefix = entry.id.split("-")[0]
    name = f"table {prefix[1:]}" if prefix.startswith("T") else f"figure {prefix}"
    return name if name in figures else None


def chapter_text(chapter, figures, rows, pictures):
    parts = [f'<h2 id="chapter-{chapter}">{"Appendix" if chapter == "A" else "Chapter"} {chapter}: {TITLES[chapter]}</h2>']
    names = {figure.id for figure in figures}
    of_figure = {}
    for row in rows:
        of_figure.setdefault(owner(row.entry, names), []).append(row)
    if None in of_figure:
        parts += ["<h3>Text and equations</h3>", table(of_figure[None])]
    for figure in figures:
        page = f", page {escaped(figure.page)}" if figure.page else ""
        parts.append(f"<h3>{escaped(figure.id.capitalize())}{page}: {escaped(figure.caption)}</h3>")
        drawn = pictures.get(figure.id, [])
        for path in drawn:
            parts.append(f"<figure>{picture(path)}</figure>")
        if figure.axes:
            parts.append(f'<p class="small">In the thesis: {escaped(figure.axes)}</p>')
        if not figure.reproduced:
            parts.append(f'<p class="small">Not reproduced: {escaped(figure.why_not)}</p>')
        elif not drawn and figure.id not in of_figure:
            parts.append('<p class="small">Not drawn: its runs were not made, or this report has no drawing of it.</p>')
        if figure.id in of_figure:
            parts.append(table(of_figure[figure.id]))
    return "\n".join(parts)


def summary_text(rows, figures, pictures):
    counts = judge.counts(rows)
    lines = [f'<tr><td class="{verdict.split()[0]}">{verdict}</td><td class="n">{number}</td><td>{escaped(judge.VERDICTS[verdict])}</td></tr>'
             for verdict, number in counts.items()]
    failed = [row for row in rows if row.verdict in judge.FAILURES]
    repeated = judge.repeated(rows)
    reproducible = [figure for figure in figures if figure.reproduced]
    parts = ["<h2>Summary</h2>", f"<table><tbody>{''.join(lines)}</tbody></table>",
             f"<p>{len(repeated)} more rows repeat the measure of another one with the same verdict. They do not count.</p>" if repeated else "",
             f"<p>{sum(bool(pictures.get(figure.id)) for figure in reproducible)} of {len(reproducible)} figures and tables that "
             f"can be reproduced are drawn; {len(figures) - len(reproducible)} are sketches, or of data that are lost.</p>"]
    if failed:
        links = ", ".join(f'<a href="#{escaped(row.entry.id)}">{escaped(row.entry.id)}</a>' for row in failed)
        parts.append(f"<p>Without an explanation: {links}.</p>")
    return "\n".join(parts)


def write(path, figures, rows, pictures, how):
    """`pictures`: {figure: files}; `how`: lines on how the report was made."""
    chapters = [chapter for chapter in CHAPTERS if any(item.chapter == chapter for item in [*figures, *(row.entry for row in rows)])]
    parts = [f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>The thesis beside Continua</title><style>{STYLE}</style></head><body>',
             "<h1>The thesis beside Continua</h1>",
             "<p>C. G. Giannopapa, <i>Fluid structure interaction in flexible vessels</i>, PhD thesis, King's College London, 2004. "
             "Each number, figure and finding of the thesis stands beside what Continua gives. The value in bold is the one that the "
             "verdict is about.</p>",
             *(f'<p class="small">{escaped(line)}</p>' for line in how),
             "<nav>" + "".join(f'<a href="#chapter-{chapter}">{"Appendix" if chapter == "A" else "Chapter"} {chapter}</a>' for chapter in chapters) + "</nav>",
             summary_text(rows, figures, pictures)]
    for chapter in chapters:
        parts.append(chapter_text(chapter, [figure for figure in figures if figure.chapter == chapter],
                                  [row for row in rows if row.entry.chapter == chapter], pictures))
    parts.append("</body></html>")
    partial = path + ".part"
    with open(partial, "w", encoding="utf-8") as stream:
        stream.write("\n".join(parts))
    os.replace(partial, path)
