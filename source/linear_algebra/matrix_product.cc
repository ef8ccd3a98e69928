#include <continua/linear_algebra/matrix_product.h>

#include <deal.II/lac/exceptions.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_FEVector.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

namespace
{
/// Whether this rank has the same entries in both. Not collective.
[[maybe_unused]] bool is_same_layout(const Epetra_BlockMap &a, const Epetra_BlockMap &b)
{
  return a.NumMyElements() == b.NumMyElements() && a.MinMyGID() == b.MinMyGID() &&
         a.MaxMyGID() == b.MaxMyGID();
}

/// Of a product target = matrix source.
void assert_layouts([[maybe_unused]] const Epetra_BlockMap &target_of_matrix,
                    [[maybe_unused]] const DistributedVector &target,
                    [[maybe_unused]] const Epetra_BlockMap &source_of_matrix,
                    [[maybe_unused]] const DistributedVector &source)
{
  Assert(is_same_layout(target_of_matrix, target.trilinos_vector().Map()),
         ExcMessage("The target has another layout than the matrix."));
  Assert(is_same_layout(source_of_matrix, source.trilinos_vector().Map()),
         ExcMessage("The source has another layout than the matrix."));
}
} // namespace

void multiply(const TrilinosWrappers::SparseMatrix &matrix,
              DistributedVector &target,
              const DistributedVector &source)
{
  assert_layouts(matrix.trilinos_matrix().RangeMap(), target, matrix.trilinos_matrix().DomainMap(),
                 source);
  const int status =
      matrix.trilinos_matrix().Multiply(false, source.trilinos_vector(), target.trilinos_vector());
  AssertThrow(status == 0, LACExceptions::ExcTrilinosError(status));
}

void multiply_transposed(const TrilinosWrappers::SparseMatrix &matrix,
                         DistributedVector &target,
                         const DistributedVector &source)
{
  assert_layouts(matrix.trilinos_matrix().DomainMap(), target, matrix.trilinos_matrix().RangeMap(),
                 source);
  const int status =
      matrix.trilinos_matrix().Multiply(true, source.trilinos_vector(), target.trilinos_vector());
  AssertThrow(status == 0, LACExceptions::ExcTrilinosError(status));
}

std::vector<unsigned int> rows_with_entries(const TrilinosWrappers::SparseMatrix &matrix)
{
  std::vector<unsigned int> rows;
  const auto n_rows = static_cast<unsigned int>(matrix.trilinos_matrix().NumMyRows());
  for (unsigned int i = 0; i < n_rows; ++i)
    if (matrix.trilinos_matrix().NumMyEntries(static_cast<int>(i)) > 0)
      rows.push_back(i);
  return rows;
}

std::vector<unsigned int> rows_with_values(const TrilinosWrappers::SparseMatrix &matrix)
{
  std::vector<unsigned int> rows;
  const auto n_rows = static_cast<unsigned int>(matrix.trilinos_matrix().NumMyRows());
  for (unsigned int i = 0; i < n_rows; ++i)
  {
    int n_entries = 0;
    double *values = nullptr;
    const int status =
        matrix.trilinos_matrix().ExtractMyRowView(static_cast<int>(i), n_entries, values);
    AssertThrow(status == 0, LACExceptions::ExcTrilinosError(status));
    if (std::any_of(values, values + n_entries, [](const double value) { return value != 0.; }))
      rows.push_back(i);
  }
  return rows;
}
} // namespace Continua
