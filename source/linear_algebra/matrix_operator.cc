#include <continua/linear_algebra/matrix_operator.h>
#include <continua/linear_algebra/matrix_product.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_FEVector.h>

namespace Continua
{
using namespace dealii;

MatrixOperator::MatrixOperator(const TrilinosWrappers::SparseMatrix &matrix)
    : matrix(matrix),
      diagonal_entries(matrix.locally_owned_range_indices(), matrix.get_mpi_communicator())
{
  const int status =
      matrix.trilinos_matrix().ExtractDiagonalCopy(*diagonal_entries.trilinos_vector()(0));
  AssertThrow(status == 0, LACExceptions::ExcTrilinosError(status));
}

void MatrixOperator::multiply(DistributedVector &target, const DistributedVector &source) const
{
  Continua::multiply(matrix, target, source);
}
} // namespace Continua
