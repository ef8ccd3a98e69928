#ifndef continua_linear_algebra_matrix_product_h
#define continua_linear_algebra_matrix_product_h

#include <continua/linear_algebra/distributed_vector.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <vector>

namespace Continua
{
/// target = matrix source, on owned entries: as deal.II's vmult, which allocates in every call.
void multiply(const dealii::TrilinosWrappers::SparseMatrix &matrix,
              DistributedVector &target,
              const DistributedVector &source);
/// target = matrix^T source.
void multiply_transposed(const dealii::TrilinosWrappers::SparseMatrix &matrix,
                         DistributedVector &target,
                         const DistributedVector &source);

/// Local indices of this rank's rows that have entries.
std::vector<unsigned int> rows_with_entries(const dealii::TrilinosWrappers::SparseMatrix &matrix);
} // namespace Continua

#endif
