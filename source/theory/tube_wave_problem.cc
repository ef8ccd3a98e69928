#include <continua/theory/tube_wave_problem.h>

namespace Continua
{
double TubeWaveProblem::length() const
{
  double sum = 0.;
  for (const TubeSegment &segment : segments)
    sum += segment.length;
  return sum;
}
} // namespace Continua
