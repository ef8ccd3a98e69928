#include <continua/inference/start_points.h>

#include <continua/signal/gsl_release.h>

#include <gsl/gsl_qrng.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace Continua
{
namespace
{
struct CoordinateRange
{
  double lower, upper;
};

CoordinateRange range_of_starts(const FitParameter &parameter)
{
  double centre = parameter.coordinate(parameter.start);
  double reach = 3. * parameter.size();
  if (parameter.prior)
  {
    centre = parameter.coordinate(parameter.prior->mean);
    reach = 2. * parameter.prior->standard_deviation /
            parameter.value_per_coordinate(parameter.prior->mean);
  }
  const double lower = parameter.coordinate(parameter.lower);
  const double upper = parameter.coordinate(parameter.upper);
  const bool has_both = std::isfinite(lower) && std::isfinite(upper) && !parameter.prior;
  CoordinateRange range{has_both ? lower : std::max(lower, centre - reach),
                        has_both ? upper : std::min(upper, centre + reach)};
  if (range.lower > range.upper)
    range = {lower, upper}; // a prior that lies outside of the bounds
  return range;
}
} // namespace

std::vector<std::vector<double>> start_points(const std::vector<FitParameter> &parameters,
                                              const unsigned int n_starts)
{
  std::vector<std::vector<double>> points(1);
  for (const FitParameter &parameter : parameters)
    points[0].push_back(parameter.start);
  const std::unique_ptr<gsl_qrng, GslRelease<gsl_qrng, gsl_qrng_free>> sequence(
      gsl_qrng_alloc(gsl_qrng_halton, parameters.size()));
  while (points.size() < n_starts)
  {
    std::vector<double> point(parameters.size());
    gsl_qrng_get(sequence.get(), point.data());
    for (std::size_t j = 0; j < parameters.size(); ++j)
    {
      const FitParameter &parameter = parameters[j];
      const CoordinateRange range = range_of_starts(parameter);
      point[j] =
          parameter.is_held()
              ? parameter.start
              : std::clamp(parameter.value(range.lower + point[j] * (range.upper - range.lower)),
                           parameter.lower, parameter.upper);
    }
    points.push_back(point);
  }
  return points;
}
} // namespace Continua
