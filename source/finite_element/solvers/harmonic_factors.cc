#include <continua/finite_element/solvers/harmonic_factors.h>

#include <continua/base/input_error.h>
#include <continua/base/lack_of_memory.h>
#include <continua/linear_algebra/singular_matrix.h>

#include <array>
#include <new>
#include <string>
#include <utility>

namespace Continua
{
HarmonicFactors::HarmonicFactors(const HarmonicMatrix &matrix,
                                 std::vector<int> owned,
                                 const MPI_Comm communicator)
    : matrix(matrix),
      communicator(communicator),
      solver(matrix.is_symmetric() ? MumpsSymmetry::symmetric : MumpsSymmetry::unsymmetric,
             MumpsScaling::of_mumps,
             MPI_COMM_SELF)
{
  solver.computes_determinant = true;
  MPI_Comm_rank(communicator, &rank);
  MPI_Comm_size(communicator, &n_ranks);
  const int n_owned = static_cast<int>(owned.size());
  n_owned_by_rank.resize(n_ranks);
  starts_by_rank.assign(n_ranks, 0);
  MPI_Allgather(&n_owned, 1, MPI_INT, n_owned_by_rank.data(), 1, MPI_INT, communicator);
  for (int other = 1; other < n_ranks; ++other)
    starts_by_rank[other] = starts_by_rank[other - 1] + n_owned_by_rank[other - 1];
  owned_of_all.resize(matrix.size());
  MPI_Allgatherv(owned.data(), n_owned, MPI_INT, owned_of_all.data(), n_owned_by_rank.data(),
                 starts_by_rank.data(), MPI_INT, communicator);
}

void HarmonicFactors::factorize(const std::vector<HarmonicCoefficients> &coefficients)
{
  // What one rank meets all of them throw.
  enum Status
  {
    fine,
    failure,
    singular
  };
  int status = fine;
  std::string text;
  std::array<double, 2> size = {{0., 0.}};
  if (rank < static_cast<int>(coefficients.size()))
    try
    {
      if (!std::exchange(is_analysed, true))
        solver.keep_pattern(matrix.size(), matrix.rows(), matrix.columns());
      matrix.set_values(coefficients[rank], values);
      solver.factorize_values(values);
      size = {{solver.memory(), solver.n_entries()}};
    }
    catch (const SingularMatrix &error)
    {
      status = singular;
      text = error.what();
    }
    catch (const RunError &error)
    {
      status = failure;
      text = error.what();
    }
    catch (const std::bad_alloc &)
    {
      status = failure;
      text = lack_of_memory + " for the factor of this rank. Use fewer ranks, each of which has a "
                              "whole factor, or a coarser mesh.";
    }
  const int own_status = status;
  MPI_Allreduce(MPI_IN_PLACE, &status, 1, MPI_INT, MPI_MAX, communicator);
  // The first of those that met the worst, with its text on all ranks.
  first_failed = status != fine && own_status == status ? rank : n_ranks;
  MPI_Allreduce(MPI_IN_PLACE, &first_failed, 1, MPI_INT, MPI_MIN, communicator);
  if (status != fine)
  {
    int length = static_cast<int>(text.size());
    MPI_Bcast(&length, 1, MPI_INT, first_failed, communicator);
    text.resize(length);
    MPI_Bcast(text.data(), length, MPI_CHAR, first_failed, communicator);
  }
  MPI_Allreduce(MPI_IN_PLACE, size.data(), 2, MPI_DOUBLE, MPI_SUM, communicator);
  bytes = size[0];
  entries = size[1];
  if (status == singular)
    throw SingularMatrix(text);
  if (status == failure)
    throw RunError(text);
}

void HarmonicFactors::solve(std::vector<Columns> &columns)
{
  const std::size_t n = matrix.size();
  travelling.resize(n);
  columns_here.clear();
  const auto type = MPI_C_DOUBLE_COMPLEX;
  for (int k = 0; k < static_cast<int>(columns.size()); ++k)
    for (std::vector<Complex> &column : columns[k])
    {
      MPI_Gatherv(column.data(), static_cast<int>(column.size()), type, travelling.data(),
                  n_owned_by_rank.data(), starts_by_rank.data(), type, k, communicator);
      if (k != rank)
        continue;
      columns_here.resize(columns_here.size() + n);
      Complex *const first = &columns_here[columns_here.size() - n];
      for (std::size_t i = 0; i < n; ++i)
        first[owned_of_all[i]] = travelling[i];
    }
  if (!columns_here.empty())
    solver.solve_columns(columns_here, static_cast<int>(columns_here.size() / n));
  for (int k = 0; k < static_cast<int>(columns.size()); ++k)
    for (std::size_t c = 0; c < columns[k].size(); ++c)
    {
      if (k == rank)
        for (std::size_t i = 0; i < n; ++i)
          travelling[i] = columns_here[c * n + owned_of_all[i]];
      MPI_Scatterv(travelling.data(), n_owned_by_rank.data(), starts_by_rank.data(), type,
                   columns[k][c].data(), static_cast<int>(columns[k][c].size()), type, k,
                   communicator);
    }
}

std::complex<double> HarmonicFactors::log_determinant(const unsigned int k) const
{
  Complex result = 0.;
  if (static_cast<int>(k) == rank)
    result = solver.log_determinant();
  MPI_Bcast(&result, 1, MPI_C_DOUBLE_COMPLEX, static_cast<int>(k), communicator);
  return result;
}
} // namespace Continua
