#include <continua/base/collective.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <limits>
#include <numeric>

namespace Continua
{
namespace
{
MPI_Datatype mpi_type(const char *)
{
  return MPI_CHAR;
}
MPI_Datatype mpi_type(const double *)
{
  return MPI_DOUBLE;
}
MPI_Datatype mpi_type(const unsigned int *)
{
  return MPI_UNSIGNED;
}
MPI_Datatype mpi_type(const unsigned long *)
{
  return MPI_UNSIGNED_LONG;
}

/// Whether there is anybody to exchange with; without MPI_Init there is nobody.
bool is_alone(const MPI_Comm communicator)
{
  return dealii::Utilities::MPI::n_mpi_processes(communicator) == 1;
}

/// Of std::string or a std::vector of numbers.
template <typename Container>
Container broadcast_container(const MPI_Comm communicator, const Container &value)
{
  if (is_alone(communicator))
    return value;
  const bool is_root = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  unsigned long size = value.size();
  AssertThrow(size <= std::numeric_limits<int>::max(), dealii::ExcMessage("too large a message"));
  int error = MPI_Bcast(&size, 1, MPI_UNSIGNED_LONG, 0, communicator);
  AssertThrowMPI(error);
  Container result = is_root ? value : Container(size, typename Container::value_type());
  error =
      MPI_Bcast(result.data(), static_cast<int>(size), mpi_type(result.data()), 0, communicator);
  AssertThrowMPI(error);
  return result;
}

template <typename Number>
std::vector<Number> all_gather_number(const MPI_Comm communicator, const Number value)
{
  if (is_alone(communicator))
    return {value};
  std::vector<Number> result(dealii::Utilities::MPI::n_mpi_processes(communicator));
  const int error =
      MPI_Allgather(&value, 1, mpi_type(&value), result.data(), 1, mpi_type(&value), communicator);
  AssertThrowMPI(error);
  return result;
}

/// Of std::string or a std::vector of numbers.
template <typename Container>
std::vector<Container> all_gather_container(const MPI_Comm communicator, const Container &value)
{
  if (is_alone(communicator))
    return {value};
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
  const int size = static_cast<int>(value.size());
  std::vector<int> sizes(n_ranks), begins(n_ranks, 0);
  int error = MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, communicator);
  AssertThrowMPI(error);
  std::partial_sum(sizes.begin(), sizes.end() - 1, begins.begin() + 1);
  AssertThrow(std::accumulate(sizes.begin(), sizes.end(), 0L) <= std::numeric_limits<int>::max(),
              dealii::ExcMessage("too large a message"));
  Container all(begins.back() + sizes.back(), typename Container::value_type());
  error = MPI_Allgatherv(value.data(), size, mpi_type(value.data()), all.data(), sizes.data(),
                         begins.data(), mpi_type(value.data()), communicator);
  AssertThrowMPI(error);
  std::vector<Container> result;
  for (unsigned int rank = 0; rank < n_ranks; ++rank)
    result.emplace_back(all.begin() + begins[rank], all.begin() + begins[rank] + sizes[rank]);
  return result;
}
} // namespace

std::string broadcast(const MPI_Comm communicator, const std::string &value)
{
  return broadcast_container(communicator, value);
}

std::vector<double> broadcast(const MPI_Comm communicator, const std::vector<double> &value)
{
  return broadcast_container(communicator, value);
}

std::vector<std::string> broadcast(const MPI_Comm communicator,
                                   const std::vector<std::string> &value)
{
  std::vector<std::string> result(
      broadcast(communicator, std::vector<double>(value.size())).size());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = broadcast(communicator, i < value.size() ? value[i] : std::string());
  return result;
}

std::vector<double> all_gather(const MPI_Comm communicator, const double value)
{
  return all_gather_number(communicator, value);
}

std::vector<unsigned int> all_gather(const MPI_Comm communicator, const unsigned int value)
{
  return all_gather_number(communicator, value);
}

std::vector<unsigned long> all_gather(const MPI_Comm communicator, const unsigned long value)
{
  return all_gather_number(communicator, value);
}

std::vector<std::string> all_gather(const MPI_Comm communicator, const std::string &value)
{
  return all_gather_container(communicator, value);
}

std::vector<std::vector<unsigned int>> all_gather(const MPI_Comm communicator,
                                                  const std::vector<unsigned int> &value)
{
  return all_gather_container(communicator, value);
}

std::vector<std::vector<double>> all_gather(const MPI_Comm communicator,
                                            const std::vector<double> &value)
{
  return all_gather_container(communicator, value);
}
} // namespace Continua
