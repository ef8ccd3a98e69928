#ifndef continua_base_collective_h
#define continua_base_collective_h

#include <mpi.h>

#include <string>
#include <vector>

namespace Continua
{
// Collective operations on plain data: all ranks of the communicator call them. deal.II's own take
// any type and compile Boost's serialisation into each file that calls them, which takes longer
// than the rest of the file.

/// The value of rank 0, on all ranks.
std::string broadcast(MPI_Comm communicator, const std::string &value);
std::vector<double> broadcast(MPI_Comm communicator, const std::vector<double> &value);
std::vector<std::string> broadcast(MPI_Comm communicator, const std::vector<std::string> &value);

/// The values of all ranks in the order of the ranks, on all ranks.
std::vector<double> all_gather(MPI_Comm communicator, double value);
std::vector<unsigned int> all_gather(MPI_Comm communicator, unsigned int value);
std::vector<unsigned long> all_gather(MPI_Comm communicator, unsigned long value);
std::vector<std::string> all_gather(MPI_Comm communicator, const std::string &value);
std::vector<std::vector<unsigned int>> all_gather(MPI_Comm communicator,
                                                  const std::vector<unsigned int> &value);
std::vector<std::vector<double>> all_gather(MPI_Comm communicator,
                                            const std::vector<double> &value);
} // namespace Continua

#endif
