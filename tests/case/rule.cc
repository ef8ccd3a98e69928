// A rule between features refuses an input that has both, with its sentence at the entry of the
// refused one, and lets every other input through.

#include "../parameter_text.h"
#include "tube_text.h"

#include <continua/base/input_error.h>
#include <continua/case/case.h>
#include <continua/case/rules/rule.h>
#include <continua/program/analyses.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <string>
#include <vector>

#include "../unit_test.h"

namespace test_of_rule
{
namespace
{
using namespace Continua;

/// A body whose input all rules of the program let through.
class Body
{
public:
  explicit Body(const std::string &of_file)
      : text(of_file),
        file(parameters_of(text)),
        input(analyses().read_case<2>(file, MPI_COMM_WORLD))
  {
  }

  /// What a list of rules says of it; empty: nothing.
  std::string answer(const std::vector<Rule> &rules)
  {
    try
    {
      check_rules(rules, input, file.root());
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "";
  }
  bool is_let_through(const std::vector<Rule> &rules) { return answer(rules).empty(); }

  /// "FILE:LINE: 'ENTRY': " of the line that sets `line` after `beginning`.
  std::string
  place(const std::string &beginning, const std::string &line, const std::string &entry) const
  {
    const std::size_t at = text.find(line, text.find(beginning));
    const auto lines = 1 + std::count(text.begin(), text.begin() + static_cast<long>(at), '\n');
    return std::string(parameter_file_of_the_test) + ":" + std::to_string(lines) + ": '" + entry +
           "': ";
  }

private:
  std::string text;
  ParameterFile file;
  Case<2> input;
};

Rule rule(const std::vector<std::string> &refused,
          const std::vector<std::string> &with,
          const std::string &reason = "the two do not go together")
{
  return {refused, with, reason, "Choose one of them"};
}

bool begins_with(const std::string &answer, const std::string &beginning)
{
  return answer.compare(0, beginning.size(), beginning) == 0;
}
} // namespace

UNIT_TEST(rule)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Body tube(tube_text::tube(tube_text::pulse()) + "subsection Probes\nsubsection wall\n"
                                                  "set Point = 0.4 m, 5.5 mm\n"
                                                  "set Fields = displacement y\nend\nend\n");
  check::is_true("the rules of the program", tube.is_let_through(rules()));
  check::is_true("no rule", tube.is_let_through({}));

  // Both are on: of a region, of the whole input.
  const std::string liquid = tube.place("subsection fluid", "set Type", "Materials/fluid/Type");
  const std::string answer = tube.answer({rule({"liquid"}, {"small deformation"})});
  check::is_true("both are on: place and sentence",
                 begins_with(answer, liquid + "the two do not go together"));
  check::is_true("both are on: remedy", answer.find("Choose one of them") != std::string::npos);
  check::is_true("of the whole input", begins_with(tube.answer({rule({"transient"}, {"liquid"})}),
                                                   tube.place("", "set Analysis", "Analysis")));

  // One of them is off, on either side.
  check::is_true("the refused one is off", tube.is_let_through({rule({"cell-wise"}, {"liquid"})}));
  check::is_true("the other one is off", tube.is_let_through({rule({"liquid"}, {"cell-wise"})}));
  check::is_true("both are off", tube.is_let_through({rule({"cell-wise"}, {"modal"})}));

  // Of several names any one is enough, and the first one that is on is refused.
  check::is_true(
      "one of several is on: refused",
      begins_with(tube.answer({rule({"modal", "liquid", "transient"}, {"taylor hood"})}), liquid));
  check::is_true("one of several is on: the other",
                 begins_with(tube.answer({rule({"liquid"}, {"modal", "taylor hood"})}), liquid));

  // Entries and sections that are given.
  const std::string step = tube.place("subsection Time", "set Time step", "Time/Time step");
  check::is_true("an entry that is given",
                 begins_with(tube.answer({rule({"set Time/Time step"}, {"liquid"})}), step));
  check::is_true("an entry that is not",
                 tube.is_let_through({rule({"set Time/Update"}, {"liquid"})}));
  check::is_true(
      "an entry of each region",
      begins_with(tube.answer({rule({"set Materials/<region>/Young's modulus"}, {"liquid"})}),
                  tube.place("subsection wall", "set Young's", "Materials/wall/Young's modulus")));
  check::is_true("a section that is given",
                 tube.answer({rule({"subsection Probes"}, {"liquid"})}).find("'Probes'") !=
                     std::string::npos);
  check::is_true("a section that is not",
                 tube.is_let_through({rule({"subsection Newton"}, {"liquid"})}));
  check::is_true("an entry of the other discretisation",
                 tube.is_let_through({rule({"set Cell-wise/Tolerance"}, {"liquid"})}));

  // The first rule that holds is the one that speaks.
  const std::vector<Rule> several = {rule({"liquid"}, {"cell-wise"}, "one"),
                                     rule({"transient"}, {"liquid"}, "two"),
                                     rule({"liquid"}, {"transient"}, "three")};
  check::is_true("the first rule that holds",
                 tube.answer(several).find(": two") != std::string::npos);
}
} // namespace test_of_rule
