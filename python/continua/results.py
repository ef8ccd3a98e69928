"""The results of a run or a study: a folder that Continua wrote."""

import functools
import json
import os
import re
import socket
import warnings

from .errors import ContinuaWarning, ResultsError
from .version import version as own_version

# What shows that a folder is one of Continua's.
_TABLES = ("amplification", "beats", "branches", "comparison", "correlation", "creep", "dispersion", "fit-creep", "fit-inflation", "fit-moduli",
           "fit-relaxation", "harmonic", "load-steps", "modes", "modulus", "power", "probes", "prony", "refinement", "relaxation",
           "relaxation-table", "residuals", "runs", "spin-coating", "sweep", "wave")
_MARKS = ("summary.json", "parameters.prm", "log.txt", "fields.pvd", "checkpoint", "other-files.txt", *(f"{name}.csv" for name in _TABLES))
_UNFINISHED = {"failed": "failed", "interrupted": "was interrupted", "running": "is still running", "killed": "was killed"}
_DAMAGED = "The file is damaged: copy it again, or remove it to read the tables without it"
# Folders of a run that are no runs of a study.
_OWN_FOLDERS = ("checkpoint", "fields", "input", "plots")


def open_results(folder):
    """The `Results` in a folder, such as "output/beam". The run need not have ended.

    Raises ResultsError if the folder is not there or holds no results. Gives a ContinuaWarning for results of another version of Continua.
    """
    return Results(folder)


class Results:
    """What a run or a study wrote into its folder. Made by `continua.open` and `continua.run`; `print(results)` shows what is there.

    folder   the path

    Each table is read when it is first asked for and then kept; open the folder again to see what a run has written since. What is not
    there raises ResultsError, whose text says why it is missing.
    """

    def __init__(self, folder):
        self.folder = os.fspath(folder)
        if not os.path.isdir(self.folder):
            if os.path.isfile(self.folder):
                remedy = f"Give the folder it is in: continua.open({os.path.dirname(self.folder) or '.'!r})"
                if self.folder.endswith(".prm"):
                    remedy = "Give the folder of the results, or run it: continua.run"
                raise ResultsError(self.folder, "this is a file, no folder", remedy)
            raise ResultsError(self.folder, "there is no such folder",
                               "A run writes into output/NAME, or into the folder after --output; a wrong input makes no folder")
        if not is_results(self.folder):
            inside = [name for name in sorted(os.listdir(self.folder)) if is_results(os.path.join(self.folder, name))]
            remedy = "Give the folder that the last line of a run names"
            if inside:
                remedy = f"There are results in the folders {', '.join(inside)} in it: open one of these"
            raise ResultsError(self.folder, "this folder has none of the files that a run of Continua writes, such as summary.json, "
                                            "parameters.prm or probes.csv", remedy)
        if self.has("summary.json"):
            self._check_version()

    def _check_version(self):
        other = self.summary.get("version")
        if other != own_version:
            written = f"Continua {other} wrote these results" if other else "summary.json does not name the version of Continua"
            warnings.warn(f"{self.folder}: {written}, and this package belongs to Continua {own_version}. Names of columns and entries may "
                          "differ. Use the package of that version, or repeat the run", ContinuaWarning, stacklevel=5)

    # How the run ended.

    @property
    def status(self):
        """"finished"; "failed" or "interrupted" with a `reason`; "running" while a process works in the folder; "killed" if the last process
        did not end by itself: it left its lock, or there is neither a summary nor a process."""
        if self._holder():
            return "running"
        if self._killed() or not self.has("summary.json"):
            return "killed"
        return self.summary.get("status", "unknown")

    @property
    def reason(self):
        """Why the run did not finish, in one text; "" for a finished run."""
        status = self.status
        if status == "running":
            return f"{self._holder()} works in the folder"
        if status == "killed" and self._killed():
            return (f"{self._killed()} left its lock in the folder and works no more: the program was killed, or the machine went down. "
                    "continua --restart goes on from a checkpoint if there is one")
        if status == "killed":
            return ("there is no summary, and no process has the lock of the folder: the program was killed, the machine went down, or the copy "
                    "is not complete. continua --restart goes on from a checkpoint if there is one")
        return self.summary.get("failure") or self.summary.get("interruption") or ""

    def _lock(self):
        """What the file `lock` says: (process, its number, its machine); None if there is no such file."""
        try:
            with open(os.path.join(self.folder, "lock"), encoding="utf-8", errors="replace") as stream:
                text = stream.readline()
        except OSError:
            return None
        match = re.match(r"Continua: (process (\d+) on (\S+) since .*)", text)
        return match.groups() if match else None

    def _holder(self):
        """The process that works in the folder; "" if there is none."""
        lock = self._lock()
        if lock is None:
            return ""
        process, number, machine = lock
        if machine != socket.gethostname():
            return process + " (another machine: whether it still runs cannot be seen from here)"
        return process if _has_lock(number) else ""

    def _killed(self):
        """The process that was killed in the folder after all others had ended, which left its file `lock`; "" if there is none."""
        lock = self._lock()
        # A run that ends removes the file before it gives up the lock.
        if lock is None or lock[2] != socket.gethostname() or _has_lock(lock[1]) or self._lock() != lock:
            return ""
        return lock[0]

    # What is there.

    def has(self, name):
        """Whether a file, such as "probes.csv", is there."""
        return os.path.exists(os.path.join(self.folder, name))

    def _path(self, name, why):
        """The path of a file. Raises ResultsError if it is missing; `why`: what a finished run without it lacks."""
        if not self.has(name):
            status = self.status
            if status not in _UNFINISHED:
                raise ResultsError(self.folder, f"the run wrote no {name}", why)
            raise ResultsError(self.folder, f"there is no {name}; the run {_UNFINISHED[status]}", self.reason[:1].upper() + self.reason[1:])
        return os.path.join(self.folder, name)

    def __repr__(self):
        return f"Results of {self.folder}: {self.status}"

    def __str__(self):
        lines = [repr(self) + (f": {self.reason}" if self.reason else "")]
        if self.has("summary.json"):
            lines += [f"  title: {self.summary.get('title', '')}",
                      f"  summary: {len(self.summary.get('quantities', []))} quantities, {len(self.summary.get('checks', []))} checks"]
        else:
            lines.append("  no summary")
        for name, units in self._headers().items():
            shown = units if name == "probes" else units[:3] + ["..."] if len(units) > 4 else units
            lines.append(f"  table {name}: {', '.join(shown)}")
        if self.has("fields.pvd"):
            lines.append("  fields")
        if self.runs:
            lines.append(f"  runs: {', '.join(self.runs)}")
        if self.missing_runs:
            lines.append(f"  runs that are not there: {', '.join(self.missing_runs)}")
        return "\n".join(lines)

    def _headers(self):
        from . import tables
        found = {}
        for name in self.tables:
            try:
                found[name] = [f"{column} [{unit}]" for column, unit in
                               tables.read_header(os.path.join(self.folder, name + ".csv")).items()]
            except ResultsError as error:
                found[name] = [error.problem]
        return found

    # The summary.

    @functools.cached_property
    def summary(self):
        """summary.json as a dictionary; the page of the manual on what a run writes has its entries. Values are in SI units, None for no
        finite number. A ContinuaWarning says so if this is the summary of the part before a restart, and the restarted run goes on or was
        killed."""
        path = self._path("summary.json", "")
        later = f"{self._holder()} works in the folder" if self._holder() else f"{self._killed()} was killed" if self._killed() else ""
        if later:
            warnings.warn(f"{path} is of an earlier part of the run: {later}", ContinuaWarning, stacklevel=2)
        try:
            with open(path, encoding="utf-8") as stream:
                summary = json.load(stream)
        except (OSError, ValueError) as error:
            raise ResultsError(path, f"cannot be read: {error}", _DAMAGED) from error
        problem = _problem_of_summary(summary)
        if problem:
            raise ResultsError(path, f"this is no summary of Continua: {problem}", _DAMAGED)
        return summary

    @functools.cached_property
    def quantities(self):
        """A pandas.DataFrame with a row for each quantity of the summary: `probe` ("" for the whole run), `name`, `value` (nan for no finite
        number) and `unit`."""
        import pandas
        rows = [(entry.get("probe", ""), entry["name"], entry["value"], entry.get("unit", "")) for entry in self.summary.get("quantities", [])]
        frame = pandas.DataFrame(rows, columns=["probe", "name", "value", "unit"])
        return frame.astype({"value": float})

    def quantity(self, name, probe=None):
        """The value [SI] of a quantity; `probe` may be left out if one probe alone has it, "" is the whole run.

        Raises ResultsError if there is none, or if several probes have it. nan stands for no finite number.
        """
        entries = self.summary.get("quantities", [])
        found = [entry for entry in entries if entry["name"] == name and probe in (None, entry.get("probe", ""))]
        if len(found) != 1:
            path = os.path.join(self.folder, "summary.json")
            label = f"'{name}'" + (f" of '{probe}'" if probe else "")
            if found:
                probes = ", ".join(repr(entry.get("probe", "")) for entry in found)
                raise ResultsError(path, f"several probes have {label}: {probes}", "Name one of them: quantity(name, probe)")
            others = sorted({entry["name"] for entry in entries if probe in (None, entry.get("probe", ""))})
            if not others:
                others = sorted({repr(entry.get("probe", "")) for entry in entries})
                raise ResultsError(path, f"there is no quantity {label}", f"There are the probes {', '.join(others) or '(none)'}")
            raise ResultsError(path, f"there is no quantity {label}", f"There are {', '.join(others)}")
        return float("nan") if found[0]["value"] is None else float(found[0]["value"])

    @functools.cached_property
    def checks(self):
        """A pandas.DataFrame with a row for each line of `Expected`: `probe`, `name`, `criterion` (a text), `value`, `unit`, `passed`.
        `passed` is missing (`pandas.NA`) where a change of the command line excludes the quantity, so that it was not compared."""
        import pandas
        columns = ["probe", "name", "criterion", "value", "unit", "passed"]
        rows = [[entry.get(column, "") for column in columns] for entry in self.summary.get("checks", [])]
        return pandas.DataFrame(rows, columns=columns).astype({"value": float, "passed": "boolean"})

    # Tables.

    @functools.cached_property
    def tables(self):
        """Names of the tables that are there, without ".csv", sorted."""
        return sorted(name[:-4] for name in os.listdir(self.folder) if name.endswith(".csv"))

    def table(self, name):
        """The table NAME.csv as a pandas.DataFrame of shape (rows, columns), with `attrs["units"]`: {column: unit}.

        Names of columns are those of the file without the unit. Columns of texts have texts. Raises ResultsError if it is not there or
        damaged.
        """
        if name not in self._tables:
            from . import tables
            there = f"There are the tables {', '.join(self.tables)}" if self.tables else "There are no tables"
            self._tables[name] = tables.read_table(self._path(name + ".csv", there))
        return self._tables[name]

    @functools.cached_property
    def _tables(self):
        return {}

    def _over_time(self, name, why):
        path = self._path(name + ".csv", why)
        if "time" not in self.table(name).columns:
            raise ResultsError(path, "the table has no column 'time'", "The file is damaged: copy it again, or repeat the run")
        frame = self.table(name).set_index("time")
        frame.attrs["units"] = self.table(name).attrs["units"]
        return frame

    @functools.cached_property
    def probes(self):
        """The probes over time: a pandas.DataFrame of shape (times, columns) with the time [s] as index and columns "PROBE: FIELD".

        `probes.attrs["units"]["tip: displacement y"]` is "m".
        """
        return self._over_time("probes", "The parameter file has no section Probes")

    @functools.cached_property
    def power(self):
        """The power balance: a pandas.DataFrame of shape (times, columns) with the end of the step [s] as index. Powers are in W and energies
        in J, of a metre of depth in the plane models; `attrs["units"]` has the units."""
        return self._over_time("power", "Transient analyses alone write it")

    @functools.cached_property
    def waves(self):
        """{probe: xarray.Dataset} of the probes with `Stations` in a tube.

        `waves["stations"]["pressure"]` has the shape (sources, stations, times) and the coordinates `source` ("simulated", "theory",
        "nonlinear theory" or "measured"), `position` [m] and `time` [s], and the unit in `attrs["units"]`. What a source does not have is nan. The differences
        between sources are columns of `table("wave")`.
        """
        from . import waves
        if not waves.paths_of_waves(self.folder):
            self._path("wave.csv", "No probe has Stations in a tube")
        found = waves.read_waves(self.folder)
        if not found:
            raise ResultsError(self.folder, "wave.csv has no rows", self.reason)
        return found

    @functools.cached_property
    def fields(self):
        """The states of the fields, a `continua.fields.Fields`: a sequence with `times` [s], whose members have a `dataset` (xarray) and a
        `grid` (VTK)."""
        from . import fields
        return fields.Fields(self._path("fields.pvd", "Set Output/Final fields = true or an Output/Field interval in the parameter file"))

    @functools.cached_property
    def log(self):
        """The text of log.txt."""
        path = self._path("log.txt", "")
        try:
            with open(path, encoding="utf-8", errors="replace") as stream:
                return stream.read()
        except OSError as error:
            raise ResultsError(path, f"cannot be read: {error.strerror}") from error

    # Studies.

    @functools.cached_property
    def runs(self):
        """{name: Results} of the runs of a comparison, a refinement study or another study, in their order; empty for a single run."""
        return {name: Results(os.path.join(self.folder, name)) for name in self._names_of_runs() if
                is_results(os.path.join(self.folder, name))}

    @property
    def missing_runs(self):
        """Names of the runs of a study that have no folder: not begun yet, or removed."""
        return [name for name in self._names_of_runs() if name not in self.runs]

    def _names_of_runs(self):
        path = os.path.join(self.folder, "other-files.txt")
        if not os.path.exists(path):
            return []
        try:
            with open(path, encoding="utf-8") as stream:
                lines = stream.read().splitlines()
        except (OSError, UnicodeDecodeError) as error:
            raise ResultsError(path, f"cannot be read: {getattr(error, 'strerror', None) or error}",
                               "The file is damaged: copy it again, or remove it to read the folder without the runs of a study") from error
        return [line[:-1] for line in lines if line.endswith("/") and line[:-1] not in _OWN_FOLDERS]


def _problem_of_summary(summary):
    """What is no summary, in words; "" if nothing is."""
    if not isinstance(summary, dict):
        return "it is no dictionary"
    for key in ("version", "status", "failure", "interruption", "title"):
        if not isinstance(summary.get(key), (str, type(None))):
            return f"'{key}' is no text"
    for key in ("quantities", "checks"):
        entries = summary.get(key, [])
        if not isinstance(entries, list):
            return f"'{key}' is no list"
        for number, entry in enumerate(entries):
            if not isinstance(entry, dict) or not isinstance(entry.get("name"), str) or not isinstance(entry.get("probe", ""), str):
                return f"entry {number} of '{key}' has no name"
            value = entry.get("value", "missing")
            if isinstance(value, bool) or not isinstance(value, (int, float, type(None))):
                return f"'value' of '{entry['name']}' in '{key}' is neither a number nor null"
    return ""


def _has_lock(process):
    """Whether a process of this machine has a lock. Its number alone could be that of a later process."""
    try:
        with open("/proc/locks", encoding="ascii") as stream:
            return any(line.split()[4] == process for line in stream)
    except OSError:
        return os.path.exists(f"/proc/{process}")


def is_results(folder):
    """Whether a folder holds one of the files that a run writes."""
    return os.path.isdir(folder) and any(os.path.exists(os.path.join(folder, name)) for name in _MARKS)
