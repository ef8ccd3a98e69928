#ifndef continua_tests_theory_waves_h
#define continua_tests_theory_waves_h

// What the tests of waves in tubes share.

#include <continua/theory/tube_wave_theory.h>

#include "../check.h"

#include <algorithm>
#include <cmath>

namespace waves
{
using namespace Continua;
constexpr double pi = 3.14159265358979323846;

inline TubeSection tube(const double radius,
                        const double thickness,
                        const double wall_density,
                        const double young,
                        const double poisson,
                        const double density,
                        const double viscosity)
{
  TubeSection section;
  section.inner_radius = radius;
  section.fluid.density = density;
  section.fluid.shear.viscosity = viscosity;
  Material wall;
  wall.density = wall_density;
  wall.compression = Compression::elastic(3. * (1. - 2. * poisson) / young);
  wall.shear.branches = {Branch{young / (2. * (1. + poisson))}};
  section.layer_thicknesses = {thickness};
  section.layers = {wall};
  return section;
}

inline double pulse(const double time, const double duration)
{
  return time > 0. && time < duration ? std::pow(std::sin(pi * time / duration), 2) : 0.;
}

inline std::vector<double> times_up_to(const double end, const double step)
{
  std::vector<double> times;
  for (unsigned int i = 0; i * step <= end; ++i)
    times.push_back(i * step);
  return times;
}

/// Time and value of the largest value, by a parabola.
inline std::pair<double, double> peak(const std::vector<double> &times,
                                      const std::vector<double> &values)
{
  const std::size_t n = std::max_element(values.begin() + 1, values.end() - 1) - values.begin();
  const double a = values[n - 1], b = values[n], c = values[n + 1];
  const double share = 0.5 * (a - c) / (a - 2. * b + c);
  return {times[n] + share * (times[1] - times[0]), b - 0.25 * (a - c) * share};
}

inline double largest_difference(const std::vector<double> &a, const std::vector<double> &b)
{
  double difference = 0., size = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    // A number that is not one is no agreement.
    if (!(std::abs(a[i] - b[i]) <= difference))
      difference = std::abs(a[i] - b[i]);
    size = std::max(size, std::abs(a[i]));
  }
  return a.size() == b.size() && size > 0. ? difference / size : 1e300;
}

} // namespace waves

#endif
