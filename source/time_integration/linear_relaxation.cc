#include <continua/time_integration/linear_relaxation.h>

#include <cmath>

namespace Continua
{
LinearRelaxation::LinearRelaxation(const double step, const double relaxation_time)
{
  const double x = step / relaxation_time, mean = -std::expm1(-x) / x;
  decay = std::exp(-x);
  // Of short steps the first terms of the series, since the differences cancel there.
  constexpr double short_step = 1e-3;
  of_old = relaxation_time * (x < short_step ? x * (0.5 - x * (1. / 3. - x / 8.)) : mean - decay);
  of_new = relaxation_time * (x < short_step ? x * (0.5 - x * (1. / 6. - x / 24.)) : 1. - mean);
}
} // namespace Continua
