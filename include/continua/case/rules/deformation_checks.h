#ifndef continua_case_rules_deformation_checks_h
#define continua_case_rules_deformation_checks_h

#include <continua/case/case.h>

namespace Continua
{
/// What no rule between features covers (see Rule) of finite deformation and of meshes that move:
/// what depends on numbers, on the mesh or on one boundary. Throws InputError.
template <int dim>
void check_deformation(const Case<dim> &input, ParameterSection root);
} // namespace Continua

#endif
