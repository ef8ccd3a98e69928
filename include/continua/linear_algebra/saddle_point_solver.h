#ifndef continua_linear_algebra_saddle_point_solver_h
#define continua_linear_algebra_saddle_point_solver_h

#include <continua/linear_algebra/block_krylov.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/linear_algebra/divergence_operator.h>
#include <continua/linear_algebra/schur_complement.h>
#include <continua/linear_algebra/velocity_operator.h>
#include <continua/linear_algebra/velocity_preconditioner.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace Continua
{
/**
 * FGMRES (see BlockKrylov) for
 *
 *   [  A   -B^T ] [ u ]   [ f ]
 *   [ -B   -C   ] [ p ] = [ g ]
 *
 * with the block-triangular preconditioner that has the approximate inverses of A and of the Schur
 * complement on its diagonal. Residuals are measured with the diagonals of both,
 * (r^T D^-1 r)^(1/2), in which the two equations have one unit, that of the square root of a power;
 * a solve has converged when that of both together is below the tolerance times that of the largest
 * of the equations' own terms: f, g, and A u, B^T p, B u, C p of the initial guess.
 *
 * Augmentation: with a diagonal W >= 0, B^T W times the second equation is taken from the first,
 * which adds B^T W B to A without a change of the solution. The preconditioner is then that of this
 * system (and the inverse of A has to be that of A + B^T W B), while the operator stays as it is.
 */
class SaddlePointSolver
{
public:
  /// Sets the rows of both equations to the product of the matrix.
  using Product = BlockKrylov::Product;

  /// A, B and C. With `coupled`, A u - B^T p and B u in one pass. With `tangent_product`, the
  /// product of another matrix, which may be unsymmetric: the blocks are then those of the
  /// preconditioner alone.
  struct Blocks
  {
    const VelocityOperator &velocity;
    const DivergenceOperator &divergence;
    const dealii::TrilinosWrappers::SparseMatrix &compression;
    Product coupled = nullptr;
    Product tangent_product = nullptr;
  };

  explicit SaddlePointSolver(unsigned int restart_length);

  /// Takes the maps of the unknowns from the blocks; allocates.
  void reinit(const Blocks &blocks);
  /// `velocity` and `pressure` hold the initial guess; nothing is taken of it if zero is closer.
  /// The preconditioner is that of the symmetric part. `balances_equations`: measures the residuals
  /// of both equations so that they are of one size at the start from zero. Else the one that is
  /// smaller in the units above may stay as it is; a correction of Newton's iteration needs both.
  KrylovReport solve(const Blocks &blocks,
                     VelocityPreconditioner &velocity_inverse,
                     SchurComplement &schur_complement,
                     const DistributedVector &augmentation,
                     const DistributedVector &momentum,
                     const DistributedVector &mass,
                     DistributedVector &velocity,
                     DistributedVector &pressure,
                     double tolerance,
                     unsigned int maximum_iterations,
                     bool balances_equations = false);
  /// See BlockKrylov.
  void free_basis() { krylov.free_basis(); }

private:
  BlockKrylov krylov;
  /// Of the scale: roots of the diagonals of A and of the Schur complement.
  BlockKrylov::BlockVector inverse_scale;
  DistributedVector velocity_work, pressure_work, augmented;

  /// Of the sizes of both equations' residuals. An equation without a residual keeps it below this
  /// share of the other: a velocity that loses volume moves the pressures of a whole outlet.
  static constexpr double largest_balance = 1e4;

  /// Makes the scaled right-hand sides of both equations equally large.
  void balance();
  void multiply_blocks(const Blocks &blocks,
                       const DistributedVector &velocity,
                       const DistributedVector &pressure,
                       DistributedVector &momentum,
                       DistributedVector &mass);
};
} // namespace Continua

#endif
