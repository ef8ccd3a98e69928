#include <continua/linear_algebra/mumps_factor.h>

namespace Continua
{
MumpsFactor::MumpsFactor(const bool quasi_definite, const MPI_Comm communicator)
    : quasi_definite(quasi_definite),
      solver(quasi_definite ? MumpsSolver::Symmetry::quasi_definite
                            : MumpsSolver::Symmetry::symmetric,
             communicator)
{
}

void MumpsFactor::factorize(const SymmetricTriplets &matrix, const std::vector<int> &owned)
{
  matrix.check(owned);
  solver.factorize(matrix.n, matrix.rows, matrix.columns, matrix.values, owned, announce);
}

std::string MumpsFactor::name() const
{
  return quasi_definite ? "MUMPS, L D L^T without pivoting" : "MUMPS, L D L^T with pivoting";
}
} // namespace Continua
