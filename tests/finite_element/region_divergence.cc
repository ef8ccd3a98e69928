// Products of the divergence by the matrices of the regions equal those of the matrix that
// assemble_divergence() makes: with an inclined roller, a fixed side, hanging nodes and two regions
// whose pressures are broken or continuous. And T u is T u + g without values.

#include <continua/finite_element/solvers/condensed_system.h>
#include <continua/finite_element/solvers/region_divergence.h>
#include <continua/linear_algebra/matrix_product.h>

#include "../unit_test.h"
#include "conditions_in_turn.h"
#include "small_problem.h"

#include <cmath>
#include <string>

namespace test_of_region_divergence
{
using namespace Continua;
using namespace dealii;

namespace
{
DistributedVector numbers(DistributedVector vector, const double step)
{
  for (const auto index : vector.locally_owned_elements())
    vector[index] = std::sin(1. + step * index);
  vector.compress(VectorOperation::insert);
  return vector;
}

double distance(DistributedVector a, const DistributedVector &b)
{
  a.add(-1., b);
  return a.linfty_norm();
}

void check_pressures(const std::string &name,
                     const PressureSpace pressure_space,
                     const std::vector<BoundaryCondition> &conditions)
{
  small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
  small_problem::make_box<2>(mesh, {4, 2}, Point<2>(), 2.);
  GridTools::rotate(0.4, mesh);
  small_problem::refine<2>(mesh, [](const Point<2> &x) { return x.norm() > 2.; });
  SpaceParameters parameters;
  parameters.pressure_space = pressure_space;
  Space<2> space(mesh, parameters, Model::plane_strain, 2);
  space.distribute();
  BoundaryConstraints<2> constraints(space, conditions);
  constraints.build();
  std::vector<RegionOperators> operators(2);
  assemble_pressure_operators(space, operators);
  TrilinosWrappers::SparseMatrix matrix;
  assemble_divergence(space, operators, constraints, matrix);
  const RegionDivergence<2> divergence(space, operators, constraints);

  const DistributedVector velocity = numbers(space.velocity_vector(), 1.7),
                          pressure = numbers(space.pressure_vector(), 0.9);
  DistributedVector of_velocity = pressure, by_matrix = pressure;
  divergence.multiply(of_velocity, velocity);
  multiply(matrix, by_matrix, velocity);
  check::is_true(name + ": the product is more than nothing", by_matrix.linfty_norm() > 0.1);
  check::absolute(name + ": product", distance(of_velocity, by_matrix), 0., 1e-14);
  DistributedVector of_pressure = velocity, transposed_by_matrix = velocity;
  divergence.multiply_transposed(of_pressure, pressure);
  multiply_transposed(matrix, transposed_by_matrix, pressure);
  check::is_true(name + ": the transposed one, too", transposed_by_matrix.linfty_norm() > 0.1);
  check::absolute(name + ": transposed product", distance(of_pressure, transposed_by_matrix), 0.,
                  1e-14);

  DistributedVector expanded(velocity), with_zeros(velocity);
  constraints.expand_free(expanded);
  constraints.set_constrained(with_zeros, space.velocity_vector());
  check::absolute(name + ": T u", distance(expanded, with_zeros), 0., 0.);
  check::is_true(name + ": T u is not u", distance(expanded, velocity) > 0.1);
}
} // namespace

UNIT_TEST(region_divergence)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  const std::vector<BoundaryCondition> conditions = conditions_of_two_regions();
  check_pressures("broken", PressureSpace::broken, conditions);
  check_pressures("continuous", PressureSpace::continuous, conditions);
}
} // namespace test_of_region_divergence
