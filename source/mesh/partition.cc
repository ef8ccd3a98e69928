#include <continua/mesh/partition.h>

#include <deal.II/base/config.h>
#include <deal.II/base/mpi.h>
#include <deal.II/distributed/shared_tria.h>
#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
/// The lighter kind of cell has this weight, so that ratios are kept to a tenth. METIS sums the
/// weights in 32 bits: at the largest ratio they are enough for 2e7 cells.
constexpr double unit_weight = 10.;
constexpr double largest_ratio = 10.;

template <int dim>
unsigned int weight_of(const Triangulation<dim> &triangulation,
                       const typename Triangulation<dim>::cell_iterator &cell)
{
  return triangulation.signals.weight.empty()
             ? 1
             : triangulation.signals.weight(cell, Triangulation<dim>::CELL_PERSIST);
}
} // namespace

const Words<Partitioner> &partitioner_words()
{
  static const Words<Partitioner> words = {{"p4est", Partitioner::p4est},
                                           {"metis", Partitioner::metis}};
  return words;
}

void PartitionParameters::read(ParameterSection mesh)
{
  add_choice(
      mesh, "Partitioner", partitioner, partitioner_words(),
      "What divides the mesh among the ranks: p4est - every rank keeps its own part only, needed "
      "where the mesh adapts and from some ten million cells or hundreds of ranks on; metis - "
      "every "
      "rank keeps the whole mesh, with fewer and shorter cuts through meshes of many coarse cells, "
      "such as those of gmsh. The results are the same");
  mesh.add("Solid weight", solid_weight, Dimensions::none,
           "How much more work for its rank a cell of a solid makes than one of a fluid; the mesh "
           "is divided into parts of equal work [1]",
           Range{1. / largest_ratio, largest_ratio, false, false});
#ifndef DEAL_II_WITH_METIS
  if (is_metis())
    mesh.refuse("Partitioner", "this deal.II was built without METIS",
                "Set Partitioner = p4est, or link with a deal.II that has DEAL_II_WITH_METIS = ON");
#endif
}

template <int dim>
std::unique_ptr<parallel::TriangulationBase<dim>> make_triangulation(
    const MPI_Comm communicator, const PartitionParameters &parameters, std::vector<bool> is_solid)
{
  std::unique_ptr<parallel::TriangulationBase<dim>> triangulation;
  const auto smoothing = Triangulation<dim>::limit_level_difference_at_vertices;
  if (parameters.is_metis())
    // Asked for by name: deal.II's own choice would be Zoltan. With artificial cells ranks exchange
    // values with their neighbours alone.
    triangulation = std::make_unique<parallel::shared::Triangulation<dim>>(
        communicator, smoothing, true, parallel::shared::Triangulation<dim>::partition_metis);
  else
    triangulation =
        std::make_unique<parallel::distributed::Triangulation<dim>>(communicator, smoothing);

  const double ratio = parameters.solid_weight;
  if (ratio != 1.)
  {
    const double lighter = std::min(ratio, 1.);
    const auto solid = static_cast<unsigned int>(std::lround(unit_weight * ratio / lighter));
    const auto fluid = static_cast<unsigned int>(std::lround(unit_weight / lighter));
    triangulation->signals.weight.connect(
        [solid, fluid,
         is_solid = std::move(is_solid)](const typename Triangulation<dim>::cell_iterator &cell,
                                         const typename Triangulation<dim>::CellStatus)
        { return is_solid.at(cell->material_id()) ? solid : fluid; });
  }
  return triangulation;
}

template <int dim>
void refine(parallel::TriangulationBase<dim> &triangulation, const unsigned int n_refinements)
{
  triangulation.refine_global(n_refinements);
  if (n_refinements > 0 || triangulation.signals.weight.empty())
    return;
  // p4est does not ask for weights when it divides the coarse mesh, and METIS before it is painted.
  if (auto *const mesh = dynamic_cast<parallel::distributed::Triangulation<dim> *>(&triangulation))
    mesh->repartition();
  else
    triangulation.execute_coarsening_and_refinement();
}

template <int dim>
PartitionQuality measure_partition(const parallel::TriangulationBase<dim> &triangulation)
{
  double work = 0.;
  unsigned int n_faces = 0;
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      work += weight_of<dim>(triangulation, cell);
      for (const unsigned int f : cell->face_indices())
        // Of two ranks the one with the smaller number counts; a face with finer cells beyond is
        // one of theirs.
        if (!cell->at_boundary(f) && !cell->neighbor(f)->has_children() &&
            cell->neighbor(f)->is_ghost() &&
            (cell->neighbor_is_coarser(f) ||
             cell->subdomain_id() < cell->neighbor(f)->subdomain_id()))
          ++n_faces;
    }
  const MPI_Comm communicator = triangulation.get_communicator();
  const Utilities::MPI::MinMaxAvg works = Utilities::MPI::min_max_avg(work, communicator);
  return {works.max / works.avg, Utilities::MPI::sum(n_faces, communicator)};
}

template std::unique_ptr<parallel::TriangulationBase<2>>
make_triangulation(MPI_Comm, const PartitionParameters &, std::vector<bool>);
template std::unique_ptr<parallel::TriangulationBase<3>>
make_triangulation(MPI_Comm, const PartitionParameters &, std::vector<bool>);
template void refine(parallel::TriangulationBase<2> &, unsigned int);
template void refine(parallel::TriangulationBase<3> &, unsigned int);
template PartitionQuality measure_partition(const parallel::TriangulationBase<2> &);
template PartitionQuality measure_partition(const parallel::TriangulationBase<3> &);
} // namespace Continua
