#include <continua/mesh/cylinder_sector_manifold.h>

namespace Continua
{
using dealii::Point;

namespace
{
/// `point` with other coordinates in the plane.
template <int dim>
Point<dim> moved(Point<dim> point, const Point<2> &plane)
{
  point[0] = plane[0];
  point[1] = plane[1];
  return point;
}
} // namespace

template <int dim>
CylinderSectorManifold<dim>::CylinderSectorManifold(const CylinderSector &sector) : sector(sector)
{
}

template <int dim>
std::unique_ptr<dealii::Manifold<dim>> CylinderSectorManifold<dim>::clone() const
{
  return std::make_unique<CylinderSectorManifold<dim>>(sector);
}

template <int dim>
Point<dim> CylinderSectorManifold<dim>::pull_back(const Point<dim> &point) const
{
  return moved(point, sector.place({point[0], point[1]}));
}

template <int dim>
Point<dim> CylinderSectorManifold<dim>::push_forward(const Point<dim> &chart_point) const
{
  return moved(chart_point, sector.point(chart_point[0], chart_point[1]));
}

template class CylinderSectorManifold<2>;
template class CylinderSectorManifold<3>;
} // namespace Continua
