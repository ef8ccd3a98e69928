#include "../unit_test.h"
#include "unsymmetric_problems.h"

#include <continua/base/input_error.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace test_of_unsymmetric_factor
{
// What make_unsymmetric_factor gives: every solver on one rank, MUMPS on several.
UNIT_TEST(unsymmetric_factor)
{
  using namespace Continua;
  namespace problems = unsymmetric_problems;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (problems::rank() > 0)
    std::cout.setstate(std::ios::failbit); // rank 0 alone prints
  const bool serial = problems::n_ranks() == 1;

  for (const DirectSolver solver : {DirectSolver::umfpack, DirectSolver::mumps})
  {
    if (solver == DirectSolver::umfpack && !serial)
      continue;
    const std::string choice = word_of(direct_solver_words(), solver);
    const auto factor = make_unsymmetric_factor(solver, MPI_COMM_WORLD);
    problems::factorize(*factor, problems::zero_diagonal());
    const std::vector<double> x = problems::solve(*factor, {4, 6, 14});
    check::absolute(choice + ", zero diagonal, first", x[0], 1, 1e-14);
    check::absolute(choice + ", zero diagonal, second", x[1], 2, 1e-14);
    check::absolute(choice + ", zero diagonal, third", x[2], 3, 1e-14);

    // Sizes that are, and are not, a whole number of the eight rows that are packed together.
    check::absolute(choice + ", 8 x 2 cells",
                    problems::relative_error(*factor, problems::cells(8, 2)), 0, 1e-12);
    check::absolute(choice + ", 5 x 7 cells",
                    problems::relative_error(*factor, problems::cells(5, 7)), 0, 1e-12);
    const Triplets matrix = problems::cells(40, 10);
    check::absolute(choice + ", refactored, 40 x 10 cells",
                    problems::relative_error(*factor, matrix), 0, 1e-12);
    check::is_true(choice + ", memory", factor->memory() > 8 * factor->n_entries());

    // Zeros on the diagonal at symmetric places. Of this liquid UMFPACK's factor has 160,000
    // entries with the symmetric strategy, more than twice what that promises, and 79,000 without
    // it.
    check::absolute(choice + ", liquid", problems::relative_error(*factor, problems::liquid(24)), 0,
                    1e-11);
    if (solver == DirectSolver::umfpack)
      check::is_true(choice + ", liquid, entries", factor->n_entries() < 1.2e5);
    check::absolute(choice + ", without a diagonal",
                    problems::relative_error(*factor, problems::without_diagonal(24)), 0, 1e-9);
    check::absolute(choice + ", without a diagonal, again",
                    problems::relative_error(*factor, problems::without_diagonal(24)), 0, 1e-9);
    // With fewer pressures the symmetric factor is kept: 76,050 entries, 110,000 without it.
    check::absolute(choice + ", few pressures",
                    problems::relative_error(*factor, problems::liquid_with_few_pressures(24)), 0,
                    1e-11);
    if (solver == DirectSolver::umfpack)
      check::is_true(choice + ", few pressures, entries", factor->n_entries() < 9e4);

    // Other values at the same places, with the analysis that is there and without.
    Triplets other = matrix;
    for (std::size_t k = 0; k < other.values.size(); ++k)
      other.values[k] *= 1. + 0.1 * std::sin(static_cast<double>(k));
    check::absolute(choice + ", other values", problems::relative_error(*factor, other), 0, 1e-12);
    const std::vector<double> c = problems::multiply(other, problems::manufactured(other.n));
    const auto fresh = make_unsymmetric_factor(solver, MPI_COMM_WORLD);
    problems::factorize(*fresh, other);
    factor->forget_analysis();
    problems::factorize(*factor, other);
    if (solver == DirectSolver::umfpack)
      check::is_true(choice + ", without the analysis: bit by bit a fresh one",
                     problems::solve(*factor, c) == problems::solve(*fresh, c));
    problems::factorize(*factor, matrix);

    const std::vector<double> b = problems::multiply(matrix, problems::manufactured(matrix.n));
    const std::vector<double> first = problems::solve(*factor, b);
    const auto again = make_unsymmetric_factor(solver, MPI_COMM_WORLD);
    problems::factorize(*again, matrix);
    // On several ranks the order in which messages arrive decides about the last bits.
    const double tolerance = serial ? 0 : 1e-13 * problems::norm(first);
    const auto change = [&](UnsymmetricFactor &other)
    { return problems::norm(problems::difference(problems::solve(other, b), first)); };
    check::absolute(choice + ", repeated solves agree", change(*factor), 0, tolerance);
    check::absolute(choice + ", a second factor agrees", change(*again), 0, tolerance);

    check::throws<RunError>(
        choice + ", singular", [&]() { problems::factorize(*factor, problems::dependent_rows()); },
        "singular");
    check::throws<std::invalid_argument>(
        choice + ", an index without owner",
        [&]() { factor->factorize(problems::strewn(problems::zero_diagonal()), {}); }, "own");
    check::throws<std::invalid_argument>(
        choice + ", outside the matrix",
        [&]() {
          factor->factorize({2, {0}, {2}, {1.}}, {});
        },
        "entry \\(0, 2\\)");
  }

  check::equal("automatic",
               make_unsymmetric_factor(DirectSolver::automatic, MPI_COMM_WORLD)->name(),
               serial ? "UMFPACK, L U" : "MUMPS, L U");
  if (!serial)
    check::throws<std::invalid_argument>(
        "umfpack on several ranks",
        [&]() { make_unsymmetric_factor(DirectSolver::umfpack, MPI_COMM_WORLD); }, "one rank only");
  check::throws<std::invalid_argument>(
      "cholmod", [&]() { make_unsymmetric_factor(DirectSolver::cholmod, MPI_COMM_WORLD); },
      "for symmetric matrices");
}
} // namespace test_of_unsymmetric_factor
