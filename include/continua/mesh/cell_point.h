#ifndef continua_mesh_cell_point_h
#define continua_mesh_cell_point_h

#include <deal.II/base/point.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/grid/tria.h>

namespace Continua
{
/**
 * Whether a cell holds a point, its faces included up to round-off (1e-8 of the cell's size), and
 * if so the point in the coordinates of the unit cell.
 */
template <int dim>
bool cell_holds_point(const dealii::Mapping<dim> &mapping,
                      const typename dealii::Triangulation<dim>::cell_iterator &cell,
                      const dealii::Point<dim> &point,
                      dealii::Point<dim> &unit_point);
} // namespace Continua

#endif
