#ifndef continua_base_message_passing_h
#define continua_base_message_passing_h

#include <string>

namespace Continua
{
/**
 * Sets, in the environment of this process, how Open MPI is to start. To be called before MPI_Init;
 * what the environment has already stays as it is.
 *
 * Without a launcher there is one rank. Open MPI 4 then starts a daemon, in case that the program
 * asks for further processes, and looks for networks and devices: MPI_Init takes 0.49 s of the
 * clock, and 0.05 s without all of this (Open MPI 4.1.4). Continua needs none of it.
 *
 * With more ranks on this machine than cores, a rank that waits gives its core to the others. Else
 * a run takes many times as long, since the ranks that wait keep the others from working.
 */
void prepare_message_passing();

/// Whether a launcher of MPI, such as mpirun or srun, has started this process as one of its ranks.
bool is_launched_rank();

/// Whether Open MPI's ranks that wait give their core to others, as the environment says.
bool waiting_ranks_yield();

/// Whether an entry of the environment, "NAME=VALUE", is of those that launchers of MPI and batch
/// systems give to their processes.
bool is_of_launcher(const std::string &entry);
} // namespace Continua

#endif
