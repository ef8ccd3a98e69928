#include "communication.h"

#include <dlfcn.h>
#include <mpi.h>

namespace Benchmarks
{
namespace
{
Communication total;

bool is_alone(const MPI_Comm communicator)
{
  int n_ranks = 0;
  PMPI_Comm_size(communicator, &n_ranks);
  return n_ranks < 2;
}

int ranks_of(const MPI_Comm communicator)
{
  int n_ranks = 0;
  PMPI_Comm_size(communicator, &n_ranks);
  return n_ranks;
}

double bytes_of(const double count, const MPI_Datatype type)
{
  int size = 0;
  PMPI_Type_size(type, &size);
  return count * size;
}

void note(const Communication::Origin origin, const Communication::Kind kind, const double bytes)
{
  total.counts[origin][kind].calls += 1.;
  total.counts[origin][kind].bytes += bytes;
}

void note_message(const Communication::Origin origin,
                  const double count,
                  const MPI_Datatype type,
                  const int destination,
                  const MPI_Comm communicator)
{
  int rank = 0;
  PMPI_Comm_rank(communicator, &rank);
  if (destination != rank && destination != MPI_PROC_NULL)
    note(origin, Communication::messages, bytes_of(count, type));
}

void note_collective(const Communication::Origin origin,
                     const Communication::Kind kind,
                     const double count,
                     const MPI_Datatype type,
                     const MPI_Comm communicator)
{
  if (!is_alone(communicator))
    note(origin, kind, bytes_of(count, type));
}

/// Calls a function of Fortran by the address of its name.
template <typename... Arguments>
void pass_on(void *const function, Arguments... arguments)
{
  reinterpret_cast<void (*)(Arguments...)>(function)(arguments...);
}

double sum(const int *const counts, const MPI_Comm communicator)
{
  double result = 0.;
  for (int rank = 0; rank < ranks_of(communicator); ++rank)
    result += counts[rank];
  return result;
}
} // namespace

const std::array<std::string, Communication::n_kinds> Communication::kind_names = {
    {"messages", "reductions", "broadcasts", "gathers", "all-to-all", "barriers"}};

Communication Communication::until_now()
{
  return total;
}

Communication Communication::operator-(const Communication &earlier) const
{
  Communication result = *this;
  for (unsigned int origin = 0; origin < n_origins; ++origin)
    for (unsigned int kind = 0; kind < n_kinds; ++kind)
    {
      result.counts[origin][kind].calls -= earlier.counts[origin][kind].calls;
      result.counts[origin][kind].bytes -= earlier.counts[origin][kind].bytes;
    }
  return result;
}
} // namespace Benchmarks

using Benchmarks::Communication;
using Benchmarks::note;
using Benchmarks::note_collective;
using Benchmarks::note_message;

// MPI's names and arguments; the macros have the functions of equal arguments.
extern "C"
{
#define CONTINUA_SEND(NAME)                                                                        \
  int MPI_##NAME(const void *buffer, int count, MPI_Datatype type, int destination, int tag,       \
                 MPI_Comm communicator)                                                            \
  {                                                                                                \
    note_message(Communication::other, count, type, destination, communicator);                    \
    return PMPI_##NAME(buffer, count, type, destination, tag, communicator);                       \
  }
  CONTINUA_SEND(Send)
  CONTINUA_SEND(Ssend)
  CONTINUA_SEND(Rsend)
  CONTINUA_SEND(Bsend)

#define CONTINUA_ISEND(NAME)                                                                       \
  int MPI_##NAME(const void *buffer, int count, MPI_Datatype type, int destination, int tag,       \
                 MPI_Comm communicator, MPI_Request *request)                                      \
  {                                                                                                \
    note_message(Communication::other, count, type, destination, communicator);                    \
    return PMPI_##NAME(buffer, count, type, destination, tag, communicator, request);              \
  }
  CONTINUA_ISEND(Isend)
  CONTINUA_ISEND(Issend)
  CONTINUA_ISEND(Irsend)
  CONTINUA_ISEND(Ibsend)

  int MPI_Sendrecv(const void *sent,
                   int sent_count,
                   MPI_Datatype sent_type,
                   int destination,
                   int sent_tag,
                   void *received,
                   int received_count,
                   MPI_Datatype received_type,
                   int source,
                   int received_tag,
                   MPI_Comm communicator,
                   MPI_Status *status)
  {
    note_message(Communication::other, sent_count, sent_type, destination, communicator);
    return PMPI_Sendrecv(sent, sent_count, sent_type, destination, sent_tag, received,
                         received_count, received_type, source, received_tag, communicator, status);
  }

#define CONTINUA_REDUCE(NAME)                                                                      \
  int MPI_##NAME(const void *sent, void *received, int count, MPI_Datatype type, MPI_Op operation, \
                 MPI_Comm communicator)                                                            \
  {                                                                                                \
    note_collective(Communication::other, Communication::reductions, count, type, communicator);   \
    return PMPI_##NAME(sent, received, count, type, operation, communicator);                      \
  }
  CONTINUA_REDUCE(Allreduce)
  CONTINUA_REDUCE(Scan)
  CONTINUA_REDUCE(Exscan)

  int MPI_Iallreduce(const void *sent,
                     void *received,
                     int count,
                     MPI_Datatype type,
                     MPI_Op operation,
                     MPI_Comm communicator,
                     MPI_Request *request)
  {
    note_collective(Communication::other, Communication::reductions, count, type, communicator);
    return PMPI_Iallreduce(sent, received, count, type, operation, communicator, request);
  }

  int MPI_Reduce(const void *sent,
                 void *received,
                 int count,
                 MPI_Datatype type,
                 MPI_Op operation,
                 int root,
                 MPI_Comm communicator)
  {
    note_collective(Communication::other, Communication::reductions, count, type, communicator);
    return PMPI_Reduce(sent, received, count, type, operation, root, communicator);
  }

  int MPI_Reduce_scatter(const void *sent,
                         void *received,
                         const int counts[],
                         MPI_Datatype type,
                         MPI_Op operation,
                         MPI_Comm communicator)
  {
    note_collective(Communication::other, Communication::reductions,
                    Benchmarks::sum(counts, communicator), type, communicator);
    return PMPI_Reduce_scatter(sent, received, counts, type, operation, communicator);
  }

  int MPI_Bcast(void *buffer, int count, MPI_Datatype type, int root, MPI_Comm communicator)
  {
    note_collective(Communication::other, Communication::broadcasts, count, type, communicator);
    return PMPI_Bcast(buffer, count, type, root, communicator);
  }

  int MPI_Allgather(const void *sent,
                    int sent_count,
                    MPI_Datatype sent_type,
                    void *received,
                    int received_count,
                    MPI_Datatype received_type,
                    MPI_Comm communicator)
  {
    note_collective(Communication::other, Communication::gathers,
                    double(received_count) * Benchmarks::ranks_of(communicator), received_type,
                    communicator);
    return PMPI_Allgather(sent, sent_count, sent_type, received, received_count, received_type,
                          communicator);
  }

  int MPI_Allgatherv(const void *sent,
                     int sent_count,
                     MPI_Datatype sent_type,
                     void *received,
                     const int received_counts[],
                     const int displacements[],
                     MPI_Datatype received_type,
                     MPI_Comm communicator)
  {
    note_collective(Communication::other, Communication::gathers,
                    Benchmarks::sum(received_counts, communicator), received_type, communicator);
    return PMPI_Allgatherv(sent, sent_count, sent_type, received, received_counts, displacements,
                           received_type, communicator);
  }

  int MPI_Gather(const void *sent,
                 int sent_count,
                 MPI_Datatype sent_type,
                 void *received,
                 int received_count,
                 MPI_Datatype received_type,
                 int root,
                 MPI_Comm communicator)
  {
    int rank = 0;
    PMPI_Comm_rank(communicator, &rank);
    if (rank == root)
      note_collective(Communication::other, Communication::gathers,
                      double(received_count) * Benchmarks::ranks_of(communicator), received_type,
                      communicator);
    else
      note_collective(Communication::other, Communication::gathers, 0., sent_type, communicator);
    return PMPI_Gather(sent, sent_count, sent_type, received, received_count, received_type, root,
                       communicator);
  }

  int MPI_Gatherv(const void *sent,
                  int sent_count,
                  MPI_Datatype sent_type,
                  void *received,
                  const int received_counts[],
                  const int displacements[],
                  MPI_Datatype received_type,
                  int root,
                  MPI_Comm communicator)
  {
    int rank = 0;
    PMPI_Comm_rank(communicator, &rank);
    if (rank == root)
      note_collective(Communication::other, Communication::gathers,
                      Benchmarks::sum(received_counts, communicator), received_type, communicator);
    else
      note_collective(Communication::other, Communication::gathers, 0., sent_type, communicator);
    return PMPI_Gatherv(sent, sent_count, sent_type, received, received_counts, displacements,
                        received_type, root, communicator);
  }

  int MPI_Alltoall(const void *sent,
                   int sent_count,
                   MPI_Datatype sent_type,
                   void *received,
                   int received_count,
                   MPI_Datatype received_type,
                   MPI_Comm communicator)
  {
    note_collective(Communication::other, Communication::all_to_all,
                    double(sent_count) * Benchmarks::ranks_of(communicator), sent_type,
                    communicator);
    return PMPI_Alltoall(sent, sent_count, sent_type, received, received_count, received_type,
                         communicator);
  }

  int MPI_Alltoallv(const void *sent,
                    const int sent_counts[],
                    const int sent_displacements[],
                    MPI_Datatype sent_type,
                    void *received,
                    const int received_counts[],
                    const int received_displacements[],
                    MPI_Datatype received_type,
                    MPI_Comm communicator)
  {
    note_collective(Communication::other, Communication::all_to_all,
                    Benchmarks::sum(sent_counts, communicator), sent_type, communicator);
    return PMPI_Alltoallv(sent, sent_counts, sent_displacements, sent_type, received,
                          received_counts, received_displacements, received_type, communicator);
  }

  int MPI_Barrier(MPI_Comm communicator)
  {
    note_collective(Communication::other, Communication::barriers, 0., MPI_CHAR, communicator);
    return PMPI_Barrier(communicator);
  }

  int MPI_Ibarrier(MPI_Comm communicator, MPI_Request *request)
  {
    note_collective(Communication::other, Communication::barriers, 0., MPI_CHAR, communicator);
    return PMPI_Ibarrier(communicator, request);
  }

  // Of Fortran: MPI's functions of C are not called by these.
#define CONTINUA_NEXT(NAME) static void *const next = dlsym(RTLD_NEXT, #NAME)

#define CONTINUA_FORTRAN_SEND(NAME)                                                                \
  void NAME(void *buffer, MPI_Fint *count, MPI_Fint *type, MPI_Fint *destination, MPI_Fint *tag,   \
            MPI_Fint *communicator, MPI_Fint *error)                                               \
  {                                                                                                \
    CONTINUA_NEXT(NAME);                                                                           \
    note_message(Communication::mumps, *count, MPI_Type_f2c(*type), *destination,                  \
                 MPI_Comm_f2c(*communicator));                                                     \
    Benchmarks::pass_on(next, buffer, count, type, destination, tag, communicator, error);         \
  }
  CONTINUA_FORTRAN_SEND(mpi_send_)
  CONTINUA_FORTRAN_SEND(mpi_ssend_)

  void mpi_isend_(void *buffer,
                  MPI_Fint *count,
                  MPI_Fint *type,
                  MPI_Fint *destination,
                  MPI_Fint *tag,
                  MPI_Fint *communicator,
                  MPI_Fint *request,
                  MPI_Fint *error)
  {
    CONTINUA_NEXT(mpi_isend_);
    note_message(Communication::mumps, *count, MPI_Type_f2c(*type), *destination,
                 MPI_Comm_f2c(*communicator));
    Benchmarks::pass_on(next, buffer, count, type, destination, tag, communicator, request, error);
  }

  void mpi_allreduce_(void *sent,
                      void *received,
                      MPI_Fint *count,
                      MPI_Fint *type,
                      MPI_Fint *operation,
                      MPI_Fint *communicator,
                      MPI_Fint *error)
  {
    CONTINUA_NEXT(mpi_allreduce_);
    note_collective(Communication::mumps, Communication::reductions, *count, MPI_Type_f2c(*type),
                    MPI_Comm_f2c(*communicator));
    Benchmarks::pass_on(next, sent, received, count, type, operation, communicator, error);
  }

  void mpi_reduce_(void *sent,
                   void *received,
                   MPI_Fint *count,
                   MPI_Fint *type,
                   MPI_Fint *operation,
                   MPI_Fint *root,
                   MPI_Fint *communicator,
                   MPI_Fint *error)
  {
    CONTINUA_NEXT(mpi_reduce_);
    note_collective(Communication::mumps, Communication::reductions, *count, MPI_Type_f2c(*type),
                    MPI_Comm_f2c(*communicator));
    Benchmarks::pass_on(next, sent, received, count, type, operation, root, communicator, error);
  }

  void mpi_bcast_(void *buffer,
                  MPI_Fint *count,
                  MPI_Fint *type,
                  MPI_Fint *root,
                  MPI_Fint *communicator,
                  MPI_Fint *error)
  {
    CONTINUA_NEXT(mpi_bcast_);
    note_collective(Communication::mumps, Communication::broadcasts, *count, MPI_Type_f2c(*type),
                    MPI_Comm_f2c(*communicator));
    Benchmarks::pass_on(next, buffer, count, type, root, communicator, error);
  }

  void mpi_gather_(void *sent,
                   MPI_Fint *sent_count,
                   MPI_Fint *sent_type,
                   void *received,
                   MPI_Fint *received_count,
                   MPI_Fint *received_type,
                   MPI_Fint *root,
                   MPI_Fint *communicator,
                   MPI_Fint *error)
  {
    CONTINUA_NEXT(mpi_gather_);
    const MPI_Comm ranks = MPI_Comm_f2c(*communicator);
    int rank = 0;
    PMPI_Comm_rank(ranks, &rank);
    const bool gets = rank == *root;
    note_collective(Communication::mumps, Communication::gathers,
                    gets ? double(*received_count) * Benchmarks::ranks_of(ranks) : 0.,
                    MPI_Type_f2c(gets ? *received_type : *sent_type), ranks);
    Benchmarks::pass_on(next, sent, sent_count, sent_type, received, received_count, received_type,
                        root, communicator, error);
  }

  void mpi_alltoall_(void *sent,
                     MPI_Fint *sent_count,
                     MPI_Fint *sent_type,
                     void *received,
                     MPI_Fint *received_count,
                     MPI_Fint *received_type,
                     MPI_Fint *communicator,
                     MPI_Fint *error)
  {
    CONTINUA_NEXT(mpi_alltoall_);
    const MPI_Comm ranks = MPI_Comm_f2c(*communicator);
    note_collective(Communication::mumps, Communication::all_to_all,
                    double(*sent_count) * Benchmarks::ranks_of(ranks), MPI_Type_f2c(*sent_type),
                    ranks);
    Benchmarks::pass_on(next, sent, sent_count, sent_type, received, received_count, received_type,
                        communicator, error);
  }

  void mpi_barrier_(MPI_Fint *communicator, MPI_Fint *error)
  {
    CONTINUA_NEXT(mpi_barrier_);
    note_collective(Communication::mumps, Communication::barriers, 0., MPI_CHAR,
                    MPI_Comm_f2c(*communicator));
    Benchmarks::pass_on(next, communicator, error);
  }
}
