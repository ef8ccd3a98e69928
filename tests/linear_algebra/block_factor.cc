// The factor of a block of a preconditioner: its precision follows from the entries on all ranks,
// and one that would be too large is not made.

#include "../unit_test.h"
#include "symmetric_problems.h"

#include <cstdlib>

namespace test_of_block_factor
{
using namespace Continua;
namespace problems = symmetric_problems;

namespace
{
/// All entries are there, and the diagonal is the largest.
SymmetricTriplets full_matrix(const int n)
{
  SymmetricTriplets matrix;
  matrix.n = n;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j)
      problems::add(matrix, i, j, i == j ? 20. : 1. / (1. + i - j));
  return matrix;
}

std::unique_ptr<SymmetricFactor> factor_of(const SymmetricTriplets &matrix, const double most_bytes)
{
  return make_block_factor(problems::strewn(matrix), problems::owned_indices(matrix.n), most_bytes,
                           MPI_COMM_WORLD);
}

void check_factor(const std::string &name, const SymmetricTriplets &matrix, const bool is_single)
{
  const std::unique_ptr<SymmetricFactor> factor = factor_of(matrix, 1e12);
  check::equal(name + ": in single precision",
               factor->name().find("in single precision") != std::string::npos ? "yes" : "no",
               is_single ? "yes" : "no");
  const std::vector<double> x = problems::manufactured(matrix.n);
  const double error = problems::norm(problems::difference(
                           problems::solve(*factor, problems::multiply(matrix, x)), x)) /
                       problems::norm(x);
  check::is_true(name + ": its digits",
                 error < (is_single ? 1e-4 : 1e-12) && (!is_single || error > 1e-10));

  double bytes = 0.;
  try
  {
    factor_of(matrix, 1e5);
  }
  catch (const FactorTooLarge &refused)
  {
    bytes = refused.bytes;
  }
  check::relative(name + ": too large, and by how much", bytes,
                  0.5 * matrix.n * (matrix.n + 1.) * (is_single ? 4. : 8.), 0.1);
}
} // namespace

UNIT_TEST(block_factor)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (problems::rank() > 0)
    std::cout.setstate(std::ios::failbit); // rank 0 alone prints

  // A rank of two alone has less than two million entries of either.
  check_factor("few entries", full_matrix(500), false);
  check_factor("many entries", full_matrix(1600), true);
}
} // namespace test_of_block_factor
