#include <continua/case/periodic_response_parameters.h>

namespace Continua
{
void PeriodicResponseParameters::read(ParameterSection section)
{
  section.add(
      "Tolerance", tolerance, Dimensions::none,
      "There are enough harmonics of the period when the last third of them changes none "
      "of Periodic state/Probes, at any time of the period, by more than this part of its "
      "range (largest less smallest value), and neither does what is left of the loads [1].",
      Range::positive());
  section.add("Most harmonics", most_harmonics,
              "Of the period; with more than these the run ends with a warning [1].", 6);
}
} // namespace Continua
