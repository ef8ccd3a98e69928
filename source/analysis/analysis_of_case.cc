#include <continua/analysis/analysis_of_case.h>

#include <continua/base/input_error.h>
#include <continua/base/interruption.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <sstream>

namespace Continua
{
template <int dim>
AnalysisOfCase<dim>::AnalysisOfCase(const AnalysisInput &input, void (*perform_run)(Run<dim> &))
    : Analysis(input),
      input(input.analyses.read_case<dim>(
          input.file, input.communicator, input.command_line.restart)),
      perform_run(perform_run)
{
}

template <int dim>
std::vector<std::string> AnalysisOfCase<dim>::plan() const
{
  std::vector<std::string> lines = Analysis::plan();
  lines.front() += ", model: " + input.general.model;
  if (input.analysis.has_fields)
  {
    lines.front() += ", discretisation: " + input.general.discretisation;
    // The coarse mesh has been made, the refined one has not.
    std::ostringstream mesh;
    mesh << "mesh: "
         << static_cast<double>(input.triangulation->n_global_active_cells()) *
                std::pow(2., dim * static_cast<double>(input.mesh.refinements))
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
  return lines;
}

template <int dim>
void AnalysisOfCase<dim>::compute(const OutputDirectory &directory, Log &log, Summary &summary)
{
  Run<dim> run(input, file, command_line, directory, log, summary);
  try
  {
    perform_run(run);
  }
  catch (const InputError &)
  {
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
    throw;
  }
}

template class AnalysisOfCase<2>;
template class AnalysisOfCase<3>;
} // namespace Continua
