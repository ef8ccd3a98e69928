#ifndef continua_linear_algebra_multigrid_solver_h
#define continua_linear_algebra_multigrid_solver_h

#include <continua/linear_algebra/block_multigrid.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <memory>

namespace Continua
{
/**
 * Conjugate gradients for a symmetric positive definite matrix of displacements, preconditioned by
 * algebraic multigrid. The multigrid is kept from matrix to matrix, until a solve takes more
 * than 1.5 times as many iterations as the first one with it, and 5.
 */
class MultigridSolver
{
public:
  /// `pattern`: of the matrix, with its diagonal. `blocks`: its `fluid` are the unknowns of the
  /// multigrid; the others are not coupled, and have 1 on the diagonal. Collective.
  MultigridSolver(const dealii::TrilinosWrappers::SparsityPattern &pattern, VelocityBlocks blocks);

  /// To be filled, from zero, before take().
  dealii::TrilinosWrappers::SparseMatrix &matrix() { return entries; }
  /// The matrix has its entries. Collective.
  void take();
  /// The next take() makes the multigrid anew.
  void forget() { multigrid = nullptr; }
  /// Solves from the solution that is given until the residual is below `tolerance` times the right
  /// side. Collective. Throws RunError if that takes too many iterations.
  void
  solve(DistributedVector &solution, const DistributedVector &right_hand_side, double tolerance);

private:
  const VelocityBlocks blocks;
  dealii::TrilinosWrappers::SparseMatrix entries;
  std::unique_ptr<BlockMultigrid> multigrid;
  unsigned int first_iterations = 0;
  bool is_used = false, is_worn = false;
};
} // namespace Continua

#endif
