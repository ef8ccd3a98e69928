#ifndef continua_finite_volume_sparse_rows_h
#define continua_finite_volume_sparse_rows_h

#include <deal.II/base/index_set.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <mpi.h>

#include <utility>
#include <vector>

namespace Continua
{
/// The rows of this rank of a matrix that is being put together; entries that occur twice add.
class SparseRows
{
public:
  SparseRows(const dealii::IndexSet &rows, const dealii::IndexSet &columns, MPI_Comm communicator);

  /// `row` and `column` global; the row must be this rank's.
  void add(const unsigned int row, const unsigned int column, const double value)
  {
    entries[row - first].emplace_back(column, value);
  }
  /// Makes the matrix; collective. The rows are empty afterwards.
  void move_to(dealii::TrilinosWrappers::SparseMatrix &matrix);

private:
  dealii::IndexSet rows, columns;
  MPI_Comm communicator;
  unsigned int first;
  std::vector<std::vector<std::pair<unsigned int, double>>> entries;
};
} // namespace Continua

#endif
