#include <continua/linear_algebra/single_precision_factor.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace Continua
{
namespace
{
/// The factors of the rows of the whole matrix, and the smallest scaled diagonal entry in size.
struct RowScale
{
  RowScale(const SymmetricTriplets &matrix, MPI_Comm communicator);

  std::vector<double> factors;
  double smallest_diagonal = 1.;
};

RowScale::RowScale(const SymmetricTriplets &matrix, const MPI_Comm communicator)
    : factors(matrix.n, 0.)
{
  std::vector<double> diagonal(matrix.n, 0.), largest(matrix.n, 0.);
  for (std::size_t k = 0; k < matrix.values.size(); ++k)
    if (matrix.rows[k] == matrix.columns[k])
      diagonal[matrix.rows[k]] += matrix.values[k];
  MPI_Allreduce(MPI_IN_PLACE, diagonal.data(), matrix.n, MPI_DOUBLE, MPI_SUM, communicator);
  for (int i = 0; i < matrix.n; ++i)
    if (diagonal[i] > 0.)
      factors[i] = 1. / std::sqrt(diagonal[i]);
  // Entries that couple the other rows with those of a positive diagonal.
  for (std::size_t k = 0; k < matrix.values.size(); ++k)
    for (const auto &[row, column] : {std::pair(matrix.rows[k], matrix.columns[k]),
                                      std::pair(matrix.columns[k], matrix.rows[k])})
      largest[row] = std::max(largest[row], std::abs(matrix.values[k]) * factors[column]);
  MPI_Allreduce(MPI_IN_PLACE, largest.data(), matrix.n, MPI_DOUBLE, MPI_MAX, communicator);
  for (int i = 0; i < matrix.n; ++i)
    if (!(diagonal[i] > 0.))
    {
      const double size = std::max(largest[i], std::sqrt(-diagonal[i]));
      factors[i] = size > 0. ? 1. / size : 1.;
      smallest_diagonal = std::min(smallest_diagonal, -diagonal[i] * factors[i] * factors[i]);
    }
}
} // namespace

SinglePrecisionFactor::SinglePrecisionFactor(const bool quasi_definite, const MPI_Comm communicator)
    : quasi_definite(quasi_definite), communicator(communicator)
{
}

void SinglePrecisionFactor::factorize(SymmetricTriplets matrix, const std::vector<int> &owned)
{
  matrix.check(owned);
  solver = nullptr; // the old factor goes before the new one is made
  std::vector<float> values(matrix.values.size());
  {
    const RowScale scale(matrix, communicator);
    pivots = !quasi_definite || scale.smallest_diagonal < smallest_pivot;
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] = static_cast<float>(matrix.values[k] * scale.factors[matrix.rows[k]] *
                                     scale.factors[matrix.columns[k]]);
    owned_scale.resize(owned.size());
    for (std::size_t k = 0; k < owned.size(); ++k)
      owned_scale[k] = scale.factors[owned[k]];
  }
  matrix.values = std::vector<double>();
  single.resize(owned.size());
  solver = std::make_unique<MumpsSolver<float>>(pivots ? MumpsSymmetry::symmetric
                                                       : MumpsSymmetry::quasi_definite,
                                                MumpsScaling::none, communicator);
  solver->factorize(matrix.n, std::move(matrix.rows), std::move(matrix.columns), std::move(values),
                    owned, announce);
}

void SinglePrecisionFactor::solve(std::vector<double> &x)
{
  assert(x.size() == single.size());
  // With a largest entry of one nothing overflows, and what is lost below 1e-38 counts for nothing.
  double size = 0.;
  for (std::size_t k = 0; k < x.size(); ++k)
  {
    x[k] *= owned_scale[k];
    size = std::max(size, std::abs(x[k]));
  }
  MPI_Allreduce(MPI_IN_PLACE, &size, 1, MPI_DOUBLE, MPI_MAX, communicator);
  if (size == 0.)
    return;
  for (std::size_t k = 0; k < x.size(); ++k)
    single[k] = static_cast<float>(x[k] / size);
  solver->solve(single);
  for (std::size_t k = 0; k < x.size(); ++k)
    x[k] = size * owned_scale[k] * single[k];
}

std::string SinglePrecisionFactor::name() const
{
  return std::string("MUMPS, L D L^T ") + (pivots ? "with" : "without") +
         " pivoting, in single precision";
}
} // namespace Continua
