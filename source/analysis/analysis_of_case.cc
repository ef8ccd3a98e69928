#include <continua/analysis/analysis_of_case.h>

#include <continua/analysis/checkpoint.h>
#include <continua/analysis/record_table.h>
#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/base/rank_agreement.h>
#include <continua/case/before_the_run/cost_of_case.h>
#include <continua/mesh/mesh_file.h>
#include <continua/mesh/partition.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <sstream>

namespace Continua
{
template <int dim>
AnalysisOfCase<dim>::AnalysisOfCase(const AnalysisInput &input, void (*perform_run)(Run<dim> &))
    : Analysis(input),
      input(input.analyses.read_case<dim>(
          input.file, input.communicator, use_of(input.command_line))),
      perform_run(perform_run)
{
}

template <int dim>
void AnalysisOfCase<dim>::check_restart(const OutputDirectory &directory) const
{
  const Checkpoint checkpoint(communicator, directory, file);
  const ArchiveReader archive = checkpoint.read();
  try
  {
    checkpoint.check_tables(archive, directory.path(), keeps_last_row(input, archive));
  }
  catch (const RunError &error)
  {
    // All ranks have read the same.
    throw InputError({directory.file("checkpoint"), 0}, "--restart",
                     std::string("the checkpoint cannot be read: ") + error.what(),
                     "Put it back from a copy, or run anew with --overwrite");
  }
}

template <int dim>
std::vector<std::string> AnalysisOfCase<dim>::outline() const
{
  std::vector<std::string> lines = Analysis::outline();
  lines.front() += ", model: " + input.general.model;
  if (input.analysis.has_fields)
  {
    lines.front() += ", discretisation: " + input.general.discretisation;
    std::ostringstream mesh;
    mesh << "mesh: "
         << input.extent.n_cells * std::pow(2., dim * static_cast<double>(input.mesh.refinements))
         << " cells" << (input.adaptation.changes_mesh() ? " at the start" : "")
         << ", ranks: " << dealii::Utilities::MPI::n_mpi_processes(input.communicator);
    lines.push_back(mesh.str());
  }
  if (input.analysis.motion == Motion::in_time)
  {
    const TimeParameters &time = input.time;
    std::ostringstream text;
    text << "time: to " << time.end_time << " s";
    if (time.is_adaptive())
      text << " in steps that adapt, the first of " << time.time_step << " s";
    else if (time.changes.empty())
      text << " in " << std::ceil(time.end_time / time.time_step - 1e-6) << " steps of "
           << time.time_step << " s";
    else
      text << " in steps of " << time.time_step << " s first";
    lines.push_back(text.str());
  }
  for (const std::string &line : cost_of(input))
    lines.push_back(line);
  return lines;
}

template <int dim>
void AnalysisOfCase<dim>::write_mesh(const std::string &mesh_file)
{
  if (!input.analysis.has_fields)
    return Analysis::write_mesh(mesh_file);
  if (dealii::Utilities::MPI::n_mpi_processes(communicator) > 1)
    throw InputError({"command line", 0}, "--mesh", "it writes the mesh of one rank",
                     "Call it without mpirun");
  refine(*input.triangulation, input.mesh.refinements);
  write_mesh_file(mesh_file, Continua::mesh_file<dim>(*input.triangulation, input.problem.regions,
                                                      input.problem.boundaries));
}

template <int dim>
double AnalysisOfCase<dim>::estimated_memory() const
{
  return input.analysis.has_fields ? CostEstimate(cost_input(input)).memory : 0.;
}

template <int dim>
void AnalysisOfCase<dim>::compute(const OutputDirectory &directory, Log &log, Summary &summary)
{
  Run<dim> run(input, file, command_line, directory, log, summary);
  try
  {
    perform_run(run);
  }
  catch (const InputError &error)
  {
    RankAgreement::wait_for_all(error.what(), exit_status_of_wrong_input);
    throw;
  }
  catch (const Interrupted &interruption)
  {
    log.end_progress();
    run.interrupt(interruption.what());
    throw;
  }
  catch (const std::exception &error)
  {
    log.end_progress();
    try
    {
      run.fail(error.what());
    }
    catch (const RunError &second)
    {
      // A full disk has no room for the summary either; what came first counts.
      log.warning(second.what());
    }
    // While the run lives: some of its parts end by collective operations.
    RankAgreement::wait_for_all(text_of_failure(error), exit_status_of_failure);
    throw;
  }
}

template class AnalysisOfCase<2>;
template class AnalysisOfCase<3>;
} // namespace Continua
