#include <continua/mesh/layered_channel_geometry.h>
#include <continua/mesh/regions_of_boundary.h>

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>

#include "../unit_test.h"

namespace test_of_regions_of_boundary
{
using namespace Continua;

UNIT_TEST(regions_of_boundary)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.setstate(std::ios::failbit);

  LayeredChannelGeometry<2>::Parameters parameters;
  parameters.axial_cells = 4;
  parameters.stack.fluid_cells = 2;
  parameters.stack.wall_thicknesses = {0.001, 0.001};
  parameters.stack.wall_cells = {1, 1};
  dealii::parallel::distributed::Triangulation<2> mesh(MPI_COMM_WORLD);
  LayeredChannelGeometry<2>(parameters).create(mesh);
  mesh.refine_global(2);

  const auto has = [&mesh](const std::string &name, const unsigned int boundary,
                           const std::vector<unsigned int> &regions)
  {
    const bool here = regions_of_boundary(mesh, boundary) == regions;
    check::is_true(name, dealii::Utilities::MPI::min(here ? 1 : 0, MPI_COMM_WORLD) == 1);
  };
  has("inlet", 0, {0});
  has("outlet", 1, {0});
  has("wall inlet end", 2, {1, 2});
  has("wall outlet end", 3, {1, 2});
  has("bottom", 4, {0});
  has("top", 5, {2});
  has("none", 6, {});

  // The names reach the refined cells of every rank.
  double inlet = 0.;
  double outermost = 0.;
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      if (cell->material_id() == 2)
        outermost += cell->measure();
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == 0)
          inlet += face->measure();
    }
  check::relative("refined: inlet", dealii::Utilities::MPI::sum(inlet, MPI_COMM_WORLD), 0.01,
                  1e-12);
  check::relative("refined: wall 2", dealii::Utilities::MPI::sum(outermost, MPI_COMM_WORLD), 1e-4,
                  1e-12);
}
} // namespace test_of_regions_of_boundary
