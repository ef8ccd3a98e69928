"""Shipped parameter files as runs: what they cost, whether they are up to date, and how they are performed side by side."""

import concurrent.futures
import glob
import math
import os
import re
import signal
import subprocess
import sys
import threading
import time

import continua

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DRIVER = os.path.join(ROOT, "tests", "drivers", "mesh_changes.py")
DRIVEN = os.path.join(ROOT, "tests", "mesh_changes", "long")
CHEAP = 60.0
CHECKPOINTS = "Output/Checkpoint wall time=5 min"
#: The verdict on a check that fails as its file says.
KNOWN = "known to fail"
SECONDS = {"s": 1.0, "second": 1.0, "seconds": 1.0, "min": 60.0, "minute": 60.0, "minutes": 60.0, "h": 3600.0}


def is_piece(path):
    """Whether it is no case but what several cases include."""
    return os.path.basename(os.path.dirname(os.path.abspath(path))) == "common"


def shipped_files():
    every = glob.glob(os.path.join(ROOT, "parameter_files", "**", "*.prm"), recursive=True)
    return sorted(path for path in every if not is_piece(path))


def driven_files():
    """Long cases that a driver of the test suite runs: the same on several numbers of ranks."""
    return sorted(glob.glob(os.path.join(DRIVEN, "*.prm")))


def chosen_files(patterns):
    """The files the patterns name, sorted; a pattern that names none is an error."""
    files = []
    for pattern in patterns:
        found = glob.glob(pattern, recursive=True)
        found = found or glob.glob(os.path.join(ROOT, pattern), recursive=True)
        if not found:
            sys.exit(f"error: no parameter file matches {pattern}")
        files += [os.path.abspath(path) for path in found if path == pattern or not is_piece(path)]
    return sorted(set(files))


def name_of(path):
    """A short name that tells files in different folders apart."""
    folder = os.path.join(ROOT, "parameter_files")
    if path.startswith(folder + os.sep):
        path = os.path.relpath(path, folder)
    elif path.startswith(ROOT + os.sep):
        path = os.path.relpath(path, ROOT)
    return os.path.splitext(path)[0].lstrip(os.sep)


def texts_of(path):
    """[(path, text)] of a parameter file and of all that it includes, the file itself first."""
    result, waiting = [], [path]
    while waiting:
        path = waiting.pop(0)
        if path in (known for known, _ in result):
            continue
        try:
            with open(path, encoding="utf-8") as stream:
                text = stream.read()
        except OSError:
            continue
        result.append((path, text))
        included = re.findall(r"^\s*include\s+([^#\n]*[^#\s])", text, re.MULTILINE)
        waiting += [os.path.normpath(os.path.join(os.path.dirname(path), name)) for name in included]
    return result


def stated_cost(texts):
    """The seconds in the comment "Cost:" of the file, or of the first that it includes with one; infinite without one."""
    for _, text in texts:
        match = re.search(r"^#.*\bCost:\s*(.*)", text, re.MULTILINE)
        if not match:
            continue
        number = re.search(r"([\d.]+)\s*(s|seconds?|min|minutes?|h)\b", match.group(1))
        if number:
            return float(number.group(1)) * SECONDS[number.group(2)]
        if re.match(r"(a second|a few seconds|none to speak of)", match.group(1)):
            return 3.0
    return float("inf")


class ExpectedFailure:
    """What the comments `# expect:` of a file ask for: a run that fails with these words."""

    def __init__(self, text):
        lines = re.findall(r"^#\s*expect:\s*(.*?)\s*$", text, re.MULTILINE)
        self.status = next((int(line.split()[1]) for line in lines if re.fullmatch(r"status \d+", line)), None)
        self.patterns = [line for line in lines if not re.fullmatch(r"status \d+", line)]

    def __bool__(self):
        return self.status is not None

    def row(self, name, status, text, cost):
        missing = [pattern for pattern in self.patterns if not re.search(pattern, text, re.MULTILINE)]
        holds = status == self.status and bool(self.patterns) and not missing
        value = f"exit status {status}" + (f" without '{missing[0]}'" if missing else "")
        expected = f"exit status {self.status}: " + ", ".join(f"'{pattern}'" for pattern in self.patterns)
        return (name, "failure of the run", "passed" if holds else "FAILED", value, expected, cost)


class KnownFailures:
    """The checks that a file is known to miss, by the comments `# known to fail: QUANTITY: because REASON`."""

    def __init__(self, text):
        lines = re.findall(r"^#\s*known to fail:\s*(.*?)\s*$", text, re.MULTILINE)
        #: {quantity as the table names it: why}
        self.reasons = {}
        for line in lines:
            quantity, _, reason = line.partition(": because ")
            self.reasons[quantity] = reason

    def judge(self, rows):
        """The rows with the verdict KNOWN where a check fails as known; a check that holds all the same, or that the run does not have, FAILED."""
        result = []
        for row in rows:
            if row[1] in self.reasons and row[2] == "FAILED":
                row = (*row[:2], KNOWN, *row[3:])
            elif row[1] in self.reasons:
                row = (*row[:2], "FAILED", row[3], f"{row[4]}, which is known to fail: remove this comment", row[5])
            result.append(row)
        names = {row[1] for row in rows}
        result += [(rows[0][0], quantity, "FAILED", "no such check", "one that is known to fail", rows[0][5])
                   for quantity in self.reasons if quantity not in names]
        return result


def newest_input(texts, program):
    """When the last of the parameter file, its pieces, its tables and meshes, and the program was changed."""
    files = [program]
    for path, text in texts:
        files.append(path)
        words = re.findall(r"[\w./-]+\.(?:csv|geo|msh)\b", text)
        files += [os.path.join(os.path.dirname(path), word) for word in words]
    return max(os.path.getmtime(path) for path in files if os.path.exists(path))


def read_summary(output):
    """The summary of a run; empty for one that has none which can be read."""
    try:
        return continua.open(output).summary
    except continua.ResultsError:
        return {}


def cost_of(summary):
    """Seconds on the clock, those before restarts included; none where the run does not say."""
    times = summary.get("wall time [s]")
    total = times.get("total") if isinstance(times, dict) else None
    if total is None:
        return "-"
    return f"{total + summary.get('wall time before the restart [s]', 0.0):.3g} s"


def number(value, unit):
    if value is None:
        return "none"
    return f"{value:.5g}" + ("" if unit in ("", "1") else f" {unit}")


def row_of_check(name, check, cost):
    quantity = check["name"] + (f" ({check['probe']})" if check.get("probe") else "")
    verdict = "passed" if check["passed"] else "FAILED" if check["passed"] is False else "not compared"
    return (name, quantity, verdict, number(check["value"], check["unit"]), check["criterion"], cost)


def version_of(program):
    """The first line of --version; empty where the program is not there."""
    try:
        text = subprocess.run([program, "--version"], capture_output=True, text=True, check=False).stdout
    except OSError:
        return ""
    return text.splitlines()[0] if text else ""


class Runs:
    """Starts runs, and ends those that go on when it is told to."""

    def __init__(self, program, folder, keep):
        self.program, self.folder, self.keep = program, folder, keep
        self.lock = threading.Lock()
        self.processes, self.stopped = [], False
        self.performed = set()  # the names of the files that were run, not kept

    def stop(self):
        with self.lock:
            self.stopped = True
            for process in self.processes:
                if process.poll() is None:
                    process.send_signal(signal.SIGINT)

    def perform(self, arguments, command=None):
        """(exit status, what was printed) of the program, or of another command."""
        with self.lock:
            if self.stopped:
                return None, ""
            # A session of its own: Ctrl-C comes from stop() alone, once.
            process = subprocess.Popen([*(command or [self.program]), *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                       stderr=subprocess.STDOUT, text=True, errors="replace", start_new_session=True)
            self.processes.append(process)
        text, _ = process.communicate()
        with self.lock:
            self.processes.remove(process)
        return process.returncode, text

    def run(self, path):
        """(rows of the table, what to show of a run that went wrong, how it came about); no rows when stopped."""
        name, texts = name_of(path), texts_of(path)
        output = os.path.join(self.folder, name)
        if path.startswith(DRIVEN + os.sep):
            return self.drive(path, name, output, newest_input(texts, self.program))
        failure, known = ExpectedFailure(texts[0][1]), KnownFailures(texts[0][1])
        newest = newest_input(texts, self.program)

        def is_newer(*names):
            file = os.path.join(output, *names)
            return os.path.exists(file) and os.path.getmtime(file) > newest

        if self.keep and is_newer("summary.json"):
            summary = read_summary(output)
            if summary.get("status") == "finished" and not failure:
                return known.judge(self.rows(name, 0, summary)), "", "kept"
            if summary.get("status") == "failed" and failure:
                return [failure.row(name, failure.status, "error: " + summary.get("failure", ""), cost_of(summary))], "", "kept"
        arguments = [path, "--output", output]
        # Only a long run is worth it; what is long is a run in time, which can go on from a checkpoint.
        if stated_cost(texts) > 5 * CHEAP and not failure and re.search(r"Analysis\s*=\s*transient", texts_text(texts)):
            arguments += ["--set", CHECKPOINTS]
        how = "run"
        status, text = 2, ""
        if self.keep and is_newer("checkpoint", "current") and read_summary(output).get("status") != "finished":
            status, text = self.perform([*arguments, "--restart"])
            how = "continued"
        if status == 2:
            status, text = self.perform([*arguments, "--overwrite"])
            how = "run"
        if status is None or self.stopped:
            return [], "", "stopped"
        self.performed.add(name)
        summary = read_summary(output)
        if failure:
            rows = [failure.row(name, status, text, cost_of(summary))]
        else:
            rows = self.rows(name, status, summary if status in (0, 1) else {})
            # A run that did not end has no checks to judge.
            rows = known.judge(rows) if summary.get("checks") and status in (0, 1) else rows
        wrong = any(row[2] == "FAILED" for row in rows) and (failure or status != 0)
        return rows, "\n".join(text.splitlines()[-15:]) if wrong else "", how

    def drive(self, path, name, output, newest):
        """As run(), of a case that a driver of the test suite runs."""
        passed = os.path.join(output, "passed")
        kept = self.keep and os.path.exists(passed) and os.path.getmtime(passed) > newest
        start = time.monotonic()
        status, text = (0, "") if kept else self.perform([self.program, path, output], [sys.executable, "-B", DRIVER])
        if status is None or self.stopped:
            return [], "", "stopped"
        if not kept:
            self.performed.add(name)
        if status == 0 and not kept:
            with open(passed, "w", encoding="utf-8") as stream:
                stream.write(f"{time.monotonic() - start:.3g} s")
        cost = f"{time.monotonic() - start:.3g} s"
        if status == 0:
            with open(passed, encoding="utf-8") as stream:
                cost = stream.read()
        row = (name, "the same on all numbers of ranks", "FAILED" if status else "passed", f"exit status {status}", "0", cost)
        return [row], "" if status == 0 else "\n".join(text.splitlines()[-15:]), "kept" if kept else "run"

    @staticmethod
    def rows(name, status, summary):
        cost = cost_of(summary)
        checks = summary.get("checks", [])
        rows = [row_of_check(name, check, cost) for check in checks]
        if status != 0:
            rows.append((name, "the run", "FAILED", f"exit status {status}", "0", cost))
        elif not checks:
            rows.append((name, "the run", "FAILED", "expects nothing", "at least one value", cost))
        return rows


def texts_text(texts):
    return "\n".join(text for _, text in texts)


def remaining_text(costs, done, spent, n_jobs):
    """"about 3 min left": what is left of the stated costs, as much slower or faster as what was done was."""
    known = sum(costs[path] for path in done if math.isfinite(costs[path]))
    left = sum(cost for path, cost in costs.items() if path not in done and math.isfinite(cost))
    if spent <= 0 or known <= 0 or left <= 0:
        return ""
    seconds = left * min(max(n_jobs * spent / known, 0.2), 5.0) / n_jobs
    return f", about {seconds:.0f} s left" if seconds < 100 else f", about {seconds / 60:.0f} min left"


def perform_all(runs, files, n_jobs):
    """{file: rows}; of those that were done when it was stopped."""
    result = {}
    costs = {path: stated_cost(texts_of(path)) for path in files}
    performed, start = set(), time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(max_workers=n_jobs) as pool:
        waiting = {pool.submit(runs.run, path): path for path in files}
        try:
            for done in concurrent.futures.as_completed(waiting):
                path = waiting[done]
                rows, text, how = done.result()
                if not rows:
                    continue
                result[path] = rows
                if how == "kept":
                    costs[path] = 0.0
                performed.add(path)
                n_passed = sum(row[2] == "passed" for row in rows)
                print(f"[{len(result)}/{len(files)}] {name_of(path)}: {n_passed} of {len(rows)} hold ({how}, {rows[0][5]})"
                      f"{remaining_text(costs, performed, time.monotonic() - start, n_jobs)}", file=sys.stderr, flush=True)
                if text:
                    print(text, file=sys.stderr, flush=True)
        except KeyboardInterrupt:
            print("stopped; runs that go on end after their step", file=sys.stderr, flush=True)
            for future in waiting:
                future.cancel()
            runs.stop()
    return result
