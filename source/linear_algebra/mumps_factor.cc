#include <continua/linear_algebra/mumps_factor.h>

#include <utility>

namespace Continua
{
MumpsFactor::MumpsFactor(const bool quasi_definite, const MPI_Comm communicator)
    : quasi_definite(quasi_definite),
      solver(quasi_definite ? MumpsSymmetry::quasi_definite : MumpsSymmetry::symmetric,
             MumpsScaling::of_mumps,
             communicator)
{
}

void MumpsFactor::factorize(SymmetricTriplets matrix, const std::vector<int> &owned)
{
  matrix.check(owned);
  solver.counts_pivots = counts_pivots;
  solver.factorize(matrix.n, std::move(matrix.rows), std::move(matrix.columns),
                   std::move(matrix.values), owned, announce);
}

std::string MumpsFactor::name() const
{
  return quasi_definite ? "MUMPS, L D L^T without pivoting" : "MUMPS, L D L^T with pivoting";
}
} // namespace Continua
