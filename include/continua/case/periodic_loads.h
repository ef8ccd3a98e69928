#ifndef continua_case_periodic_loads_h
#define continua_case_periodic_loads_h

#include <continua/case/case.h>

namespace Continua
{
/// The samples of probes.csv in a beat; whole after set_periodic_loads().
template <int dim>
std::size_t intervals_of_beat(const Case<dim> &input);

/**
 * Completes the section Periodic state of a case in time, whose conditions are read: finds the
 * period where it is not given, and gives it to all loads, which then have a mean over it. Throws
 * InputError unless the loads repeat themselves, the run has two beats and each beat has the same
 * times. To be called before the flow profiles and the outlets are made of the conditions.
 */
template <int dim>
void set_periodic_loads(Case<dim> &input, ParameterSection root);

/// Refuses a name in Periodic state/Probes that no probe has. After Probes::check().
template <int dim>
void check_compared_probes(const Case<dim> &input, const ParameterSection &section);
} // namespace Continua

#endif
