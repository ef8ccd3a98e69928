// Several complex symmetric matrices with one analysis: solutions of several right-hand sides, and
// determinants.

#include "../unit_test.h"

#include <continua/linear_algebra/mumps_solver.h>
#include <continua/linear_algebra/singular_matrix.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <complex>

namespace test_of_mumps_solver
{
UNIT_TEST(mumps_solver)
{
  using namespace Continua;
  using Complex = std::complex<double>;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Complex i(0., 1.);

  MumpsSolver<Complex> solver(MumpsSymmetry::symmetric, MumpsScaling::of_mumps, MPI_COMM_SELF);
  solver.computes_determinant = true;
  // [a b 0; b 0 c; 0 c d], whose (1, 0) is given in two parts.
  const FactorEstimate estimate = solver.keep_pattern(3, {0, 1, 1, 2, 2}, {0, 0, 0, 1, 2});
  check::is_true("estimate", estimate.n_entries >= 5.);
  for (const Complex scale : {Complex(1.), Complex(0.3, -1e6)})
  {
    const Complex a = 2. * scale, b = i * scale, c = (1. + 3. * i) * scale, d = (4. - i) * scale;
    std::vector<Complex> values = {a, 0.25 * b, 0.75 * b, c, d};
    solver.factorize_values(values);
    const std::vector<Complex> x = {1., 2. - i, -3. * i};
    std::vector<Complex> columns;
    for (const Complex factor : {Complex(1.), i})
      for (const Complex row : {a * x[0] + b * x[1], b * x[0] + c * x[2], c * x[1] + d * x[2]})
        columns.push_back(factor * row);
    solver.solve_columns(columns, 2);
    double error = 0.;
    for (unsigned int k = 0; k < 3; ++k)
      error = std::max({error, std::abs(columns[k] - x[k]), std::abs(columns[3 + k] - i * x[k])});
    check::absolute("two right-hand sides", error, 0., 1e-14);
    const Complex determinant = -a * c * c - b * b * d;
    check::absolute("determinant",
                    std::abs(std::exp(solver.log_determinant()) / determinant - 1.), 0., 1e-13);
  }
  std::vector<Complex> singular = {1., 0., 0., 0., 1.};
  check::throws<SingularMatrix>(
      "singular", [&] { solver.factorize_values(singular); }, "the matrix is singular");
}
} // namespace test_of_mumps_solver
