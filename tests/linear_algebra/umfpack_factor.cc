#include "../unit_test.h"
#include "symmetric_problems.h"

#include <continua/base/input_error.h>
#include <continua/linear_algebra/symmetric_factor.h>

#include <deal.II/base/mpi.h>

namespace test_of_umfpack_factor
{
UNIT_TEST(umfpack_factor)
{
  using namespace Continua;
  namespace problems = symmetric_problems;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // Both triangles of a symmetric matrix, given to the unsymmetric factor.
  const auto umfpack = make_symmetric_factor(DirectSolver::umfpack, false, 1, MPI_COMM_WORLD);
  SymmetricFactor &factor = *umfpack;
  problems::factorize(factor, problems::small_indefinite());
  const std::vector<double> x = problems::solve(factor, {-1, 8, -6});
  check::absolute("small indefinite, first", x[0], 1, 1e-14);
  check::absolute("small indefinite, second", x[1], 2, 1e-14);
  check::absolute("small indefinite, third", x[2], 3, 1e-14);

  check::absolute("saddle point",
                  problems::relative_residual(factor, problems::saddle_point(24, 1e3, 1e-3, false)),
                  0, 1e-10);
  const SymmetricTriplets incompressible = problems::saddle_point(24, 1e3, 0, false);
  check::absolute("refactored, incompressible", problems::relative_residual(factor, incompressible),
                  0, 1e-10);
  const std::vector<double> b =
      problems::multiply(incompressible, problems::manufactured(incompressible.n));
  check::is_true("repeated solves are bit-equal",
                 problems::solve(factor, b) == problems::solve(factor, b));
  check::is_true("memory", factor.memory() > 8 * factor.n_entries());

  check::throws<RunError>(
      "singular", [&]() { problems::factorize(factor, problems::rank_one()); },
      "UMFPACK.*singular");
  check::throws<std::invalid_argument>(
      "an index without owner",
      [&]() {
        factor.factorize(problems::small_indefinite(), {0, 1});
      },
      "owns every index");
  check::equal("name", factor.name(), "UMFPACK, L U");
}
} // namespace test_of_umfpack_factor
