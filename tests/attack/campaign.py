"""Performs the trials of an attack, several at a time, keeps those that failed, and counts."""

import collections
import concurrent.futures
import json
import os
import shlex
import shutil
import time
import traceback

from program import BAD, KINDS, Verdict


class Trial:
    """One trial: its name, which says all that it does; a folder of its own; what was run."""

    def __init__(self, name, folder):
        self.name, self.folder, self.runs = name, folder, []

    def note(self, done):
        """Keeps what a run printed, for the record of a failure."""
        self.runs.append(done)
        return done


class Campaign:
    """An attack has `name`, `summary`, corpus() and trials(number, seed), which list names of trials, prepare(folder),
    and perform(trial), which returns a Verdict."""

    def __init__(self, attack, folder, jobs, resume, command):
        self.attack, self.jobs, self.command = attack, jobs, command
        self.folder = os.path.join(os.path.realpath(folder), attack.name)
        self.record = os.path.join(self.folder, "trials.jsonl")
        if not resume:
            shutil.rmtree(self.folder, ignore_errors=True)
        os.makedirs(self.folder, exist_ok=True)
        self.counts = collections.Counter()
        self.failures = []
        self.seconds = 0.

    def earlier(self):
        """The trials of a campaign that was broken off."""
        try:
            with open(self.record, encoding="utf-8") as stream:
                return {entry["trial"]: Verdict(entry["verdict"], entry["note"]) for entry in map(json.loads, stream)}
        except FileNotFoundError:
            return {}

    def run(self, names):
        begin = time.monotonic()
        shared = os.path.join(self.folder, "shared")
        shutil.rmtree(shared, ignore_errors=True)
        os.makedirs(shared)
        self.attack.prepare(shared)
        # An attack may find its trials only now.
        names = list(dict.fromkeys(names() if callable(names) else names))
        done = self.earlier()
        for name in names:
            if name in done:
                self.count(name, done[name])
        left = [name for name in names if name not in done]
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool, \
                open(self.record, "a", encoding="utf-8") as record:
            for number, verdict, name in pool.map(self.perform, enumerate(left)):
                record.write(json.dumps({"trial": name, "verdict": verdict.kind, "note": verdict.note}) + "\n")
                record.flush()
                self.count(name, verdict)
                if verdict.kind in BAD:
                    print(f"  {verdict.kind}: {name}: {verdict.note}", flush=True)
        self.seconds = time.monotonic() - begin
        return self

    def perform(self, numbered):
        number, name = numbered
        folder = os.path.join(self.folder, f"trial-{number}")
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        trial = Trial(name, folder)
        try:
            verdict = self.attack.perform(trial)
        except Exception:  # pylint: disable=broad-except
            # A mistake of the attack must not pass for a success.
            verdict = Verdict("wrong", "the attack itself failed: " + traceback.format_exc().replace("\n", " | "))
        if verdict.kind in BAD:
            self.keep(trial, verdict)
        else:
            shutil.rmtree(folder, ignore_errors=True)
        return number, verdict, name

    def keep(self, trial, verdict):
        kept = os.path.join(self.folder, "failures", os.path.basename(trial.folder))
        shutil.rmtree(kept, ignore_errors=True)
        os.makedirs(os.path.dirname(kept), exist_ok=True)
        os.rename(trial.folder, kept)
        with open(os.path.join(kept, "trial.txt"), "w", encoding="utf-8", errors="replace") as stream:
            stream.write(f"{verdict.kind}: {verdict.note}\ntrial: {trial.name}\n"
                         f"again: {self.command} {self.attack.name} --trial {shlex.quote(trial.name)}\n\n")
            for done in trial.runs:
                stream.write(done.text() + "\n")

    def count(self, name, verdict):
        self.counts[verdict.kind] += 1
        if verdict.kind in BAD:
            self.failures.append((name, verdict))


COLUMNS = ("attack", "trials", "refused rightly", "accepted rightly", "wrong", "crash", "hang", "lost", "skipped")


def rows(campaigns):
    result = []
    for campaign in campaigns:
        counts = [campaign.counts[kind] for kind in KINDS]
        result.append([campaign.attack.name, str(sum(counts)), *map(str, counts)])
    if len(result) > 1:
        result.append(["all", *(str(sum(int(row[i]) for row in result)) for i in range(1, len(COLUMNS)))])
    return result


def table(campaigns, markdown):
    """The result, one line for each attack."""
    lines = [list(COLUMNS), *rows(campaigns)]
    if markdown:
        return "\n".join("| " + " | ".join(line) + " |" for line in
                         [lines[0], ["---"] + ["---:"] * (len(COLUMNS) - 1), *lines[1:]])
    widths = [max(len(line[i]) for line in lines) for i in range(len(COLUMNS))]
    return "\n".join("  ".join(cell.ljust(width) if i == 0 else cell.rjust(width)
                               for i, (cell, width) in enumerate(zip(line, widths))) for line in lines)
