// Mass and inertia of bodies for which textbooks have them.

#include <continua/analysis/rigid_motions.h>

#include "../unit_test.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>

namespace test_of_rigid_motions
{
using namespace Continua;
using namespace dealii;

namespace
{
template <int dim>
std::vector<RigidMotion<dim>> motions_of_box(const Point<dim> &begin,
                                             const Point<dim> &end,
                                             const Model model,
                                             const std::vector<double> &densities)
{
  parallel::distributed::Triangulation<dim> mesh(MPI_COMM_WORLD);
  std::vector<unsigned int> cells(dim, 2);
  GridGenerator::subdivided_hyper_rectangle(mesh, cells, begin, end);
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(densities.size() > 1 && cell->center()[0] > 0.5 * (begin + end)[0]);
  Problem problem;
  problem.model = model;
  problem.materials.resize(densities.size());
  for (unsigned int i = 0; i < densities.size(); ++i)
    problem.materials[i].density = densities[i];
  return rigid_motions<dim>(mesh, StaticMappingQ1<dim>::mapping, problem);
}
} // namespace

UNIT_TEST(rigid_motions)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) > 0)
    std::cout.setstate(std::ios::failbit); // rank 0 alone prints

  // 2 x 3 x 4 m and 5 kg/m^3: 120 kg, m (a^2 + b^2) / 12.
  const auto box = motions_of_box<3>({1., 0., 0.}, {3., 3., 4.}, Model::three_dimensional, {5.});
  check::equal("box: motions", std::to_string(box.size()), "6");
  check::relative("box: mass", box[0].inertia, 120., 1e-12);
  check::relative("box: about x", box[3].inertia, 120. * 25. / 12., 1e-12);
  check::relative("box: about y", box[4].inertia, 120. * 20. / 12., 1e-12);
  check::relative("box: about z", box[5].inertia, 120. * 13. / 12., 1e-12);
  check::is_true("box: along y", box[1](Point<3>(7., 8., 9.)) == Tensor<1, 3>({0., 1., 0.}));
  // y x (1, 0, 0) = (0, 0, -1), one metre off the centre (2, 1.5, 2).
  const Tensor<1, 3> turned = box[4](Point<3>(3., 1.5, 2.));
  check::absolute("box: turn about y", (turned - Tensor<1, 3>({0., 0., -1.})).norm(), 0., 1e-12);

  // Halves of 1 and 3 kg/m^2 side by side: the centre of mass at 5/8 of the length.
  const auto plane = motions_of_box<2>({0., 0.}, {2., 1.}, Model::plane_strain, {1., 3.});
  check::equal("plane: motions", std::to_string(plane.size()), "3");
  check::relative("plane: mass", plane[0].inertia, 4., 1e-12);
  check::relative("plane: centre", plane[0].centre[0], 1.25, 1e-12);
  // Two squares: m/6 each, and their distances 3/4 and 1/4 from the centre of mass.
  check::relative("plane: about z", plane[2].inertia, 4. / 6. + 9. / 16. + 3. / 16., 1e-12);
  check::absolute("plane: turn about z",
                  (plane[2](Point<2>(1.25, 1.5)) - Tensor<1, 2>({-1., 0.})).norm(), 0., 1e-12);

  // A cylinder of radius 1 and length 2.
  const auto round = motions_of_box<2>({0., 0.}, {2., 1.}, Model::axisymmetric, {7.});
  check::equal("round: motions", std::to_string(round.size()), "1");
  check::relative("round: mass", round[0].inertia, 14. * numbers::PI, 1e-12);
}
} // namespace test_of_rigid_motions
