"""What the drivers share: header comments of a case, runs of the program, tables and summaries."""

import csv
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "python"))
from continua.program import environment as environment_of_runs  # noqa: E402


class TestFailure(Exception):
    """The case does not hold; the text says what was expected and what came."""


def header(path):
    """The comment lines `# key: value` of a file, as a dictionary from key to the list of its values."""
    entries = {}
    with open(path, encoding="utf-8") as stream:
        for line in stream:
            match = re.match(r"#\s*([a-z][a-z ]*?)\s*:\s*(.*?)\s*$", line)
            if match:
                entries.setdefault(match.group(1), []).append(match.group(2))
    return entries


def overrides(lines):
    """The arguments for a list of texts `KEY = VALUE`."""
    arguments = []
    for line in lines:
        key, equals, value = line.partition("=")
        if not equals:
            raise TestFailure(f"'{line}' is not KEY = VALUE")
        arguments += ["--set", f"{key.strip()}={value.strip()}"]
    return arguments


def single(entries, key, default=None):
    """The one value of a key; the default when it is not there."""
    values = entries.get(key, [])
    if len(values) > 1:
        raise TestFailure(f"the header has '{key}' more than once")
    return values[0] if values else default


def environment():
    """One thread a rank; more ranks than cores and root are allowed. Ranks that wait give their core to what else runs here."""
    return {**environment_of_runs(), "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "DEAL_II_NUM_THREADS": "1", "LC_ALL": "C.UTF-8",
            "OMPI_MCA_mpi_yield_when_idle": "1"}


def on_ranks(command, ranks, errors=None):
    """The command as it is started: through the client of a server that has loaded its program already (tests/served.c) where the environment
    names one, under mpiexec when ranks > 1. The ranks append what they write to standard error to the file `errors`: Open MPI 5 may bring it
    into standard output."""
    client = os.environ.get("CONTINUA_SERVED")
    if client and os.path.basename(command[0]).startswith(("continua", "unit_tests_")):
        command = [client, *command]
    if ranks == 1:
        return command
    if errors:
        command = ["sh", "-c", 'exec "$@" 2>>"$0"', errors, *command]
    return ["mpiexec", "--bind-to", "none", "-n", str(ranks), *command]


def run(program, arguments, ranks=1, folder=None, time_limit=300):
    """Runs the program, under mpiexec when ranks > 1. Returns its subprocess.CompletedProcess with text streams."""
    command = [program, *arguments]
    print("+", " ".join(on_ranks(command, ranks)), flush=True)
    with tempfile.TemporaryDirectory() as temporary:
        errors = os.path.join(temporary, "errors")
        try:
            done = subprocess.run(on_ranks(command, ranks, errors), cwd=folder, env=environment(),
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                  errors="replace", timeout=time_limit, check=False)
        except subprocess.TimeoutExpired as expired:
            raise TestFailure(f"the run took more than {time_limit} s") from expired
        if os.path.exists(errors):
            with open(errors, encoding="utf-8", errors="replace") as stream:
                done.stderr = stream.read() + done.stderr
        return done


def run_to_the_end(program, arguments, ranks=1, folder=None, time_limit=300):
    """As run, but any exit status but 0 is a failure."""
    done = run(program, arguments, ranks, folder, time_limit)
    if done.returncode != 0:
        raise TestFailure(f"exit status {done.returncode}\n{done.stdout}{done.stderr}")
    return done


def fresh_folder(path):
    """Empties the folder a case works in."""
    shutil.rmtree(path, ignore_errors=True)
    os.makedirs(path)
    return os.path.abspath(path)


def read_table(path, gaps=False):
    """(column names, rows of numbers) of a csv file that a run wrote; with `gaps` a number may be missing, as nan."""
    with open(path, encoding="utf-8", newline="") as stream:
        rows = list(csv.reader(stream))
    if not rows:
        raise TestFailure(f"{path} is empty")
    table = [[float(cell) for cell in row] for row in rows[1:]]
    if not table:
        raise TestFailure(f"{path} has a header but no rows")
    if any(not math.isfinite(value) and not (gaps and math.isnan(value)) for row in table for value in row):
        raise TestFailure(f"{path} holds a number that is not finite")
    return rows[0], table


def unit_of(name):
    return name[name.rfind("["):] if "[" in name else ""


def compare_tables(first, second, tolerance, floor=0.0, left_out=(), floor_share=0.0, of_fields=(), gaps=False):
    """Column by column, the deviation relative to the largest magnitude in the column of the first table, or to the
    floor where the whole column is below it (a quantity that is zero but for round-off). The floor is at least
    `floor_share` of the largest magnitude among all columns of the same unit. Columns that are `left_out` need not
    agree. `of_fields`: {field: tolerance} for the columns 'PROBE: FIELD [UNIT]' that have one of their own. `gaps`: as in
    read_table(); both tables then lack the same numbers."""
    names, rows = read_table(first, gaps)
    other_names, other_rows = read_table(second, gaps)
    if names != other_names:
        raise TestFailure(f"columns differ: {names} in {first}, {other_names} in {second}")
    if len(rows) != len(other_rows):
        raise TestFailure(f"{len(rows)} rows in {first}, {len(other_rows)} in {second}")
    if any(math.isnan(a) != math.isnan(b) for row, other in zip(rows, other_rows) for a, b in zip(row, other)):
        raise TestFailure(f"{first} and {second} do not lack the same numbers")
    rows, other_rows = ([[0.0 if math.isnan(value) else value for value in row] for row in table]
                        for table in (rows, other_rows))
    largest = [max(abs(row[column]) for row in rows) for column in range(len(names))]
    for column, name in enumerate(names):
        if name in left_out:
            continue
        of_unit = max(size for size, other in zip(largest, names) if unit_of(other) == unit_of(name))
        scale = max(floor, largest[column], floor_share * of_unit)
        deviation, time = max((abs(a[column] - b[column]), a[0]) for a, b in zip(rows, other_rows))
        allowed = dict(of_fields).get(name.rpartition(": ")[2].partition(" [")[0], tolerance)
        print(f"  {name}: {deviation / scale if scale > 0 else 0:.2g} of the largest magnitude, allowed {allowed:g}")
        if deviation > allowed * scale:
            raise TestFailure(f"column '{name}': off by {deviation:.3g} at time {time:.6g}, which is more than "
                              f"{allowed:g} of the largest magnitude {scale:.6g}")


def quantity(summary_file, name, probe=None):
    """The value of a quantity in summary.json; with several probes the probe must be told."""
    with open(summary_file, encoding="utf-8") as stream:
        quantities = json.load(stream)["quantities"]
    found = [q for q in quantities if q["name"] == name and probe in (None, q.get("probe", ""))]
    if len(found) != 1:
        there = ", ".join(f"{q.get('probe', '')}: {q['name']}".lstrip(": ") for q in quantities)
        raise TestFailure(f"{len(found)} quantities match '{name}'"
                          + (f" of '{probe}'" if probe else "") + f"; the run has: {there or 'none'}")
    if found[0]["value"] is None:
        raise TestFailure(f"'{name}' is not a finite number")
    return found[0]["value"]


def main(case):
    """Runs case(program, parameter_file, folder) with the three arguments every driver takes."""
    if len(sys.argv) != 4:
        sys.exit(f"usage: {os.path.basename(sys.argv[0])} PROGRAM CASE.prm WORKING_FOLDER")
    program, parameter_file, folder = (os.path.abspath(argument) for argument in sys.argv[1:])
    try:
        case(program, parameter_file, fresh_folder(folder))
    except TestFailure as failure:
        print(f"FAILED: {failure}")
        sys.exit(1)
    except OSError as error:
        print(f"FAILED: {error}")
        sys.exit(1)
    print("ok")
