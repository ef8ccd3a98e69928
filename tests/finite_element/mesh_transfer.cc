// Over a change of the mesh: fields that the spaces hold stay the same functions, through
// refinement and coarsening, with pressures that jump between regions; hanging nodes are zero.

#include <continua/finite_element/mesh_transfer.h>

#include "small_problem.h"

#include "../unit_test.h"

namespace test_of_mesh_transfer
{
namespace
{
using namespace Continua;
using namespace dealii;

/// Quadratic velocities and linear pressures with a jump of 100 between the regions.
template <int dim>
Tensor<1, dim> velocity_at(const Point<dim> &x, const double factor)
{
  Tensor<1, dim> u;
  for (unsigned int c = 0; c < dim; ++c)
    u[c] = factor * (1. + c + x[0] * x[1] - 0.5 * x[c] * x[c]);
  return u;
}
template <int dim>
double pressure_at(const Point<dim> &x, const unsigned int region)
{
  return 2. - x[0] + 3. * x[1] + 100. * region;
}

template <int dim>
void test()
{
  const std::string name = dim == 2 ? "2-D: " : "3-D: ";
  small_problem::Mesh<dim> mesh(MPI_COMM_WORLD);
  std::vector<unsigned int> cells(dim, 2);
  small_problem::make_box<dim>(mesh, cells, Point<dim>(), 1.);
  Space<dim> space(mesh, SpaceParameters(),
                   dim == 2 ? Model::plane_strain : Model::three_dimensional, 2);
  space.distribute();
  DistributedVector velocity, other, pressure;
  const auto exact_velocity = [&](const double factor)
  {
    return small_problem::interpolated<dim>(space, [factor](const Point<dim> &x)
                                            { return velocity_at<dim>(x, factor); });
  };
  const auto exact_pressure = [&]()
  { return small_problem::interpolated_pressure<dim>(space, pressure_at<dim>); };
  velocity = exact_velocity(1.);
  other = exact_velocity(-3.);
  pressure = exact_pressure();

  const auto change = [&](const std::string &what, const std::function<void()> &flag)
  {
    MeshTransfer<dim> transfer(space);
    flag();
    mesh.prepare_coarsening_and_refinement();
    transfer.prepare({&velocity, &other}, {&pressure});
    mesh.execute_coarsening_and_refinement();
    space.distribute();
    for (DistributedVector *vector : {&velocity, &other})
      *vector = space.velocity_vector();
    pressure = space.pressure_vector();
    transfer.finish({&velocity, &other}, {&pressure});
    DistributedVector error = velocity, other_error = other, pressure_error = pressure;
    error.add(-1., exact_velocity(1.));
    other_error.add(-1., exact_velocity(-3.));
    pressure_error.add(-1., exact_pressure());
    check::absolute(name + what + ", velocity", error.linfty_norm(), 0., 1e-13);
    check::absolute(name + what + ", another one", other_error.linfty_norm(), 0., 1e-13);
    check::absolute(name + what + ", pressure", pressure_error.linfty_norm(), 0., 1e-12);
  };
  const std::size_t n_coarse = mesh.n_global_active_cells();
  change("refined beside the interface",
         [&]()
         {
           for (const auto &cell : mesh.active_cell_iterators())
             if (cell->is_locally_owned() && cell->center()[0] > 1. && cell->center()[1] < 1.)
               cell->set_refine_flag();
         });
  check::is_true(name + "more cells", mesh.n_global_active_cells() > n_coarse);
  change("coarsened here and refined there",
         [&]()
         {
           for (const auto &cell : mesh.active_cell_iterators())
             if (cell->is_locally_owned() && cell->level() > 0)
               cell->set_coarsen_flag();
             else if (cell->is_locally_owned() && cell->center()[1] > 1.)
               cell->set_refine_flag();
         });
}
} // namespace

UNIT_TEST(mesh_transfer)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  test<2>();
  test<3>();
}
} // namespace test_of_mesh_transfer
