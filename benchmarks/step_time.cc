// What a step costs: the cantilever in two and three dimensions on meshes of many sizes, beside
// what the memory's bandwidth allows and what a naive direct solution would take.
//
//   benchmark_step_time OUTPUT SOURCE_DIRECTORY [--all-solvers]
//
// writes OUTPUT.txt and OUTPUT.md. With --all-solvers CHOLMOD is measured in the largest plane
// case, too, where it takes most of a minute to factor.

#include "measurement.h"
#include "naive_step.h"

#include <continua/base/log.h>
#include <continua/case/case.h>
#include <continua/continuum/discrete_continuum.h>
#include <continua/finite_element/taylor_hood.h>
#include <continua/program/analyses.h>

#include <Epetra_CrsMatrix.h>

#include <cmath>
#include <iostream>
#include <map>
#include <random>

namespace Benchmarks
{
using namespace Continua;

constexpr unsigned int n_repetitions = 5;
/// Each repetition takes as many steps as fit into this time, and at least one [s].
constexpr double repetition_time = 0.3;

struct Sizes
{
  unsigned int n_dimensions;
  std::string cells;
  unsigned int refinements;
  std::vector<std::string> solvers;
};

/// One row of the tables; times in seconds, of one step where nothing else is said.
struct Row
{
  std::string cells, solver;
  unsigned int n_dimensions = 0;
  double n_dofs = 0., factor_entries = 0., factor_memory = 0., entry_bytes = 0.;
  double factor = 0., right_hand_side = 0., solve = 0., update = 0., step = 0.,
         step_with_ledger = 0.;
  double product_bytes = 0.;
  double bandwidth = 0.; ///< of the triad between the repetitions [bytes/s]
  double naive_factor = 0., naive_solve = 0.;
};

/// Processor times by section [s].
std::map<std::string, double> section_times(Log &log)
{
  return log.timer().processor_times();
}

/// A mesh with what a naive step on it costs.
template <int dim>
class Bench
{
public:
  Bench(const std::string &source_directory, const Sizes &sizes);
  /// Measures the steps with one direct solver.
  Row measure(const std::string &solver, Triad &triad);
  /// The largest difference between the naive step's solution and ours, relative.
  double difference();

private:
  const Sizes &sizes;
  std::string parameter_file;
  std::vector<std::string> overrides;
  Log log;
  ParameterFile file;
  Case<dim> input;
  double naive_factor = 0., naive_solve = 0., product_bytes = 0., naive_difference = 0.;

  Step step(unsigned int number) const;
  void measure_naive();
};

template <int dim>
Bench<dim>::Bench(const std::string &source_directory, const Sizes &sizes)
    : sizes(sizes),
      parameter_file(source_directory + (dim == 2 ? "/parameter_files/thesis/chapter-4/beam.prm"
                                                  : "/benchmarks/beam-3d.prm")),
      overrides(
          {"Mesh/Cells=" + sizes.cells, "Mesh/Refinements=" + std::to_string(sizes.refinements)}),
      log(MPI_COMM_WORLD),
      file(parameter_file, overrides),
      input(analyses().read_case<dim>(file, MPI_COMM_WORLD))
{
  input.triangulation->refine_global(input.mesh.refinements);
  measure_naive();
}

template <int dim>
Step Bench<dim>::step(const unsigned int number) const
{
  const double size = input.time.time_step;
  return backward_differencing_step(number * size, size, size, input.time.update_type());
}

template <int dim>
void Bench<dim>::measure_naive()
{
  Space<dim> space(*input.triangulation, input.discretisation.taylor_hood.space,
                   input.problem.model, input.problem.regions.size());
  space.distribute();
  std::vector<RegionOperators> operators(input.problem.regions.size());
  assemble_region_operators(space, operators);
  BoundaryConstraints<dim> constraints(space, input.problem.conditions);
  constraints.build();
  SystemCoefficients coefficients;
  const Step first = step(0);
  for (const Material &material : input.problem.materials)
  {
    coefficients.mass.push_back(first.a0 * material.density);
    coefficients.stiffness.push_back(material.shear.viscosity +
                                     BranchHistory::step_stiffness(material, first));
    coefficients.compressibility.push_back(material.inverse_bulk_modulus() / first.pressure_time);
  }
  // A step multiplies once by each: inertia, branches, pressure of the past; 8 bytes of value and
  // 4 of index an entry.
  for (const RegionOperators &region : operators)
    product_bytes +=
        12. * (region.mass.n_nonzero_elements() + region.stiffness.n_nonzero_elements() +
               region.pressure_mass.n_nonzero_elements());

  NaiveStep<dim> naive(space, operators, constraints, coefficients);
  naive_factor = processor_time([&]() { naive.factorize(); });
  DistributedVector momentum = space.velocity_vector(), mass = space.pressure_vector();
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> distribution(-1., 1.);
  for (double &value : momentum)
    value = distribution(generator);
  constraints.restrict_to_free(momentum);
  const unsigned int n_velocity = space.velocity_dofs.n_dofs();
  dealii::Vector<double> right_hand_side(n_velocity + space.pressure_dofs.n_dofs()),
      solution(right_hand_side.size());
  std::copy(momentum.begin(), momentum.end(), right_hand_side.begin());
  std::vector<double> times;
  for (unsigned int repetition = 0; repetition < n_repetitions; ++repetition)
    times.push_back(processor_time([&]() { naive.solve(solution, right_hand_side); }));
  naive_solve = median(times);

  // Whether both solve the same system is asked where it is quick.
  if (right_hand_side.size() > 20000)
    return;
  StepSystem<dim> system(space, operators, constraints, {});
  system.reinit();
  system.prepare(coefficients);
  DistributedVector velocity = space.velocity_vector(), pressure = space.pressure_vector();
  system.solve(momentum, mass, velocity, pressure);
  double scale = 0.;
  for (unsigned int i = 0; i < n_velocity; ++i)
  {
    scale = std::max(scale, std::abs(solution[i]));
    naive_difference = std::max(naive_difference, std::abs(solution[i] - velocity.begin()[i]));
  }
  naive_difference /= scale;
}

template <int dim>
Row Bench<dim>::measure(const std::string &solver, Triad &triad)
{
  TaylorHoodParameters parameters = input.discretisation.taylor_hood;
  parameters.linear_solver.type = LinearSolverType::direct;
  parameters.linear_solver.direct_solver = value_of(direct_solver_words(), solver);
  Log times_of_run(MPI_COMM_WORLD);
  times_of_run.timer().take_processor_times();
  DiscreteContinuum<dim> body(std::make_unique<TaylorHood<dim>>(*input.triangulation, input.problem,
                                                                parameters, times_of_run),
                              input.problem, times_of_run);
  body.initialise();
  unsigned int n_steps = 0;
  const double first = processor_time([&]() { body.advance(step(n_steps++)); });
  // The second step is free of first uses and tells how many fit into a repetition.
  const double one = processor_time([&]() { body.advance(step(n_steps++)); });
  const unsigned int steps_of_repetition =
      std::max(1u, static_cast<unsigned int>(repetition_time / one));

  Row row;
  row.factor = first - one;
  std::map<std::string, std::vector<double>> times;
  for (unsigned int repetition = 0; repetition < n_repetitions; ++repetition)
  {
    times["triad"].push_back(triad.bandwidth());
    body.advance(step(n_steps++)); // brings the factor back to the cache
    const std::map<std::string, double> before = section_times(times_of_run);
    const double whole = processor_time(
        [&]()
        {
          for (unsigned int i = 0; i < steps_of_repetition; ++i)
            body.advance(step(n_steps++));
        });
    const std::map<std::string, double> after = section_times(times_of_run);
    for (const char *const section : {"right-hand side", "solve", "update"})
      times[section].push_back((after.at(section) - before.at(section)) / steps_of_repetition);
    times["step"].push_back(whole / steps_of_repetition);
    times["with ledger"].push_back(processor_time(
                                       [&]()
                                       {
                                         for (unsigned int i = 0; i < steps_of_repetition; ++i)
                                         {
                                           body.advance(step(n_steps++));
                                           body.power_balance(false);
                                         }
                                       }) /
                                   steps_of_repetition);
  }
  row.right_hand_side = median(times["right-hand side"]);
  row.solve = median(times["solve"]);
  row.update = median(times["update"]);
  row.step = median(times["step"]);
  row.bandwidth = median(times["triad"]);
  row.step_with_ledger = median(times["with ledger"]);

  const SolverSizes numbers = body.sizes();
  row.n_dimensions = dim;
  row.cells = std::to_string(numbers.n_cells);
  for (const auto &field : numbers.n_dofs)
    row.n_dofs += static_cast<double>(field.second);
  row.factor_entries = numbers.factor_entries;
  row.factor_memory = numbers.factor_memory;
  const bool is_cholmod = numbers.linear_solver.find("CHOLMOD") != std::string::npos;
  row.solver = is_cholmod ? "cholmod" : "mumps";
  // MUMPS's dense blocks need next to no indices.
  row.entry_bytes = is_cholmod ? 12. : 8.;
  row.product_bytes = product_bytes;
  row.naive_factor = naive_factor;
  row.naive_solve = naive_solve;
  return row;
}

template <int dim>
double Bench<dim>::difference()
{
  return naive_difference;
}

void write(Report &report, const std::vector<Row> &rows)
{
  const auto solve_limit = [](const Row &row)
  { return 2. * row.entry_bytes * row.factor_entries / row.bandwidth; };
  const auto step_limit = [&](const Row &row)
  { return solve_limit(row) + row.product_bytes / row.bandwidth; };
  const auto names = [](const Row &row)
  {
    return std::vector<std::string>{std::to_string(row.n_dimensions), row.cells,
                                    std::to_string(static_cast<long>(row.n_dofs)), row.solver};
  };
  const auto add = [&](const Row &row, const std::vector<double> &values)
  {
    std::vector<std::string> cells = names(row);
    for (const double value : values)
      cells.push_back(number(value));
    report.row(cells);
  };

  report.start_table("Ratios", {"dim", "cells", "dofs", "solver", "step/limit", "solve/limit",
                                "step/solve", "with ledger/solve", "naive solve/solve"});
  for (const Row &row : rows)
    add(row, {row.step / step_limit(row), row.solve / solve_limit(row), row.step / row.solve,
              row.step_with_ledger / row.solve, row.naive_solve / row.solve});
  report.start_table("Times of a step [ms]", {"dim", "cells", "dofs", "solver", "right-hand side",
                                              "solve", "update", "whole", "with ledger", "limit",
                                              "naive solve", "million dofs/s", "triad [GB/s]"});
  for (const Row &row : rows)
    add(row, {1e3 * row.right_hand_side, 1e3 * row.solve, 1e3 * row.update, 1e3 * row.step,
              1e3 * row.step_with_ledger, 1e3 * step_limit(row), 1e3 * row.naive_solve,
              1e-6 * row.n_dofs / row.step, 1e-9 * row.bandwidth});
  report.start_table("The factor", {"dim", "cells", "dofs", "solver", "entries", "bytes/dof",
                                    "factor [s]", "naive factor [s]", "factor/solve"});
  for (const Row &row : rows)
    add(row, {row.factor_entries, row.factor_memory / row.n_dofs, row.factor, row.naive_factor,
              row.factor / row.solve});
}

template <int dim>
void measure(const std::string &source_directory,
             const Sizes &sizes,
             Triad &triad,
             std::vector<Row> &rows,
             double &difference)
{
  Bench<dim> bench(source_directory, sizes);
  for (const std::string &solver : sizes.solvers)
  {
    rows.push_back(bench.measure(solver, triad));
    std::cerr << dim << "-D, " << rows.back().n_dofs << " dofs, " << rows.back().solver << ": step "
              << 1e3 * rows.back().step << " ms, solve " << 1e3 * rows.back().solve
              << " ms, factor " << rows.back().factor << " s, naive factor "
              << rows.back().naive_factor << " s, solve " << 1e3 * rows.back().naive_solve
              << " ms, triad " << 1e-9 * rows.back().bandwidth << " GB/s" << std::endl;
  }
  difference = std::max(difference, bench.difference());
}

void run(const std::string &output, const std::string &source_directory, const bool all_solvers)
{
  const std::vector<std::string> both = {"cholmod", "mumps"};
  const auto chosen = all_solvers ? both : std::vector<std::string>{"automatic"};
  const std::vector<Sizes> all_sizes = {
      {2, "12, 3", 0, both},    {2, "40, 10", 0, both},
      {2, "40, 10", 1, both},   {2, "40, 10", 2, both},
      {2, "40, 10", 3, both},   {2, "40, 10", 4, chosen},
      {3, "8, 2, 2", 0, both},  {3, "8, 2, 2", 1, both},
      {3, "24, 6, 6", 0, both}, {3, "40, 10, 10", 0, {"automatic"}}};

  Report report("Time of a step");
  describe_machine(report);
  describe_libraries(report);
  Triad triad;
  report.line("times: processor time of one core; triad: measured between the repetitions");
  report.line("cantilever of chapter 4 in two dimensions, 20 m x 5 m x 5 m in three; backward "
              "differencing, 0.1 ms; medians of " +
              std::to_string(n_repetitions) + " repetitions of " + number(repetition_time) +
              " s or one step");
  report.line("limit: bytes of the factor twice (12 an entry for CHOLMOD, 8 for MUMPS) and of the "
              "step's matrix products once, over the triad's bandwidth; a system that fits into "
              "the cache may be faster");
  report.line("naive: deal.II's SparseDirectUMFPACK, as it is, on the assembled matrix");

  std::vector<Row> rows;
  double difference = 0.;
  for (const Sizes &sizes : all_sizes)
    if (sizes.n_dimensions == 2)
      measure<2>(source_directory, sizes, triad, rows, difference);
    else
      measure<3>(source_directory, sizes, triad, rows, difference);
  report.line("largest difference of the naive solution from ours, relative, up to 20,000 dofs: " +
              number(difference));
  report.line("load at the end: " + number(load()));
  write(report, rows);
  report.finish(output);
}
} // namespace Benchmarks

int main(int argc, char **argv)
{
  return Benchmarks::main_of(argc, argv, Benchmarks::run, "--all-solvers");
}
