#ifndef continua_case_case_checks_h
#define continua_case_case_checks_h

#include <continua/case/case.h>

namespace Continua
{
/**
 * The rules across sections that no single one of them can check: whether pressure level and
 * support determine the solution, whether everything given has a meaning in this analysis, whether
 * the axis is one, and whether the linear solver fits. Throws InputError.
 */
template <int dim>
void check_case(const Case<dim> &input, ParameterSection root);
} // namespace Continua

#endif
