#ifndef continua_finite_element_looking_cell_of_point_h
#define continua_finite_element_looking_cell_of_point_h

#include <continua/continuum/field_probes.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <functional>

namespace Continua
{
/// The cell at which a probe of a point looks.
template <int dim>
struct CellOfPoint
{
  typename dealii::Triangulation<dim>::cell_iterator cell;
  dealii::Point<dim> unit_point; ///< in the unit cell
  bool is_here = false;          ///< this rank owns the cell; else the members above mean nothing
  bool is_anywhere = false;      ///< on some rank
};

/// Of all cells that hold the point, on whatever rank, the first by its identity: stress and
/// pressure do not depend on the partition. `displacement`: with ghost entries, for points that are
/// fixed in space [m]. `counts`: whether a region does. Collective.
template <int dim>
CellOfPoint<dim> find_cell_of_point(const Space<dim> &space,
                                    const ProbeRequest<dim> &request,
                                    const DistributedVector &displacement,
                                    const std::function<bool(unsigned int region)> &counts);
} // namespace Continua

#endif
