#ifndef continua_case_periodic_response_parameters_h
#define continua_case_periodic_response_parameters_h

#include <continua/base/parameter_section.h>

namespace Continua
{
/// The section Periodic response: how many harmonics a periodic state has.
struct PeriodicResponseParameters
{
  double tolerance = 1e-3; ///< of the last third of the harmonics, over the range of a probe [1]
  unsigned int most_harmonics = 200;

  /// Throws InputError.
  void read(ParameterSection section);
};
} // namespace Continua

#endif
