#ifndef continua_case_case_checks_h
#define continua_case_case_checks_h

#include <continua/case/case.h>

namespace Continua
{
/**
 * The rules across sections that no single section can check: first those of the analysis
 * (AnalysisTraits::check), then those that hold for each analysis with fields: whether pressure
 * level and support determine the solution, whether the axis is one, and whether the linear solver
 * fits. Throws InputError.
 */
template <int dim>
void check_case(const Case<dim> &input, ParameterSection root);
} // namespace Continua

#endif
