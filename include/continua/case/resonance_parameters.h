#ifndef continua_case_resonance_parameters_h
#define continua_case_resonance_parameters_h

#include <continua/base/parameter_section.h>

namespace Continua
{
/// The section Resonances: which resonances of a body are sought, and how.
struct ResonanceParameters
{
  double lowest = 0., highest = 0.;   ///< of |s|/(2 pi) [Hz]
  double largest_damping_ratio = 0.9; ///< a motion with more damping is no resonance [1]
  double tolerance = 1e-8;            ///< of the rational approximation between the frequencies [1]
  unsigned int most_frequencies = 200;
  unsigned int loads_in_a_region = 2;
  bool counts = true; ///< by the winding of the determinant

  /// Throws InputError.
  void read(ParameterSection section);
};
} // namespace Continua

#endif
