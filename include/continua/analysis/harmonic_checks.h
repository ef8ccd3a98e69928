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
// What a HarmonicSystem has not is refused before, by the rules between features (see Rule).

/// Refuses probes whose numbers are not linear in the motion, and have no amplitude. `remedy`:
/// another way, "use Analysis = transient". Throws InputError.
template <int dim>
void check_harmonic_probes(const Case<dim> &input,
                           ParameterSection root,
                           const std::string &remedy);

/// Refuses the mean pressure of an absorbing end, about which waves would go.
void check_no_mean_pressure(const Problem &problem,
                            ParameterSection root,
                            const std::string &remedy);
/// Refuses what belongs to a state that is not there: beside the mean pressure of an absorbing end
/// the initial pressure of a windkessel.
void check_no_states(const Problem &problem, ParameterSection root, const std::string &remedy);

/// Refuses what a small motion about the state at rest under the loads of the file, in finite
/// deformation, has not. Throws InputError.
template <int dim>
void check_loaded_state(const Case<dim> &input, ParameterSection root, const std::string &remedy);

/// The system of a run that was initialised, its solver named in log.txt. Throws RunError where the
/// discretisation has none, which a rule refuses before.
template <int dim>
std::unique_ptr<HarmonicSystem<dim>> harmonic_system_of(Run<dim> &run);
} // namespace Continua

#endif
