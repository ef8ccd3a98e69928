#ifndef continua_case_rules_case_checks_h
#define continua_case_rules_case_checks_h

#include <continua/case/case.h>

namespace Continua
{
/**
 * What no single section can check: first the rules between features (check_rules()), then what
 * depends on numbers, regions or the mesh: the rules of the analysis (AnalysisTraits::check),
 * whether pressure level and support determine the solution, whether the axis is one. Throws
 * InputError.
 */
template <int dim>
void check_case(const Case<dim> &input, ParameterSection root);
} // namespace Continua

#endif
