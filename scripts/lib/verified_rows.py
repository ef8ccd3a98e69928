"""What scripts/verify has found, with date, revision and cost, and what has changed since: DIR/rows.csv."""

import csv
import datetime
import os
import re
import subprocess

import case_runs

COLUMNS = ("parameter file", "check", "verdict", "value", "expected", "cost", "date", "revision")
#: What results depend on, beside the parameter file and what it includes.
CODE = ("source", "include", "CMakeLists.txt", "cmake")


def _file(folder):
    return os.path.join(folder, "rows.csv")


def read(folder):
    """{(parameter file, check): row} of all earlier calls; empty without any."""
    try:
        with open(_file(folder), encoding="utf-8", newline="") as stream:
            return {(row["parameter file"], row["check"]): row for row in csv.DictReader(stream)}
    except FileNotFoundError:
        return {}


def keep(folder, rows, performed, program):
    """Adds the rows of this call; those of earlier calls stay for the files that it did not run. `performed`: the names of the files that were
    run now; the others are kept runs, whose rows keep their date."""
    revision = re.search(r"\((\w+)", case_runs.version_of(program))
    known = read(folder)
    names = {row[0] for row in rows}
    kept = {key: row for key, row in known.items() if key[0] not in names}
    for row in rows:
        before = known.get((row[0], row[1]))
        if before is None or row[0] in performed:
            when = (datetime.date.today().isoformat(), revision.group(1) if revision else "unknown")
        else:
            when = (before["date"], before["revision"])
        kept[row[0], row[1]] = dict(zip(COLUMNS, (*row, *when)))
    os.makedirs(folder, exist_ok=True)
    with open(_file(folder) + ".part", "w", encoding="utf-8", newline="") as stream:
        writer = csv.DictWriter(stream, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(kept[key] for key in sorted(kept))
    os.replace(_file(folder) + ".part", _file(folder))


def _changes(revision, root):
    """How many commits changed the code since; None for a revision that the checkout does not know."""
    done = subprocess.run(["git", "-C", root, "rev-list", "--count", f"{revision}..HEAD", "--", *CODE], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True, check=False)
    return int(done.stdout) if done.returncode == 0 else None


def with_age(rows, root=case_runs.ROOT):
    """Rows (..., date, revision, what has changed since)."""
    ages = {}
    for row in rows:
        revision = row["revision"]
        if revision not in ages:
            n_changes = _changes(revision, root)
            ages[revision] = ("unknown revision" if n_changes is None else "the same code" if n_changes == 0
                              else f"older than the code by {n_changes} change" + "s" * (n_changes > 1))
    return [(*(row[column] for column in COLUMNS), ages[row["revision"]]) for row in rows]
