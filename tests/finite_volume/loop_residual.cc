// The residual of the segregated loop: by hand, and of components that are next to nothing.

#include "../unit_test.h"

#include <continua/finite_volume/loop_residual.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>
#include <vector>

namespace test_of_loop_residual
{
UNIT_TEST(loop_residual)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  using namespace Continua;

  // A = diag(2, 4), x = (1, 3), b = (3, 13): A x = (2, 12), the mean is 2, A x_mean = (4, 8).
  {
    LoopResidual residual(1, MPI_COMM_SELF);
    const std::vector<double> r = {1., 1.}, product = {2., 12.}, sums = {2., 4.}, x = {1., 3.};
    residual.evaluate(2, 2., r.data(), product.data(), sums.data(), x.data());
    // |2 - 4| + |12 - 8| + |3 - 4| + |13 - 8| = 12.
    check::relative("by hand", residual.largest(), 2. / 12., 1e-14);
    check::relative("its sum", residual.magnitude(), 2., 1e-14);
  }
  // The second component is rounding beside the first.
  {
    LoopResidual residual(2, MPI_COMM_SELF);
    const std::vector<double> r = {0., 1e-16, 0., -1e-16}, product = {1., 1e-16, -1., -1e-16},
                              sums = {1., 1., 1., 1.}, x = {1., 1e-16, -1., -1e-16};
    residual.evaluate(2, 2., r.data(), product.data(), sums.data(), x.data());
    check::is_true("rounding does not count", residual.largest() < 1e-12);
  }
  {
    LoopResidual residual(1, MPI_COMM_SELF);
    const std::vector<double> zero = {0., 0.};
    residual.evaluate(2, 2., zero.data(), zero.data(), zero.data(), zero.data());
    check::is_true("rest", residual.largest() == 0.);
    const std::vector<double> none = {0., std::numeric_limits<double>::quiet_NaN()};
    residual.evaluate(2, 2., none.data(), zero.data(), zero.data(), zero.data());
    check::is_true("no number stays", !std::isfinite(residual.largest()));
  }
  check::throws<std::invalid_argument>(
      "four components", []() { LoopResidual(4, MPI_COMM_SELF); }, "one to three");
}
} // namespace test_of_loop_residual
