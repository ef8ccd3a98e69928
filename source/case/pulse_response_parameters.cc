#include <continua/case/pulse_response_parameters.h>

namespace Continua
{
void PulseResponseParameters::read(ParameterSection section)
{
  section.add("Tolerance", tolerance, Dimensions::none,
              "There are enough points of the contour when the loads that have these frequencies "
              "alone differ at no time by more than this part of their largest value from those "
              "of the file [1].",
              Range::positive());
}
} // namespace Continua
