#include <continua/theory/amplification.h>

#include <continua/signal/gsl_release.h>
#include <continua/signal/linear_recurrence.h>

#include <gsl/gsl_eigen.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace Continua
{
namespace
{
using GslMatrix = std::unique_ptr<gsl_matrix, GslRelease<gsl_matrix, gsl_matrix_free>>;
using Vector =
    std::unique_ptr<gsl_vector_complex, GslRelease<gsl_vector_complex, gsl_vector_complex_free>>;
using Workspace = std::unique_ptr<gsl_eigen_nonsymm_workspace,
                                  GslRelease<gsl_eigen_nonsymm_workspace, gsl_eigen_nonsymm_free>>;

/// A linear function of the state: U and omega D at the start of the step, and one step before.
using Row = std::array<double, 4>;

Row combination(const double a, const Row &x, const double b, const Row &y)
{
  Row result;
  for (unsigned int i = 0; i < 4; ++i)
    result[i] = a * x[i] + b * y[i];
  return result;
}

std::vector<Complex> eigenvalues_of(const std::array<Row, 4> &rows)
{
  const GslMatrix matrix(gsl_matrix_alloc(4, 4));
  const Vector values(gsl_vector_complex_alloc(4));
  const Workspace workspace(gsl_eigen_nonsymm_alloc(4));
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int j = 0; j < 4; ++j)
      gsl_matrix_set(matrix.get(), i, j, rows[i][j]);
  gsl_eigen_nonsymm(matrix.get(), values.get(), workspace.get());
  std::vector<Complex> result;
  for (unsigned int i = 0; i < 4; ++i)
  {
    const gsl_complex value = gsl_vector_complex_get(values.get(), i);
    result.emplace_back(GSL_REAL(value), GSL_IMAG(value));
  }
  std::sort(result.begin(), result.end(),
            [](const Complex a, const Complex b) { return std::abs(a) > std::abs(b); });
  return result;
}
} // namespace

Amplification::Amplification(const Step &step, const double angular_frequency)
    : duration(step.size()), theta(angular_frequency * step.size())
{
  const Row velocity_old = {{1., 0., 0., 0.}}, displacement_old = {{0., 1., 0., 0.}};
  const BranchCoefficients branch = step.branch(std::numeric_limits<double>::infinity());
  // omega D of the balanced level: omega `velocity` U and a known part; a0 U + a1 U_old + a2
  // U_older = -omega (omega D) then gives U. D is scaled with omega, so that the exact map is a
  // rotation and its eigenvalues are well conditioned.
  const double omega = angular_frequency;
  const Row known = {{omega * branch.velocity_old, branch.old, 0., branch.older}};
  const Row inertia = {{step.a1, 0., step.a2, 0.}};
  Row velocity = combination(-omega, known, -1., inertia);
  const double divisor = step.a0 + omega * omega * branch.velocity;
  for (double &entry : velocity)
    entry /= divisor;
  Row displacement = combination(omega * branch.velocity, velocity, 1., known);
  if (step.extrapolate)
  {
    velocity = combination(2., velocity, -1., velocity_old);
    displacement = combination(2., displacement, -1., displacement_old);
  }
  eigenvalues = eigenvalues_of({{velocity, displacement, velocity_old, displacement_old}});
}

Amplification::Amplification(const double duration,
                             const double theta,
                             std::vector<Complex> eigenvalues)
    : duration(duration), theta(theta), eigenvalues(std::move(eigenvalues))
{
}

Amplification Amplification::of_displacement_form(const double size,
                                                  const bool four_levels,
                                                  const double angular_frequency)
{
  const double theta = angular_frequency * size;
  // The difference plus theta^2 D at the new level, the oldest level first.
  const std::vector<double> polynomial = four_levels
                                             ? std::vector<double>{-1., 4., -5., 2. + theta * theta}
                                             : std::vector<double>{1., -2., 1. + theta * theta};
  return Amplification(size, theta, polynomial_roots(polynomial));
}

Complex Amplification::of_wave() const
{
  // Round-off gives a double real root imaginary parts.
  const double least = 1e-7 * spectral_radius();
  const auto wave = std::find_if(eigenvalues.begin(), eigenvalues.end(),
                                 [least](const Complex value) { return value.imag() > least; });
  return wave == eigenvalues.end() ? eigenvalues.front() : *wave;
}

bool Amplification::rings() const
{
  const Complex last = eigenvalues.front();
  return last.real() < 0. && std::abs(last.imag()) <= 1e-7 * std::abs(last);
}

Complex Amplification::principal() const
{
  const Complex exact = std::polar(1., theta);
  return *std::min_element(eigenvalues.begin(), eigenvalues.end(),
                           [&exact](const Complex a, const Complex b)
                           { return std::abs(a - exact) < std::abs(b - exact); });
}

double Amplification::remaining(const double time) const
{
  return std::pow(std::abs(principal()), time / duration);
}

double Amplification::frequency_error() const
{
  return std::arg(principal()) / theta - 1.;
}
} // namespace Continua
