// A correction by GMRES: the solution of a small system, whatever the units of its rows; one
// iteration with the factor of the system itself; a tolerance and a largest number of iterations.

#include <continua/linear_algebra/krylov_correction.h>

#include "../unit_test.h"

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace test_of_krylov_correction
{
using namespace Continua;
using namespace dealii;

namespace
{
constexpr unsigned int n_velocity = 4, n_pressure = 2, n = n_velocity + n_pressure;

/// A saddle point, its rows of momentum times a factor; `skewness` makes it unsymmetric.
FullMatrix<double> make_matrix(const double momentum_unit, const double skewness)
{
  FullMatrix<double> matrix(n, n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
    {
      const bool i_is_pressure = i >= n_velocity, j_is_pressure = j >= n_velocity;
      double entry = std::sin(1. + 3. * std::min(i, j) + std::max(i, j));
      if (i_is_pressure && j_is_pressure)
        entry = i == j ? -0.1 : 0.;
      else if (!i_is_pressure && !j_is_pressure)
        entry = (i == j ? 5. : 0.3 * entry) + skewness * std::cos(2. * i - 5. * j);
      matrix(i, j) = (i_is_pressure ? 1. : momentum_unit) * entry;
    }
  return matrix;
}

struct System
{
  FullMatrix<double> derivative, inverse;
  DistributedVector momentum{complete_index_set(n_velocity), MPI_COMM_SELF},
      mass{complete_index_set(n_pressure), MPI_COMM_SELF}, velocity{momentum}, pressure{mass};
  Vector<double> exact;

  System(const double momentum_unit, const double skewness, const double skewness_of_factor)
      : derivative(make_matrix(momentum_unit, skewness)), inverse(n, n), exact(n)
  {
    inverse.invert(make_matrix(momentum_unit, skewness_of_factor));
    Vector<double> rows(n);
    for (unsigned int i = 0; i < n; ++i)
      exact[i] = 1. + 0.5 * i;
    derivative.vmult(rows, exact);
    put(rows, momentum, mass);
  }

  static Vector<double> joined(const DistributedVector &first, const DistributedVector &second)
  {
    Vector<double> result(n);
    std::copy(second.begin(), second.end(), std::copy(first.begin(), first.end(), result.begin()));
    return result;
  }
  static void put(const Vector<double> &values, DistributedVector &first, DistributedVector &second)
  {
    std::copy(values.begin(), values.begin() + n_velocity, first.begin());
    std::copy(values.begin() + n_velocity, values.end(), second.begin());
  }
  /// Solves, and returns the number of iterations.
  unsigned int
  solve(const double momentum_scale, const double tolerance, const unsigned int maximum)
  {
    KrylovCorrection krylov;
    krylov.reinit(velocity, pressure);
    const auto multiply = [](const FullMatrix<double> &matrix, const DistributedVector &a,
                             const DistributedVector &b, DistributedVector &x, DistributedVector &y)
    {
      Vector<double> result(n);
      matrix.vmult(result, joined(a, b));
      put(result, x, y);
    };
    return krylov.solve(
        [&](const DistributedVector &u, const DistributedVector &p, DistributedVector &f,
            DistributedVector &g) { multiply(derivative, u, p, f, g); },
        [&](DistributedVector &f, DistributedVector &g, DistributedVector &u, DistributedVector &p)
        { multiply(inverse, f, g, u, p); },
        {momentum, mass, momentum_scale, 1.}, tolerance, maximum, velocity, pressure);
  }
  double error() const
  {
    Vector<double> difference = joined(velocity, pressure);
    difference -= exact;
    return difference.linfty_norm() / exact.linfty_norm();
  }
};
} // namespace

UNIT_TEST(krylov_correction)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  {
    System system(1., 0.6, 0.6);
    check::is_true("its own factor: one iteration", system.solve(1., 1e-10, 20) == 1);
    check::absolute("its own factor: solution", system.error(), 0., 1e-12);
  }
  System unscaled(1., 0.6, 0.);
  const unsigned int n_iterations = unscaled.solve(1., 1e-10, 20);
  check::absolute("another factor: solution", unscaled.error(), 0., 1e-8);
  check::is_true("another factor: several iterations",
                 n_iterations > 1 && n_iterations <= n_velocity + 1);

  // Momentum in 1e-9 of its unit: with its scale nothing changes. Without it GMRES would see the
  // rows of volume alone.
  System scaled(1e9, 0.6, 0.);
  check::is_true("other units: as many iterations", scaled.solve(1e9, 1e-10, 20) == n_iterations);
  check::absolute("other units: solution", scaled.error(), 0., 1e-8);
  System ill_scaled(1e9, 0.6, 0.);
  ill_scaled.solve(1e18, 1e-3, 20);
  check::is_true("a wrong scale loses momentum", ill_scaled.error() > 1e-3);

  System rough(1., 0.6, 0.);
  const unsigned int n_rough = rough.solve(1., 0.3, 20);
  check::is_true("a rough tolerance ends earlier", n_rough >= 1 && n_rough < n_iterations);
  System cut(1., 0.6, 0.);
  check::is_true("largest number of iterations", cut.solve(1., 1e-10, 2) == 2);
  check::is_true("what two of them have reached", cut.error() > 1e-8 && cut.error() < 1.);
}
} // namespace test_of_krylov_correction
