#ifndef continua_case_rules_deformation_checks_h
#define continua_case_rules_deformation_checks_h

#include <continua/case/case.h>

namespace Continua
{
/// The rules of Deformation across sections: what has no place, or none so far, in finite
/// deformation, and entries that a small one makes no use of. Throws InputError.
template <int dim>
void check_deformation(const Case<dim> &input, ParameterSection root);
} // namespace Continua

#endif
