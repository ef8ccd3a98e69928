// What an iteration leaves of a block's residual: nothing with the inverse, as much as the theory
// of conjugate gradients says (both minimise over the same polynomials) without a preconditioner,
// nearly all of it where the condition is bad; and what is outside of the block does not count.

#include <continua/linear_algebra/convergence_factor.h>
#include <continua/linear_algebra/matrix_product.h>

#include "../unit_test.h"
#include "dense_systems.h"

namespace test_of_convergence_factor
{
using namespace Continua;
using namespace dense_systems;

namespace
{
constexpr unsigned int n = 200;

/// Of the rows from `first` on; the preconditioner divides by a diagonal.
double factor(const Full &full, const List &divisors, const unsigned int first = 0)
{
  Sparse matrix;
  distribute(full, matrix);
  List diagonal(n), is_of_block(n);
  for (unsigned int i = 0; i < n; ++i)
  {
    diagonal[i] = full(i, i);
    is_of_block[i] = i >= first ? 1. : 0.;
  }
  const DistributedVector divisor = distributed(divisors);
  return convergence_factor([&](DistributedVector &target, const DistributedVector &source)
                            { multiply(matrix, target, source); },
                            [&](DistributedVector &target, const DistributedVector &source)
                            {
                              target.equ(1., source);
                              for (unsigned int i = 0; i < target.locally_owned_size(); ++i)
                                target.begin()[i] /= divisor.begin()[i];
                            },
                            distributed(diagonal), distributed(is_of_block));
}
} // namespace

UNIT_TEST(convergence_factor)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  List one(n), entries(n);
  one = 1.;
  Full diagonal(n, n);
  for (unsigned int i = 0; i < n; ++i)
    diagonal(i, i) = entries[i] = std::pow(10., 6. * i / n);
  check::absolute("inverse", factor(diagonal, entries), 0., 1e-10);

  // Eigenvalues from m to m + 4, so (sqrt(k) - 1)/(sqrt(k) + 1) with k = 1 + 4/m.
  check::relative("condition 2", factor(chain(n, 1., 4.), one), 0.1716, 0.06);
  check::relative("condition 5", factor(chain(n, 1., 1.), one), 0.3820, 0.06);
  check::is_true("bad condition", factor(chain(n, 1., 0.), one) > 0.9);

  // A first half that is bad by itself.
  const Full two_halves = chain(n, 1e8, 4.);
  check::is_true("both halves", factor(two_halves, one) > 0.5);
  check::relative("second half", factor(two_halves, one, n / 2), 0.1716, 0.06);
  check::absolute("no rows", factor(two_halves, one, n), 0., 0.);

  check::relative("second half of the residuals", late_factor({1., 1e-3, 1e-5, 5e-6, 2.5e-6}), 0.5,
                  1e-12);
  check::relative("one iteration", late_factor({4., 1.}), 0.25, 1e-12);
  check::absolute("nothing left", late_factor({4., 0.}), 0., 0.);
  check::absolute("no iteration", late_factor({4.}), 0., 0.);
}
} // namespace test_of_convergence_factor
