#include <continua/linear_algebra/matrix_product.h>

#include <deal.II/lac/exceptions.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_FEVector.h>

namespace Continua
{
using namespace dealii;

void multiply(const TrilinosWrappers::SparseMatrix &matrix,
              DistributedVector &target,
              const DistributedVector &source)
{
  const int status =
      matrix.trilinos_matrix().Multiply(false, source.trilinos_vector(), target.trilinos_vector());
  AssertThrow(status == 0, LACExceptions::ExcTrilinosError(status));
}

void multiply_transposed(const TrilinosWrappers::SparseMatrix &matrix,
                         DistributedVector &target,
                         const DistributedVector &source)
{
  const int status =
      matrix.trilinos_matrix().Multiply(true, source.trilinos_vector(), target.trilinos_vector());
  AssertThrow(status == 0, LACExceptions::ExcTrilinosError(status));
}

std::vector<unsigned int> rows_with_entries(const TrilinosWrappers::SparseMatrix &matrix)
{
  std::vector<unsigned int> rows;
  const auto n_rows = static_cast<unsigned int>(matrix.trilinos_matrix().NumMyRows());
  for (unsigned int i = 0; i < n_rows; ++i)
    if (matrix.trilinos_matrix().NumMyEntries(i) > 0)
      rows.push_back(i);
  return rows;
}
} // namespace Continua
