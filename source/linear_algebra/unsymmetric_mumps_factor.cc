#include <continua/linear_algebra/unsymmetric_mumps_factor.h>

namespace Continua
{
UnsymmetricMumpsFactor::UnsymmetricMumpsFactor(const MPI_Comm communicator)
    : solver(MumpsSymmetry::unsymmetric, MumpsScaling::of_mumps, communicator)
{
}

void UnsymmetricMumpsFactor::factorize(const Triplets &matrix, const std::vector<int> &owned)
{
  matrix.check(owned);
  solver.factorize(matrix.n, matrix.rows, matrix.columns, matrix.values, owned);
}

std::string UnsymmetricMumpsFactor::name() const
{
  return "MUMPS, L U";
}
} // namespace Continua
