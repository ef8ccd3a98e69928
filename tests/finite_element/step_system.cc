// The system of a step solved for a known velocity and pressure, on hanging nodes, with an inclined
// roller and an inclined support; and the factor's life.

#include <continua/boundary/boundary_conditions.h>
#include <continua/finite_element/products/supports.h>
#include <continua/finite_element/solvers/step_system.h>

#include "../parameter_text.h"
#include "../unit_test.h"
#include "small_problem.h"

namespace test_of_step_system
{
using namespace Continua;
using namespace dealii;

UNIT_TEST(step_system)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
  small_problem::make_box<2>(mesh, {4, 2}, Point<2>(), 2.);
  GridTools::rotate(0.4, mesh);
  small_problem::refine<2>(mesh, [](const Point<2> &x) { return x.norm() > 2.; });
  Space<2> space(mesh, SpaceParameters(), Model::plane_strain, 2);
  space.distribute();
  ParameterFile file = parameters_of("subsection Boundaries\n"
                                     "subsection left\nset Type = roller\nend\n"
                                     "subsection right\nset Type = free\nend\n"
                                     "subsection bottom\nset Type = fixed\nend\n"
                                     "subsection top\nset Type = support\n"
                                     "set Normal stiffness = 2e3\nset Tangential damping = 30\n"
                                     "end\nend\n");
  std::set<std::pair<unsigned int, unsigned int>> pairs = {{0, 0}, {1, 1}, {2, 0},
                                                           {2, 1}, {3, 0}, {3, 1}};
  const std::vector<BoundaryCondition> conditions =
      read_boundary_conditions(file.root().subsection("Boundaries"),
                               {"left", "right", "bottom", "top"}, {"one", "two"}, pairs, 2, false);
  BoundaryConstraints<2> constraints(space, conditions);
  constraints.build();
  std::vector<RegionOperators> operators(2);
  assemble_region_operators(space, operators);
  assemble_supports(space, conditions, operators);

  struct Case
  {
    std::string name;
    double compressibility; ///< of the first region
    bool is_single;
    DirectSolver direct_solver;
    unsigned int n_pivoted; ///< factors without pivots that lose their digits
  };
  for (const auto &[name, compressibility, is_single, direct_solver, n_pivoted] :
       {Case{"compressible: ", 0.1, false, DirectSolver::automatic, 0},
        Case{"incompressible: ", 0., false, DirectSolver::automatic, 0},
        Case{"compressible, in single precision: ", 0.1, true, DirectSolver::automatic, 0},
        Case{"incompressible, in single precision: ", 0., true, DirectSolver::automatic, 0},
        Case{"nearly incompressible, MUMPS: ", 1e-30, false, DirectSolver::mumps, 1}})
  {
    LinearSolverParameters parameters;
    parameters.direct_solver = direct_solver;
    if (is_single)
      parameters.factor_precision = FactorPrecision::single_precision;
    StepSystem<2> system(space, operators, constraints, parameters);
    unsigned int n_announced = 0;
    system.announce_pivots = [&n_announced](const std::string &of_factor)
    { n_announced += of_factor == "MUMPS, L D L^T without pivoting" ? 1 : 100; };
    system.reinit();
    const SystemCoefficients coefficients{{2., 5.}, {1., 1e4}, {compressibility, 0.01}, 0.3, 1.};
    check::is_true(name + "a factor is made", system.prepare(coefficients));
    check::is_true(name + "and kept", !system.prepare(coefficients));

    // Any velocity that obeys the constraints, and any pressure.
    DistributedVector velocity = small_problem::interpolated<2>(
        space,
        [](const Point<2> &x) {
          return Tensor<1, 2>({std::sin(x[0] + 2. * x[1]), std::cos(3. * x[0] * x[1])});
        });
    DistributedVector zero = space.velocity_vector();
    constraints.set_constrained(velocity, zero);
    const DistributedVector pressure = small_problem::interpolated_pressure<2>(
        space, [](const Point<2> &x, const unsigned int region)
        { return 10. * region + std::sin(x[0] - x[1]); });

    DistributedVector momentum = space.velocity_vector(), mass = space.pressure_vector();
    system.add_velocity_product(velocity, momentum);
    system.add_gradient(-1., pressure, momentum);
    constraints.restrict_to_free(momentum);
    system.add_divergence(-1., velocity, mass);
    DistributedVector compression = space.pressure_vector();
    system.add_compression(pressure, compression);
    mass.add(-1., compression);

    DistributedVector solved = space.velocity_vector(), solved_pressure = space.pressure_vector();
    system.solve(momentum, mass, solved, solved_pressure);
    const unsigned int n_iterations = system.take_iterations();
    check::is_true(name + "iterations",
                   is_single ? n_iterations > 0 && n_iterations < 5 : n_iterations == 0);
    constraints.set_constrained(solved, zero);
    solved.add(-1., velocity);
    solved_pressure.add(-1., pressure);
    check::absolute(name + "velocity", solved.linfty_norm(), 0., 1e-9);
    check::absolute(name + "pressure", solved_pressure.linfty_norm(), 0., 1e-7);
    check::absolute(name + "factors that needed pivots", n_announced, n_pivoted, 0.);

    SystemCoefficients others = coefficients;
    others.mass[0] *= 1.5;
    check::is_true(name + "another step, another factor", system.prepare(others));
    others.support_stiffness *= 1.5;
    check::is_true(name + "another support, another factor", system.prepare(others));
  }
}
} // namespace test_of_step_system
