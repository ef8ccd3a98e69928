#include <continua/analysis/case_run.h>

#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/base/version.h>
#include <continua/program/analyses.h>

#include <deal.II/base/mpi.h>

#include <fstream>

namespace Continua
{
void begin_output(const ParameterFile &file,
                  const CommandLine &command_line,
                  const MPI_Comm communicator,
                  const std::string &title,
                  const OutputDirectory &directory,
                  Log &log)
{
  log.open(directory.file("log.txt"), command_line.restart);
  if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0 && !command_line.restart)
  {
    std::ofstream resolved(directory.file("parameters.prm"));
    file.print(resolved, ParameterFile::Style::prm);
    if (!resolved)
      throw RunError("cannot write " + directory.file("parameters.prm"));
  }
  directory.copy_inputs(file.input_files());
  log.line("Continua" + (title.empty() ? "" : ": " + title));
  log.detail("version " + version() + ", revision " + revision());
}

template <int dim>
void perform_case(Case<dim> &input,
                  const ParameterFile &file,
                  const CommandLine &command_line,
                  const OutputDirectory &directory,
                  Log &log)
{
  Run<dim> run(input, file, command_line, directory, log);
  try
  {
    perform_analysis(run);
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

template void
perform_case(Case<2> &, const ParameterFile &, const CommandLine &, const OutputDirectory &, Log &);
template void
perform_case(Case<3> &, const ParameterFile &, const CommandLine &, const OutputDirectory &, Log &);
} // namespace Continua
