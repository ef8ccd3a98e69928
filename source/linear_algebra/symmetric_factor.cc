#include <continua/base/input_error.h>
#include <continua/linear_algebra/both_triangles.h>
#include <continua/linear_algebra/cholmod_factor.h>
#include <continua/linear_algebra/mumps_factor.h>
#include <continua/linear_algebra/single_precision_factor.h>
#include <continua/linear_algebra/symmetric_factor.h>
#include <continua/linear_algebra/umfpack_factor.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace Continua
{
void SymmetricTriplets::check(const std::vector<int> &owned) const
{
  if (rows.size() != columns.size() || rows.size() != values.size())
    throw std::invalid_argument("SymmetricTriplets: rows, columns and values differ in length");
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (columns[k] < 0 || columns[k] > rows[k] || rows[k] >= n)
      throw std::invalid_argument("SymmetricTriplets: entry (" + std::to_string(rows[k]) + ", " +
                                  std::to_string(columns[k]) +
                                  ") is not in the lower triangle of a matrix of size " +
                                  std::to_string(n));
  if (std::any_of(owned.begin(), owned.end(), [&](const int i) { return i < 0 || i >= n; }))
    throw std::invalid_argument("SymmetricTriplets: an owned index is outside the matrix");
}

std::size_t SymmetricFactor::n_negative_pivots() const
{
  if (!counts_pivots)
    throw std::logic_error("SymmetricFactor: set counts_pivots before the factorisation");
  return count_negative_pivots();
}

std::size_t SymmetricFactor::count_negative_pivots() const
{
  throw RunError("the solver " + name() + " does not tell the signs of its pivots; choose mumps");
}

std::unique_ptr<SymmetricFactor> make_symmetric_factor(const DirectSolver choice,
                                                       const bool quasi_definite,
                                                       const std::size_t n_entries,
                                                       const MPI_Comm communicator)
{
  int n_ranks = 1;
  MPI_Comm_size(communicator, &n_ranks);

  if (choice == DirectSolver::automatic)
  {
    const bool simplicial =
        n_ranks == 1 && quasi_definite && n_entries <= largest_simplicial_matrix;
    return make_symmetric_factor(simplicial ? DirectSolver::cholmod : DirectSolver::mumps,
                                 quasi_definite, n_entries, communicator);
  }
  if (choice == DirectSolver::mumps)
    return std::make_unique<MumpsFactor>(quasi_definite, communicator);
  if (n_ranks > 1)
    throw std::invalid_argument("the solver '" + word_of(direct_solver_words(), choice) +
                                "' works on one rank only; choose mumps or automatic");
  if (choice == DirectSolver::umfpack)
    return std::make_unique<BothTriangles>(std::make_unique<UmfpackFactor>());
  if (!quasi_definite)
    throw std::invalid_argument(
        "the solver 'cholmod' does not pivot, so it needs a compressible material everywhere "
        "(1/K > 0); choose mumps or automatic");
  return std::make_unique<CholmodFactor>();
}

std::unique_ptr<SymmetricFactor> make_block_factor(SymmetricTriplets matrix,
                                                   const std::vector<int> &owned,
                                                   const double most_bytes,
                                                   const MPI_Comm communicator)
{
  // On any number of ranks the same precision.
  std::size_t n_entries = matrix.values.size();
  MPI_Allreduce(MPI_IN_PLACE, &n_entries, 1, MPI_UNSIGNED_LONG, MPI_SUM, communicator);
  const bool is_single = n_entries > largest_simplicial_matrix;
  std::unique_ptr<SymmetricFactor> factor;
  if (!is_single)
    factor = make_symmetric_factor(DirectSolver::automatic, true, n_entries, communicator);
  else
    factor = std::make_unique<SinglePrecisionFactor>(true, communicator);
  factor->announce = [most_bytes, is_single](const FactorEstimate &estimate)
  {
    const double bytes = estimate.n_entries * (is_single ? sizeof(float) : sizeof(double));
    if (bytes > most_bytes)
      throw FactorTooLarge(bytes);
  };
  factor->factorize(std::move(matrix), owned);
  factor->announce = nullptr;
  return factor;
}
} // namespace Continua
