#ifndef continua_linear_algebra_matrix_operator_h
#define continua_linear_algebra_matrix_operator_h

#include <continua/linear_algebra/velocity_operator.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace Continua
{
/// The velocities' matrix as a matrix.
class MatrixOperator : public VelocityOperator
{
public:
  /// The matrix must outlive it.
  explicit MatrixOperator(const dealii::TrilinosWrappers::SparseMatrix &matrix);

  void multiply(DistributedVector &target, const DistributedVector &source) const override;
  const DistributedVector &diagonal() const override { return diagonal_entries; }

private:
  const dealii::TrilinosWrappers::SparseMatrix &matrix;
  DistributedVector diagonal_entries;
};
} // namespace Continua

#endif
