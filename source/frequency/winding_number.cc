#include <continua/frequency/winding_number.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
using Complex = std::complex<double>;

/// Parts of a side: the first step, and the longest one.
constexpr double first_step = 1e-6, longest_step = 0.125;
/// Difference of a phase from the predicted one that is accepted, and one after which the next
/// step is longer [rad].
constexpr double accepted_difference = 0.4, small_difference = 0.05;
/// The difference grows with the cube of the step: below the accepted one it is never a whole turn.
constexpr double growth_of_step = 2.;

/// One side of the contour, from 0 to 1.
using Side = std::function<Complex(double)>;

struct ContourWalk
{
  const std::function<Complex(Complex)> &logarithm;
  const std::size_t most_evaluations;
  std::size_t n_evaluations = 0;

  double phase(const Complex s)
  {
    ++n_evaluations;
    return logarithm(s).imag();
  }

  /// The change of the phase along a side; returns whether it is known.
  bool walk(const Side &side, double &change)
  {
    double place = 0., step = first_step, slope = 0., bend = 0., last_length = 0.;
    double before = phase(side(0.));
    bool has_slope = false;
    while (place < 1.)
    {
      if (n_evaluations >= most_evaluations || step < 1e-3 * first_step)
        return false;
      const double next = std::min(1., place + step), length = next - place;
      const double now = phase(side(next));
      // Slopes are those in the middle of a step. Of the phases that differ by whole turns that
      // next to the predicted one.
      const double predicted = (slope + 0.5 * bend * (last_length + length)) * length;
      const double off = std::remainder(now - before - predicted, 2. * M_PI);
      if (!(std::abs(off) < accepted_difference))
      {
        step *= 0.3;
        continue;
      }
      const double turned = predicted + off;
      change += turned;
      if (has_slope)
        bend = 2. * (turned / length - slope) / (last_length + length);
      slope = turned / length;
      last_length = length;
      before = now;
      place = next;
      // The first slope is that of a step so short that nothing is predicted.
      if (std::abs(off) < small_difference || !has_slope)
        step = std::min(longest_step, growth_of_step * length);
      else
        step = length;
      has_slope = true;
    }
    return true;
  }
};
} // namespace

WindingNumber winding_number(const std::function<Complex(Complex)> &logarithm,
                             const PlaneSector &sector,
                             const std::size_t most_evaluations)
{
  const double ratio = sector.outer / sector.inner, angle = sector.last_angle - sector.first_angle;
  const Side sides[4] = {
      [&](const double x)
      { return std::polar(sector.inner * std::pow(ratio, x), sector.first_angle); },
      [&](const double x) { return std::polar(sector.outer, sector.first_angle + x * angle); },
      [&](const double x)
      { return std::polar(sector.outer * std::pow(ratio, -x), sector.last_angle); },
      [&](const double x) { return std::polar(sector.inner, sector.last_angle - x * angle); }};
  ContourWalk walk{logarithm, most_evaluations};
  WindingNumber result;
  double change = 0.;
  result.is_known = std::all_of(std::begin(sides), std::end(sides),
                                [&](const Side &side) { return walk.walk(side, change); });
  result.n_evaluations = walk.n_evaluations;
  if (result.is_known)
    result.number = static_cast<int>(std::lround(change / (2. * M_PI)));
  return result;
}
} // namespace Continua
