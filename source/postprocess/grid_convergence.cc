#include <continua/postprocess/grid_convergence.h>

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace Continua
{
namespace
{
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr double lowest_order = 0.5;
constexpr double safety = 1.25, safety_without_order = 3.;

/// The p > 0 with r21^p (r32^p - 1) / (r21^p - 1) = ratio, which must exceed its limit at p = 0.
double solve_for_order(const double ratio, const double r21, const double r32)
{
  const double log21 = std::log(r21), log32 = std::log(r32);
  const auto excess = [&](const double p)
  {
    // In logarithms: it overflows for no order.
    return p * log21 + std::log(std::expm1(p * log32)) - std::log(std::expm1(p * log21)) -
           std::log(ratio);
  };
  std::uintmax_t n_iterations = 200;
  const auto bracket = boost::math::tools::bracket_and_solve_root(
      excess, 1., 2., true, boost::math::tools::eps_tolerance<double>(40), n_iterations);
  return 0.5 * (bracket.first + bracket.second);
}
} // namespace

GridConvergence::GridConvergence(const std::vector<double> &cell_sizes,
                                 const std::vector<double> &values,
                                 const ConvergenceOrders &orders,
                                 const double round_off)
    : order(undefined), limit(undefined), estimated_error(undefined)
{
  const std::size_t n = values.size();
  if (cell_sizes.size() != n)
    throw std::invalid_argument("as many cell sizes as values are needed");
  for (std::size_t i = 0; i < n; ++i)
    if (!(cell_sizes[i] > 0.) || (i > 0 && !(cell_sizes[i] < cell_sizes[i - 1])))
      throw std::invalid_argument("the cell sizes must be positive and decrease");
  if (n < 2)
    return;

  const double finest = values[n - 1], difference = finest - values[n - 2];
  const double r21 = cell_sizes[n - 2] / cell_sizes[n - 1];
  const auto extrapolate = [&](const double with_order, const double factor)
  {
    const double correction = difference / (std::pow(r21, with_order) - 1.);
    limit = finest + correction;
    estimated_error = factor * std::abs(correction);
  };
  if (std::abs(difference) <= round_off)
  {
    behaviour = Behaviour::settled;
    limit = finest;
    estimated_error = std::abs(difference);
    return;
  }
  if (n == 2)
  {
    behaviour = Behaviour::two_meshes;
    extrapolate(orders.assumed, safety_without_order);
    return;
  }

  const double coarser_difference = values[n - 2] - values[n - 3];
  const double r32 = cell_sizes[n - 3] / cell_sizes[n - 2];
  const double ratio = coarser_difference / difference;
  if (ratio < 0.)
  {
    behaviour = Behaviour::oscillatory;
    limit = finest;
    estimated_error = std::max(std::abs(difference), std::abs(coarser_difference));
  }
  else if (ratio <= std::log(r32) / std::log(r21))
    behaviour = Behaviour::divergent;
  else
  {
    behaviour = Behaviour::monotone;
    order = solve_for_order(ratio, r21, r32);
    order_plausible = order >= lowest_order && order <= orders.highest + 0.5;
    if (order_plausible)
      extrapolate(order, safety);
    else
      extrapolate(std::clamp(order, lowest_order, orders.highest), safety_without_order);
  }
}

std::string GridConvergence::description() const
{
  switch (behaviour)
  {
  case Behaviour::two_meshes:
    return "two meshes";
  case Behaviour::monotone:
  {
    std::ostringstream text;
    text << std::fixed << std::setprecision(2) << order << (order_plausible ? "" : " ?");
    return text.str();
  }
  case Behaviour::oscillatory:
    return "oscillates";
  case Behaviour::divergent:
    return "diverges";
  case Behaviour::settled:
    return "settled";
  case Behaviour::too_few:
    break;
  }
  return "too few";
}
} // namespace Continua
