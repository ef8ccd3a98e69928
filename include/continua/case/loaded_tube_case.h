#ifndef continua_case_loaded_tube_case_h
#define continua_case_loaded_tube_case_h

#include <continua/case/case.h>
#include <continua/theory/loaded_tube.h>

namespace Continua
{
/// Whether linear wave theory has the waves about a loaded state: Deformation = finite.
template <int dim>
bool is_about_loaded_state(const Case<dim> &input)
{
  return !input.analysis.has_fields && input.problem.deformation == Deformation::finite;
}

/// Refuses what the theory of waves about a loaded state does not have. A case that is no tube of
/// liquid at all is left to others. Throws InputError.
template <int dim>
void check_loaded_tube(const Case<dim> &input, ParameterSection root);
} // namespace Continua

#endif
