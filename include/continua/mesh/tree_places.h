#ifndef continua_mesh_tree_places_h
#define continua_mesh_tree_places_h

#include <deal.II/distributed/tria_base.h>

#include <vector>

namespace Continua
{
/**
 * The place of each active cell, by its active index, in the order of the coarse cells and of their
 * children: the same on every number of ranks. Only of a mesh that every rank has whole; empty for
 * one of parallel::distributed::Triangulation, in which deal.II numbers along p4est's curve what is
 * numbered by DoFRenumbering::hierarchical.
 */
template <int dim>
std::vector<unsigned long>
tree_places(const dealii::parallel::TriangulationBase<dim> &triangulation);
} // namespace Continua

#endif
