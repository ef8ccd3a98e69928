#ifndef continua_linear_algebra_saddle_point_block_h
#define continua_linear_algebra_saddle_point_block_h

#include <continua/linear_algebra/symmetric_factor.h>

#include <Epetra_CrsMatrix.h>

#include <limits>
#include <memory>
#include <vector>

namespace Continua
{
/// Some velocities and some pressures of a distributed saddle point [A -B^T; -B -C], and the factor
/// of their block. It is factored without pivoting, so that C has to be positive there.
class SaddlePointBlock
{
public:
  /// Local indices of this rank's rows of A, and of B and C. The matrices need not outlive it.
  SaddlePointBlock(const Epetra_CrsMatrix &velocity,
                   const Epetra_CrsMatrix &divergence,
                   const Epetra_CrsMatrix &compression,
                   std::vector<unsigned int> velocities,
                   std::vector<unsigned int> pressures);

  /// To be called once. Throws FactorTooLarge, see make_block_factor(). Collective.
  void factorize(double most_bytes = std::numeric_limits<double>::infinity());

  /// Adds the solution for the block's part of a right-hand side; arrays of the whole system's
  /// owned entries. Allocates nothing.
  void add_solution(const double *momentum, const double *mass, double *velocity, double *pressure);

  const SymmetricFactor &factor() const { return *inverse; }

private:
  std::vector<unsigned int> velocities, pressures;
  const MPI_Comm communicator;
  SymmetricTriplets block; ///< until it is factored
  std::vector<int> owned;
  std::vector<double> part;
  std::unique_ptr<SymmetricFactor> inverse;
};
} // namespace Continua

#endif
