#include <continua/mesh/branch_axis.h>

#include <limits>

namespace Continua
{
namespace
{
/// By how much vertices and curved cells may be beyond the tube, over its radius: less than half of
/// the distance between two branches that have left their junction.
constexpr double slack = 0.02;
} // namespace

BranchAxis::BranchAxis(const dealii::Point<3> &begin,
                       const dealii::Point<3> &end,
                       const std::array<double, 2> &tube,
                       const double outer_radius)
    : begin(begin),
      direction((end - begin) / begin.distance(end)),
      tube(tube),
      outer_radius(outer_radius)
{
}

dealii::Point<3> BranchAxis::point(const double position) const
{
  return begin + position * direction;
}

double BranchAxis::position(const dealii::Point<3> &point) const
{
  const double result = (point - begin) * direction;
  const double margin = slack * outer_radius;
  const bool belongs = tube[0] - margin <= result && result <= tube[1] + margin &&
                       point.distance(begin + result * direction) <= outer_radius + margin;
  return belongs ? result : std::numeric_limits<double>::quiet_NaN();
}
} // namespace Continua
