#ifndef continua_case_rules_liquid_body_checks_h
#define continua_case_rules_liquid_body_checks_h

#include <continua/case/case.h>

namespace Continua
{
/// Of connected regions: an incompressible body must have somewhere to go, a cavity full of liquid
/// something that yields, and an unloaded shape the pressure of each liquid. Throws InputError.
template <int dim>
void check_bodies(const Case<dim> &input, ParameterSection root);
} // namespace Continua

#endif
