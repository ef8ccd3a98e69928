// The iterative solver finds a known velocity and pressure, on hanging nodes, with an inclined
// roller, a jump of the stiffness by 1e9 and with incompressible regions; in a bounded number of
// iterations, that do not grow with the mesh.

#include <continua/finite_element/products/matrix_free_regions.h>
#include <continua/finite_element/solvers/iterative/iterative_step_solver.h>
#include <continua/finite_element/solvers/step_system.h>

#include "../../../unit_test.h"
#include "../../conditions_in_turn.h"
#include "../../small_problem.h"

#include <algorithm>
#include <memory>

namespace test_of_iterative_step_solver
{
using namespace Continua;
using namespace dealii;

namespace
{
/// A box of two regions that is turned, with hanging nodes.
void make_mesh(small_problem::Mesh<2> &mesh, const unsigned int n_refinements)
{
  small_problem::make_box<2>(mesh, {4, 2}, Point<2>(), 2.);
  GridTools::rotate(0.4, mesh);
  mesh.refine_global(n_refinements);
  small_problem::refine<2>(mesh, [](const Point<2> &x) { return x.norm() > 2.; });
}

/// Solves for a known solution; the solver's name.
std::string solve(const std::string &name,
                  const unsigned int n_refinements,
                  const SystemCoefficients &coefficients,
                  LinearSolverParameters parameters,
                  const bool has_products = false,
                  unsigned int *const n_iterations = nullptr)
{
  static const std::vector<BoundaryCondition> conditions = conditions_of_two_regions();
  small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
  make_mesh(mesh, n_refinements);
  Space<2> space(mesh, SpaceParameters(), Model::plane_strain, 2);
  space.distribute();
  BoundaryConstraints<2> constraints(space, conditions);
  constraints.build();
  std::vector<RegionOperators> operators(2);
  if (!has_products)
    assemble_region_operators(space, operators);
  else
  {
    assemble_pressure_operators(space, operators);
    const auto products = std::make_shared<MatrixFreeRegions<2>>(
        space, constraints, operators.size(), parameters.instruction_set);
    for (unsigned int region = 0; region < operators.size(); ++region)
    {
      operators[region].products = products;
      operators[region].number = region;
    }
  }

  parameters.type = LinearSolverType::iterative;
  parameters.tolerance = 1e-12;
  StepSystem<2> system(space, operators, constraints, parameters);
  system.reinit();
  system.prepare(coefficients);

  DistributedVector velocity = small_problem::interpolated<2>(
      space,
      [](const Point<2> &x) {
        return Tensor<1, 2>({std::sin(x[0] + 2. * x[1]), std::cos(3. * x[0] * x[1])});
      });
  const DistributedVector zero = space.velocity_vector();
  constraints.set_constrained(velocity, zero);
  const DistributedVector pressure = small_problem::interpolated_pressure<2>(
      space, [](const Point<2> &x, const unsigned int region)
      { return 10. * region + std::sin(x[0] - x[1]); });
  DistributedVector momentum = space.velocity_vector(), mass = space.pressure_vector(),
                    compression = mass;
  system.add_velocity_product(velocity, momentum);
  system.add_gradient(-1., pressure, momentum);
  constraints.restrict_to_free(momentum);
  system.add_divergence(-1., velocity, mass);
  system.add_compression(pressure, compression);
  mass.add(-1., compression);

  DistributedVector solved = space.velocity_vector(), solved_pressure = space.pressure_vector();
  system.solve(momentum, mass, solved, solved_pressure);
  const unsigned int n_first = system.take_iterations();
  if (n_iterations != nullptr)
    *n_iterations = n_first;
  constraints.set_constrained(solved, zero);
  DistributedVector error = solved, pressure_error = solved_pressure;
  error.add(-1., velocity);
  pressure_error.add(-1., pressure);
  check::absolute(name + ": velocity", error.linfty_norm(), 0., 1e-6);
  // Pressures are balanced by stresses, so they count relative to those.
  const double stress =
      *std::max_element(coefficients.stiffness.begin(), coefficients.stiffness.end());
  check::absolute(name + ": pressure",
                  pressure_error.linfty_norm() / std::max(stress, pressure.linfty_norm()), 0.,
                  1e-8);
  if (n_first > 70)
    std::cout << n_first << " iterations" << std::endl;
  check::is_true(name + ": iterations", n_first > 0 && n_first <= 70);
  system.solve(momentum, mass, solved, solved_pressure);
  check::is_true(name + ": the solution is its own guess", system.take_iterations() <= 1);
  return system.name();
}

bool contains(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

/// The block that is assembled cell by cell is the one that is taken from matrices: as many
/// iterations. With a wrong entry it is no inverse any more.
void check_block_by_cells(const std::string &name, const SystemCoefficients &coefficients)
{
  unsigned int n_by_cells = 0, n_by_matrix = 0;
  LinearSolverParameters parameters;
  check::is_true(name + ", by cells: a factor", contains(solve(name + ", by cells", 1, coefficients,
                                                               parameters, true, &n_by_cells),
                                                         "L D L^T"));
  solve(name + ", by matrix", 1, coefficients, parameters, false, &n_by_matrix);
  check::absolute(name + ": iterations by cells and by matrix", n_by_cells, n_by_matrix, 0.);
}

/// Of a tangent with grad-div in its soft region. A part of it in the preconditioner saves
/// iterations, a small change does nothing, and a new preconditioner has it, too.
void check_grad_div(const std::string &name,
                    LinearSolverParameters parameters,
                    const bool has_effect)
{
  static const std::vector<BoundaryCondition> conditions = conditions_of_two_regions();
  small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
  make_mesh(mesh, 1);
  Space<2> space(mesh, SpaceParameters(), Model::plane_strain, 2);
  space.distribute();
  BoundaryConstraints<2> constraints(space, conditions);
  constraints.build();
  std::vector<RegionOperators> operators(2);
  assemble_region_operators(space, operators);
  parameters.type = LinearSolverType::iterative;

  const auto grad_div = [&](const double gamma)
  {
    std::vector<double> result(mesh.n_active_cells(), 0.);
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned() && cell->material_id() == 0)
        result[cell->active_cell_index()] = gamma * (1. + cell->center()[1]);
    return result;
  };
  const auto product = make_matrix_free_product<2, double>(
      InstructionSet::baseline, {space.mapping, space.velocity_dofs, constraints.all(), false});
  product->set({{0., 0.}, {0., 0.}, {}, grad_div(60.)});
  typename MatrixFreeProduct<2, double>::Vector source, target;
  product->initialise(source);
  product->initialise(target);
  const SaddlePointSolver::Product add_nonlinear_terms =
      [&](const DistributedVector &velocity, const DistributedVector &, DistributedVector &momentum,
          DistributedVector &)
  {
    std::copy(velocity.begin(), velocity.end(), source.begin());
    product->multiply(target, source);
    for (unsigned int i = 0; i < momentum.locally_owned_size(); ++i)
      momentum.begin()[i] += target.local_element(i);
  };
  DistributedVector solution;
  const auto iterations_of = [&](StepSystem<2> &system)
  {
    // Both equations have a residual.
    DistributedVector change =
        small_problem::interpolated<2>(space,
                                       [](const Point<2> &x) {
                                         return Tensor<1, 2>({std::sin(7. * x[0]), x[0] * x[1]});
                                       });
    constraints.set_constrained(change, space.velocity_vector());
    DistributedVector momentum = space.velocity_vector(), mass = space.pressure_vector(),
                      velocity = momentum, pressure = mass;
    system.add_velocity_product(change, momentum);
    constraints.restrict_to_free(momentum);
    system.add_divergence(-1., change, mass);
    system.solve_tangent(add_nonlinear_terms, TangentTerms::convection, 1e-3, momentum, mass,
                         velocity, pressure);
    solution = velocity;
    return static_cast<double>(system.take_iterations());
  };
  const auto prepare = [](StepSystem<2> &of_step, const SystemCoefficients &wanted)
  {
    of_step.take(wanted);
    of_step.prepare_nearby(wanted);
  };
  const SystemCoefficients coefficients{{2e3, 2e3}, {1e-3, 1e6}, {1e-6, 1e-6}},
      of_short_steps{{2e4, 2e4}, {1e-3, 1e5}, {1e-7, 1e-7}};
  StepSystem<2> system(space, operators, constraints, parameters);
  system.reinit();
  prepare(system, coefficients);
  const double n_without = iterations_of(system);
  system.precondition_grad_div(grad_div(60.));
  const double n_with = iterations_of(system);
  if (has_effect && !(n_with < 0.7 * n_without))
    std::cout << n_without << ", " << n_with << std::endl;
  check::is_true(name + ": iterations with grad-div in the preconditioner",
                 has_effect ? n_with < 0.7 * n_without : n_with == n_without);
  // Another preconditioner leaves another solution, within the tolerance.
  const DistributedVector before = solution;
  system.precondition_grad_div(grad_div(50.));
  iterations_of(system);
  solution -= before;
  check::absolute(name + ": a small change does nothing", solution.l2_norm(), 0., 1e-6);
  system.precondition_grad_div({});
  check::absolute(name + ": nor do terms without grad-div", iterations_of(system), n_with, 0.);
  prepare(system, of_short_steps);
  const double n_after = iterations_of(system);
  StepSystem<2> another(space, operators, constraints, parameters);
  another.reinit();
  prepare(another, of_short_steps);
  another.precondition_grad_div(grad_div(60.));
  check::absolute(name + ": a new preconditioner has it", n_after, iterations_of(another), 0.);
  prepare(system, coefficients);
  system.precondition_grad_div(grad_div(0.));
  check::absolute(name + ": without a flow it is as before", iterations_of(system), n_without, 0.);
}

/// Up to where the stiff block has a factor.
void check_limits(const SystemCoefficients &coefficients)
{
  const std::string multigrid = "stiff block: polynomial multigrid (degree 3, linear velocities: ";
  LinearSolverParameters parameters;
  StiffBlockLimits &limits = parameters.stiff_block_limits;
  limits.small_in_plane = 0;
  limits.largest_share = 1.;
  check::is_true("a small factor is made",
                 contains(solve("small factor", 1, coefficients, parameters), "L D L^T"));
  limits.bytes_per_unknown = 1.;
  check::is_true("a large factor is not made, and the name says why",
                 contains(solve("large factor", 1, coefficients, parameters),
                          "), since a factor would need "));
  limits.bytes_per_unknown = 1e6;
  limits.largest_share = 0.1;
  check::is_true("a large share of the velocities has multigrid at once",
                 contains(solve("large share", 1, coefficients, parameters), multigrid));
  parameters.velocity_product = VelocityProduct::assembled;
  check::is_true("with a matrix it has algebraic multigrid",
                 contains(solve("large share, assembled", 1, coefficients, parameters),
                          "stiff block: algebraic multigrid;"));
  parameters.velocity_product = VelocityProduct::automatic;
  limits.largest_share = 1.;
  limits.largest = 10;
  check::is_true("many velocities have multigrid at once",
                 contains(solve("many", 1, coefficients, parameters), multigrid));
  limits.largest_with_linear_factor = 10;
  check::is_true("very many have no factor of the linear velocities either",
                 contains(solve("very many", 1, coefficients, parameters),
                          multigrid + "algebraic multigrid);"));
  limits.largest_with_linear_factor = 2000000;
  limits.linear_bytes_per_unknown = 1.;
  check::is_true("a large factor of the linear velocities is not made",
                 contains(solve("large linear factor", 1, coefficients, parameters),
                          multigrid + "algebraic multigrid);"));
  limits.small_in_plane = 100000;
  limits.bytes_per_unknown = 1.;
  check::is_true("a small block has a factor of any size",
                 contains(solve("small block", 1, coefficients, parameters), "L D L^T"));
}
} // namespace

UNIT_TEST(iterative_step_solver)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  const SystemCoefficients jump{{2e3, 2e3}, {1e-3, 1e6}, {0.1, 1e-6}};
  const SystemCoefficients incompressible{{2., 5.}, {1e-2, 1e4}, {0., 0.}};
  const SystemCoefficients bulky{{1., 1.}, {1e3, 1e3}, {1e-3, 1e-3}};
  const SystemCoefficients steady{{0., 0.}, {1., 2.}, {0.5, 0.}};
  LinearSolverParameters parameters;
  check_block_by_cells("all stiff", bulky);
  check_block_by_cells("one region stiff", jump);
  check_block_by_cells("without inertia", steady);
  for (const unsigned int n_refinements : {1, 2})
  {
    const std::string mesh = n_refinements == 1 ? "coarse, " : "fine, ";
    solve(mesh + "a stiff region", n_refinements, jump, parameters);
    solve(mesh + "incompressible", n_refinements, incompressible, parameters);
    solve(mesh + "steady", n_refinements, steady, parameters);
    LinearSolverParameters multigrid;
    multigrid.stiff_block = StiffBlock::algebraic_multigrid;
    solve(mesh + "multigrid", n_refinements, bulky, multigrid);
    multigrid.stiff_block = StiffBlock::polynomial_multigrid;
    for (const auto &[solid, coefficients] : std::map<std::string, SystemCoefficients>{
             {"bulky", bulky}, {"a stiff region", jump}, {"incompressible", incompressible}})
      solve(mesh + "multigrid in the degree, " + solid, n_refinements, coefficients, multigrid);
    multigrid.schur_complement = SchurApproximation::simple;
    solve(mesh + "multigrid in the degree, simple", n_refinements, bulky, multigrid);
    LinearSolverParameters simple;
    simple.schur_complement = SchurApproximation::simple;
    solve(mesh + "simple", n_refinements, jump, simple);
  }

  check_limits(jump);

  LinearSolverParameters other;
  check_grad_div("a flow", other, true);
  other.velocity_product = VelocityProduct::assembled;
  check_grad_div("a flow, assembled", other, false);

  LinearSolverParameters few;
  few.maximum_iterations = 3;
  check::throws<RunError>(
      "too few iterations", [&]() { solve("few", 1, jump, few); }, "has not converged: after 3");
  check::throws<RunError>(
      "vibrations",
      [&]() {
        solve("shifted", 1, SystemCoefficients{{-1., -1.}, {1., 1.}, {1., 1.}}, parameters);
      },
      "use Linear solver/Type = direct");
}
} // namespace test_of_iterative_step_solver
