#ifndef continua_case_rules_rule_h
#define continua_case_rules_rule_h

#include <continua/case/case.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * Features that no input may have together: none of `refused` goes with any of `with`. Names are
 * those that FeaturesOfCase::place() takes. The error names the entry of the refused one, says the
 * reason and gives the remedy.
 */
struct Rule
{
  std::vector<std::string> refused, with;
  std::string reason, remedy;
};

/// All rules, in the order in which they are tried. To add one, add a row.
const std::vector<Rule> &rules();

/// Refuses an input with two features that exclude each other by one of the rules, the first of
/// them in their order. Throws InputError.
template <int dim>
void check_rules(const std::vector<Rule> &of_features,
                 const Case<dim> &input,
                 ParameterSection root);
} // namespace Continua

#endif
