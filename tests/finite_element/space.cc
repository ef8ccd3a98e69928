// The broken pressure: 10 (region + 1) + a linear function, exact through hanging nodes at the
// interface, refinement and coarsening, on one rank and on several; no interface pressure is
// pinned.

#include <continua/finite_element/mesh_transfer.h>
#include <continua/finite_element/space/space.h>

#include <deal.II/hp/fe_values.h>

#include "../unit_test.h"
#include "small_problem.h"

namespace test_of_space
{
using namespace Continua;
using namespace dealii;

namespace
{
double exact(const Point<2> &point, const unsigned int region)
{
  return 10. * (region + 1) + 3. * point[0] - 2. * point[1];
}

/// Largest error at the quadrature points of all cells.
double error(const Space<2> &space, const DistributedVector &pressure)
{
  const DistributedVector ghosted = space.ghosted_pressure(pressure);
  hp::FEValues<2> values(space.pressure_elements, hp::QCollection<2>(QGauss<2>(2)),
                         update_values | update_quadrature_points);
  double largest = 0.;
  for (const auto &cell : space.pressure_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      values.reinit(cell);
      const FEValues<2> &present = values.get_present_fe_values();
      std::vector<Vector<double>> p(4, Vector<double>(space.pressure_elements.n_components()));
      present.get_function_values(ghosted, p);
      for (unsigned int q = 0; q < 4; ++q)
        largest =
            std::max(largest, std::abs(p[q][space.pressure_component(cell->material_id())] -
                                       exact(present.quadrature_point(q), cell->material_id())));
    }
  return Utilities::MPI::max(largest, MPI_COMM_WORLD);
}

/// Whether a pressure dof has a constraint without masters (owned by this rank or not).
bool pinned(const Space<2> &space)
{
  for (const auto &line : space.pressure_hanging.get_lines())
    if (line.entries.empty())
      return true;
  return false;
}
} // namespace

UNIT_TEST(space)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();

  small_problem::Mesh<2> mesh(MPI_COMM_WORLD, Triangulation<2>::limit_level_difference_at_vertices);
  small_problem::make_box<2>(mesh, {4, 3}, Point<2>(), 2.);
  Space<2> space(mesh, SpaceParameters(), Model::plane_strain, 2);
  space.distribute();
  // 9 x 7 nodes of two components; two pressures of 3 x 4 nodes.
  check::is_true("velocity dofs", space.velocity_dofs.n_dofs() == 2 * 9 * 7);
  check::is_true("pressure dofs: doubled on the interface", space.pressure_dofs.n_dofs() == 2 * 12);

  DistributedVector pressure = small_problem::interpolated_pressure<2>(space, exact);
  DistributedVector velocity =
      small_problem::interpolated<2>(space,
                                     [](const Point<2> &x) {
                                       return Tensor<1, 2>({x[0] * x[0], x[0] * x[1]});
                                     });
  check::absolute("coarse", error(space, pressure), 0., 1e-12);
  const auto change = [&](const std::string &name, const auto &flag)
  {
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned())
        flag(cell);
    mesh.prepare_coarsening_and_refinement();
    MeshTransfer<2> transfer(space);
    transfer.prepare({&velocity}, {&pressure});
    mesh.execute_coarsening_and_refinement();
    space.distribute();
    velocity = space.velocity_vector();
    pressure = space.pressure_vector();
    transfer.finish({&velocity}, {&pressure});
    check::absolute(name + ": pressure", error(space, pressure), 0., 1e-12);
    check::is_true(name + ": no pressure is pinned",
                   Utilities::MPI::max(pinned(space) ? 1 : 0, MPI_COMM_WORLD) == 0);
    DistributedVector difference =
        small_problem::interpolated<2>(space,
                                       [](const Point<2> &x) {
                                         return Tensor<1, 2>({x[0] * x[0], x[0] * x[1]});
                                       });
    difference.add(-1., velocity);
    check::absolute(name + ": velocity", difference.linfty_norm(), 0., 1e-12);
  };
  change("hanging nodes on one side",
         [](const auto &cell)
         {
           if (cell->center()[0] > 2. && cell->center()[1] > 1.)
             cell->set_refine_flag();
         });
  change("two levels across the interface",
         [](const auto &cell)
         {
           if (std::abs(cell->center()[0] - 2.) < 0.6 && cell->center()[1] > 1.6)
             cell->set_refine_flag();
         });
  change("coarsened on the other side",
         [](const auto &cell)
         {
           if (cell->center()[0] > 2.)
             cell->set_coarsen_flag();
           else if (cell->center()[1] < 1.)
             cell->set_refine_flag();
         });

  SpaceParameters parameters;
  parameters.pressure_space = PressureSpace::continuous;
  Space<2> continuous(mesh, parameters, Model::plane_strain, 2);
  continuous.distribute();
  check::is_true("continuous: fewer dofs",
                 continuous.pressure_dofs.n_dofs() < space.pressure_dofs.n_dofs() &&
                     continuous.pressure_component(1) == 0);
  check::absolute("measure", space.circumference(Point<2>(1., 3.)), 1., 0.);
  const Space<2> tube(mesh, SpaceParameters(), Model::axisymmetric, 2);
  check::relative("measure in axisymmetry", tube.circumference(Point<2>(1., 3.)), 6. * numbers::PI,
                  1e-14);
}
} // namespace test_of_space
