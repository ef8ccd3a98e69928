#ifndef continua_mesh_distortion_h
#define continua_mesh_distortion_h

#include <deal.II/grid/tria.h>

namespace Continua
{
/**
 * Moves the inner vertices of a coarse mesh (not yet refined) in random directions by at most
 * `distortion` times the shortest edge at the vertex, for tests on irregular cells. Vertices on the
 * boundary and on faces between two regions stay. The same on every rank, machine and run. Throws
 * InputError (of Mesh/Distortion) if a cell would be turned inside out; with box-shaped cells that
 * cannot happen below 1 / (2 sqrt(dim)).
 */
template <int dim>
void distort_coarse_mesh(dealii::Triangulation<dim> &triangulation, double distortion);
} // namespace Continua

#endif
