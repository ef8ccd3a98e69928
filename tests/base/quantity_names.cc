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
    std::vector<ExpectedValue> expected = read_expected(section);
    names.refuse_unknown(section, expected);
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
  std::vector<std::string> there = {"frequency", "tip: frequency"}, missing = {"tip: mass"};
  names.refuse_unknown(section, "Quantities", there);
  check::throws<InputError>(
      "asked for in a list", [&]() { names.refuse_unknown(section, "Quantities", missing); },
      "'tip: mass'");

  // A position in another unit than that of the name.
  names.add("height", "stations 0.043 m");
  names.add("maximum", "stations 0.2 m: flow rate");
  names.add("modulus", "harmonic at 0.5 Hz");
  names.add("height", "stations 7 mm"); // a probe that is called so
  std::vector<std::string> in_units = {"stations 43 mm: height", "stations 4.3cm: height",
                                       "stations 200 mm: flow rate: maximum",
                                       "harmonic at 500 mHz: modulus", "stations 7 mm: height"};
  names.refuse_unknown(section, "Quantities", in_units);
  std::string found;
  for (const std::string &name : in_units)
    found += name + "; ";
  check::equal("positions in any unit", found,
               "stations 0.043 m: height; stations 0.043 m: height; "
               "stations 0.2 m: flow rate: maximum; harmonic at 0.5 Hz: modulus; "
               "stations 7 mm: height; ");
  ParameterFile file = parameters_of("subsection Expected\nset stations 43 mm: height = < 1 m\n"
                                     "set stations 200 mm: flow rate: maximum = < 1\nend\n");
  const ParameterSection of_file = file.root().subsection("Expected");
  std::vector<ExpectedValue> expected = read_expected(of_file);
  names.refuse_unknown(file, of_file, expected);
  check::equal("an expected position", expected.at(0).probe, "stations 0.043 m");
  check::equal("an expected position of a field", expected.at(1).probe,
               "stations 0.2 m: flow rate");

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
