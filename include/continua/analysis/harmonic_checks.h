#ifndef continua_analysis_harmonic_checks_h
#define continua_analysis_harmonic_checks_h

#include <continua/analysis/run.h>
#include <continua/base/parameter_section.h>
#include <continua/case/case.h>
#include <continua/continuum/harmonic_system.h>

#include <memory>
#include <string>

namespace Continua
{
/// What messages of these analyses recommend.
constexpr const char *remedy_of_harmonic = "use Analysis = transient";

// What a HarmonicSystem has not is refused before, by the rules between features (see Rule).

/// Whether the field of a probe is linear in the motion, so that it has an amplitude: no magnitude,
/// no average of one and no Q criterion.
bool is_linear_in_motion(const std::string &field);

/// Refuses probes whose numbers are not linear in the motion, and have no amplitude. `remedy`:
/// another way, "use Analysis = transient". `has_history`: fields which are not linear follow from
/// the motion at each time. Throws InputError.
template <int dim>
void check_harmonic_probes(const Case<dim> &input,
                           ParameterSection root,
                           const std::string &remedy,
                           bool has_history = false);

/// Refuses the mean pressure of an absorbing end, about which waves would go.
void check_no_mean_pressure(const Problem &problem,
                            ParameterSection root,
                            const std::string &remedy);
/// Refuses what belongs to a state that is not there: beside the mean pressure of an absorbing end
/// the initial pressure of a windkessel.
void check_no_states(const Problem &problem, ParameterSection root, const std::string &remedy);

/// Refuses what a small motion about a state at rest under loads, in finite deformation, has not.
/// Throws InputError.
template <int dim>
void check_loaded_state(const Case<dim> &input, ParameterSection root, const std::string &remedy);

/// Refuses loads that depend on time, by `in_time` and a remedy. Throws InputError.
template <int dim>
void check_no_loads_in_time(const Case<dim> &input,
                            ParameterSection root,
                            const std::string &in_time,
                            const std::string &remedy);
/// Refuses loads of the state about which the motion is small that depend on time.
template <int dim>
void check_no_loads_of_state_in_time(const Case<dim> &input,
                                     ParameterSection root,
                                     const std::string &remedy);

/// The system of a run that was initialised, its solver named in log.txt. Throws RunError where the
/// discretisation has none, which a rule refuses before.
template <int dim>
std::unique_ptr<HarmonicSystem<dim>> harmonic_system_of(Run<dim> &run);
} // namespace Continua

#endif
