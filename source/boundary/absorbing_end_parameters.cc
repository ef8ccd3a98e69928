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
  section.add(
      "Mean pressure", mean_pressure, Dimensions::pressure,
      "Pressure p0 of the state about which waves are small: the end lets those of p - p0 "
      "pass. In finite deformation the tube that goes on is under it. A search for a steady state "
      "before the start holds it at the end, and flow rates then count from those of that "
      "state.");
  has_mean_pressure = section.given("Mean pressure");
}
} // namespace Continua
