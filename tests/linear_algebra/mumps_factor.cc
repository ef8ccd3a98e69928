#include "../unit_test.h"
#include "symmetric_problems.h"

#include <continua/base/input_error.h>
#include <continua/linear_algebra/mumps_factor.h>

#include <deal.II/base/mpi.h>

namespace test_of_mumps_factor
{
UNIT_TEST(mumps_factor)
{
  using namespace Continua;
  namespace problems = symmetric_problems;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (problems::rank() > 0)
    std::cout.setstate(std::ios::failbit); // rank 0 alone prints

  MumpsFactor factor(false, MPI_COMM_WORLD);
  problems::factorize(factor, problems::small_indefinite());
  const std::vector<double> x = problems::solve(factor, {-1, 8, -6});
  check::absolute("small indefinite, first", x[0], 1, 1e-14);
  check::absolute("small indefinite, second", x[1], 2, 1e-14);
  check::absolute("small indefinite, third", x[2], 3, 1e-14);

  // [0 1; 1 0] has no factor without pivoting.
  problems::factorize(factor, {2, {0, 1, 1}, {0, 0, 1}, {0, 1, 0}});
  const std::vector<double> swapped = problems::solve(factor, {7, 5});
  check::absolute("zero diagonal, first", swapped[0], 5, 0);
  check::absolute("zero diagonal, second", swapped[1], 7, 0);

  const SymmetricTriplets incompressible = problems::saddle_point(24, 1e3, 0, false);
  check::absolute("refactored, incompressible", problems::relative_residual(factor, incompressible),
                  0, 1e-10);
  const std::vector<double> b =
      problems::multiply(incompressible, problems::manufactured(incompressible.n));
  const std::vector<double> first = problems::solve(factor, b);
  // On several ranks the order in which messages arrive decides about the last bits, so that the
  // solutions agree as far as the matrix' condition lets them: they have the same right-hand side.
  const double tolerance = problems::n_ranks() == 1 ? 0 : 1e-12 * problems::norm(b);
  const auto change = [&](SymmetricFactor &other)
  {
    const std::vector<double> x = problems::solve(other, b);
    return problems::norm(problems::multiply(incompressible, problems::difference(x, first)));
  };
  check::absolute("repeated solves agree", change(factor), 0, tolerance);
  MumpsFactor again(false, MPI_COMM_WORLD);
  problems::factorize(again, incompressible);
  check::absolute("a second factor agrees", change(again), 0, tolerance);
  check::is_true("memory", factor.memory() > 8 * factor.n_entries());

  MumpsFactor quasi_definite(true, MPI_COMM_WORLD);
  check::absolute(
      "saddle point",
      problems::relative_residual(quasi_definite, problems::saddle_point(24, 1e3, 1e-3, false)), 0,
      1e-10);

  for (const double shift : {0., 0.1234, 1.234, 5.678})
  {
    MumpsFactor counting(false, MPI_COMM_WORLD);
    counting.counts_pivots = true;
    problems::factorize(counting, problems::five_points(20, shift));
    check::equal("negative pivots, shift " + std::to_string(shift),
                 std::to_string(counting.n_negative_pivots()),
                 std::to_string(problems::n_negative_of_five_points(20, shift)));
  }
  check::throws<std::logic_error>(
      "pivots that are not counted", [&]() { factor.n_negative_pivots(); }, "counts_pivots");

  check::throws<RunError>(
      "singular", [&]() { problems::factorize(factor, problems::rank_one()); }, "MUMPS.*singular");
  check::throws<RunError>(
      "singular but for rounding",
      [&]() { problems::factorize(factor, problems::laplacian(20, 0.)); }, "MUMPS.*singular");
  check::throws<RunError>(
      "closed box, incompressible",
      [&]() { problems::factorize(factor, problems::saddle_point(24, 1e3, 0, true)); },
      "MUMPS.*singular");
  check::absolute("nearly singular",
                  problems::relative_residual(factor, problems::laplacian(20, 1e-9)), 0, 1e-10);

  check::throws<std::invalid_argument>(
      "an index without owner",
      [&]() { factor.factorize(problems::strewn(problems::small_indefinite()), {}); },
      "owned by one rank");
  check::equal("made by name",
               make_symmetric_factor(DirectSolver::mumps, true, 1, MPI_COMM_WORLD)->name(),
               "MUMPS, L D L^T without pivoting");
}
} // namespace test_of_mumps_factor
