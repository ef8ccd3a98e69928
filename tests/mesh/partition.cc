// Parts of a mesh that METIS cuts: against the shortest cut there is, and by the weights; the same
// mesh as p4est's.

#include <continua/mesh/partition.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>

#include "../unit_test.h"

namespace test_of_partition
{
using namespace Continua;
using dealii::Point;

namespace
{
/// 16 x 4 squares, refined once; x < 0.5 is fluid (material 0), the rest solid (1).
std::unique_ptr<dealii::parallel::TriangulationBase<2>>
make_mesh(const Partitioner partitioner, const double solid_weight, const unsigned int refinements)
{
  PartitionParameters parameters;
  parameters.partitioner = partitioner;
  parameters.solid_weight = solid_weight;
  auto mesh = make_triangulation<2>(MPI_COMM_WORLD, parameters, {false, true});
  dealii::GridGenerator::subdivided_hyper_rectangle(*mesh, {16, 4}, Point<2>(), Point<2>(1., .25));
  for (const auto &cell : mesh->cell_iterators_on_level(0))
    cell->set_material_id(cell->center()[0] < 0.5 ? 0 : 1);
  refine(*mesh, refinements);
  return mesh;
}

/// Of the rank in question, as a fraction of the mesh.
double owned_share(const dealii::parallel::TriangulationBase<2> &mesh, const unsigned int material)
{
  unsigned int n_owned = 0;
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned() && cell->material_id() == material)
      ++n_owned;
  return double(n_owned) / mesh.n_global_active_cells();
}
} // namespace

UNIT_TEST(partition)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.setstate(std::ios::failbit);

  const auto metis = make_mesh(Partitioner::metis, 1., 1);
  const PartitionQuality quality = measure_partition(*metis);
  check::is_true("cells", metis->n_global_active_cells() == 256);
  check::relative("parts are equal", quality.imbalance, 1., 0.05);
  // The shortest cut is across the strip, 8 faces; a heuristic may miss it, by less than half.
  const unsigned int shortest = 8 * (n_ranks - 1);
  check::is_true("cut", quality.n_cut_faces >= shortest && 2 * quality.n_cut_faces <= 3 * shortest);

  for (const Partitioner partitioner : {Partitioner::p4est, Partitioner::metis})
    for (const unsigned int refinements : {0, 2})
    {
      // Three to one: all of the fluid and a third of the solid for one rank. The curve of p4est
      // runs through whole coarse cells.
      const std::string name =
          word_of(partitioner_words(), partitioner) + (refinements == 0 ? ", coarse" : ", refined");
      const auto mesh = make_mesh(partitioner, 3., refinements);
      check::relative(name + ": equal work", measure_partition(*mesh).imbalance, 1., 0.1);
      const double work = owned_share(*mesh, 0) + 3. * owned_share(*mesh, 1);
      const double most = dealii::Utilities::MPI::max(work, MPI_COMM_WORLD);
      check::relative(name + ": by the weights", most, 2. / n_ranks, 0.1);
    }
}
} // namespace test_of_partition
