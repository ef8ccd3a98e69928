#ifndef continua_program_run_report_h
#define continua_program_run_report_h

#include <mpi.h>

#include <string>

namespace Continua
{
class ParameterFile;

/// Whether Output/Report of the file asks for a report; false for an analysis without this section.
/// Throws InputError.
bool asks_for_report(ParameterFile &file);

/**
 * Writes report.html into the folder of a run that is over by `scripts/report`, which came with the
 * program, and prints where it is. Where the script or what it needs is missing, prints a warning
 * with the reason: the results are there without it. Collective; the other ranks wait without using
 * their cores.
 */
void make_report(const std::string &folder, MPI_Comm communicator);
} // namespace Continua

#endif
