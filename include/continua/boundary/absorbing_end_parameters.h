#ifndef continua_boundary_absorbing_end_parameters_h
#define continua_boundary_absorbing_end_parameters_h

#include <continua/base/parameter_section.h>

namespace Continua
{
/// Over which band, and how closely, the impedance of an absorbing end follows that of the tube,
/// and about which state.
struct AbsorbingEndParameters
{
  double lowest_frequency = 0.;  ///< [Hz]; 0: that of the run
  double highest_frequency = 0.; ///< [Hz]; 0: that of the loads
  double tolerance = 5e-3;       ///< of the impedance, relative; see ImpedanceFit
  double mean_pressure = 0.;     ///< of the state about which waves are small [Pa]
  bool has_mean_pressure = false;

  /// Declares and reads the entries in the section of the condition. Throws InputError.
  void read(ParameterSection &section);
};
} // namespace Continua

#endif
