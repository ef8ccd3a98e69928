#include <continua/boundary/absorbing_end_parameters.h>

namespace Continua
{
void AbsorbingEndParameters::read(ParameterSection &section)
{
  section.add("Lowest frequency", lowest_frequency, Dimensions::frequency,
              "Lower end of the band over which the impedance follows that of the tube; 0: "
              "1/(2 pi) of the inverse of the run's end time.",
              Range::not_negative());
  section.add("Highest frequency", highest_frequency, Dimensions::frequency,
              "Upper end of that band, in all of which the tolerance then holds alike; 0: where "
              "the spectrum of the loads has fallen to a thousandth, and an error counts as much "
              "as the loads from its frequency on.",
              Range::not_negative());
  section.add("Fit tolerance", tolerance, Dimensions::none,
              "Largest relative error of the impedance over the band. A wave comes back with half "
              "of the error.",
              Range{1e-6, 0.5, false, false});
}
} // namespace Continua
