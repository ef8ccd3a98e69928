// The names of what a run can state: of the whole, of a probe, of any probe, and what is refused.

#include <continua/base/input_error.h>
#include <continua/base/quantity_names.h>
#include <continua/base/summary.h>

#include "../parameter_text.h"
#include "../unit_test.h"

namespace test_of_quantity_names
{
using namespace Continua;

UNIT_TEST(quantity_names)
{
  QuantityNames names, others;
  names.add("power residual");
  names.add("frequency", "tip");
  others.add("frequency", "wall: displacement y");
  names.add(others);
  check::is_true("of the whole", names.has("power residual", ""));
  check::is_true("of a probe", names.has("frequency", "tip"));
  check::is_true("not of the whole", !names.has("frequency", ""));
  check::is_true("of some probe", names.any_has("frequency") && !names.any_has("tip"));
  std::string labels;
  for (const std::string &label : names.labels())
    labels += label + "; ";
  check::equal("labels", labels,
               "power residual; tip: frequency; wall: displacement y: frequency; ");

  const auto refuse = [&names](const std::string &line)
  {
    ParameterFile file = parameters_of("subsection Expected\nset " + line + "\nend\n");
    const ParameterSection section = file.root().subsection("Expected");
    names.refuse_others(section, read_expected(section));
  };
  refuse("frequency = 1 Hz +- 1 %");
  refuse("wall: displacement y: frequency = 1 Hz +- 1 %");
  refuse("power residual = < 1e-9");
  check::throws<InputError>(
      "a misspelt name", [&]() { refuse("frequenzy = 1 Hz +- 1 %"); },
      "2: 'Expected/frequenzy'.*Did you mean 'frequency'");
  check::throws<InputError>(
      "of another probe", [&]() { refuse("tipp: frequency = 1 Hz +- 1 %"); },
      "Did you mean 'tip: frequency'");
  check::throws<InputError>(
      "of a probe, but it is the whole's", [&]() { refuse("tip: power residual = < 1e-9"); },
      "no run of this file states");
  check::throws<InputError>(
      "nothing near", [&]() { refuse("colour = < 1"); }, "doc/output.md");

  ParameterFile empty = parameters_of("");
  const ParameterSection section = empty.root();
  names.refuse_others(section, "Quantities",
                      std::vector<std::string>{"frequency", "tip: frequency"});
  check::throws<InputError>(
      "asked for in a list",
      [&]() { names.refuse_others(section, "Quantities", std::vector<std::string>{"tip: mass"}); },
      "'tip: mass'");

  // What no one announced is said of a summary that knows the names.
  Summary summary;
  summary.add({"frequency", 1., "Hz", "tip"});
  summary.add({"mass", 1., "kg", ""});
  bool all_passed = false;
  check::is_true("without names nothing is said", summary.check({}, all_passed).empty());
  summary.set_possible(names);
  const std::vector<std::string> lines = summary.check({}, all_passed);
  check::is_true("one quantity was not announced, and is named",
                 lines.size() == 1 && check::matches(lines.front(), "quantity mass,"));
}
} // namespace test_of_quantity_names
