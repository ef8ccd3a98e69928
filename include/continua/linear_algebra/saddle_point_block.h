#ifndef continua_linear_algebra_saddle_point_block_h
#define continua_linear_algebra_saddle_point_block_h

#include <continua/linear_algebra/symmetric_factor.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_IntVector.h>

#include <cassert>
#include <cstddef>
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
  /// With B and C, which need not outlive it. Local indices of this rank's velocities and
  /// pressures: columns and rows of B.
  SaddlePointBlock(const Epetra_CrsMatrix &divergence,
                   const Epetra_CrsMatrix &compression,
                   std::vector<unsigned int> velocities,
                   std::vector<unsigned int> pressures);

  /// Adds entries to A, those of the block from a matrix. Collective.
  void add_velocity_entries(const Epetra_CrsMatrix &matrix);
  /// Makes number() known for velocities of other ranks, by their global indices; those of this
  /// rank may be among them. Collective.
  void learn_numbers(const std::vector<int> &velocities);
  /// The row in the block of a velocity by its global index, which must be learned; -1 if it is
  /// not in.
  int number(const int velocity) const
  {
    const int local = numbers->Map().LID(velocity);
    if (local >= 0)
      return (*numbers)[local];
    const int of_others = numbers_of_others->Map().LID(velocity);
    assert(of_others >= 0);
    return (*numbers_of_others)[of_others];
  }
  /// Makes room for so many single entries. Arrays that grow would be in memory twice.
  void reserve(std::size_t n_entries);
  /// Adds to A, on or below its diagonal, at rows of the block, also of other ranks.
  void add_velocity_entry(const int row, const int column, const double value)
  {
    block.rows.push_back(row);
    block.columns.push_back(column);
    block.values.push_back(value);
  }

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
  int first_velocity = 0;
  /// Of this rank's velocities in the block, else -1; and of those of others.
  std::unique_ptr<Epetra_IntVector> numbers, numbers_of_others;
  std::vector<int> owned;
  std::vector<double> part;
  std::unique_ptr<SymmetricFactor> inverse;
};
} // namespace Continua

#endif
