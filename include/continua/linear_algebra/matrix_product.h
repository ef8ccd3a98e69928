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

/// Local indices of this rank's rows that have entries, be they zero.
std::vector<unsigned int> rows_with_entries(const dealii::TrilinosWrappers::SparseMatrix &matrix);

/// Local indices of this rank's rows that have an entry other than zero. (Of a matrix whose rows
/// other ranks fill, too, the pattern is no measure: deal.II puts an entry into one row of a rank
/// that has nothing to send to others.)
std::vector<unsigned int> rows_with_values(const dealii::TrilinosWrappers::SparseMatrix &matrix);
} // namespace Continua

#endif
