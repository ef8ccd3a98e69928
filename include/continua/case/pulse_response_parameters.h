#ifndef continua_case_pulse_response_parameters_h
#define continua_case_pulse_response_parameters_h

#include <continua/base/parameter_section.h>

namespace Continua
{
/// The section Pulse response: how closely the loads of a pulse are followed.
struct PulseResponseParameters
{
  double tolerance = 1e-3; ///< of the loads, over their largest value [1]

  /// Throws InputError.
  void read(ParameterSection section);
};
} // namespace Continua

#endif
