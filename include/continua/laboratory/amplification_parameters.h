#ifndef continua_laboratory_amplification_parameters_h
#define continua_laboratory_amplification_parameters_h

#include <continua/laboratory/wave_scheme.h>

#include <vector>

namespace Continua
{
/// The section Amplification: schemes, Courant numbers and waves.
struct AmplificationParameters
{
  std::vector<WaveScheme> schemes = {WaveScheme::displacement_euler, WaveScheme::velocity_euler};
  std::vector<double> courant_numbers = {0.25, 0.5, 0.75, 1., 1.25, 2.}; ///< c dt/dx [1]
  unsigned int fewest_cells = 2;                                         ///< in a wavelength [1]
  unsigned int most_cells = 25;                                          ///< in a wavelength [1]
  bool runs = true; ///< whether each is also measured in a run

  /// Declares and reads; throws InputError.
  void read(ParameterSection section);
};
} // namespace Continua

#endif
