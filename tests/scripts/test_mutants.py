#!/usr/bin/python3
"""scripts/measure/mutants changes what it says it changes, and finds which tests notice it."""

import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
SCRIPT = os.path.join(ROOT, "scripts", "measure", "mutants")
sys.path.insert(0, os.path.join(ROOT, "scripts", "lib"))

import mutant_runs  # noqa: E402
import mutant_sites  # noqa: E402
import mutant_tree  # noqa: E402

# The suite may itself run with a mutant.
for variable in ("CONTINUA_MUTANT", "CONTINUA_MUTANTS_REACHED"):
    os.environ.pop(variable, None)

# Each place once. The comments state nothing that may be changed: 1 + 2.
SOURCE = '''#include <array>
#include <stdexcept>
#include <string>

const double outside = 3.5;

/// Area, or a message.
double area(const double width, const double height)
{
  if (width < 0.)
    throw std::runtime_error("too small: " + std::to_string(1 + 2));
  return width * height;
}

double last(const std::array<double, 3> &values, const unsigned int i)
{
  static const double once = 4.5;
  constexpr double always = 5.5;
  return values[i] + once - always;
}
'''


def others(text):
    """{(kind, before, after)} of a function's body, with the first of the possible changes."""
    sites = mutant_sites.sites_of("source/a.cc", f"void f()\n{{\n  {text}\n}}\n", lambda choices: choices[0])
    return {(site.kind, site.before, site.after) for site in sites}


class Sites(unittest.TestCase):
    def test_what_is_changed(self):
        sites = mutant_sites.sites_of("source/a.cc", SOURCE, lambda choices: choices[0])
        self.assertEqual([(site.line, site.kind, site.before, site.after) for site in sites],
                         [(10, "condition", "width < 0.", "!(width < 0.)"), (10, "comparison", "width < 0.", "width <= 0."),
                          (10, "constant", "0.", "1.0"), (12, "arithmetic", "width * height", "width / height"),
                          (19, "index", "i", "i + 1"), (19, "arithmetic", "values[i] + once", "values[i] - once"),
                          (19, "arithmetic", "values[i] + once - always", "values[i] + once + always")])

    def test_operands_follow_precedence(self):
        self.assertIn(("arithmetic", "b * c", "b / c"), others("x = a - b * c + d;"))
        self.assertIn(("arithmetic", "a - b * c", "a + b * c"), others("x = a - b * c + d;"))
        self.assertIn(("logical", "a && b == c", "a || b == c"), others("return a && b == c || d;"))
        self.assertIn(("arithmetic", "a + b", "a - b"), others("return g(c, a + b) ? d : e;"))

    def test_assignment_takes_its_right_side(self):
        self.assertIn(("arithmetic", "sum += c ? a : b", "sum -= c ? a : b"), others("if (d)\n sum += c ? a : b;"))

    def test_what_is_no_operator(self):
        self.assertEqual(others("const std::vector<double> *x = &y; auto &&z = std::move(w); using A = B<n - 1>;"), set())

    def test_what_stays(self):
        self.assertEqual(others('Assert(a + b > 1, ExcMessage("no")); AssertThrow(c < 2, E(3)); static_assert(d == 1);'), set())
        self.assertEqual(others('const std::string name = "p" + count + "of";'), set())
        self.assertEqual(others("switch (a)\n{\n case 3:\n break;\n}"), set())

    def test_initialisers_of_a_constructor(self):
        sites = mutant_sites.sites_of("source/a.cc", "A::A(const double x)\n  : B{2 * x},\n    c(x)\n{\n}\n", lambda choices: choices[0])
        self.assertIn("2 / x", [site.after for site in sites])


PROGRAM = '''#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sys/wait.h>
#include <unistd.h>

double area(double width, double height);
double never(double x);
double unseen(double x);
int spin(int n);

int main(int argc, char **argv)
{
  if (std::strcmp(argv[1], "fork") == 0)
  {
    // A server, whose children have the environment of a client: "CONTINUA_MUTANT" comes as the second argument. The third
    // one: the child reaches the place before it has the environment, too.
    std::printf("%g ", area(2., 3.));
    std::fflush(stdout);
    if (fork() == 0)
    {
      if (argc > 3)
        area(2., 3.);
      setenv("CONTINUA_MUTANT", argv[2], 1);
      std::printf("%g\\n", area(2., 3.));
      std::fflush(stdout);
      _exit(0);
    }
    wait(nullptr);
    return 0;
  }
  if (std::strcmp(argv[1], "area") == 0)
    return area(2., 3.) == 6. ? 0 : 1;
  if (std::strcmp(argv[1], "spin") == 0)
    return spin(3) == 3 ? 0 : 1;
  if (std::strcmp(argv[1], "abort") == 0)
  {
    unseen(1.);
    _exit(0);
  }
  return 1;
}
'''
LIBRARY = '''double area(double width, double height)
{
  return width * height;
}

double never(double x)
{
  return x - x;
}

double unseen(double x)
{
  return x + x;
}

int spin(int n)
{
  int i = 0;
  while (i != n)
    ++i;
  return i;
}

template <int n>
int constant()
{
  int values[1] = {n};
  return values[0];
}

struct OnlyPlus
{
  OnlyPlus operator+(const OnlyPlus &) const { return {}; }
};

OnlyPlus sum(const OnlyPlus &a, const OnlyPlus &b)
{
  return a + b;
}
'''
CMAKE = '''cmake_minimum_required(VERSION 3.18)
project(tiny LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
add_executable(tiny source/main.cc source/library.cc)
target_include_directories(tiny PRIVATE include)
enable_testing()
add_test(NAME prepare COMMAND ${CMAKE_COMMAND} -E touch prepared)
set_tests_properties(prepare PROPERTIES FIXTURES_SETUP prepared)
add_test(NAME area COMMAND sh -c "test -e prepared && \\"$0\\" area" $<TARGET_FILE:tiny>)
set_tests_properties(area PROPERTIES FIXTURES_REQUIRED prepared)
add_test(NAME spin COMMAND tiny spin)
add_test(NAME abort COMMAND tiny abort)
add_test(NAME broken COMMAND tiny broken)
'''


class TinyProgram(unittest.TestCase):
    """A program of its own goes through all steps."""

    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.folder = cls.holder.name
        cls.root = os.path.join(cls.folder, "checkout")
        os.makedirs(os.path.join(cls.root, "source"))
        for name, text in (("source/main.cc", PROGRAM), ("source/library.cc", LIBRARY), ("CMakeLists.txt", CMAKE)):
            with open(os.path.join(cls.root, name), "w", encoding="utf-8") as stream:
                stream.write(text)
        cls.list, cls.tree = (os.path.join(cls.folder, name) for name in ("list.json", "tree"))
        cls.build = os.path.join(cls.tree, "build")
        commands = os.path.join(cls.root, "build")
        # All places that compile: of the sum of two OnlyPlus the other operator does not, and `i != n` is there twice.
        cls.count = len(mutant_sites.sites_of("source/library.cc", LIBRARY, lambda choices: choices[0])) - 2
        cls.call(["cmake", "-S", cls.root, "-B", commands])
        cls.mutants("draw", cls.list, "--seed", "1", "--count", str(cls.count))
        with open(cls.list, encoding="utf-8") as stream:
            cls.drawn = json.load(stream)
        cls.mutants("apply", cls.list, "--tree", cls.tree, "--commands", commands)
        with open(cls.list, encoding="utf-8") as stream:
            cls.applied = json.load(stream)
        cls.call(["cmake", "-S", cls.tree, "-B", cls.build])
        cls.call(["cmake", "--build", cls.build])

    @classmethod
    def tearDownClass(cls):
        cls.holder.cleanup()

    @staticmethod
    def call(command, status=0):
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != status:
            raise AssertionError(f"{command}: exit status {done.returncode}\n{done.stdout}{done.stderr}")
        return done.stdout + done.stderr

    @classmethod
    def mutants(cls, *arguments, status=0):
        return cls.call([SCRIPT, "--root", cls.root, *arguments], status)

    def number(self, before):
        return next(str(mutant["id"]) for mutant in self.applied["mutants"] if mutant["before"] == before)

    def test_same_seed_same_list(self):
        other = os.path.join(self.folder, "other.json")
        self.mutants("draw", other, "--seed", "1", "--count", "5")
        with open(other, encoding="utf-8") as stream:
            self.assertEqual(json.load(stream)["mutants"], self.drawn["mutants"][:5])

    def test_what_does_not_compile_is_replaced(self):
        self.assertEqual(len(self.applied["mutants"]), self.count)
        reasons = {entry["before"]: entry["reason"] for entry in self.applied["refused"]}
        self.assertRegex(reasons["a + b"], "does not compile: .*operator-")
        self.assertNotIn("a + b", [mutant["before"] for mutant in self.applied["mutants"]])

    def test_goes_on_where_it_stopped(self):
        again = os.path.join(self.folder, "again.json")
        mutant_tree.write_json(again, {**self.drawn, **{key: self.applied[key] for key in ("compiled", "refused")}})
        printed = self.mutants("apply", again, "--tree", os.path.join(self.folder, "again"), "--commands", self.build)
        self.assertNotIn("mutants in source", printed)
        self.assertEqual(mutant_tree.read_list(again)["mutants"], self.applied["mutants"])

    def test_lines_stay(self):
        with open(os.path.join(self.tree, "source", "library.cc"), encoding="utf-8") as stream:
            lines = stream.read().split("#line 1\n")[1].splitlines()
        self.assertEqual(len(lines), len(LIBRARY.splitlines()))
        self.assertRegex(lines[2], r"return \(::continua_mutants::is_on\(\d+\) \? \(width / height\) : \(width \* height\)\);")

    def test_child_of_a_server_has_its_own_mutant(self):
        number = self.number("width * height")
        # The second case replaces a variable, the others add one.
        for inherited, late in (({}, []), ({"CONTINUA_MUTANT": "0"}, []), ({}, ["late"])):
            done = subprocess.run([os.path.join(self.build, "tiny"), "fork", number, *late], env={**os.environ, **inherited},
                                  capture_output=True, text=True, check=True)
            self.assertEqual(done.stdout, "6 0.666667\n", (inherited, late))

    def test_what_is_reached_is_noted(self):
        with tempfile.TemporaryDirectory() as reached:
            subprocess.run([os.path.join(self.build, "tiny"), "fork", "0", "late"], check=True, stdout=subprocess.DEVNULL,
                           env={**os.environ, "CONTINUA_MUTANTS_REACHED": reached})
            self.assertEqual(os.listdir(reached), [self.number("width * height")])

    def test_run_and_compare(self):
        result, other = (os.path.join(self.folder, name) for name in ("result.json", "other_result.json"))
        printed = self.mutants("run", self.list, "--build", self.build, "--result", result)
        self.assertIn("left out: broken: failed without a mutant", printed)
        with open(result, encoding="utf-8") as stream:
            contents = json.load(stream)
        outcome = contents["outcomes"][self.number("width * height")]
        self.assertEqual((outcome["state"], outcome["by"], outcome["how"]), ("killed", "area", "failed"))
        outcome = contents["outcomes"][self.number("i != n")]
        self.assertEqual((outcome["state"], outcome["by"]), ("killed", "spin"))
        self.assertEqual(contents["outcomes"][self.number("x - x")]["state"], "not reached")
        # The process ended by _exit, and its test looks at nothing.
        outcome = contents["outcomes"][self.number("x + x")]
        self.assertEqual((outcome["state"], outcome["n_reaching"]), ("survived", 1))

        # Once more: nothing but what sets up others runs.
        again = self.mutants("run", self.list, "--build", self.build, "--result", result)
        self.assertEqual(re.findall(r"^without a mutant: (\w+)", again, re.MULTILINE), ["prepare"])
        self.assertEqual(again[again.index("| mutant"):], printed[printed.index("| mutant"):])

        self.mutants("run", self.list, "--build", self.build, "--result", other, "--exclude", "area")
        compared = self.mutants("compare", result, other)
        first, second = compared.split("only the new suite kills:")
        self.assertIn("`width * height` to `width / height`: killed by area (failed), test 1 of 1; other suite: not reached", first)
        self.assertNotIn("width", second)
        n_killed = sum(outcome["state"] == "killed" for outcome in contents["outcomes"].values())
        self.assertIn(f"the old suite kills {n_killed}, the new one {n_killed - 1}", second)

    def test_cheap_tests_first_and_the_others_in_a_later_call(self):
        number, result = self.number("width * height"), os.path.join(self.folder, "cheap_first.json")
        os.makedirs(os.path.join(self.build, "test_times"))
        with open(os.path.join(self.build, "test_times", "area.time"), "w", encoding="utf-8") as stream:
            stream.write("2.5 0.5 4\n")
        cheap = self.mutants("run", self.list, "--build", self.build, "--result", result, "--at-most", "2.9")
        self.assertIn("left out: area: takes longer than --at-most", cheap)
        self.assertEqual(mutant_tree.read_json(result)["outcomes"][number]["state"], "not reached")
        further = self.mutants("run", self.list, "--build", self.build, "--result", result, "--at-most", "3.1")
        self.assertEqual(set(re.findall(r"^without a mutant: (\w+)", further, re.MULTILINE)), {"prepare", "area"})
        outcome = mutant_tree.read_json(result)["outcomes"][number]
        self.assertEqual((outcome["state"], outcome["by"]), ("killed", "area"))

    def test_wrong_input(self):
        self.assertIn("exists; remove it", self.mutants("apply", self.list, "--tree", self.tree, "--commands", self.build, status=1))
        self.assertIn("there is no such file", self.mutants("run", "/nowhere.json", "--build", self.build, status=1))
        with open(os.path.join(self.folder, "text.json"), "w", encoding="utf-8") as stream:
            stream.write("[]")
        self.assertIn("this is no list of mutants", self.mutants("run", stream.name, "--build", self.build, status=1))


class Processes(unittest.TestCase):
    def test_time_limit_ends_what_left_the_group(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "pid")
            test = mutant_runs.Test("sleeps", ["sh", "-c", f"setsid sh -c 'echo $$ >{path}; exec sleep 60' & sleep 60"], folder, {}, 60., 1,
                                    set(), set(), -1)
            result, _ = mutant_runs.run_test(test, {}, 1.)
            with open(path, encoding="utf-8") as stream:
                pid = int(stream.read())
            self.assertEqual(result, "timeout")
            try:
                with open(f"/proc/{pid}/stat", encoding="utf-8") as stream:
                    self.assertEqual(stream.read().split()[2], "Z")
            except FileNotFoundError:
                pass


class Picks(unittest.TestCase):
    def test_overlapping_sites(self):
        sites = mutant_sites.sites_of("source/a.cc", "int f(int a)\n{\n  return a + 1;\n}\n", lambda choices: choices[0])
        refused = {}
        picked = mutant_tree.pick(sites, 1, refused)
        self.assertEqual((list(picked), refused), ([1], {}))
        with self.assertRaisesRegex(mutant_tree.MutantsError, "only 1 mutants"):
            mutant_tree.pick(sites, 2, refused)
        self.assertEqual(refused, {2: "overlaps mutant 1"})


if __name__ == "__main__":
    unittest.main()
