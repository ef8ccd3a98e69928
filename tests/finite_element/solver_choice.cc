// The rule of Linear solver/Type = automatic, as a table: what is known of the run, and what
// follows.

#include <continua/finite_element/solvers/solver_choice.h>

#include "../unit_test.h"

#include <regex>

namespace test_of_solver_choice
{
using namespace Continua;

namespace
{
struct Row
{
  std::string name;
  unsigned int dim;
  double n_unknowns, n_solves, memory; ///< of the limit [GB]
  StepSolver solver;
  std::string reason;
};

/// A tube: the factor's entries as those of elastic-tube-3d, or of a channel.
SystemSize size_of(const Row &row)
{
  SystemSize reference;
  reference.dim = row.dim;
  reference.n_regions = 2;
  reference.n_unknowns = 1e5;
  reference.factor_entries = row.dim == 2 ? 5e6 : 8e7;
  return reference.scaled_to(row.n_unknowns);
}

void expect(const Row &row,
            const LinearSolverParameters &parameters,
            const bool is_of_tangents = false,
            const bool is_finite = false)
{
  SolverOutlook outlook;
  outlook.is_finite = is_finite;
  outlook.n_solves = row.n_solves;
  outlook.memory_limit = 1e9 * row.memory;
  const SolverChoice choice = is_of_tangents
                                  ? choose_tangent_solver(parameters, size_of(row), outlook)
                                  : choose_step_solver(parameters, size_of(row), outlook);
  check::is_true(row.name + ": solver", choice.solver == row.solver);
  const bool is_reason = std::regex_search(choice.reason, std::regex(row.reason));
  check::is_true(row.name + ": reason", is_reason);
  if (choice.solver != row.solver || !is_reason)
    std::cout << choice.reason << std::endl;
}
} // namespace

UNIT_TEST(solver_choice)
{
  constexpr StepSolver direct = StepSolver::direct, single = StepSolver::single_precision,
                       iterative = StepSolver::iterative;
  const LinearSolverParameters automatic;
  const std::vector<Row> table = {
      {"plane", 2, 9e5, 1., 100., direct, "^there are no more than 1000000 unknowns in 2 dim"},
      {"large plane", 2, 1.1e6, 1e5, 100., iterative, "^there are more than 1000000"},
      {"plane, little memory", 2, 9e5, 1e5, 2.95, single,
       "double precision needs about 3.* of 2.95"},
      {"plane, no memory", 2, 9e5, 1e5, 1., iterative, "single precision needs about"},
      {"small", 3, 3e4, 1., 100., direct, "^there are no more than 30000 unknowns in 3 dim"},
      {"small, no memory", 3, 3e4, 1., 0.1, iterative, "single precision needs about"},
      {"few steps", 3, 1.2e5, 10., 100., iterative, "^its set-up and 10 solves take about"},
      {"many steps", 3, 1.2e5, 1e4, 100., direct, "^there are no more than 150000"},
      {"many steps, little memory", 3, 1.2e5, 1e4, 1.4, single, "double precision needs about"},
      {"few steps, little memory", 3, 1.2e5, 10., 1.4, iterative, "^its set-up and 10 solves"},
      {"no memory", 3, 1.2e5, 1e4, 0.5, iterative, "single precision needs about"},
      {"large, few steps", 3, 2.5e5, 10., 100., iterative, "^its set-up and 10 solves"},
      {"large, many steps", 3, 2.5e5, 1e4, 100., single, "^there are more than 150000"},
      {"too large", 3, 3.1e5, 1e5, 1000., iterative, "^there are more than 300000"},
  };
  for (const Row &row : table)
    expect(row, automatic);

  // Entries have the last word.
  LinearSolverParameters parameters;
  parameters.type = LinearSolverType::iterative;
  expect({"iterative", 3, 1e3, 1e5, 100., iterative, "Linear solver/Type says"}, parameters);
  parameters.type = LinearSolverType::direct;
  expect({"direct", 3, 1e6, 1., 1000., direct, "Linear solver/Type says"}, parameters);
  expect({"direct, little memory", 3, 1.2e5, 1., 1.4, single, "needs about"}, parameters);
  expect({"direct, no memory", 3, 1.2e5, 1., 0.1, direct, "Linear solver/Type says"}, parameters);
  parameters.factor_precision = FactorPrecision::double_precision;
  expect({"double, little memory", 3, 1.2e5, 1., 1.4, direct, "Type says"}, parameters);
  parameters.factor_precision = FactorPrecision::single_precision;
  expect({"single", 3, 1e3, 1., 100., single, "Linear solver/Factor precision says"}, parameters);
  parameters.type = LinearSolverType::automatic;
  expect({"single, few steps", 3, 1.2e5, 10., 100., iterative, "^its set-up"}, parameters);
  parameters.factor_precision = FactorPrecision::double_precision;
  expect({"never single", 3, 2.5e5, 1e4, 100., iterative, "^there are more than 150000"},
         parameters);
  parameters = automatic;
  parameters.direct_solver = DirectSolver::umfpack;
  expect({"umfpack, little memory", 3, 1.2e5, 1e4, 1.4, iterative, "needs about"}, parameters);

  // Tangents of convection.
  parameters = automatic;
  expect({"tangent", 3, 1.2e5, 1., 100., direct, "^there are no more than 150000"}, parameters,
         true);
  expect({"tangent, little memory", 3, 1.2e5, 1e4, 4., iterative,
          "^a factor of the tangent needs about 4.5.* of 4 GB"},
         parameters, true);
  expect({"large tangent", 3, 1.6e5, 1e4, 100., iterative, "^there are more than 150000"},
         parameters, true);
  expect({"large tangent to rest", 3, 1.6e5, 1e9, 100., direct, "fits into the memory"}, parameters,
         true);
  expect(
      {"large tangent of finite deformation", 3, 1.6e5, 1e4, 100., direct, "fits into the memory"},
      parameters, true, true);
  expect({"tangent of finite deformation, little memory", 3, 1.2e5, 1e4, 4., iterative,
          "^a factor of the tangent needs about 4.5.* of 4 GB"},
         parameters, true, true);
  parameters.type = LinearSolverType::direct;
  expect({"direct tangent", 3, 1.6e5, 1., 1., direct, "Linear solver/Type says"}, parameters, true);

  // Entries of a factor grow as nested dissection says.
  SystemSize size = size_of(table.back());
  check::relative("scaled entries", size.scaled_to(8. * size.n_unknowns).factor_entries,
                  16. * size.factor_entries, 1e-12);
}
} // namespace test_of_solver_choice
