"""The sections of a report: what a run was, what came out, what it cost, how to repeat it."""

import math
import os
import re
import shlex
import subprocess
import tempfile

import continua
import plot_style
import report_charts
from report_html import Markup, escaped, picture, section, table, tag

MOST_ROWS = 100  # of a table of the run in the page
MOST_CELLS_OF_A_SKETCH = 20000
# Tables whose curves are drawn, or which are too long to be read.
CURVES = ("probes", "power", "residuals", "mass", "dispersion", "relaxation-table")


def entries_of(path):
    """[(section, key, value, default or None, meaning)] of the entries that parameters.prm sets; the default where it differs."""
    found, names, comment = [], [], []
    try:
        with open(path, encoding="utf-8", errors="replace") as stream:
            lines = stream.read().splitlines()
    except OSError:
        return found
    for line in lines:
        text = line.strip()
        if text.startswith("#"):
            # An entry that is not set is a comment, too, and its meaning stands above it.
            comment = [] if re.match(r"# set \S", text) else [*comment, text[1:].strip()]
            continue
        if text.startswith("subsection "):
            names.append(text[len("subsection "):].strip())
        elif text == "end" and names:
            names.pop()
        elif text.startswith("set ") and "=" in text:
            key, _, rest = text[4:].partition("=")
            value, mark, default = rest.partition("# default:")
            found.append(("/".join(names), key.strip(), value.strip(), default.strip() if mark else None, " ".join(comment)))
        comment = []
    return found


def number(value, unit, name=""):
    """A value of the summary as a reader likes it: in a unit with a prefix."""
    if value is None or not math.isfinite(value):
        return "no number"
    factor, shown = plot_style.readable(abs(value), unit, name)
    return f"{value * factor:.5g}" + ("" if shown in ("", "1") else " " + plot_style.axis_label("", shown).strip(" []"))


def verdict_of(check):
    return "passed" if check.get("passed") else "FAILED" if check.get("passed") is False else "not compared"


def head(runs):
    """Titles, how the runs ended, and how many expected values they met."""
    parts = []
    for run in runs:
        checks = run["summary"].get("checks", [])
        missed = sum(check.get("passed") is False for check in checks)
        compared = sum(check.get("passed") is not None for check in checks)
        badge = tag("span", f"{compared - missed} of {compared} expected values met" if compared else "no expected values",
                    class_="verdict" + (" bad" if missed else "" if compared else " none"))
        revision = run["summary"].get("revision", "")
        sub = ", ".join(filter(None, [run["summary"].get("analysis", ""), run["summary"].get("model", ""), run["summary"].get("discretisation", ""),
                                      f"{run['summary']['cells']} cells" if run["summary"].get("cells") else "",
                                      f"{run['summary']['steps']} steps" if run["summary"].get("steps") else "", run["status"],
                                      f"Continua {run['summary'].get('version', '')}" + (f" ({revision[:10]})" if revision else "")]))
        parts += [tag("h1", run["title"]), tag("p", sub, class_="sub"), tag("p", badge)]
    return parts


def warnings(runs):
    """First what failed, then what the runs warn of."""
    parts = []
    for run in runs:
        name = f"{run['title']}: " if len(runs) > 1 else ""
        if run["status"] != "finished":
            parts.append(tag("p", f"{name}the run {run['status']}" + (f": {run['reason']}" if run["reason"] else ""), class_="failed-run"))
        parts += [tag("p", name + text, class_="warning") for text in run["warnings"]]
    return section("warnings", "Warnings", parts or tag("p", "none"))


def key_of(check):
    """What tells the lines of `Expected` apart."""
    return check.get("probe", ""), check["name"], check["criterion"]


def titles_of(runs):
    """The heads of the columns of several runs; one needs none."""
    return [run["title"] if len(runs) > 1 else "" for run in runs]


def verdicts(runs):
    rows, classes = [], {}
    checks = [{key_of(check): check for check in run["summary"].get("checks", [])} for run in runs]
    names = list(dict.fromkeys(key for of_run in checks for key in of_run))
    for i, (probe, name, criterion) in enumerate(names):
        row = [probe, name, criterion]
        for of_run in checks:
            check = of_run.get((probe, name, criterion))
            if check is None:
                row += ["", ""]
                continue
            value = check.get("value")
            row += ["no number" if value is None else f"{value:.6g} {'' if check.get('unit') in ('1', None) else check['unit']}", verdict_of(check)]
            classes[i, len(row) - 1] = {"passed": "passed", "FAILED": "missed"}.get(verdict_of(check), "")
        rows.append(row)
    columns = ["probe", "quantity", "expected"]
    for run in runs:
        of = f", {run['title']}" if len(runs) > 1 else ""
        columns += [f"value{of}", f"verdict{of}"]
    return section("verdicts", "Expected values", table(columns, rows, range(3, len(columns), 2), classes) if rows else None)


def quantities_of(runs, wanted):
    """A table of the quantities that `wanted(probe, name)` takes, with a column for each run."""
    names = list(dict.fromkeys((entry.get("probe", ""), entry["name"]) for run in runs for entry in run["summary"].get("quantities", [])
                               if wanted(entry.get("probe", ""), entry["name"])))
    values = [{(entry.get("probe", ""), entry["name"]): number(entry["value"], entry.get("unit", ""), entry["name"])
               for entry in run["summary"].get("quantities", [])} for run in runs]
    rows = [[probe, name, *(of_run.get((probe, name), "") for of_run in values)] for probe, name in names]
    head_row = ["probe", "quantity", *(run["title"] if len(runs) > 1 else "value" for run in runs)]
    return table(head_row, rows, range(2, len(head_row))) if rows else None


WAVES = re.compile(r"wave speed|phase speed|attenuation|reflection|first pulse|travel|transit")
BEATS = re.compile(r"of the last beat|beats?\b|last periods")


def answer(runs):
    """What was asked for first, then all the rest, folded."""
    asked = {(check.get("probe", ""), check["name"]) for run in runs for check in run["summary"].get("checks", [])}
    parts = [quantities_of(runs, lambda probe, name: (probe, name) in asked or not probe)]
    for title, kind in (("Waves: speeds, heights, reflections", WAVES), ("Beats and periods", BEATS)):
        found = quantities_of(runs, lambda probe, name, kind=kind: kind.search(name) is not None)
        parts += [tag("h3", title), found] if found else []
    rest = quantities_of(runs, lambda probe, name: bool(probe) and not WAVES.search(name) and not BEATS.search(name))
    if rest:
        parts.append(tag("details", tag("summary", "All other quantities"), rest))
    absent = [[run["title"], entry.get("probe", ""), entry["name"], entry.get("reason", "")]
              for run in runs for entry in run["summary"].get("absent", [])]
    if absent:
        parts.append(tag("details", tag("summary", f"{len(absent)} quantities that the results cannot tell"),
                         table(["run", "probe", "quantity", "reason"], absent)))
    largest = list(dict.fromkeys(name for run in runs for name in run["summary"].get("largest values", {})))
    if largest:
        rows = []
        for name in largest:
            quantity, _, unit = name.rpartition(" [")
            values = [run["summary"].get("largest values", {}).get(name) for run in runs]
            rows.append([quantity, *(number(value, unit.rstrip("]")) for value in values)])
        parts += [tag("h3", "How far the run went"), table(["largest value", *titles_of(runs)], rows, range(1, 1 + len(runs)))]
    return section("answer", "Results", parts)


def setup(runs, notes):
    """Of each run: entries that differ from the defaults, materials, a sketch of the body with its boundaries."""
    parts = []
    for run in runs:
        entries = entries_of(os.path.join(run["folder"], "parameters.prm"))
        if len(runs) > 1:
            parts.append(tag("h3", run["title"]))
        parts.append(sketch(run, notes))
        materials = [(where.partition("/")[2], key, value) for where, key, value, _, _ in entries if where.startswith("Materials/")]
        if materials:
            parts += [tag("h3", "Materials"), table(["region", "entry", "value"], materials)]
        rows = [[where, key, value, tag("span", default, title=meaning)] for where, key, value, default, meaning in entries
                if default is not None and not where.startswith(("Materials/", "Expected"))]
        if rows:
            parts += [tag("h3", "Entries that differ from their defaults"), table(["section", "entry", "value", "default"], rows)]
        report = run["summary"].get("pre-flight report", {})
        if isinstance(report, dict) and report:
            rows = [[name.rpartition(" [")[0], number(value, name.rpartition(" [")[2].rstrip("]")) if isinstance(value, (int, float)) else value]
                    for name, value in report.items()]
            parts.append(tag("details", tag("summary", "Before the run: speeds and resolution"), table(["", "value"], rows, [1])))
    return section("setup", "What was run", parts)


def sketch(run, notes):
    """The mesh with its regions and boundaries, which the program writes from the run's own parameters."""
    parameters = os.path.join(run["folder"], "parameters.prm")
    if not os.path.exists(parameters) or run["summary"].get("cells", 1) > MOST_CELLS_OF_A_SKETCH:
        return None
    why = f"the sketch of {run['title']}"
    try:
        import draw_mesh
    except ImportError:
        notes.append(f"{why} (python3-vtk9 is not installed)")
        return None
    try:
        program = continua.find_program()
    except continua.ContinuaError as error:
        notes.append(f"{why} ({error})")
        return None
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "mesh.vtu")
        done = subprocess.run([program, parameters, "--mesh", file], capture_output=True, text=True, check=False, timeout=300)
        if done.returncode != 0 or not os.path.exists(file):
            said = (done.stderr or done.stdout).strip().splitlines()
            notes.append(f"{why} (continua --mesh: {said[-1] if said else done.returncode})")
            return None
        mesh = draw_mesh.Mesh(file)
    with open(parameters, encoding="utf-8", errors="replace") as stream:
        text = stream.read()
    names = ("x, axis", "y, radius") if run["summary"].get("model") == "axisymmetric" else ("x", "y")
    figure = draw_mesh.draw_space(mesh) if mesh.dim == 3 else draw_mesh.draw_plane(mesh, draw_mesh.liquids_of(text), names)
    return picture(report_charts.png_of(figure), f"The mesh of {run['title']} with its regions and boundaries")


def tables(runs):
    """Short tables that the runs wrote: modes, beats, fits, studies."""
    parts = []
    for run in runs:
        for name in run["results"].tables:
            if name in CURVES or name.startswith("wave"):
                continue
            try:
                frame = run["results"].table(name)
            except continua.ResultsError:
                continue
            if frame.empty or len(frame) > MOST_ROWS:
                continue
            units = frame.attrs.get("units", {})
            columns = [column if units.get(column, "1") == "1" else f"{column} [{units[column]}]" for column in frame.columns]
            rows = [["" if value != value else f"{value:.6g}" if isinstance(value, float) else value for value in row]
                    for row in frame.itertuples(index=False, name=None)]
            right = [i for i, column in enumerate(frame.columns) if frame[column].dtype.kind in "fi"]
            parts += [tag("h3", (f"{run['title']}: " if len(runs) > 1 else "") + name), table(columns, rows, right)]
    return section("tables", "Tables", parts)


def cost(runs):
    rows = []

    def row(name, value_of):
        values = [value_of(run["summary"]) for run in runs]
        if any(value not in (None, "") for value in values):
            rows.append([name, *("" if value is None else value for value in values)])

    row("ranks", lambda summary: summary.get("ranks"))
    row("cells", lambda summary: summary.get("cells"))
    row("steps", lambda summary: summary.get("steps"))
    for name in list(dict.fromkeys(name for run in runs for name in run["summary"].get("degrees of freedom", {}))):
        row(f"degrees of freedom, {name}", lambda summary, name=name: summary.get("degrees of freedom", {}).get(name))
    row("linear solver", lambda summary: summary.get("linear solver"))
    row("estimated time on one core", lambda summary: seconds(summary.get("estimated time on one core [s]")))
    row("memory of the first rank at its peak", lambda summary: memory(summary.get("peak memory of the first rank [bytes]")))
    row("estimated memory", lambda summary: memory(summary.get("estimated memory [bytes]")))
    sections = list(dict.fromkeys(name for run in runs for name in run["summary"].get("wall time [s]", {})))
    for name in sorted(sections, key=lambda name: -max(run["summary"].get("wall time [s]", {}).get(name, 0) for run in runs)):
        row(f"wall time, {name}", lambda summary, name=name: seconds(summary.get("wall time [s]", {}).get(name)))
    return section("cost", "Cost", table(["", *titles_of(runs)], rows, range(1, 1 + len(runs))) if rows else None)


def seconds(value):
    return None if value is None else f"{value:.3g} s" if value < 120 else f"{value / 60:.3g} min" if value < 7200 else f"{value / 3600:.3g} h"


def memory(value):
    return None if value is None else f"{value / 1e6:.0f} MB" if value < 1e9 else f"{value / 1e9:.2f} GB"


def repeat(runs):
    """Commands and files to have the runs once more."""
    parts = []
    for run in runs:
        summary, folder = run["summary"], os.path.abspath(run["folder"])
        if len(runs) > 1:
            parts.append(tag("h3", run["title"]))
        command = summary.get("command line", "")
        again = f"continua {shlex.quote(os.path.join(folder, 'parameters.prm'))} --output {shlex.quote(folder + '-again')}"
        if summary.get("ranks", 1) > 1:
            again = f"mpirun -n {summary['ranks']} {again}"
        lines = [f"# as it was run\n{command}"] if command else []
        lines.append(f"# from what the run kept of its parameters\n{again}")
        parts.append(tag("pre", "\n\n".join(lines)))
        revision = summary.get("revision", "")
        if revision:
            changed = " with uncommitted changes" if summary.get("revision has uncommitted changes") else ""
            libraries = ", ".join(f"{name} {version}" for name, version in summary.get("libraries", {}).items())
            parts.append(tag("p", f"Revision {revision}{changed}. {libraries}"))
        files = sorted(name for name in os.listdir(folder) if os.path.isfile(os.path.join(folder, name)) and name != "lock")
        kept = os.path.join(folder, "input")
        inputs = sorted(os.listdir(kept)) if os.path.isdir(kept) else []
        read = f" Files that the run read, in its folder input: {', '.join(inputs)}." if inputs else ""
        parts.append(tag("p", f"Files in {folder}: {', '.join(files)}.{read}"))
        log = os.path.join(folder, "log.txt")
        if os.path.exists(log):
            with open(log, encoding="utf-8", errors="replace") as stream:
                text = stream.read()
            shown = text if len(text) < 60000 else text[:30000] + "\n...\n" + text[-30000:]
            parts.append(tag("details", tag("summary", "log.txt"), tag("pre", shown)))
    return section("repeat", "To repeat it", parts)


def notes_section(notes):
    return section("left-out", "Left out", tag("ul", [tag("li", note) for note in dict.fromkeys(notes)]) if notes else None)


def navigation(body):
    """Links to the sections that there are."""
    names = re.findall(r'<section id="([a-z-]+)">\s*<h2>(.*?)</h2>', escaped(body), re.S)
    return tag("nav", [tag("a", Markup(title), href=f"#{name}") for name, title in names])
