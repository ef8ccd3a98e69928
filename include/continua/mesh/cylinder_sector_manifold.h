#ifndef continua_mesh_cylinder_sector_manifold_h
#define continua_mesh_cylinder_sector_manifold_h

#include <continua/mesh/cylinder_sector.h>

#include <deal.II/grid/manifold.h>

#include <memory>

namespace Continua
{
/**
 * The shape of the cells in a CylinderSector (in three dimensions, extended along z): new points of
 * refined and of curved cells lie where their places (s, v) say, so that those on the circle are on
 * the circle. Neighbouring sectors agree on the straight line between them.
 */
template <int dim>
class CylinderSectorManifold : public dealii::ChartManifold<dim, dim, dim>
{
public:
  explicit CylinderSectorManifold(const CylinderSector &sector);

  std::unique_ptr<dealii::Manifold<dim>> clone() const override;
  dealii::Point<dim> pull_back(const dealii::Point<dim> &point) const override;
  dealii::Point<dim> push_forward(const dealii::Point<dim> &chart_point) const override;

private:
  const CylinderSector sector;
};
} // namespace Continua

#endif
