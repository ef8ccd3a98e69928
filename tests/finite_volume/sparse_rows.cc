// A matrix from its rows: what occurs twice adds, the ranks' rows together, and it is empty
// afterwards.

#include <continua/finite_volume/sparse_rows.h>
#include <continua/linear_algebra/matrix_product.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/trilinos_vector.h>

#include "../unit_test.h"

namespace test_of_sparse_rows
{
using namespace Continua;

UNIT_TEST(sparse_rows)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD),
                     n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  if (rank != 0)
    std::cout.setstate(std::ios::failbit);
  // Three rows and two columns of each rank: a_ij = i + 10 j for j = i/2 and the last column.
  dealii::IndexSet rows(3 * n_ranks), columns(2 * n_ranks);
  rows.add_range(3 * rank, 3 * rank + 3);
  columns.add_range(2 * rank, 2 * rank + 2);
  SparseRows list(rows, columns, MPI_COMM_WORLD);
  const unsigned int last = 2 * n_ranks - 1;
  for (unsigned int i = 3 * rank; i < 3 * rank + 3; ++i)
  {
    list.add(i, last, 0.25 * (i + 10. * last));
    list.add(i, i / 2, i + 10. * (i / 2));
    list.add(i, last, 0.75 * (i + 10. * last));
  }
  dealii::TrilinosWrappers::SparseMatrix matrix;
  list.move_to(matrix);
  check::is_true("size", matrix.m() == 3 * n_ranks && matrix.n() == 2 * n_ranks);
  dealii::TrilinosWrappers::MPI::Vector x(columns, MPI_COMM_WORLD), y(rows, MPI_COMM_WORLD);
  for (const auto j : columns)
    x[j] = 1. + j * j;
  x.compress(dealii::VectorOperation::insert);
  multiply(matrix, y, x);
  double error = 0.;
  for (const auto i : rows)
  {
    const double j = i / 2;
    // Where both are the same column, they add.
    const double expected =
        (i + 10. * j) * (1. + j * j) + (i + 10. * last) * (1. + 1. * last * last);
    error = std::max(error, std::abs(y(i) - expected));
  }
  check::absolute("product", dealii::Utilities::MPI::max(error, MPI_COMM_WORLD), 0., 1e-11);

  list.add(3 * rank, 2 * rank, 4.);
  list.move_to(matrix);
  check::absolute("empty afterwards", matrix.frobenius_norm(), 4. * std::sqrt(double(n_ranks)),
                  1e-14);
}
} // namespace test_of_sparse_rows
