#ifndef continua_mesh_partition_h
#define continua_mesh_partition_h

#include <continua/base/words.h>

#include <deal.II/distributed/tria_base.h>

#include <mpi.h>

#include <memory>
#include <vector>

namespace Continua
{
/// What divides the mesh among the ranks.
enum class Partitioner
{
  p4est,
  metis
};

const Words<Partitioner> &partitioner_words();

/// Entries of the section Mesh: how the cells are divided among the ranks.
struct PartitionParameters
{
  Partitioner partitioner = Partitioner::p4est;
  double solid_weight = 1.; ///< work of a cell of solid over that of a cell of fluid

  /// Throws InputError.
  void read(ParameterSection mesh);
  bool is_metis() const { return partitioner == Partitioner::metis; }
};

/**
 * An empty mesh that the partitioner asked for divides among the ranks, anew at each refinement;
 * levels of cells differ by at most one at a vertex.
 *
 * p4est: parallel::distributed::Triangulation, of which a rank has its own cells and those around
 * them, cut out of a space-filling curve through the coarse cells in their order. metis:
 * parallel::shared::Triangulation, whose active cells every rank has, cut so that few faces lie
 * between ranks; the numbers of cells and vertices, and so every result, are the same.
 *
 * `is_solid`: for each material id of the mesh whether its cells weigh `solid_weight`. With a
 * weight of 1 the partitioner is given none.
 */
template <int dim>
std::unique_ptr<dealii::parallel::TriangulationBase<dim>> make_triangulation(
    MPI_Comm communicator, const PartitionParameters &parameters, std::vector<bool> is_solid);

/// Gives each active cell the number of a part, so that the parts have equal weights and few faces
/// between them. No part is empty unless there are fewer cells than parts.
template <int dim>
void divide_by_metis(dealii::Triangulation<dim> &triangulation, unsigned int n_parts);

/// Refines every cell so many times, and divides the mesh by the weights even if that is none.
template <int dim>
void refine(dealii::parallel::TriangulationBase<dim> &triangulation, unsigned int n_refinements);

/// The cells of the rank that has most over the mean of all ranks, each by its weight, and the
/// faces between two ranks; the ranks without a cell. Collective.
struct PartitionQuality
{
  double imbalance = 1.;
  unsigned int n_cut_faces = 0;
  unsigned int n_idle_ranks = 0;
};
template <int dim>
PartitionQuality measure_partition(const dealii::parallel::TriangulationBase<dim> &triangulation);
} // namespace Continua

#endif
