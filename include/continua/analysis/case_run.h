#ifndef continua_analysis_case_run_h
#define continua_analysis_case_run_h

#include <continua/analysis/run.h>

#include <string>

namespace Continua
{
/// Opens the log in the folder of a run and leaves there the resolved parameters and the user's
/// files. Collective; throws RunError.
void begin_output(const ParameterFile &file,
                  const CommandLine &command_line,
                  MPI_Comm communicator,
                  const std::string &title,
                  const OutputDirectory &directory,
                  Log &log);

/// Performs the analysis of a case. If it fails, what was computed stays, the summary says that and
/// why, and the exception goes on.
template <int dim>
void perform_case(Case<dim> &input,
                  const ParameterFile &file,
                  const CommandLine &command_line,
                  const OutputDirectory &directory,
                  Log &log);
} // namespace Continua

#endif
