// GMRES and FGMRES: the solution of a small system, whatever the units of its rows; one iteration
// with the factor of the system itself; a tolerance and a largest number of iterations; a first
// guess; no right-hand side. (In Debug deal.II refuses what is no number.)

#include <continua/linear_algebra/block_krylov.h>

#include "../unit_test.h"

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace test_of_block_krylov
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
  /// Multiplies with the matrix.
  void multiply(const DistributedVector &u,
                const DistributedVector &p,
                DistributedVector &f,
                DistributedVector &g)
  {
    Vector<double> result(n);
    derivative.vmult(result, joined(u, p));
    put(result, f, g);
  }
  /// Solves, momentum measured in the unit; starts from `velocity` and `pressure` if that is
  /// better.
  KrylovReport solve(const BlockKrylov::Method method,
                     const double momentum_unit,
                     const double tolerance,
                     const unsigned int maximum)
  {
    BlockKrylov krylov(method, maximum + 1);
    krylov.reinit(velocity, pressure);
    krylov.scale.block(0) = 1. / momentum_unit;
    krylov.scale.block(1) = 1.;
    krylov.set_right_hand_side(momentum, mass);
    const auto product = [&](const DistributedVector &u, const DistributedVector &p,
                             DistributedVector &f, DistributedVector &g) { multiply(u, p, f, g); };
    const auto apply_inverse =
        [&](DistributedVector &f, DistributedVector &g, DistributedVector &u, DistributedVector &p)
    {
      f *= momentum_unit;
      Vector<double> result(n);
      inverse.vmult(result, joined(f, g));
      put(result, u, p);
    };
    guess_is_taken = krylov.take_guess(product, velocity, pressure);
    return krylov.solve(product, apply_inverse, krylov.scaled_right_hand_side().l2_norm(),
                        tolerance, maximum, velocity, pressure);
  }
  double error() const
  {
    Vector<double> difference = joined(velocity, pressure);
    difference -= exact;
    return difference.linfty_norm() / exact.linfty_norm();
  }

  bool guess_is_taken = false;
};

void check_method(const std::string &name, const BlockKrylov::Method method)
{
  {
    System system(1., 0.6, 0.6);
    check::is_true(name + ": its own factor: one iteration",
                   system.solve(method, 1., 1e-10, 20).iterations == 1);
    check::absolute(name + ": its own factor: solution", system.error(), 0., 1e-12);
  }
  System unscaled(1., 0.6, 0.);
  const KrylovReport report = unscaled.solve(method, 1., 1e-10, 20);
  check::absolute(name + ": another factor: solution", unscaled.error(), 0., 1e-8);
  check::is_true(name + ": another factor: several iterations",
                 report.converged && report.residual < 1e-10 && report.iterations > 1 &&
                     report.iterations <= n_velocity + 1);

  // Momentum in 1e-9 of its unit: with its scale nothing changes. Without it the rows of volume
  // alone would count.
  System scaled(1e9, 0.6, 0.);
  check::is_true(name + ": other units: as many iterations",
                 scaled.solve(method, 1e9, 1e-10, 20).iterations == report.iterations);
  check::absolute(name + ": other units: solution", scaled.error(), 0., 1e-8);
  System ill_scaled(1e9, 0.6, 0.);
  ill_scaled.solve(method, 1e18, 1e-3, 20);
  check::is_true(name + ": a wrong scale loses momentum", ill_scaled.error() > 1e-3);

  System rough(1., 0.6, 0.);
  const KrylovReport of_rough = rough.solve(method, 1., 0.3, 20);
  check::is_true(name + ": a rough tolerance ends earlier",
                 of_rough.iterations >= 1 && of_rough.iterations < report.iterations);
  System cut(1., 0.6, 0.);
  const KrylovReport of_cut = cut.solve(method, 1., 1e-10, 2);
  check::is_true(name + ": largest number of iterations",
                 of_cut.iterations == 2 && !of_cut.converged && of_cut.residual > 1e-10);
  check::is_true(name + ": what two of them have reached", cut.error() > 1e-8 && cut.error() < 1.);

  check::is_true(name + ": zero is no better guess", !cut.guess_is_taken);
  check::is_true(name + ": a guess that is near", cut.solve(method, 1., 1e-10, 20).converged &&
                                                      cut.guess_is_taken && cut.error() < 1e-8);
  cut.velocity *= -10.;
  check::is_true(name + ": a guess that is far",
                 cut.solve(method, 1., 1e-10, 20).iterations == report.iterations &&
                     !cut.guess_is_taken && cut.error() < 1e-8);

  System nothing(1., 0.6, 0.);
  nothing.momentum = 0.;
  nothing.mass = 0.;
  nothing.velocity = 1.;
  check::is_true(name + ": no right-hand side",
                 nothing.solve(method, 1., 1e-10, 20).iterations == 0 &&
                     nothing.velocity.linfty_norm() == 0. && nothing.pressure.linfty_norm() == 0.);
}
} // namespace

UNIT_TEST(block_krylov)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_method("GMRES", BlockKrylov::Method::gmres);
  check_method("FGMRES", BlockKrylov::Method::fgmres);
}
} // namespace test_of_block_krylov
