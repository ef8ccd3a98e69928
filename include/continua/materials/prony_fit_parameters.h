#ifndef continua_materials_prony_fit_parameters_h
#define continua_materials_prony_fit_parameters_h

#include <continua/base/parameter_section.h>

namespace Continua
{
/// Over which band, and how closely, a Prony series follows a law that has no branches.
struct PronyFitParameters
{
  unsigned int n_branches = 0;   ///< beside the spring; 0: as few as meet the tolerance
  double lowest_frequency = 0.;  ///< [Hz]; 0: that of the run
  double highest_frequency = 0.; ///< [Hz]; 0: that of the run
  double tolerance = 5e-4;       ///< largest |fit/law - 1| of the complex modulus over the band

  /// Declares and reads the entries in the section of the material. Throws InputError.
  void read(ParameterSection &section);
};
} // namespace Continua

#endif
