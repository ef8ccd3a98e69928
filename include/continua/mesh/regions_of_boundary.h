#ifndef continua_mesh_regions_of_boundary_h
#define continua_mesh_regions_of_boundary_h

#include <deal.II/grid/tria.h>

#include <vector>

namespace Continua
{
/**
 * The regions (material ids, ascending) whose cells have a face on a boundary. Looks at the coarse
 * cells, which every rank has, so the answer is the same on all ranks without communication.
 */
template <int dim>
std::vector<unsigned int> regions_of_boundary(const dealii::Triangulation<dim> &triangulation,
                                              dealii::types::boundary_id boundary);
} // namespace Continua

#endif
