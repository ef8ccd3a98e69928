#ifndef continua_mesh_round_section_h
#define continua_mesh_round_section_h

#include <deal.II/grid/tria.h>

#include <set>

namespace Continua
{
/// A boundary that is a disc, or a half or a quarter of one.
template <int dim>
struct RoundSection
{
  dealii::Point<dim> centre; ///< [m]
  double radius;             ///< [m], of the outermost vertex
  double fraction;           ///< 1, 1/2 or 1/4: the part of the disc that the mesh has
};

/**
 * The disc that the faces of a boundary next to the given regions make: one around the x axis, of
 * which the mesh may have a half or a quarter; or a disc or half of one anywhere. In two dimensions
 * the mesh is taken as axisymmetric, so that a line from the axis is a whole disc. Looks at the
 * coarse cells, which every rank has. Throws std::invalid_argument, with a reason that a user
 * understands, if the faces do not lie in one plane (in two dimensions across the x axis), or do
 * not fill the disc up to its centre.
 */
template <int dim>
RoundSection<dim> find_round_section(const dealii::Triangulation<dim> &triangulation,
                                     dealii::types::boundary_id boundary,
                                     const std::set<unsigned int> &regions);
} // namespace Continua

#endif
