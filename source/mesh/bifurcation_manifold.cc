#include <continua/mesh/bifurcation_manifold.h>
#include <continua/mesh/tube_cross_section.h>

namespace Continua
{
using dealii::Point;

namespace
{
/// Only the rings of a whole section go round.
dealii::Tensor<1, 3> periodicity(const BifurcationManifold::Part part)
{
  dealii::Tensor<1, 3> period;
  if (part == BifurcationManifold::Part::rings)
    period[2] = TubeCrossSection::full_turn;
  return period;
}
} // namespace

BifurcationManifold::BifurcationManifold(const std::shared_ptr<const BifurcationShape> &shape,
                                         const unsigned int tube,
                                         const Part part)
    : dealii::ChartManifold<3, 3, 3>(periodicity(part)), shape(shape), tube(tube), part(part)
{
}

std::unique_ptr<dealii::Manifold<3>> BifurcationManifold::clone() const
{
  return std::make_unique<BifurcationManifold>(shape, tube, part);
}

Point<3> BifurcationManifold::pull_back(const Point<3> &point) const
{
  const Point<3> place = shape->place(tube, point);
  if (part == Part::core)
    return place;
  const Point<2> in_rings = TubeCrossSection::place({place[1], place[2]});
  return {place[0], in_rings[0], in_rings[1]};
}

Point<3> BifurcationManifold::push_forward(const Point<3> &chart_point) const
{
  if (part == Part::core)
    return shape->point(tube, chart_point);
  const Point<2> scaled = TubeCrossSection::point(chart_point[1], chart_point[2]);
  return shape->point(tube, {chart_point[0], scaled[0], scaled[1]});
}
} // namespace Continua
