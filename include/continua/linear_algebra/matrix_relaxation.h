#ifndef continua_linear_algebra_matrix_relaxation_h
#define continua_linear_algebra_matrix_relaxation_h

#include <continua/linear_algebra/block_multigrid.h>
#include <continua/linear_algebra/velocity_blocks.h>
#include <continua/linear_algebra/velocity_relaxation.h>

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>

namespace Continua
{
/// By the matrix: a sweep of symmetric Gauss-Seidel over all velocities, or, in a viscous fluid, a
/// cycle of algebraic multigrid for the fluid.
class MatrixRelaxation : public VelocityRelaxation
{
public:
  /// The matrix must outlive it.
  MatrixRelaxation(const dealii::TrilinosWrappers::SparseMatrix &matrix,
                   const VelocityBlocks &blocks);

  void add_relaxed(DistributedVector &velocity, const DistributedVector &residual) override;
  void leave_residual(DistributedVector &residual,
                      const DistributedVector &velocity,
                      const DistributedVector &source) override;

private:
  const dealii::TrilinosWrappers::SparseMatrix &matrix;
  dealii::TrilinosWrappers::PreconditionSSOR sweep;
  std::unique_ptr<BlockMultigrid> multigrid; ///< of a viscous fluid
  DistributedVector correction;
};
} // namespace Continua

#endif
