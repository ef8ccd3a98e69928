#ifndef continua_linear_algebra_for_row_h
#define continua_linear_algebra_for_row_h

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Epetra_CrsMatrix.h>

namespace Continua
{
/// One row of this rank: calls function(global column, value) for each entry.
template <typename Function>
void for_row(const dealii::TrilinosWrappers::SparseMatrix &matrix,
             const int local_row,
             const Function &function)
{
  const Epetra_CrsMatrix &epetra = matrix.trilinos_matrix();
  int n_entries = 0;
  double *values = nullptr;
  int *columns = nullptr;
  epetra.ExtractMyRowView(local_row, n_entries, values, columns);
  for (int k = 0; k < n_entries; ++k)
    function(epetra.GCID(columns[k]), values[k]);
}
} // namespace Continua

#endif
