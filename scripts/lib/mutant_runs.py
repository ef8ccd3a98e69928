"""Runs the tests of a build for scripts/measure/mutants: once without a mutant, then each mutant by the tests that reach it."""

import concurrent.futures
import dataclasses
import glob
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import tempfile
import threading
import time
import uuid

from mutant_tree import MutantsError, read_json, write_json

# Each test's processes carry this variable: so they are found wherever they went, ranks of MPI, too.
MARK = "CONTINUA_MUTANTS_RUN"


@dataclasses.dataclass
class Test:
    name: str
    command: list
    folder: str
    environment: dict
    time_limit: float
    processors: int
    sets_up: set
    needs: set
    skip_status: int


def read_tests(build):
    """What ctest knows of the tests of a build, in ctest's order."""
    done = subprocess.run(["ctest", "--show-only=json-v1"], cwd=build, capture_output=True, text=True, check=False)
    try:
        described = json.loads(done.stdout)["tests"]
    except (ValueError, KeyError):
        raise MutantsError(f"{build}: ctest lists no tests there: {done.stderr.strip()}") from None
    tests, left_out = [], {}
    for entry in described:
        properties = {item["name"]: item["value"] for item in entry.get("properties", [])}
        not_known = {"WILL_FAIL", "PASS_REGULAR_EXPRESSION", "FAIL_REGULAR_EXPRESSION"} & set(properties)
        if "command" not in entry:
            left_out[entry["name"]] = "its program is not built"
        elif properties.get("DISABLED"):
            left_out[entry["name"]] = "disabled"
        elif not_known:
            left_out[entry["name"]] = f"has the property {not_known.pop()}, which this script does not know"
        else:
            tests.append(Test(entry["name"], entry["command"], properties.get("WORKING_DIRECTORY", build),
                              dict(item.split("=", 1) for item in properties.get("ENVIRONMENT", [])),
                              properties.get("TIMEOUT", 1500.), int(properties.get("PROCESSORS", 1)),
                              set(properties.get("FIXTURES_SETUP", [])), set(properties.get("FIXTURES_REQUIRED", [])),
                              properties.get("SKIP_RETURN_CODE", -1)))
    return tests, left_out


def last_time(build, name):
    """Processor seconds that a test took when it ran last in this build (tests/measured.c), or 0 if it did not run."""
    try:
        with open(os.path.join(build, "test_times", name + ".time"), encoding="utf-8") as stream:
            user, system, _ = map(float, stream.read().split())
    except (OSError, ValueError):
        return 0.
    return user + system


def end_all(mark):
    """Ends the processes of one test, also those that left its process group. Again, for those that started meanwhile."""
    found = True
    while found:
        found = False
        for path in glob.glob("/proc/[0-9]*/environ"):
            try:
                with open(path, "rb") as stream:
                    if f"{MARK}={mark}".encode() in stream.read().split(b"\0"):
                        os.kill(int(path.split("/")[2]), signal.SIGKILL)
                        found = True
            except OSError:
                pass  # has ended, or belongs to someone else


def limit_memory(gibibytes):
    """For this process and all that it starts, each. They may raise the limit again."""
    resource.setrlimit(resource.RLIMIT_CORE, (0, resource.getrlimit(resource.RLIMIT_CORE)[1]))
    if gibibytes:
        resource.setrlimit(resource.RLIMIT_AS, (int(gibibytes * (1 << 30)), resource.getrlimit(resource.RLIMIT_AS)[1]))


def run_test(test, variables, time_limit, stopped=None):
    """(result, seconds): "passed", "failed", "timeout", "skipped", or "stopped" if this event was set meanwhile."""
    mark = uuid.uuid4().hex
    inherited = {key: value for key, value in os.environ.items() if key not in ("CONTINUA_MUTANT", "CONTINUA_MUTANTS_REACHED")}
    begin = time.monotonic()
    # Into a file: a process that stays, such as a server, would keep a pipe open.
    with tempfile.TemporaryFile() as output:
        try:
            process = subprocess.Popen(test.command, cwd=test.folder, env={**inherited, **test.environment, **variables, MARK: mark},
                                       stdin=subprocess.DEVNULL, stdout=output, stderr=output, start_new_session=True)
        except OSError:
            return "failed", 0.
        result = None
        while result is None:
            try:
                status = process.wait(timeout=0.2)
                result = {0: "passed", test.skip_status: "skipped"}.get(status, "failed")
            except subprocess.TimeoutExpired:
                if time.monotonic() - begin > time_limit:
                    result = "timeout"
                elif stopped is not None and stopped.is_set():
                    result = "stopped"
        seconds = time.monotonic() - begin
        if result in ("failed", "timeout", "stopped"):
            end_all(mark)
            process.wait()
    return result, seconds


class Slots:
    """As many processors as tests may take together."""

    def __init__(self, n):
        self.n = self.free = n
        self.condition = threading.Condition()

    def take(self, n):
        with self.condition:
            self.condition.wait_for(lambda: self.free >= min(n, self.n))
            self.free -= min(n, self.n)

    def give(self, n):
        with self.condition:
            self.free += min(n, self.n)
            self.condition.notify_all()


class Suite:
    """The tests of a build, and the file of results, which is written after each step."""

    def __init__(self, contents, build, path, jobs, exclude, most_seconds, least_time_limit, say):
        self.mutants = contents["mutants"]
        self.path, self.jobs, self.say = path, jobs, say
        self.processor_seconds, self.least_time_limit = {}, least_time_limit
        self.result = {"build": build, "mutants": self.mutants, "plain": {}, "left out": {}, "unreliable": {}, "outcomes": {}}
        if os.path.exists(path):
            before = read_json(path)
            if before.get("mutants") != self.mutants or before.get("build") != build:
                raise MutantsError(f"{path} has results of other mutants or of another build; give --result another name")
            self.result = before
        tests, left_out = read_tests(build)
        for test in tests:
            self.processor_seconds[test.name] = last_time(build, test.name)
            if exclude and re.search(exclude, test.name):
                left_out[test.name] = "excluded by --exclude"
            elif not test.sets_up and test.name not in self.result["plain"] and self.processor_seconds[test.name] > most_seconds:
                left_out[test.name] = "takes longer than --at-most"
        self.tests = {test.name: test for test in tests if test.name not in left_out}
        # What is left out may differ from call to call, but for the tests that failed without a mutant.
        failed = {name: f"{plain['result']} without a mutant" for name, plain in self.result["plain"].items()
                  if plain["result"] != "passed"}
        self.result["left out"] = {**failed, **self.result["unreliable"], **left_out}
        self.save_lock = threading.Lock()

    def save(self):
        with self.save_lock:
            write_json(self.path, self.result)

    def setups_of(self, test):
        return [other for other in self.tests.values() if other.sets_up & test.needs]

    def run(self):
        self.run_plainly()
        for mutant in self.mutants:
            number = str(mutant["id"])
            outcome = self.result["outcomes"].setdefault(number, {"passed": []})
            if outcome.get("state") != "killed" and ("state" not in outcome or set(self.reaching(number)) - set(outcome["passed"])):
                self.judge(number, outcome)
            self.say(f"mutant {number}, {mutant['file']}:{mutant['line']}: {in_words(outcome)}")

    def run_plainly(self):
        """Every test without a mutant, but those that an earlier call ran. What sets up others runs first, and in each call."""
        for test in self.tests.values():
            if test.sets_up:
                self.run_one_plainly(test)
        others = [test for test in self.tests.values() if not test.sets_up and test.name not in self.result["plain"]]
        # Those of several ranks first, which need all processors; then the cheapest, so that a call that is stopped has judged most.
        others.sort(key=lambda test: (-test.processors, self.processor_seconds[test.name]))
        slots = Slots(self.jobs)

        def run(test):
            slots.take(test.processors)
            try:
                self.run_one_plainly(test)
            finally:
                slots.give(test.processors)

        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            for done in concurrent.futures.as_completed([pool.submit(run, test) for test in others]):
                done.result()
        self.save()

    def run_one_plainly(self, test):
        broken = [other.name for other in self.setups_of(test) if self.result["plain"][other.name]["result"] != "passed"]
        folder = tempfile.mkdtemp(prefix="mutants-reached-")
        try:
            result, seconds = ("failed", 0.) if broken else \
                run_test(test, {"CONTINUA_MUTANTS_REACHED": folder}, test.time_limit)
            reached = sorted(int(name) for name in os.listdir(folder))
        finally:
            shutil.rmtree(folder)
        # A set-up that runs again finds its work done: what it reached and took at first counts.
        before = self.result["plain"].get(test.name)
        if before is None or result != before["result"]:
            self.result["plain"][test.name] = {"result": result, "seconds": round(seconds, 2), "reached": reached}
        if result != "passed":
            reason = f"needs {broken[0]}, which failed" if broken else f"{result} without a mutant"
            self.result["left out"][test.name] = reason
        self.say(f"without a mutant: {test.name}: {result}, {seconds:.1f} s, {len(reached)} sites")
        self.save()

    def time_limit(self, name):
        """Of a test with a mutant."""
        return max(self.least_time_limit, 10. * self.result["plain"][name]["seconds"])

    def reaching(self, number):
        """The tests that reach a mutant, or that use what such a test set up; the cheapest first."""
        plain = self.result["plain"]
        reaching = {name for name in self.tests if name not in self.result["left out"] and int(number) in plain[name]["reached"]}
        reaching |= {name for name, test in self.tests.items() if name not in self.result["left out"] and
                     any(other.name in reaching for other in self.setups_of(test))}
        return sorted(reaching, key=lambda name: (plain[name]["seconds"], name))

    def judge(self, number, outcome):
        """Runs the tests until one fails with the mutant and passes once more without it."""
        begin = time.monotonic()
        names = self.reaching(number)
        set_up = [name for name in names if self.tests[name].sets_up]
        # An earlier call may have been stopped. What sets up others ran without the mutant since then.
        outcome["passed"] = [name for name in outcome["passed"] if name not in set_up]
        outcome["n_reaching"] = len(names)
        killer = None
        while killer is None:
            waiting = [name for name in names if name not in outcome["passed"] and name not in self.result["left out"]]
            if not waiting:
                break
            killer = self.first_failure(waiting, number, outcome)
            if killer is None:
                break
            # A test that fails by chance, or on a busy machine, kills nothing.
            test = self.tests[killer[0]]
            again, _ = run_test(test, {}, self.time_limit(test.name))
            if again != "passed":
                reason = f"{again} when it ran once more without a mutant"
                self.result["unreliable"][test.name] = self.result["left out"][test.name] = reason
                killer = None
        for name in set_up:
            self.run_one_plainly(self.tests[name])
        outcome["n_run"] = len(outcome["passed"]) + (killer is not None)
        if killer:
            outcome.update(state="killed", by=killer[0], how=killer[1])
        else:
            outcome["state"] = "survived" if names else "not reached"
        outcome["seconds"] = round(outcome.get("seconds", 0.) + time.monotonic() - begin, 1)
        if killer:
            del outcome["passed"]
        self.save()

    def first_failure(self, names, number, outcome):
        """(name, how it failed) of one of the tests, or None if all pass. What sets up others runs before all others, one by one."""
        stopped, slots, failures = threading.Event(), Slots(self.jobs), []

        def run(name):
            if stopped.is_set():
                return
            result, _ = run_test(self.tests[name], {"CONTINUA_MUTANT": number}, self.time_limit(name), stopped)
            if result in ("failed", "timeout"):
                stopped.set()
                failures.append((name, result))
            elif result != "stopped":
                outcome["passed"].append(name)
                self.save()

        def run_in_slots(name):
            slots.take(self.tests[name].processors)
            try:
                run(name)
            finally:
                slots.give(self.tests[name].processors)

        for name in names:
            if self.tests[name].sets_up:
                run(name)
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            for done in [pool.submit(run_in_slots, name) for name in names if not self.tests[name].sets_up]:
                done.result()
        return failures[0] if failures else None


def in_words(outcome):
    if outcome["state"] == "not reached":
        return "not reached by any test"
    if outcome["state"] == "survived":
        return f"survived {outcome['n_reaching']} tests"
    return f"killed by {outcome['by']} ({outcome['how']}), test {outcome['n_run']} of {outcome['n_reaching']}"
