#ifndef continua_case_theory_loaded_tube_case_h
#define continua_case_theory_loaded_tube_case_h

#include <continua/case/case.h>
#include <continua/theory/loaded_tube.h>
#include <continua/vessel/tube_law.h>

namespace Continua
{
/// Whether linear wave theory has the waves about a loaded state: Deformation = finite.
template <int dim>
bool is_about_loaded_state(const Case<dim> &input)
{
  return !input.analysis.has_fields && input.problem.deformation == Deformation::finite;
}

/// The section of the tube at z [m] of its axis, under a pressure [Pa] about which waves are small.
/// `condition` is the section whose entry Mean pressure gave it. Throws InputError where theory has
/// no such state.
template <int dim>
TubeSection loaded_section_at(const Case<dim> &input,
                              const TubeLaw &law,
                              double z,
                              double pressure,
                              const ParameterSection &condition,
                              ParameterSection root);

/// Refuses pressures at a time [s] under which the wall of a tube has no state at rest, such as
/// those beyond the largest one of rubber. What the theory of such states does not know passes.
/// Throws InputError.
template <int dim>
void check_largest_pressure(const Case<dim> &input, double time, ParameterSection root);

/// Refuses what the theory of waves about a loaded state does not have. A case that is no tube of
/// liquid at all is left to others. Throws InputError.
template <int dim>
void check_loaded_tube(const Case<dim> &input, ParameterSection root);
} // namespace Continua

#endif
