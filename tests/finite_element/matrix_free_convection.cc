// Products with the derivative of convection without a matrix, against the matrices of the cells
// (which convective_terms tests against differences): curved cells, hanging nodes, liquids with and
// without compressibility and flow curve beside a solid, cells at an open end, a liquid at rest;
// with each set of instructions that this processor has.

#include <continua/finite_element/assembly/convective_terms.h>

#include <deal.II/base/mpi.h>

#include "../unit_test.h"
#include "flow_state.h"

namespace test_of_matrix_free_convection
{
using namespace Continua;
using namespace dealii;
using flow_state::make_state;
using flow_state::wave;

namespace
{
struct Rows
{
  DistributedVector momentum, volume;
};

template <int dim>
Rows product_of(const Space<dim> &space,
                const Problem &problem,
                const std::optional<InstructionSet> instruction_set,
                const StepSolution &state)
{
  ConvectiveTerms<dim> terms(space, problem, instruction_set);
  terms.reinit();
  const KeptDerivative form =
      instruction_set ? KeptDerivative::without_matrix : KeptDerivative::matrices;
  if (instruction_set)
  {
    // What was kept before, of another state and step, must leave nothing behind.
    StepSolution other = state;
    other.step = euler_step(0., 0.02, Update::implicit);
    other.velocity *= 3.;
    other.pressure *= 0.5;
    terms.keep_derivative(other, form);
    DistributedVector momentum = space.velocity_vector(), volume = space.pressure_vector();
    terms.add_derivative_product(state.velocity, state.pressure, momentum, volume);
  }
  terms.keep_derivative(state, form);
  Rows rows = {space.velocity_vector(), space.pressure_vector()};
  const DistributedVector velocity = small_problem::interpolated<dim>(
                              space, [](const Point<dim> &x)
                              { return wave(x, 7.) * Point<dim>::unit_vector(dim - 1) + 0.3 * x; }),
                          pressure = small_problem::interpolated_pressure<dim>(
                              space, [](const Point<dim> &x, const unsigned int region)
                              { return wave(x, 9. - region); });
  terms.add_derivative_product(velocity, pressure, rows.momentum, rows.volume);
  return rows;
}

double distance(const DistributedVector &a, const DistributedVector &b)
{
  DistributedVector difference = a;
  difference.add(-1., b);
  return difference.linfty_norm();
}

template <int dim>
void compare(const std::string &name,
             const Space<dim> &space,
             const Problem &problem,
             const StepSolution &state)
{
  const Rows expected = product_of(space, problem, std::nullopt, state);
  const double of_momentum = expected.momentum.linfty_norm(),
               of_volume = expected.volume.linfty_norm();
  check::is_true(name + ": there is a product", of_momentum > 1e-3);
  check::is_true(name + ": rows of volume", of_volume > 1e-4);
  for (const InstructionSet instruction_set :
       {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
  {
    // What this processor lacks is as good as what it has: the answer must not depend on it.
    const Rows rows =
        product_of(space, problem,
                   can_run(instruction_set) ? instruction_set : InstructionSet::baseline, state);
    const std::string of_set = name + ", " + word_of(instruction_set_words(), instruction_set);
    check::absolute(of_set + ": momentum", distance(rows.momentum, expected.momentum) / of_momentum,
                    0., 1e-13);
    check::absolute(of_set + ": volume", distance(rows.volume, expected.volume) / of_volume, 0.,
                    1e-13);
  }
}

template <int dim>
void check_products(const std::string &name, const Model model)
{
  small_problem::Mesh<dim> mesh(MPI_COMM_WORLD);
  GridGenerator::quarter_hyper_shell(mesh, Point<dim>(), 1., 1.5, 0, true);
  mesh.refine_global(dim == 2 ? 2 : 1);
  // A compressible liquid, an incompressible one and a solid.
  for (const auto &cell : mesh.active_cell_iterators())
  {
    const Point<dim> x = cell->center();
    cell->set_material_id(x.norm() > 1.2 ? 2 : x[0] > x[1] ? 1 : 0);
  }
  small_problem::refine<dim>(mesh, [](const Point<dim> &x) { return x[0] > 0.6; });
  Space<dim> space(mesh, SpaceParameters(), model, 3);
  space.distribute();

  Problem problem;
  problem.model = model;
  problem.regions = {"gas", "liquid", "solid"};
  problem.materials.resize(3);
  for (Material &material : problem.materials)
    material.density = 3.;
  problem.materials[0].compression = Compression::elastic(0.05);
  problem.materials[0].volume_exponent = 7.15;
  problem.materials[0].reference_pressure = 0.3;
  problem.materials[0].shear.viscosity = 2.;
  problem.materials[0].shear.flow_curve = FlowCurve{2., 0.3, 0.8, 0.4, 1.5};
  problem.materials[2].shear.branches = {{1., 1.}};
  problem.convection.is_on = true;
  problem.convection.stabilisation_viscosity = 0.7;
  const StepSolution state = make_state(space);
  compare(name + ", skew", space, problem, state);

  // Grad-div follows the speed, and an end is open.
  problem.convection.stabilisation_viscosity = 0.;
  problem.convection.term = ConvectiveTerm::advective;
  problem.materials[0].volume_exponent = 0.;
  BoundaryCondition condition;
  condition.boundary_id = 2;
  condition.region_ids = {0, 1};
  condition.inflow_pressure = InflowPressure::total;
  problem.conditions.push_back(condition);
  compare(name + ", advective, open end", space, problem, state);

  problem.materials[0] = problem.materials[1];
  compare(name + ", incompressible", space, problem, state);

  // At rest the speed has no derivative.
  StepSolution at_rest = state;
  at_rest.velocity = 0.;
  problem.materials[0].compression = Compression::elastic(0.05);
  problem.convection.term = ConvectiveTerm::skew;
  compare(name + ", at rest", space, problem, at_rest);

  // A mesh that is bent, widened and moves; without convection its own motion carries.
  problem.mesh_moves = true;
  StepSolution moved = state;
  moved.mesh_displacement = small_problem::interpolated<dim>(
      space, [](const Point<dim> &x)
      { return 0.05 * wave(x, 3.) * Point<dim>::unit_vector(0) + 0.1 * x; });
  moved.mesh_velocity = small_problem::interpolated<dim>(
      space,
      [](const Point<dim> &x) { return 0.4 * wave(x, 5.) * Point<dim>::unit_vector(1) - 0.2 * x; });
  compare(name + ", mesh that moves", space, problem, moved);
  problem.convection.is_on = false;
  compare(name + ", mesh that moves, without convection", space, problem, moved);
}
} // namespace

UNIT_TEST(matrix_free_convection)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  check_products<2>("plane", Model::plane_strain);
  check_products<2>("axisymmetric", Model::axisymmetric);
  check_products<3>("in space", Model::three_dimensional);
}
} // namespace test_of_matrix_free_convection
