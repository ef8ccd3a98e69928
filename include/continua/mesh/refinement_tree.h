#ifndef continua_mesh_refinement_tree_h
#define continua_mesh_refinement_tree_h

#include <continua/base/archive.h>

#include <deal.II/distributed/tria_base.h>

namespace Continua
{
// A refined mesh as the list of those cells that have children. With the coarse mesh this is all of
// it. The list does not depend on the number of ranks. It goes into the archive of a checkpoint, so
// that no library writes a file of its own, whose failures nobody would see.

/// Adds the list to the archive, the same on all ranks. Collective.
template <int dim>
void save_refinement(const dealii::parallel::TriangulationBase<dim> &triangulation,
                     ArchiveWriter &archive);

/// Whether the archive has a list.
bool has_refinement(const ArchiveReader &archive);

/// Refines a coarse mesh as the list says. Throws RunError if the list is not one of this mesh.
/// Collective.
template <int dim>
void load_refinement(const ArchiveReader &archive,
                     dealii::parallel::TriangulationBase<dim> &triangulation);
} // namespace Continua

#endif
