// Every value of the start is the given function at its place; what is not given stays; the
// pressure of each region, and in plane stress its auxiliary.

#include <continua/finite_volume/cell_wise_initial_state.h>

#include "cell_wise_body.h"

#include "../unit_test.h"

namespace test_of_cell_wise_initial_state
{
namespace
{
using namespace cell_wise_meshes;

Expression formula(const std::string &text)
{
  return Expression(text, Dimensions::none);
}

template <int dim>
void test()
{
  const std::string name = dim == 2 ? "2-D: " : "3-D: ";
  Triangulation<dim> triangulation(MPI_COMM_WORLD);
  make_box(triangulation, 4);
  refine_corner(triangulation);
  const Model model = dim == 2 ? Model::plane_stress : Model::three_dimensional;
  CellWiseSpace<dim> space(triangulation, model);
  space.distribute();
  Problem problem = make_problem<dim>(model);
  problem.plane_stress_factors.resize(problem.materials.size());
  problem.plane_stress_factors[0].pressure_factor = 0.8;
  problem.interior.initial_velocity = {formula("2*x"), formula("3*y")};
  problem.interior.initial_pressure = {formula("1+x"), formula("5-y")};
  if (dim == 3)
    problem.interior.initial_velocity.push_back(formula("x+z"));
  DistributedVector velocity = space.velocity_vector(), displacement = velocity,
                    pressure = space.pressure_vector();
  displacement.add(7.);
  set_initial_values(space, problem, velocity, displacement, pressure);
  velocity.add(-1., velocity_field<dim>(space,
                                        [](const dealii::Point<dim> &p)
                                        {
                                          dealii::Tensor<1, dim> u;
                                          u[0] = 2. * p[0];
                                          u[1] = 3. * p[1];
                                          if (dim == 3)
                                            u[dim - 1] = p[0] + p[dim - 1];
                                          return u;
                                        }));
  pressure.add(-1.,
               pressure_field<dim>(space, [](const dealii::Point<dim> &p, const unsigned int region)
                                   { return region == 0 ? (1. + p[0]) / 0.8 : 5. - p[1]; }));
  check::absolute(name + "velocity", velocity.linfty_norm(), 0., 1e-14);
  check::absolute(name + "pressure", pressure.linfty_norm(), 0., 1e-14);
  displacement.add(-7.);
  check::absolute(name + "no displacement is given", displacement.linfty_norm(), 0., 0.);

  problem.interior = {};
  problem.interior.initial_displacement.assign(dim, formula("x*y"));
  velocity = 0.;
  velocity.add(4.);
  set_initial_values(space, problem, velocity, displacement, pressure);
  velocity.add(-4.);
  check::absolute(name + "velocity stays", velocity.linfty_norm(), 0., 0.);
  displacement.add(-1., velocity_field<dim>(space,
                                            [](const dealii::Point<dim> &p)
                                            {
                                              dealii::Tensor<1, dim> u;
                                              for (unsigned int c = 0; c < dim; ++c)
                                                u[c] = p[0] * p[1];
                                              return u;
                                            }));
  check::absolute(name + "displacement", displacement.linfty_norm(), 0., 1e-14);
}
} // namespace

UNIT_TEST(cell_wise_initial_state)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  test<2>();
  test<3>();
}
} // namespace test_of_cell_wise_initial_state
