#include <continua/inference/fit_parameter.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace Continua
{
double FitParameter::coordinate(const double value) const
{
  return scale == Scale::logarithmic ? std::log(value) : value;
}

double FitParameter::value(const double coordinate) const
{
  return scale == Scale::logarithmic ? std::exp(coordinate) : coordinate;
}

double FitParameter::value_per_coordinate(const double at) const
{
  return scale == Scale::logarithmic ? at : 1.;
}

double FitParameter::size() const
{
  if (scale == Scale::logarithmic)
    return 1.;
  double size = std::numeric_limits<double>::infinity();
  for (const double candidate :
       {std::abs(start), upper - lower, prior ? prior->standard_deviation : 0.})
    if (candidate > 0. && candidate < size)
      size = candidate;
  return size;
}

void check_fit_parameters(const std::vector<FitParameter> &parameters)
{
  std::set<std::string> names;
  for (const FitParameter &parameter : parameters)
  {
    const auto refuse = [&](const std::string &problem)
    { throw std::invalid_argument("the parameter '" + parameter.name + "' " + problem); };
    if (!names.insert(parameter.name).second)
      refuse("is there twice");
    if (!std::isfinite(parameter.start) || std::isnan(parameter.lower) ||
        std::isnan(parameter.upper))
      refuse("has a start or a bound that is not a number");
    if (parameter.lower > parameter.upper)
      refuse("has a lower bound above its upper bound");
    if (parameter.start < parameter.lower || parameter.start > parameter.upper)
      refuse("starts outside of its bounds");
    if (parameter.prior && !(std::isfinite(parameter.prior->mean) &&
                             std::isfinite(parameter.prior->standard_deviation) &&
                             parameter.prior->standard_deviation > 0.))
      refuse("has a prior whose standard deviation is not positive");
    if (parameter.scale == FitParameter::Scale::logarithmic)
    {
      if (!(parameter.start > 0.) || (std::isfinite(parameter.lower) && parameter.lower < 0.))
        refuse("has a logarithmic scale, and a start or a lower bound that is not positive");
      if (parameter.prior && !(parameter.prior->mean > 0.))
        refuse("has a logarithmic scale, and a prior whose mean is not positive");
    }
    if (!parameter.is_held() && !std::isfinite(parameter.size()))
      refuse("starts at 0 and has no size: it needs two bounds or a prior");
  }
}
} // namespace Continua
