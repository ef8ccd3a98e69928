// Products with a matrix that is spread over ranks, and the rows that count as filled: a zero that
// other ranks' rows left behind is an entry, but no value.

#include <continua/linear_algebra/matrix_product.h>

#include "dense_systems.h"

#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include "../unit_test.h"

namespace test_of_matrix_product
{
namespace
{
using namespace Continua;
using namespace dense_systems;

/// How many of all ranks' rows there are, and the sum of their global numbers.
std::pair<unsigned int, unsigned int> of_all_ranks(const std::vector<unsigned int> &rows,
                                                   const unsigned int n)
{
  unsigned int sums[2] = {static_cast<unsigned int>(rows.size()), 0};
  for (const unsigned int row : rows)
    sums[1] += owned(n).nth_index_in_set(row);
  MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_UNSIGNED, MPI_SUM, MPI_COMM_WORLD);
  return {sums[0], sums[1]};
}
} // namespace

UNIT_TEST(matrix_product)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  constexpr unsigned int n = 7, m = 5;
  Full full(n, m);
  List source(m), transposed_source(n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < m; ++j)
      full(i, j) = 1. + i - 2. * j + i * j;
  for (unsigned int j = 0; j < m; ++j)
    source[j] = 3. - j;
  for (unsigned int i = 0; i < n; ++i)
    transposed_source[i] = 0.5 * i;
  Sparse matrix;
  distribute(full, matrix);
  List expected(n), expected_transposed(m);
  full.vmult(expected, source);
  full.Tvmult(expected_transposed, transposed_source);
  DistributedVector target = distributed(transposed_source),
                    transposed_target = distributed(source);
  multiply(matrix, target, distributed(source));
  multiply_transposed(matrix, transposed_target, distributed(transposed_source));
  List difference = gathered(target);
  difference -= expected;
  check::absolute("product", difference.linfty_norm(), 0., 1e-12);
  difference = gathered(transposed_target);
  difference -= expected_transposed;
  check::absolute("transposed product", difference.linfty_norm(), 0., 1e-12);

  // Rows 1 and 4 of a square matrix have values, row 2 a zero, the others nothing.
  dealii::TrilinosWrappers::SparsityPattern pattern(owned(n), owned(n), MPI_COMM_WORLD, 1);
  for (const auto i : owned(n))
    if (i == 1 || i == 2 || i == 4)
      pattern.add(i, i);
  Sparse rows;
  pattern.compress();
  rows.reinit(pattern);
  for (const auto i : owned(n))
    if (i == 1 || i == 4)
      rows.set(i, i, -2.);
  rows.compress(dealii::VectorOperation::insert);
  check::is_true("rows with entries",
                 of_all_ranks(rows_with_entries(rows), n) == std::pair(3u, 1u + 2u + 4u));
  check::is_true("rows with values",
                 of_all_ranks(rows_with_values(rows), n) == std::pair(2u, 1u + 4u));

  // A matrix to whose rows other ranks may add: the rows that have values are those of the cells,
  // however many ranks there are.
  dealii::IndexSet all(n);
  all.add_range(0, n);
  dealii::TrilinosWrappers::SparsityPattern shared(owned(n), owned(n), all, MPI_COMM_WORLD);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    shared.add(5, 5);
  shared.compress();
  Sparse added;
  added.reinit(shared);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    added.add(5, 5, 1.);
  added.compress(dealii::VectorOperation::add);
  check::is_true("values in one row",
                 of_all_ranks(rows_with_values(added), n) == std::pair(1u, 5u));
}
} // namespace test_of_matrix_product
