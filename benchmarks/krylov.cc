// Iterations of the iterative solver over mesh size, time step, shear modulus, aspect ratio and
// Poisson's ratio, with algebraic multigrid on all velocities at once as the control; and where it
// overtakes a direct solver.
//
//   benchmark_krylov OUTPUT [--times]
//
// writes OUTPUT.txt and OUTPUT.md. --times: without the iterations.

#include "measurement.h"

#include <continua/base/parameter_file.h>
#include <continua/boundary/boundary_condition.h>
#include <continua/finite_element/solvers/condensed_system.h>
#include <continua/finite_element/solvers/iterative/iterative_step_solver.h>
#include <continua/finite_element/solvers/step_system.h>
#include <continua/linear_algebra/matrix_product.h>

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/lac/solver_cg.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <set>

namespace Benchmarks
{
using namespace Continua;
using namespace dealii;

/// Water of 10 mm depth or radius under a wall of 2 n rows of cells whose length is `aspect` times
/// their height; or a clamped beam of five times its height.
struct Problem
{
  std::string body = "channel"; ///< channel, tube, duct, beam or bar
  unsigned int n = 2;           ///< cells of 2 mm / n
  double time_step = 1e-5, shear_modulus = 2e9, aspect = 1., poisson = 0.3, viscosity = 1e-3;
};

bool is_solid(const Problem &problem)
{
  return problem.body == "beam" || problem.body == "bar";
}

/// A body, its matrices and its load, its own weight under 1 m/s^2 in every direction.
template <int dim>
class Body
{
public:
  explicit Body(const Problem &problem);

  const Problem problem;
  parallel::distributed::Triangulation<dim> mesh;
  std::unique_ptr<Space<dim>> space;
  std::vector<RegionOperators> operators;
  std::vector<BoundaryCondition> conditions;
  std::unique_ptr<BoundaryConstraints<dim>> constraints;
  SystemCoefficients coefficients;
  std::vector<double> densities;
  DistributedVector weight, mass, velocity, pressure;
  unsigned int n_unknowns = 0;

private:
  void make_mesh();
  void make_conditions(unsigned int n_regions);
};

template <int dim>
void Body<dim>::make_mesh()
{
  std::vector<std::vector<double>> steps(dim);
  const double h = 2e-3 / problem.n;
  const auto add = [&](const unsigned int direction, const unsigned int number, const double size)
  { steps[direction].insert(steps[direction].end(), number, size); };
  if (is_solid(problem))
  {
    const unsigned int across = 2 * problem.n;
    add(0, 5 * across, problem.aspect * h);
    for (unsigned int direction = 1; direction < dim; ++direction)
      add(direction, across, h);
  }
  else
  {
    add(0, (dim == 2 ? 50 : 10) * problem.n, h);
    add(1, 5 * problem.n, h);
    add(1, 2 * problem.n, h / problem.aspect);
    if (dim == 3)
      add(2, 3 * problem.n, h);
  }
  Point<dim> end;
  for (unsigned int direction = 0; direction < dim; ++direction)
    for (const double step : steps[direction])
      end[direction] += step;
  GridGenerator::subdivided_hyper_rectangle(mesh, steps, Point<dim>(), end, true);
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(!is_solid(problem) && cell->center()[1] > 0.01 ? 1 : 0);
}

template <int dim>
void Body<dim>::make_conditions(const unsigned int n_regions)
{
  const bool solid = is_solid(problem);
  std::vector<std::pair<std::string, std::string>> types = {{"left", "fixed"},
                                                            {"right", "free"},
                                                            {"bottom", solid ? "free"
                                                                       : problem.body == "tube"
                                                                           ? "axis"
                                                                           : "roller"},
                                                            {"top", "free"}};
  if (dim == 3)
    for (const char *const side : {"back", "front"})
      types.emplace_back(side, solid ? "free" : "roller");
  const std::string path = "benchmark_krylov.prm";
  std::vector<std::string> names;
  {
    std::ofstream file(path);
    file << "subsection Boundaries\n";
    for (const auto &[name, type] : types)
    {
      file << "subsection " << name << "\nset Type = " << type << "\nend\n";
      names.push_back(name);
    }
    file << "end\n";
  }
  std::set<std::pair<unsigned int, unsigned int>> pairs;
  for (unsigned int face = 0; face < 2 * dim; ++face)
    for (unsigned int region = 0; region < n_regions; ++region)
      pairs.insert({face, region});
  std::vector<std::string> regions = {"first", "second"};
  regions.resize(n_regions);
  ParameterFile file(path, {});
  conditions = read_boundary_conditions(file.root().subsection("Boundaries"), names, regions, pairs,
                                        dim, problem.body == "tube");
}

template <int dim>
Body<dim>::Body(const Problem &problem) : problem(problem), mesh(MPI_COMM_WORLD)
{
  make_mesh();
  const unsigned int n_regions = is_solid(problem) ? 1 : 2;
  const Model model = problem.body == "tube" ? Model::axisymmetric
                      : dim == 3             ? Model::three_dimensional
                                             : Model::plane_strain;
  space = std::make_unique<Space<dim>>(mesh, SpaceParameters(), model, n_regions);
  space->distribute();
  n_unknowns = space->velocity_dofs.n_dofs() + space->pressure_dofs.n_dofs();
  operators.resize(n_regions);
  assemble_region_operators(*space, operators);
  make_conditions(n_regions);
  constraints = std::make_unique<BoundaryConstraints<dim>>(*space, conditions);
  constraints->build();

  // Backward Euler.
  const double dt = problem.time_step, mu = problem.shear_modulus, nu = problem.poisson;
  const auto add = [&](const double density, const double alpha, const double inverse_bulk_modulus)
  {
    densities.push_back(density);
    coefficients.mass.push_back(density / dt);
    coefficients.stiffness.push_back(alpha);
    coefficients.compressibility.push_back(inverse_bulk_modulus / dt);
  };
  if (!is_solid(problem))
    add(1000., problem.viscosity, 1. / 2.2e9);
  add(1100., mu * dt, 3. * (1. - 2. * nu) / (2. * mu * (1. + nu)));

  velocity = weight = space->velocity_vector();
  pressure = mass = space->pressure_vector();
  DistributedVector one = velocity, product = velocity;
  one = 1.;
  for (unsigned int region = 0; region < n_regions; ++region)
  {
    multiply(operators[region].mass, product, one);
    weight.add(densities[region], product);
  }
  constraints->restrict_to_free(weight);
}

/// FGMRES iterations from zero to 1e-8.
template <int dim>
unsigned int iterations(Body<dim> &body, const LinearSolverParameters &parameters)
{
  IterativeStepSolver<dim> solver(*body.space, body.operators, *body.constraints, parameters);
  solver.prepare(body.coefficients);
  return solver.solve(body.weight, body.mass, body.velocity, body.pressure);
}

/// CG iterations for A alone to 1e-8 with algebraic multigrid on all velocities, that is told of
/// the translations only; at most 300.
template <int dim>
unsigned int control_iterations(Body<dim> &body)
{
  TrilinosWrappers::SparseMatrix matrix;
  assemble_velocity_block(*body.space, body.operators, *body.constraints, body.coefficients,
                          nullptr, nullptr, matrix);
  VelocityBlocks all;
  all.n_components = dim;
  all.stiff_is_direct = false;
  const unsigned int n = body.space->velocity_owned.n_elements();
  all.modes.assign(dim, std::vector<double>(n, 0.));
  for (unsigned int c = 0; c < dim; ++c)
  {
    ComponentMask component(dim, false);
    component.set(c, true);
    for (const auto index : DoFTools::extract_dofs(body.space->velocity_dofs, component))
      all.modes[c][body.space->velocity_owned.index_within_set(index)] = 1.;
  }
  for (unsigned int i = 0; i < n; ++i)
    all.stiff.push_back(i);
  VelocityPreconditioner multigrid(matrix, all, nullptr);
  struct Inverse
  {
    VelocityPreconditioner &multigrid;
    void vmult(DistributedVector &target, const DistributedVector &source) const
    {
      multigrid.vmult(target, source);
    }
  };
  SolverControl control(300, 1e-8 * body.weight.l2_norm());
  SolverCG<DistributedVector> solver(control);
  body.velocity = 0.;
  try
  {
    solver.solve(matrix, body.velocity, body.weight, Inverse{multigrid});
  }
  catch (const SolverControl::NoConvergence &)
  {
  }
  return control.last_step();
}

std::string text(const unsigned int n, const unsigned int cap)
{
  return n < cap ? std::to_string(n) : "> " + std::to_string(cap - 1);
}

template <int dim>
void iterations(Report &report, const Problem &problem)
{
  Body<dim> body(problem);
  LinearSolverParameters parameters;
  parameters.maximum_iterations = 300;
  const auto count = [&](const SchurApproximation schur_complement)
  {
    parameters.schur_complement = schur_complement;
    try
    {
      return text(iterations(body, parameters), 300);
    }
    catch (const RunError &)
    {
      return text(300, 300);
    }
  };
  const std::string ours = count(SchurApproximation::cahouet_chabard),
                    simple = count(SchurApproximation::simple);
  report.row({problem.body, std::to_string(problem.n), std::to_string(body.n_unknowns),
              number(problem.time_step), number(problem.shear_modulus), number(problem.aspect),
              number(problem.poisson), number(problem.viscosity), ours, simple,
              text(control_iterations(body), 300)});
  std::cerr << problem.body << " " << body.n_unknowns << ": " << ours << " " << simple << std::endl;
}

/// Time of set-up and of a step, over ten steps of backward Euler from rest, of one solver.
template <int dim>
void crossover(Report &report, const Problem &problem, const LinearSolverType type)
{
  const std::string name = type == LinearSolverType::direct ? "direct" : "iterative";
  Body<dim> body(problem);
  LinearSolverParameters parameters;
  parameters.type = type;
  StepSystem<dim> system(*body.space, body.operators, *body.constraints, parameters);
  system.reinit();
  const double set_up = processor_time([&]() { system.prepare(body.coefficients); });
  DistributedVector displacement = body.space->velocity_vector(), momentum = displacement,
                    product = displacement, velocity = displacement, zero = displacement;
  DistributedVector mass = body.space->pressure_vector(), pressure = mass, compression = mass;
  const unsigned int n_steps = 10;
  std::vector<double> times;
  unsigned int n_iterations = 0;
  const double dt = problem.time_step;
  for (unsigned int step = 0; step < n_steps; ++step)
  {
    momentum = body.weight;
    for (unsigned int region = 0; region < body.operators.size(); ++region)
    {
      multiply(body.operators[region].mass, product, velocity);
      momentum.add(body.coefficients.mass[region], product);
      if (region + 1 == body.operators.size()) // the solid
      {
        multiply(body.operators[region].stiffness, product, displacement);
        momentum.add(-problem.shear_modulus, product);
      }
    }
    body.constraints->restrict_to_free(momentum);
    mass = 0.;
    system.add_compression(pressure, mass);
    mass *= -1.;
    times.push_back(processor_time([&]() { system.solve(momentum, mass, velocity, pressure); }));
    n_iterations += system.take_iterations();
    body.constraints->set_constrained(velocity, zero);
    displacement.add(dt, velocity);
  }
  report.row(
      {problem.body, std::to_string(body.n_unknowns), name, number(set_up), number(median(times)),
       number(static_cast<double>(n_iterations) / static_cast<double>(n_steps)),
       number(system.factor() != nullptr ? system.factor()->memory() / body.n_unknowns : 0.)});
  std::cerr << problem.body << " " << body.n_unknowns << " " << name << ": " << set_up << " s, "
            << median(times) << " s a step" << std::endl;
}

/// The table of iterations.
void count_iterations(const std::string &output, Report &report)
{
  report.start_table("Iterations",
                     {"body", "n", "unknowns", "time step [s]", "mu [Pa]", "aspect", "nu",
                      "viscosity [Pa s]", "cahouet-chabard", "simple", "control"});
  for (const std::string body : {"channel", "tube", "beam"})
  {
    for (const double time_step : {1e-7, 1e-5, 1e-3})
      for (const unsigned int n : {1, 2, 4})
        iterations<2>(report, {body, n, time_step});
    for (const double time_step : {1e-7, 1e-5, 1e-3})
      for (const double shear_modulus : {2e9, 8e10})
        for (const double aspect : {10., 40.})
          for (const double poisson : {0.3, 0.4999})
            iterations<2>(report, {body, 2, time_step, shear_modulus, aspect, poisson});
    for (const double poisson : {0.49, 0.4999, 0.5})
      iterations<2>(report, {body, 2, 1e-4, 2e9, 1., poisson});
    report.save(output);
  }
  for (const double viscosity : {1., 10., 1e3})
    iterations<2>(report, {"channel", 2, 1e-3, 2e9, 1., 0.3, viscosity});
  for (const std::string body : {"duct", "bar"})
  {
    for (const double time_step : {1e-7, 1e-5, 1e-3})
      for (const unsigned int n : {1, 2})
        iterations<3>(report, {body, n, time_step});
    iterations<3>(report, {body, 3, 1e-5});
    for (const double aspect : {10., 40.})
      for (const double poisson : {0.3, 0.4999})
        iterations<3>(report, {body, 1, 1e-3, 8e10, aspect, poisson});
    report.save(output);
  }
}

void run(const std::string &output, const bool times_only)
{
  Report report("Iterative solver");
  describe_machine(report);
  describe_libraries(report);
  report.line(
      "iterations to 1e-8 of the load's residual, from zero; the solver's own choices, with "
      "either Schur complement; times of one core");
  report.line("control: conjugate gradients for the velocity block alone, algebraic multigrid on "
              "all of it at once");

  if (!times_only)
    count_iterations(output, report);

  report.start_table("Direct and iterative",
                     {"body", "unknowns", "solver", "set-up [s]", "solve of a step [s]",
                      "iterations a step", "factor [bytes/unknown]"});
  for (const LinearSolverType type : {LinearSolverType::direct, LinearSolverType::iterative})
  {
    for (const unsigned int n : {2, 4, 8})
      crossover<2>(report, {"channel", n}, type);
    for (const std::string body : {"duct", "bar"})
      for (const unsigned int n : {1, 2, 3})
        crossover<3>(report, {body, n}, type);
  }
  report.line("load at the end: " + number(load()));
  report.finish(output);
}
} // namespace Benchmarks

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool times_only = argc == 3 && std::string(argv[2]) == "--times";
  if (argc != 2 && !times_only)
  {
    std::cerr << "usage: " << argv[0] << " OUTPUT [--times]" << std::endl;
    return 2;
  }
  try
  {
    Benchmarks::run(argv[1], times_only);
  }
  catch (const std::exception &error)
  {
    std::cerr << "error: " << error.what() << std::endl;
    return 1;
  }
}
