#ifndef continua_analysis_periodic_checks_h
#define continua_analysis_periodic_checks_h

#include <continua/base/parameter_section.h>
#include <continua/case/case.h>

namespace Continua
{
/// Refuses what a periodic response has not: it is linear, or a small motion about a state in
/// finite deformation, and its loads repeat themselves. Throws InputError.
template <int dim>
void check_periodic_response(const Case<dim> &input, ParameterSection root);
} // namespace Continua

#endif
