#include <continua/mesh/centreline_axis.h>

namespace Continua
{
CentrelineAxis::CentrelineAxis(const std::shared_ptr<const Centreline> &centreline)
    : centreline(centreline)
{
}

std::array<double, 2> CentrelineAxis::range() const
{
  return {{0., centreline->length()}};
}

dealii::Point<3> CentrelineAxis::point(const double position) const
{
  return centreline->point(position);
}

dealii::Tensor<1, 3> CentrelineAxis::tangent(const double position) const
{
  return centreline->tangent(position);
}

double CentrelineAxis::position(const dealii::Point<3> &point) const
{
  return centreline->nearest(point);
}
} // namespace Continua
