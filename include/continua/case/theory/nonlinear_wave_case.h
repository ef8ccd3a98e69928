#ifndef continua_case_theory_nonlinear_wave_case_h
#define continua_case_theory_nonlinear_wave_case_h

#include <continua/case/theory/tube_wave_case.h>
#include <continua/network/nonlinear_tube_waves.h>

#include <memory>

namespace Continua
{
/// The nonlinear theory of a case that linear theory covers, about the mean pressure of the case.
/// Throws std::domain_error with the reason, a predicate of the tube, if there is none.
template <int dim>
std::unique_ptr<NonlinearTubeWaves> make_nonlinear_waves(const Case<dim> &input,
                                                         const TubeWaveCase &wave_case);

/// If Wave theory/Nonlinear is on: whether there is such a theory. Throws InputError.
template <int dim>
void check_nonlinear_waves(const Case<dim> &input, ParameterSection root);
} // namespace Continua

#endif
