#include <continua/finite_element/solvers/solver_choice.h>

#include <continua/base/memory_limit.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
namespace
{
// The constants are fits to runs; doc/estimates.md and doc/linear-solvers.md have the runs.

constexpr double nanosecond = 1e-9, microsecond = 1e-6; // [s]
/// Bytes that an entry of a factor takes, with what the solver needs besides.
constexpr double bytes_per_entry = 11.5;
constexpr double bytes_per_single_entry = 6.;
/// Of a tangent: what UMFPACK's analysis takes for an entry of the matrix, and UMFPACK's own factor
/// beside the packed one for an entry of these.
constexpr double bytes_per_tangent_entry = 70., bytes_per_unsymmetric_entry = 25.;
/// Uses of a factor in single precision for a solve by FGMRES, which has two iterations: deal.II
/// tests for convergence at the start of the next one.
constexpr double uses_of_single_precision = 3.;
/// As many solves as a run has whose solves nobody can count.
constexpr double many_solves = 1e9;

SolverCost cost_of_factor(const SystemSize &size)
{
  const bool is_plane = size.dim == 2;
  SolverCost cost;
  cost.memory = (is_plane ? 2900. : 7400.) * size.n_unknowns +
                size.n_factors * bytes_per_entry * size.factor_entries;
  double factor_time = 140. * nanosecond * size.factor_entries;
  cost.solve_time = 0.4 * microsecond * size.n_unknowns + 1.1 * nanosecond * size.factor_entries;
  if (size.takes_cholmod)
  {
    factor_time = (is_plane ? 160. : 360.) * nanosecond * size.factor_entries *
                  std::pow(std::max(1., size.factor_entries / 1e6), 0.3);
    cost.solve_time = (size.factor_entries < 4e5 ? 0.7
                       : is_plane                ? 2.8
                                                 : 2.3) *
                      nanosecond * size.factor_entries;
  }
  cost.factor_time = factor_time;
  cost.set_up_time =
      (is_plane ? 12. : 48.) * microsecond * size.n_unknowns + size.n_factors * factor_time;
  return cost;
}

SolverCost cost_of_single_precision(const SystemSize &size)
{
  SystemSize of_mumps = size;
  of_mumps.takes_cholmod = false;
  const SolverCost of_factor = cost_of_factor(of_mumps);
  const bool is_plane = size.dim == 2;
  const bool is_lean = size.is_matrix_free && !is_plane;
  SolverCost cost;
  cost.memory = (is_lean    ? 3300.
                 : is_plane ? 2900.
                            : 7400.) *
                    size.n_unknowns +
                size.n_factors * bytes_per_single_entry * size.factor_entries;
  cost.set_up_time = 0.7 * of_factor.set_up_time;
  cost.solve_time =
      uses_of_single_precision * (0.7 * of_factor.solve_time + 0.3 * microsecond * size.n_unknowns);
  return cost;
}

SolverCost cost_of_iterations(const SystemSize &size)
{
  const bool is_plane = size.dim == 2;
  // In a plane the factor of a stiff block counts more than the products.
  const bool is_lean = size.is_matrix_free && !is_plane;
  // In space a wall and its liquid take more iterations than one body.
  const bool is_one_body = is_plane || size.n_regions == 1;
  SolverCost cost;
  cost.memory = (is_lean ? 2400. : is_plane ? 4500. : 11500.) * size.n_unknowns;
  const double assembly = is_plane ? 12. : is_lean ? 15. : 48.;
  const double preconditioner = is_plane ? 25. : is_lean ? 20. : 150.;
  cost.set_up_time = (assembly + size.n_factors * preconditioner) * microsecond * size.n_unknowns;
  cost.solve_time = (is_lean ? (is_one_body ? 2. : 6.) : (is_one_body ? 8. : 35.)) * microsecond *
                    size.n_unknowns;
  return cost;
}

/// Entries of a tangent for each unknown, both triangles: a node has (k + 2)^dim nodes of its own
/// kind in its row on average, a node of the velocity ((k^2 + k - 1)/k)^dim of the pressure's.
double tangent_entries_per_unknown(const SystemSize &size)
{
  const double k = size.degree, dim = size.dim;
  const auto power = [dim](const double x) { return std::pow(x, dim); };
  const double pressures = power((k - 1.) / k); // for a node of the velocity
  return (dim * dim * power(k + 2.) + 2. * dim * power((k * k + k - 1.) / k) +
          pressures * power(k + 1.)) /
         (dim + pressures);
}

double time_of(const SolverCost &cost, const double n_solves)
{
  return cost.set_up_time + n_solves * cost.solve_time;
}

/// The memory of a factor against the limit.
std::string memory_against(const double needed, const double limit, const std::string &what)
{
  return what + " needs about " + memory_text(needed) + " of " + memory_text(limit);
}

/// How the size compares with a limit: "there are no more than 30000 unknowns in 3 dimensions".
std::string size_against(const SystemSize &size, const double limit)
{
  std::ostringstream text;
  text.precision(0);
  text << std::fixed << "there are " << (size.n_unknowns > limit ? "more" : "no more") << " than "
       << limit << " unknowns in " << size.dim << " dimensions";
  return text.str();
}
} // namespace

SystemSize SystemSize::scaled_to(const double other_unknowns) const
{
  SystemSize other = *this;
  other.n_unknowns = other_unknowns;
  if (n_unknowns > 0.)
    other.factor_entries *= std::pow(other_unknowns / n_unknowns, dim == 2 ? 1. : 4. / 3.);
  // CHOLMOD, which one rank alone can have, is there for small matrices.
  if (dim == 3 && other_unknowns > largest_small_system_in_space)
    other.takes_cholmod = false;
  return other;
}

SolverCost cost_of_solver(const StepSolver solver, const SystemSize &size)
{
  switch (solver)
  {
  case StepSolver::direct:
    return cost_of_factor(size);
  case StepSolver::single_precision:
    return cost_of_single_precision(size);
  default:
    return cost_of_iterations(size);
  }
}

SolverChoice choose_step_solver(const LinearSolverParameters &parameters,
                                const SystemSize &size,
                                const SolverOutlook &outlook)
{
  const bool is_plane = size.dim == 2;
  const std::string by_entry = "Linear solver/Type says";
  if (outlook.is_of_vibrations)
    return {StepSolver::direct, "the solver of vibrations is direct"};
  if (parameters.type == LinearSolverType::iterative)
    return {StepSolver::iterative, by_entry};

  const auto memory_of = [&](const StepSolver solver)
  { return outlook.memory_of_program + cost_of_solver(solver, size).memory; };
  const auto fits = [&](const StepSolver solver)
  { return memory_of(solver) <= outlook.memory_limit; };
  const auto too_large = [&](const StepSolver solver, const std::string &precision)
  {
    return memory_against(memory_of(solver), outlook.memory_limit,
                          "a factor in " + precision + " precision");
  };
  const bool may_be_single = parameters.refinement_steps == 0 &&
                             parameters.factor_precision != FactorPrecision::double_precision &&
                             (parameters.direct_solver == DirectSolver::automatic ||
                              parameters.direct_solver == DirectSolver::mumps);
  const bool is_free = parameters.type == LinearSolverType::automatic;

  // The factor that is in question, and why in this precision.
  SolverChoice factor;
  double largest_system =
      is_plane ? largest_direct_system_in_plane : largest_direct_system_in_space;
  const double largest_single_system =
      is_plane ? largest_direct_system_in_plane : largest_single_precision_system_in_space;
  if (parameters.factor_precision == FactorPrecision::single_precision)
    factor = {StepSolver::single_precision, "Linear solver/Factor precision says"};
  else if (may_be_single && !fits(StepSolver::direct))
    factor = {StepSolver::single_precision, too_large(StepSolver::direct, "double")};
  else if (may_be_single && is_free && size.n_unknowns > largest_system)
    factor = {StepSolver::single_precision, size_against(size, largest_system)};
  else
    factor = {StepSolver::direct, is_free ? size_against(size, largest_system) : by_entry};
  if (factor.solver == StepSolver::single_precision)
    largest_system = largest_single_system;

  if (!is_free)
  {
    // Where neither fits the entry is obeyed as it stands.
    if (parameters.factor_precision == FactorPrecision::automatic && !fits(factor.solver))
      return {StepSolver::direct, by_entry};
    return factor;
  }
  if (size.n_unknowns > largest_system)
    return {StepSolver::iterative, size_against(size, largest_system)};
  if (!fits(factor.solver))
    return {StepSolver::iterative,
            too_large(factor.solver, factor.solver == StepSolver::direct ? "double" : "single")};
  if (is_plane)
    return factor;
  if (size.n_unknowns <= largest_small_system_in_space)
  {
    if (factor.solver == StepSolver::direct)
      factor.reason = size_against(size, largest_small_system_in_space);
    return factor;
  }
  const double of_factor = time_of(cost_of_solver(factor.solver, size), outlook.n_solves);
  const double of_iterations =
      time_of(cost_of_solver(StepSolver::iterative, size), outlook.n_solves);
  if (of_factor <= of_iterations)
    return factor;
  std::ostringstream text;
  text.precision(3);
  text << "its set-up and ";
  if (outlook.n_solves < many_solves)
    text << std::lround(outlook.n_solves) << " solves take about " << of_iterations
         << " s, and those of a factor about " << of_factor << " s";
  else
    text << "many solves take less time than those of a factor, as estimated";
  return {StepSolver::iterative, text.str()};
}

SolverCost cost_of_tangents(const StepSolver solver, const SystemSize &size)
{
  const bool is_plane = size.dim == 2;
  SolverCost cost;
  if (solver == StepSolver::iterative)
  {
    cost = cost_of_iterations(size);
    if (size.has_matrices_of_cells)
    {
      cost.memory += (is_plane ? 500. : 2700.) * size.n_unknowns;
      cost.solve_time = (is_plane ? 20. : 60.) * microsecond * size.n_unknowns;
    }
    else
    {
      cost.memory += 300. * size.n_unknowns;
      cost.solve_time = (is_plane ? 7. : 15.) * microsecond * size.n_unknowns;
    }
    return cost;
  }
  cost.memory = 1200. * size.n_unknowns +
                bytes_per_tangent_entry * tangent_entries_per_unknown(size) * size.n_unknowns +
                bytes_per_unsymmetric_entry * size.factor_entries;
  cost.factor_time = 130. * nanosecond * size.factor_entries;
  cost.set_up_time = (is_plane ? 12. : 48.) * microsecond * size.n_unknowns + cost.factor_time;
  cost.solve_time = (is_plane ? 0.25 : 1.8) * microsecond * size.n_unknowns +
                    2. * nanosecond * size.factor_entries;
  return cost;
}

SolverChoice choose_tangent_solver(const LinearSolverParameters &parameters,
                                   const SystemSize &size,
                                   const SolverOutlook &outlook)
{
  if (parameters.type != LinearSolverType::automatic)
    return {parameters.type == LinearSolverType::iterative ? StepSolver::iterative
                                                           : StepSolver::direct,
            "Linear solver/Type says"};
  const double largest_system =
      size.dim == 2 ? largest_direct_system_in_plane : largest_direct_system_in_space;
  // The steps of a search for a steady flow grow, and with them the iterations. In finite
  // deformation these depend on how far the tangent is from that of small strains.
  const bool prefers_factor = outlook.n_solves >= many_solves || outlook.is_finite;
  if (size.n_unknowns > largest_system && !prefers_factor)
    return {StepSolver::iterative, size_against(size, largest_system)};
  const double memory =
      outlook.memory_of_program + cost_of_tangents(StepSolver::direct, size).memory;
  if (memory > outlook.memory_limit)
    return {StepSolver::iterative,
            memory_against(memory, outlook.memory_limit, "a factor of the tangent")};
  if (prefers_factor)
    return {StepSolver::direct, "a factor of the tangent fits into the memory"};
  return {StepSolver::direct, size_against(size, largest_system)};
}
} // namespace Continua
