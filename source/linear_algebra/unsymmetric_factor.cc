#include <continua/linear_algebra/umfpack_factor.h>
#include <continua/linear_algebra/unsymmetric_factor.h>
#include <continua/linear_algebra/unsymmetric_mumps_factor.h>

#include <algorithm>
#include <stdexcept>

namespace Continua
{
void Triplets::check(const std::vector<int> &owned) const
{
  if (rows.size() != columns.size() || rows.size() != values.size())
    throw std::invalid_argument("Triplets: rows, columns and values differ in length");
  const auto outside = [&](const int i) { return i < 0 || i >= n; };
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (outside(rows[k]) || outside(columns[k]))
      throw std::invalid_argument("Triplets: entry (" + std::to_string(rows[k]) + ", " +
                                  std::to_string(columns[k]) + ") is not in a matrix of size " +
                                  std::to_string(n));
  if (std::any_of(owned.begin(), owned.end(), outside))
    throw std::invalid_argument("Triplets: an owned index is outside the matrix");
}

std::unique_ptr<UnsymmetricFactor> make_unsymmetric_factor(const DirectSolver choice,
                                                           const MPI_Comm communicator)
{
  int n_ranks = 1;
  MPI_Comm_size(communicator, &n_ranks);

  if (choice == DirectSolver::automatic)
    return make_unsymmetric_factor(n_ranks == 1 ? DirectSolver::umfpack : DirectSolver::mumps,
                                   communicator);
  if (choice == DirectSolver::mumps)
    return std::make_unique<UnsymmetricMumpsFactor>(communicator);
  if (choice == DirectSolver::cholmod)
    throw std::invalid_argument("the solver 'cholmod' is for symmetric matrices; choose automatic, "
                                "mumps or umfpack");
  if (n_ranks > 1)
    throw std::invalid_argument("the solver 'umfpack' works on one rank only; choose mumps or "
                                "automatic");
  return std::make_unique<UmfpackFactor>();
}
} // namespace Continua
