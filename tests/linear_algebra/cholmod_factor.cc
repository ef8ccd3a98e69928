#include "../unit_test.h"
#include "symmetric_problems.h"

#include <continua/base/input_error.h>
#include <continua/linear_algebra/cholmod_factor.h>

#include <deal.II/base/mpi.h>

namespace test_of_cholmod_factor
{
UNIT_TEST(cholmod_factor)
{
  using namespace Continua;
  namespace problems = symmetric_problems;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  CholmodFactor factor;
  problems::factorize(factor, problems::small_indefinite());
  const std::vector<double> x = problems::solve(factor, {-1, 8, -6});
  check::absolute("small indefinite, first", x[0], 1, 1e-14);
  check::absolute("small indefinite, second", x[1], 2, 1e-14);
  check::absolute("small indefinite, third", x[2], 3, 1e-14);
  // Three pivots, and below them the entries (2, 0) and (2, 1): index 2 is eliminated last.
  check::absolute("small indefinite, entries", factor.n_entries(), 5, 0);

  const SymmetricTriplets saddle = problems::saddle_point(24, 1e3, 1e-3, false);
  check::absolute("refactored, saddle point", problems::relative_residual(factor, saddle), 0,
                  1e-10);
  const std::vector<double> b = problems::multiply(saddle, problems::manufactured(saddle.n));
  check::is_true("repeated solves are bit-equal",
                 problems::solve(factor, b) == problems::solve(factor, b));
  const std::vector<double> first = problems::solve(factor, b);
  CholmodFactor again;
  problems::factorize(again, saddle);
  check::is_true("a second factor is bit-equal", problems::solve(again, b) == first);
  check::is_true("memory", factor.memory() > 8 * factor.n_entries());

  // The order of the unknowns is kept for other values at the same places, and not for others.
  CholmodFactor keeping;
  keeping.keeps_analysis = true;
  problems::factorize(keeping, problems::saddle_point(24, 1e2, 1e-3, false));
  problems::factorize(keeping, saddle);
  check::is_true("with a kept analysis bit-equal", problems::solve(keeping, b) == first);
  check::absolute("with a kept analysis, entries", keeping.n_entries(), again.n_entries(), 0);
  check::throws<RunError>(
      "with a kept analysis, singular",
      [&]() { problems::factorize(keeping, problems::laplacian(20, 0.)); }, "CHOLMOD.*singular");
  check::absolute("with a kept analysis, after a singular matrix",
                  problems::relative_residual(keeping, problems::laplacian(20, 1.)), 0, 1e-10);
  problems::factorize(keeping, problems::five_points(20, 0.1234));
  CholmodFactor fresh;
  problems::factorize(fresh, problems::five_points(20, 0.1234));
  check::absolute("with a kept analysis, other places", keeping.n_entries(), fresh.n_entries(), 0);

  for (const double shift : {0., 0.1234, 1.234, 5.678})
  {
    CholmodFactor counting;
    counting.counts_pivots = true;
    problems::factorize(counting, problems::five_points(20, shift));
    check::equal("negative pivots, shift " + std::to_string(shift),
                 std::to_string(counting.n_negative_pivots()),
                 std::to_string(problems::n_negative_of_five_points(20, shift)));
  }
  check::throws<std::logic_error>(
      "pivots that are not counted", [&]() { factor.n_negative_pivots(); }, "counts_pivots");

  check::throws<RunError>(
      "singular", [&]() { problems::factorize(factor, problems::rank_one()); },
      "CHOLMOD.*singular");
  check::throws<RunError>(
      "singular but for rounding",
      [&]() { problems::factorize(factor, problems::laplacian(20, 0.)); }, "CHOLMOD.*singular");
  check::absolute("nearly singular",
                  problems::relative_residual(factor, problems::laplacian(20, 1e-9)), 0, 1e-10);
  SymmetricTriplets broken = problems::small_indefinite();
  broken.values[0] = std::nan("");
  check::throws<RunError>(
      "not a number", [&]() { problems::factorize(factor, broken); }, "not finite");

  check::throws<std::invalid_argument>(
      "upper triangle",
      [&]() {
        factor.factorize({2, {0, 0, 1}, {0, 1, 1}, {1, 1, 1}}, {0, 1});
      },
      "lower triangle");
  check::throws<std::invalid_argument>(
      "an index without owner",
      [&]() {
        factor.factorize(problems::small_indefinite(), {0, 1});
      },
      "owns every index");

  const auto made =
      [](const DirectSolver choice, const bool quasi_definite, const std::size_t n_entries = 1)
  { return make_symmetric_factor(choice, quasi_definite, n_entries, MPI_COMM_WORLD)->name(); };
  check::equal("automatic", made(DirectSolver::automatic, true), "CHOLMOD, simplicial L D L^T");
  check::equal("automatic, large", made(DirectSolver::automatic, true, 2000001),
               "MUMPS, L D L^T without pivoting");
  check::equal("automatic, incompressible", made(DirectSolver::automatic, false),
               "MUMPS, L D L^T with pivoting");
  check::throws<std::invalid_argument>(
      "cholmod, incompressible", [&]() { made(DirectSolver::cholmod, false); }, "compressible");
}
} // namespace test_of_cholmod_factor
