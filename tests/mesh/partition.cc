// Parts of a mesh that METIS cuts: against the shortest cut there is, and by the weights; the same
// mesh as p4est's.

#include <continua/mesh/partition.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>

#include "../unit_test.h"

#include <algorithm>

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

/// The numbers of cells in the parts, the fewest first.
std::vector<unsigned int> sizes_of_parts(const std::vector<unsigned int> &cells,
                                         const unsigned int n_parts)
{
  dealii::Triangulation<2> mesh;
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh, cells, Point<2>(),
                                                    Point<2>(cells[0], cells[1]));
  divide_by_metis<2>(mesh, n_parts);
  std::vector<unsigned int> sizes(n_parts, 0);
  for (const auto &cell : mesh.active_cell_iterators())
    ++sizes.at(cell->subdomain_id());
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

/// METIS itself leaves 8 of 16 parts of 5 x 5 cells empty, and 16 of 32 of a row of 40.
void test_few_cells()
{
  const std::vector<unsigned int> square = sizes_of_parts({5, 5}, 16),
                                  row = sizes_of_parts({40, 1}, 32);
  check::is_true("5 x 5 cells in 16 parts", square.front() == 1 && square.back() <= 3);
  check::is_true("40 cells in 32 parts", row.front() == 1 && row.back() <= 3);
  check::is_true("2 cells in 3 parts",
                 sizes_of_parts({2, 1}, 3) == std::vector<unsigned int>({0, 1, 1}));
  check::is_true("3 cells in 3 parts",
                 sizes_of_parts({3, 1}, 3) == std::vector<unsigned int>({1, 1, 1}));
}

} // namespace

UNIT_TEST(partition)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.setstate(std::ios::failbit);

  test_few_cells();
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
