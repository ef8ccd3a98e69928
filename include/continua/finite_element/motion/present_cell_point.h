#ifndef continua_finite_element_motion_present_cell_point_h
#define continua_finite_element_motion_present_cell_point_h

#include <continua/finite_element/space/space.h>

#include <deal.II/base/point.h>

namespace Continua
{
/// Whether a cell of the velocity holds a point as it is displaced, its faces included up to
/// round-off (1e-8 of the cell's size), and if so the point in the coordinates of the unit cell.
/// `displacement`: with ghost entries [m].
template <int dim>
bool cell_holds_present_point(const Space<dim> &space,
                              const typename dealii::DoFHandler<dim>::active_cell_iterator &cell,
                              const DistributedVector &displacement,
                              const dealii::Point<dim> &point,
                              dealii::Point<dim> &unit_point);
} // namespace Continua

#endif
