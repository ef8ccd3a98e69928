#ifndef continua_case_rules_rule_rows_h
#define continua_case_rules_rule_rows_h

#include <continua/case/rules/rule.h>

namespace Continua
{
// Parts of rules().

/// Of convection, and of what is there with it alone.
std::vector<Rule> rules_of_convection();
/// One matrix serves all steps of explicit convection, so that nothing else may be nonlinear.
std::vector<Rule> rules_of_explicit_convection();
/// Of the cell-wise discretisation.
std::vector<Rule> rules_of_cells();
/// Of a cell-wise mesh whose vertices move before each step.
std::vector<Rule> rules_of_moving_cells();
/// Of linear solvers and of how the mesh is divided.
std::vector<Rule> rules_of_solvers();
} // namespace Continua

#endif
