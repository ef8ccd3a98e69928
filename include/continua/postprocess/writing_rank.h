#ifndef continua_postprocess_writing_rank_h
#define continua_postprocess_writing_rank_h

#include <mpi.h>

#include <functional>

namespace Continua
{
/**
 * Runs `function` on rank 0 of the communicator. If it throws a RunError there, every rank throws
 * it, so that none waits for one that has given up. Collective.
 */
void on_writing_rank(MPI_Comm communicator, const std::function<void()> &function);

/// Whether this is the rank of the communicator that writes.
bool is_writing_rank(MPI_Comm communicator);
} // namespace Continua

#endif
