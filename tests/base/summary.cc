// summary.json and the verdicts on the expected values.

#include <continua/base/input_error.h>
#include <continua/base/summary.h>

#include "../unit_test.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace test_of_summary
{
using namespace Continua;

namespace
{
const std::string file = "summary-test.json";

std::string written(const Summary &summary)
{
  summary.write(file);
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  std::filesystem::remove(file);
  return text.str();
}

std::string verdict(Summary &summary, const std::string &key, const std::string &text, bool &passed)
{
  return summary.check({parse_expected_value(key, text)}, passed).front();
}

void passes(Summary &summary,
            const std::string &key,
            const std::string &text,
            const std::string &line)
{
  bool passed = false;
  const std::string given = verdict(summary, key, text, passed);
  check::equal(key + " = " + text, (passed ? "passed: " : "failed: ") + given, "passed: " + line);
}

void fails(Summary &summary,
           const std::string &key,
           const std::string &text,
           const std::string &line)
{
  bool passed = true;
  const std::string given = verdict(summary, key, text, passed);
  check::equal(key + " = " + text, (passed ? "passed: " : "failed: ") + given, "failed: " + line);
}
} // namespace

UNIT_TEST(summary)
{
  Summary summary;
  bool passed = true;
  fails(summary, "frequency", "3 Hz +- 1 %",
        "check: frequency: FAILED: the run has no such quantity (it has none)");

  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  summary.add({"frequency", 99., "Hz", "tip"});
  summary.add({"frequency", 3.36, "Hz", "tip"});
  check::is_true("the later value of a quantity counts",
                 summary.quantities().size() == 1 && summary.quantities()[0].value == 3.36);
  summary.add({"energy residual", 2e-9, "1", ""});
  summary.add({"wave speed", 11.0, "m/s", "inlet"});
  summary.add({"wave speed", 12.0, "m/s", "outlet"});
  summary.add({"drift", -0.003, "m", ""});
  summary.add({"lost", not_a_number, "m", ""});

  const std::string all = "(it has frequency (tip), energy residual, wave speed (inlet), wave "
                          "speed (outlet), drift, lost)";
  passes(summary, "frequency", "3.3624 Hz +- 0.2 %",
         "check: frequency (tip): within 0.2 % of 3.3624 Hz");
  passes(summary, "tip: frequency", "3362.4 mHz +- 3 mHz",
         "check: frequency (tip): within 3 mHz of 3362.4 mHz");
  passes(summary, "frequency", "3.36 +- 0", "check: frequency (tip): within 0 of 3.36");
  fails(summary, "frequency", "3.2 Hz +- 0.2 %",
        "check: frequency (tip): FAILED: 3.36 Hz is 5 % off 3.2 Hz +- 0.2 %");
  fails(summary, "frequency", "3200 mHz +- 159 mHz",
        "check: frequency (tip): FAILED: 3360 mHz is 5 % off 3200 mHz +- 159 mHz");
  fails(summary, "frequency", "1 Hz +- 1 %",
        "check: frequency (tip): FAILED: 3.36 Hz is 236 % off 1 Hz +- 1 %");
  fails(summary, "frequency", "3.4 mm +- 1 %",
        "check: frequency (tip): FAILED: the quantity is in Hz, not in mm");
  fails(summary, "root: frequency", "3 Hz +- 1 %",
        "check: frequency (root): FAILED: the run has no such quantity " + all);
  fails(summary, "wave speed", "11 m/s +- 5 %",
        "check: wave speed: FAILED: several probes have it (inlet, outlet); name one: 'PROBE: "
        "wave speed'");
  passes(summary, "outlet: wave speed", "1200 cm/s +- 5 %",
         "check: wave speed (outlet): within 5 % of 1200 cm/s");
  passes(summary, "energy residual", "< 1e-8", "check: energy residual: below 1e-8");
  fails(summary, "energy residual", "< 1e-9",
        "check: energy residual: FAILED: 2e-09 is not below 1e-9");
  passes(summary, "frequency", "> 3 Hz", "check: frequency (tip): above 3 Hz");
  fails(summary, "frequency", "> 4 Hz",
        "check: frequency (tip): FAILED: 3.36 Hz is not above 4 Hz");
  fails(summary, "drift", "0 mm +- 1 mm", "check: drift: FAILED: -3 mm is 3 mm off 0 mm +- 1 mm");
  for (const std::string text : {"0 m +- 1 m", "< 1 m", "> 1 m"})
    fails(summary, "lost", text,
          "check: lost: FAILED: the value is not a finite number (expected " + text + ")");

  const std::vector<std::string> lines =
      summary.check({parse_expected_value("frequency", "3.36 Hz +- 1 %"),
                     parse_expected_value("drift", "1 mm +- 1 mm")},
                    passed);
  check::is_true("one failure fails all", !passed && lines.size() == 2);
  check::is_true("nothing expected passes", (summary.check({}, passed).empty() && passed));

  Summary small;
  small.set("version", "0.1.0");
  small.set("dirty", false);
  small.set("cells", 800);
  small.set("wall time", 0.25);
  small.set("dofs", std::map<std::string, double>{{"pressure", 451}, {"velocity", 3362}});
  small.set("libraries", std::map<std::string, std::string>{{"deal.II", "9.4.1"}});
  small.set("warnings", std::vector<std::string>{"a \"b\""});
  small.set("version", std::string("0.2.0"));
  small.set("residual", not_a_number);
  small.add({"frequency", 3.2, "Hz", "tip"});
  small.add({"lost", not_a_number, "m", ""});
  small.check({parse_expected_value("frequency", "3200 mHz +- 10 mHz"),
               parse_expected_value("lost", "< 1 m")},
              passed);
  check::equal("the file", written(small), R"({
  "version": "0.2.0",
  "dirty": false,
  "cells": 800,
  "wall time": 0.25,
  "dofs": {
    "pressure": 451,
    "velocity": 3362
  },
  "libraries": {
    "deal.II": "9.4.1"
  },
  "warnings": [
    "a \"b\""
  ],
  "residual": null,
  "quantities": [
    {
      "name": "frequency",
      "value": 3.2,
      "unit": "Hz",
      "probe": "tip"
    },
    {
      "name": "lost",
      "value": null,
      "unit": "m",
      "probe": ""
    }
  ],
  "checks": [
    {
      "name": "frequency",
      "probe": "tip",
      "criterion": "3200 mHz +- 10 mHz",
      "expected": 3200.0,
      "tolerance": 10.0,
      "unit": "mHz",
      "value": 3200.0,
      "passed": true
    },
    {
      "name": "lost",
      "probe": "",
      "criterion": "< 1 m",
      "expected": 1.0,
      "tolerance": null,
      "unit": "m",
      "value": null,
      "passed": false
    }
  ]
}
)");
  check::absolute("a number", small.number_of("wall time"), 0.25, 0.);
  check::is_true("numbers with names",
                 small.numbers_of("dofs") ==
                     std::map<std::string, double>{{"pressure", 451.}, {"velocity", 3362.}});
  check::is_true("what was not set", small.number_of("steps") == 0. &&
                                         small.numbers_of("steps").empty() &&
                                         small.number_of("version") == 0.);
  const Summary again = Summary::read(written(small));
  check::equal("read and written", written(again), written(small));
  check::absolute("a number that was read", again.number_of("cells"), 800., 0.);
  check::is_true("quantities that were read", again.quantities().size() == 2 &&
                                                  again.quantities()[0].value == 3.2 &&
                                                  again.quantities()[0].probe == "tip" &&
                                                  std::isnan(again.quantities()[1].value));
  Summary beats;
  beats.set("beats", Summary::Columns{{"time [s]", {0.8, 1.6}}, {"a, range", {std::nan(""), 2.5}}});
  const Summary::Columns table = Summary::read(written(beats)).columns_of("beats");
  check::is_true("a table, in its order",
                 table.size() == 2 && table[0].first == "time [s]" && table[0].second[1] == 1.6 &&
                     table[1].second.size() == 2 && std::isnan(table[1].second[0]) &&
                     table[1].second[1] == 2.5);
  check::is_true("no table", beats.columns_of("waves").empty());
  check::throws<RunError>(
      "no folder", [&small]() { small.write("no-such-folder/summary.json"); }, "No such file");
}
} // namespace test_of_summary
