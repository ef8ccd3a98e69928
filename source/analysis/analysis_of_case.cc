#include <continua/analysis/analysis_of_case.h>

#include <continua/analysis/checkpoint.h>
#include <continua/analysis/record_table.h>
#include <continua/base/input_error.h>
#include <continua/base/interruption.h>

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
  checkpoint.check_tables(archive, directory.path(), keeps_last_row(input, archive));
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
