#include <continua/base/duration_text.h>
#include <continua/base/memory_limit.h>
#include <continua/base/message_passing.h>
#include <continua/case/before_the_run/cost_estimate.h>
#include <continua/linear_algebra/symmetric_factor.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
namespace
{
// The constants of this file are fits to runs; doc/estimates.md has the runs, the command that
// repeats them, and the machine.

/// What a rank holds before it has a mesh: the program and its libraries [bytes].
constexpr double memory_of_program = 180e6;
/// Bytes that an entry of a factor takes, with what the solver needs besides.
constexpr double bytes_per_entry = 11.5;
/// What an entry of a complex matrix takes, with the real matrices of which it is the sum.
constexpr double bytes_per_harmonic_entry = 120.;
/// What an entry of UMFPACK's factor takes, its own one beside the packed one.
constexpr double bytes_per_unsymmetric_entry = 25.;
/// Unknowns of a rank below which messages cost more than the rank computes.
constexpr double fewest_unknowns_per_rank = 10000.;

/// The mesh as a bar of L layers of w or w x w cells.
struct Bar
{
  explicit Bar(const CostInput &input)
      : is_plane(input.dim == 2),
        length(input.coarse.n_layers * std::pow(2., input.refinements)),
        section(input.coarse.cells_per_layer() *
                std::pow(2., (input.dim - 1.) * input.refinements)),
        width(is_plane ? section : std::sqrt(section))
  {
  }

  /// Nodes of elements of a degree.
  double nodes(const double degree) const
  {
    return (degree * length + 1.) * nodes_of_section(degree);
  }
  double nodes_of_section(const double degree) const
  {
    return is_plane ? degree * width + 1. : (degree * width + 1.) * (degree * width + 1.);
  }
  /// Faces of the outside.
  double outer_faces() const
  {
    return is_plane ? 2. * (length + width) : 4. * length * width + 2. * section;
  }
  /// Length over width, not less than 1.
  double aspect() const { return std::max(1., length / width); }

  bool is_plane;
  double length;
  double section;
  double width;
};

double unknowns_of(const CostInput &input, const Bar &bar)
{
  if (input.cell_wise)
    return (input.dim + (input.has_pressure ? 1. : 0.)) *
           (bar.length * bar.section + bar.outer_faces());
  const double degree = input.degree;
  // The pressure has a value of each region at an interface, taken to lie along the bar.
  const double interface =
      bar.is_plane ? (degree - 1.) * bar.length + 1.
                   : ((degree - 1.) * bar.length + 1.) * ((degree - 1.) * bar.width + 1.);
  return input.dim * bar.nodes(degree) + bar.nodes(degree - 1.) +
         (input.n_regions - 1.) * interface;
}

/// Entries of both triangles of a tangent's factor over those of the one triangle of a symmetric
/// matrix. The order is by the places of A + A^T, as that of a symmetric matrix, with UMFPACK's
/// symmetric strategy and with MUMPS; whether a material is incompressible changes little.
double fill_of_tangent(const CostInput &input)
{
  return 2.1 * std::pow(0.5 * input.degree, 0.2);
}

/// Entries of a factor for each unknown, by nested dissection of a bar.
double fill_of(const CostInput &input, const Bar &bar, const double n_unknowns)
{
  const double unknowns_per_layer = n_unknowns / bar.length;
  if (input.segregated)
    return 4.;
  const double both = input.cell_wise ? 1.6 : input.is_nonlinear ? fill_of_tangent(input) : 1.;
  const double pivots = input.pivots && !input.cell_wise && !input.is_nonlinear ? 1.3 : 1.;
  if (!bar.is_plane)
    return both * pivots * 1.6 * std::pow(unknowns_per_layer, 0.805) * bar.aspect() /
           (bar.aspect() + 1.);
  if (input.cell_wise && input.is_nonlinear)
    return 64. * std::pow(bar.width, 0.47);
  if (input.cell_wise)
    return (input.has_pressure ? 9. : 5.2) * std::pow(bar.width, 0.94);
  const double width = 0.5 * input.degree * bar.width;
  const double dissected =
      21. * std::log2(width) - 40. + 5. * std::min(4., std::log2(bar.aspect()));
  return both * pivots * std::min(0.6 * unknowns_per_layer, std::max(12., dissected));
}

/// Of the lower triangle.
double entries_per_unknown(const CostInput &input)
{
  return input.dim == 2 ? 20. : 90.;
}

/// Of the matrices that a harmonic analysis about a loaded state keeps of each cell, see
/// LoadedCell: stiffness, mass, and that of a viscosity or of branches.
double bytes_of_loaded_cells(const CostInput &input, const double n_cells)
{
  const double n_velocities = input.dim * std::pow(input.degree + 1., input.dim);
  return 3. * sizeof(double) * n_velocities * n_velocities * n_cells;
}

/// As make_symmetric_factor() chooses.
bool takes_cholmod(const CostInput &input, const double n_unknowns)
{
  const DirectSolver library = input.linear_solver.direct_solver;
  if (library != DirectSolver::automatic)
    return library == DirectSolver::cholmod;
  const double entries = entries_per_unknown(input) * n_unknowns;
  return input.n_ranks == 1 && !input.pivots && !input.is_harmonic &&
         entries <= static_cast<double>(largest_simplicial_matrix);
}

/// What Newton's iteration takes, as means of the runs of doc/estimates.md.
struct NewtonCounts
{
  double corrections, new_factors;
};
constexpr NewtonCounts counts_of_step{4.5, 0.02};
constexpr NewtonCounts counts_of_explicit_step{1., 0.};  ///< by a factor
constexpr NewtonCounts counts_of_steady_search{30., 9.}; ///< of all steps on the way

/// Of a step, or of the search for a steady state [s].
double time_of_newton(const CostInput &input, const SolverCost &cost, const double n_unknowns)
{
  const bool searches = input.finds_steady_state || input.is_harmonic;
  const NewtonCounts &counts = searches                    ? counts_of_steady_search
                               : input.convects_explicitly ? counts_of_explicit_step
                                                           : counts_of_step;
  double time = counts.corrections * cost.solve_time + counts.new_factors * cost.factor_time;
  // The integrals over the present mesh, its own factor, and more factors of the tangent.
  if (input.mesh_moves)
    time += 1.5e-6 * counts.corrections * n_unknowns + 0.4 * cost.factor_time;
  return time;
}

SystemSize size_of(const CostInput &input, const Bar &bar)
{
  SystemSize size;
  size.dim = input.dim;
  size.degree = input.degree;
  size.n_unknowns = unknowns_of(input, bar);
  size.factor_entries = size.n_unknowns * fill_of(input, bar, size.n_unknowns);
  size.n_factors = input.n_factors;
  size.n_regions = input.n_regions;
  size.takes_cholmod = takes_cholmod(input, size.n_unknowns);
  size.is_matrix_free = input.linear_solver.is_matrix_free(input.degree);
  size.has_matrices_of_cells = input.has_supg || input.is_finite || !size.is_matrix_free;
  return size;
}
} // namespace

CostEstimate::CostEstimate(const CostInput &input)
{
  const Bar bar(input);
  const bool is_plane = bar.is_plane;
  const SystemSize size = size_of(input, bar);
  const bool is_linear_system = !input.cell_wise && !input.is_nonlinear;
  n_cells = bar.length * bar.section;
  n_unknowns = size.n_unknowns;
  if (is_linear_system)
    solver = choose_step_solver(input.linear_solver, size, solver_outlook(input)).solver;
  else if (input.has_tangents)
    solver = choose_tangent_solver(input.linear_solver, size, solver_outlook(input)).solver;
  factor_entries = solver == StepSolver::iterative ? 0. : size.factor_entries;

  const double second = 1., nanosecond = 1e-9 * second, microsecond = 1e-6 * second;
  double solve_time = 0.;
  if (is_linear_system)
  {
    const SolverCost cost = cost_of_solver(solver, size);
    memory = cost.memory;
    set_up_time = cost.set_up_time;
    solve_time = cost.solve_time;
  }
  else if (input.has_tangents)
  {
    const SolverCost cost = cost_of_tangents(solver, size);
    memory = cost.memory;
    set_up_time = cost.set_up_time;
    solve_time = time_of_newton(input, cost, n_unknowns);
  }
  else
  {
    // Of cell-wise elements: mesh, numbering, matrices by region and of the step, vectors.
    const double bytes_per_unknown = input.segregated     ? 4500.
                                     : input.is_nonlinear ? 9000.
                                     : input.has_pressure ? 12000.
                                                          : 7500.;
    memory = bytes_per_unknown * n_unknowns +
             input.n_factors *
                 (input.is_nonlinear ? bytes_per_unsymmetric_entry : bytes_per_entry) *
                 factor_entries;
    SolverCost cost;
    if (input.segregated)
      cost.solve_time = 1.5 * microsecond * n_unknowns;
    else
    {
      cost.factor_time = 240. * nanosecond * factor_entries;
      cost.solve_time = (factor_entries < 4e5 ? 0.7 : 1.6) * nanosecond * factor_entries;
    }
    set_up_time = 56. * microsecond * n_unknowns + input.n_factors * cost.factor_time;
    solve_time = input.is_nonlinear ? time_of_newton(input, cost, n_unknowns) : cost.solve_time;
  }
  if (input.is_harmonic)
  {
    // Complex numbers have twice the bytes; all entries of the matrix are on each rank.
    // About a loaded state the matrix has both triangles, as its factor has them already.
    const double triangles = input.is_nonlinear ? 2. : 1.;
    memory += size.n_factors * bytes_per_entry * factor_entries +
              triangles * input.n_ranks * bytes_per_harmonic_entry * entries_per_unknown(input) *
                  n_unknowns;
    if (input.is_nonlinear)
      memory += bytes_of_loaded_cells(input, n_cells);
    // The search for this state is before the frequencies.
    const double search_time = input.is_nonlinear ? set_up_time + solve_time : 0.;
    // Fitted to strips of 9,553 and 74,103 unknowns: 0.05 and 0.5 s a frequency, most of it the
    // factor.
    const double factor_time = 90. * nanosecond * factor_entries;
    set_up_time = 5. * (is_plane ? 12. : 48.) * microsecond * n_unknowns + search_time;
    solve_time = factor_time + 8. * nanosecond * factor_entries;
  }
  memory += input.n_ranks * memory_of_program;
  // The times are one more column, the start is one more row.
  if (input.n_histories > 0.)
    history_memory =
        input.n_ranks * sizeof(double) * (input.n_histories + 1.) * (input.n_steps + 1.);
  memory += history_memory;
  set_up_time += 0.4 * second;
  const bool is_lean = solver != StepSolver::direct && size.is_matrix_free;
  step_time = 25. * microsecond + (is_plane || is_lean ? 0.25 : 0.5) * microsecond * n_unknowns +
              solve_time;
  theory_time =
      5e-3 * second * input.n_wave_roots + 50. * microsecond * input.n_wave_segment_solves;
  time = set_up_time + input.n_steps * step_time + theory_time;
}

SolverOutlook solver_outlook(const CostInput &input)
{
  SolverOutlook outlook;
  outlook.size = size_of(input, Bar(input));
  // How many steps bring a body to rest is unknown.
  if (!input.finds_steady_state)
    outlook.n_solves = input.n_steps;
  outlook.memory_limit = input.memory_limit;
  outlook.memory_of_program = memory_of_program;
  outlook.is_of_tangents = input.has_tangents;
  outlook.is_finite = input.is_finite;
  outlook.is_of_vibrations = input.is_of_vibrations;
  return outlook;
}

std::string CostEstimate::text() const
{
  std::ostringstream text;
  text.precision(0);
  text << std::fixed << n_unknowns << " unknowns in " << n_cells << " cells, "
       << memory_text(memory) << " of memory, " << duration_text(std::max(1., time))
       << " on one core";
  return text.str();
}

int fitting_refinements(CostInput input, const double bytes)
{
  for (int refinements = static_cast<int>(input.refinements); refinements >= 0; --refinements)
  {
    input.refinements = refinements;
    if (CostEstimate(input).memory <= bytes)
      return refinements;
  }
  return -1;
}

std::string advice_on_ranks(const CostInput &input, const unsigned int n_processors)
{
  if (input.n_ranks == 1)
    return "";
  std::ostringstream text;
  if (input.n_ranks > n_processors)
    text << input.n_ranks << " ranks share " << n_processors
         << " processors: the run will be slower than on " << n_processors << " rank"
         << (n_processors == 1 ? "" : "s")
         << (waiting_ranks_yield()
                 ? ", though a rank that waits gives its processor to the others"
                 : ", many times, since ranks that wait keep others from working");
  else if (CostEstimate(input).n_unknowns < fewest_unknowns_per_rank * input.n_ranks)
    text << "each of the " << input.n_ranks << " ranks has fewer than " << fewest_unknowns_per_rank
         << " unknowns: the run will be slower than on one rank";
  return text.str();
}
} // namespace Continua
