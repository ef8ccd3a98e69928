#include <continua/case/before_the_run/cost_of_case.h>
#include <continua/case/theory/tube_wave_case.h>

#include <deal.II/base/mpi.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
/// Steps from the start to the end, with the changes of their size that the file asks for.
double steps_of(const TimeParameters &time)
{
  double steps = 0., start = 0., size = time.time_step;
  for (const auto &[change, next] : time.changes)
  {
    steps += (std::min(change, time.end_time) - start) / size;
    start = std::min(change, time.end_time);
    size = next;
  }
  return steps + (time.end_time - start) / size;
}

/// Solves of an analysis that does not step through time: of the vibrations of a body about so
/// many.
constexpr double solves_of_modes = 60.;

unsigned int ranks_on_this_machine(const MPI_Comm communicator)
{
  MPI_Comm machine;
  int error = MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  AssertThrowMPI(error);
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(machine);
  error = MPI_Comm_free(&machine);
  AssertThrowMPI(error);
  return n_ranks;
}

/// Of a harmonic analysis as given; of a pulse response at most, which needs fewer points where the
/// loads are smooth; of one that chooses them by itself as many as usual.
template <int dim>
std::size_t n_frequencies_of(const Case<dim> &input)
{
  constexpr std::size_t n_usual = 50;
  if (input.analysis.name == "pulse response")
    return static_cast<std::size_t>(std::ceil(input.time.end_time / input.time.time_step)) + 1;
  return input.harmonic.frequencies.empty() ? n_usual : input.harmonic.frequencies.size();
}

/// But for wave theory.
template <int dim>
CostInput cost_of_fields(const Case<dim> &input)
{
  CostInput cost;
  cost.dim = dim;
  cost.coarse = input.extent;
  cost.refinements = input.mesh.refinements;
  const TaylorHoodParameters &taylor_hood = input.discretisation.taylor_hood;
  cost.n_regions = taylor_hood.space.pressure_space == PressureSpace::broken
                       ? static_cast<unsigned int>(input.problem.regions.size())
                       : 1;
  cost.degree = taylor_hood.space.velocity_degree;
  cost.cell_wise = input.discretisation.is_cell_wise();
  cost.has_pressure = input.discretisation.cell_wise.formulation == Formulation::velocity_pressure;
  cost.segregated = input.discretisation.cell_wise.is_segregated();
  cost.pivots = std::any_of(input.problem.materials.begin(), input.problem.materials.end(),
                            [](const Material &material) { return material.is_incompressible(); });
  cost.is_nonlinear = input.problem.is_nonlinear();
  cost.has_tangents = cost.is_nonlinear && !cost.cell_wise;
  cost.is_finite = input.problem.deformation == Deformation::finite;
  cost.mesh_moves = input.problem.some_mesh_moves();
  cost.convects_explicitly = input.problem.convection.is_explicit();
  cost.has_supg = input.problem.convection.is_on &&
                  input.problem.convection.stabilisation == ConvectionStabilisation::supg;
  cost.linear_solver = taylor_hood.linear_solver;
  // Both have an indefinite matrix, which is factored.
  cost.is_of_vibrations = input.analysis.is_modal() || input.analysis.is_harmonic();
  cost.memory_limit = taylor_hood.outlook.memory_limit;
  cost.n_ranks = Utilities::MPI::n_mpi_processes(input.communicator);
  if (input.analysis.is_transient())
  {
    cost.n_steps = steps_of(input.time);
    cost.n_histories = input.n_histories;
    // Its start has a matrix of its own.
    cost.n_factors =
        input.time.scheme == Scheme::backward_differencing && !cost.is_nonlinear ? 2 : 1;
  }
  else
  {
    cost.finds_steady_state = !cost.is_of_vibrations;
    cost.n_steps = input.analysis.is_harmonic() ? n_frequencies_of(input)
                   : cost.finds_steady_state    ? 1.
                                                : solves_of_modes;
    cost.is_harmonic = input.analysis.is_harmonic();
    // One on each rank, of another frequency.
    if (cost.is_harmonic)
      cost.n_factors = std::min<std::size_t>(cost.n_ranks, n_frequencies_of(input));
  }
  return cost;
}

/// Of the theory that stands beside a run of a tube.
template <int dim>
void set_wave_theory(const Case<dim> &input, CostInput &cost)
{
  TubeWaveCase wave_case;
  if (!input.wave_theory.overlay || input.probes.stations().empty() ||
      !make_tube_wave_case(input, wave_case).empty())
    return;
  const TubeWaveTheory::Work work =
      TubeWaveTheory::work(wave_case.problem, wave_case.inlet, input.time.end_time,
                           input.wave_theory.spectral_tolerance);
  cost.n_wave_roots = work.n_roots;
  cost.n_wave_segment_solves = input.probes.stations().size() * work.n_segment_solves;
}

/// What a run may take on this machine.
template <int dim>
MemoryLimit limit_of_machine(const Case<dim> &input)
{
  MemoryLimit limit = memory_limit();
  if (input.mesh.memory_limit > 0.)
    limit = {input.mesh.memory_limit * 1e9, "Mesh/Memory limit"};
  return limit;
}
} // namespace

template <int dim>
CostInput cost_input(const Case<dim> &input)
{
  CostInput cost = cost_of_fields(input);
  if (input.analysis.is_transient())
    set_wave_theory(input, cost);
  return cost;
}

template <int dim>
SolverOutlook solver_outlook(const Case<dim> &input)
{
  CostInput cost = cost_of_fields(input);
  cost.memory_limit = Utilities::MPI::min(limit_of_machine(input).bytes, input.communicator);
  return solver_outlook(cost);
}

template <int dim>
std::vector<std::string> cost_of(const Case<dim> &input)
{
  if (!input.analysis.has_fields)
    return {};
  const CostInput cost = cost_input(input);
  const std::string adapts = input.adaptation.changes_mesh() ? ", before the mesh adapts" : "";
  std::vector<std::string> lines = {"Estimate: " + CostEstimate(cost).text() + adapts};
  if (input.problem.some_mesh_moves())
    lines.push_back(std::string("The mesh of the liquids moves: ") +
                    word_of(mesh_motion_words(), input.problem.mesh_motion) +
                    (input.problem.mesh_motion == MeshMotionKind::elastic
                         ? ", with a factor of its own for the whole run"
                         : ", with a factor of its own in each step"));
  const double n_machines =
      static_cast<double>(cost.n_ranks) / ranks_on_this_machine(input.communicator);
  const std::string advice =
      advice_on_ranks(cost, std::lround(n_machines * sysconf(_SC_NPROCESSORS_ONLN)));
  if (!advice.empty())
    lines.push_back("Note: " + advice);
  return lines;
}

template <int dim>
MemoryLimit memory_limit_of(const Case<dim> &input)
{
  MemoryLimit limit = limit_of_machine(input);
  // All ranks decide alike, by the machine with the least for a rank.
  const double n_ranks = Utilities::MPI::n_mpi_processes(input.communicator);
  limit.bytes = Utilities::MPI::min(
      limit.bytes * n_ranks / ranks_on_this_machine(input.communicator), input.communicator);
  return limit;
}

template <int dim>
void check_memory(const Case<dim> &input, const ParameterSection &mesh)
{
  if (!input.analysis.has_fields)
    return;
  const CostInput cost = cost_of_fields(input);
  const CostEstimate estimate(cost);
  const MemoryLimit limit = memory_limit_of(input);
  if (estimate.memory <= limit.bytes)
    return;
  const bool is_refined = input.mesh.refinements > 0;
  const int fitting = fitting_refinements(cost, limit.bytes);
  std::string remedy;
  if (is_refined && fitting >= 0)
    remedy = "Refinements = " + std::to_string(fitting) + " fits";
  else
  {
    // Memory grows at least as the number of cells.
    std::ostringstream cells;
    cells.precision(2);
    cells << 0.8 * estimate.n_cells * limit.bytes / estimate.memory;
    remedy = "About " + cells.str() + " cells or fewer fit";
  }
  if (estimate.solver != StepSolver::iterative && !cost.cell_wise)
  {
    CostInput other = cost;
    other.linear_solver.type = LinearSolverType::iterative;
    if (CostEstimate(other).memory <= limit.bytes)
      remedy += "; so does Linear solver/Type = iterative";
  }
  remedy += "; Mesh/Memory limit = " +
            std::to_string(static_cast<long>(std::ceil(1.5e-9 * estimate.memory))) +
            " tries it all the same";
  std::ostringstream problem;
  problem.precision(0);
  problem << std::fixed << "the run of " << estimate.n_unknowns << " unknowns in "
          << estimate.n_cells << " cells needs about " << memory_text(estimate.memory)
          << ", and it may take " << memory_text(limit.bytes) << " (" << limit.source << ")";
  mesh.refuse(is_refined ? "Refinements" : entry_of_cells(mesh), problem.str(), remedy);
}

template <int dim>
void check_histories(const Case<dim> &input, const ParameterSection &probes)
{
  if (!input.analysis.has_fields)
    return;
  const CostInput cost = cost_of_fields(input);
  const CostEstimate estimate(cost);
  const MemoryLimit limit = memory_limit_of(input);
  if (estimate.memory <= limit.bytes)
    return;
  std::ostringstream problem;
  problem.precision(0);
  problem << std::fixed << "the histories of " << cost.n_histories << " columns over "
          << cost.n_steps << " steps need about " << memory_text(estimate.history_memory)
          << " of the run's " << memory_text(estimate.memory) << ", and it may take "
          << memory_text(limit.bytes) << " (" << limit.source << ")";
  probes.refuse("", problem.str(),
                "Give fewer probes, stations or fields, a longer Time/Time step or an earlier "
                "Time/End time");
}

template CostInput cost_input(const Case<2> &);
template CostInput cost_input(const Case<3> &);
template SolverOutlook solver_outlook(const Case<2> &);
template SolverOutlook solver_outlook(const Case<3> &);
template std::vector<std::string> cost_of(const Case<2> &);
template std::vector<std::string> cost_of(const Case<3> &);
template MemoryLimit memory_limit_of(const Case<2> &);
template MemoryLimit memory_limit_of(const Case<3> &);
template void check_histories(const Case<2> &, const ParameterSection &);
template void check_histories(const Case<3> &, const ParameterSection &);
template void check_memory(const Case<2> &, const ParameterSection &);
template void check_memory(const Case<3> &, const ParameterSection &);
} // namespace Continua
