#ifndef continua_benchmarks_communication_h
#define continua_benchmarks_communication_h

#include <array>
#include <string>

namespace Benchmarks
{
/// How often this rank did one kind of communication, and the bytes of it.
struct CommunicationCount
{
  double calls = 0.;
  double bytes = 0.;
};

/**
 * What this process has exchanged with other ranks since its start, counted by MPI's profiling
 * layer: the program has functions of the names of MPI's, which note and pass on. Calls on a
 * communicator of one rank and messages to oneself do not count. Bytes are those of
 *  - messages: sent;
 *  - reductions (also to one rank, and scans) and broadcasts: the vector that this rank gives or
 *    gets;
 *  - gathers (also to all): what this rank gets from all;
 *  - all-to-all: what this rank gives.
 * Calls from Fortran are those of MUMPS.
 */
class Communication
{
public:
  enum Kind
  {
    messages,
    reductions,
    broadcasts,
    gathers,
    all_to_all,
    barriers,
    n_kinds
  };
  static const std::array<std::string, n_kinds> kind_names;
  enum Origin
  {
    other,
    mumps,
    n_origins
  };

  static Communication until_now();
  Communication operator-(const Communication &earlier) const;

  std::array<std::array<CommunicationCount, n_kinds>, n_origins> counts;
};
} // namespace Benchmarks

#endif
