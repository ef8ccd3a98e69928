// Pulses of a damped oscillator and of a power law beside their closed forms.

#include "../unit_test.h"

#include <continua/frequency/damped_contour.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace test_of_damped_contour
{
using namespace Continua;
using Complex = std::complex<double>;

namespace
{
constexpr double knot = 0.1;
constexpr unsigned int degree = 7;

/// Of each knot of the spline with degree + 2 knots, (t - t_k)_+^degree/knot^degree, the response
/// `of_power` at t - t_k. Its terms cancel, hence the longer numbers.
double spline(const double t, const std::function<long double(long double)> &of_power)
{
  long double sum = 0., factor = 1.;
  for (unsigned int k = 0; k <= degree + 1; ++k)
  {
    if (t > k * knot)
      sum += factor * of_power(t - k * static_cast<long double>(knot));
    factor *= -(degree + 1. - k) / (k + 1.);
  }
  return sum;
}

/// A power law s^-order makes of t^m: m! t^(m + order)/Gamma(m + 1 + order).
std::function<double(double)> of_power_law(const double order)
{
  return [order](const double t)
  {
    return spline(t,
                  [order](const long double part)
                  {
                    return std::tgamma(degree + 1.L) / std::tgamma(degree + 1.L + order) *
                           std::pow(part, degree + static_cast<long double>(order)) /
                           std::pow(static_cast<long double>(knot), degree);
                  });
  };
}

double load(const double t)
{
  return of_power_law(0.)(t);
}

/// The largest difference of a response from the exact one, up to 2 s.
double error_of(const DampedContour &contour,
                const std::function<Complex(Complex)> &transfer,
                const std::function<double(double)> &exact)
{
  std::vector<double> samples;
  for (const double t : contour.times())
    samples.push_back(load(t));
  std::vector<Complex> response = contour.transform(samples);
  for (std::size_t k = 0; k < response.size(); ++k)
    response[k] *= transfer(contour.points()[k]);
  const std::vector<double> history = contour.history(response);
  double largest = 0.;
  for (std::size_t j = 0; j < history.size() && contour.times()[j] < 2.; ++j)
    largest = std::max(largest, std::abs(history[j] - exact(contour.times()[j])));
  return largest;
}
} // namespace

UNIT_TEST(damped_contour)
{
  const DampedContour contour(2., 512);
  check::relative("damping", contour.damping(), std::log(1e8) / (2. * 2.), 1e-14);
  check::absolute("last time", contour.times().back(), 2. - 2. / 512., 1e-14);
  check::absolute("a point", std::abs(contour.points()[3] - Complex(contour.damping(), 3. * M_PI)),
                  0., 1e-12);
  const double largest = load(0.5 * (degree + 1) * knot);
  check::absolute("nothing but the load",
                  error_of(
                      contour, [](Complex) { return 1.; }, load) /
                      largest,
                  0., 1e-11);

  // Relaxation: at real frequencies its tail comes back, here by e^(-a T) of it.
  const auto relaxation = [](const Complex s) { return s == 0. ? 0. : std::pow(s, 0.4); };
  const double of_relaxation = error_of(contour, relaxation, of_power_law(-0.4)) / largest;
  const double at_real_frequencies =
      error_of(DampedContour(2., 512, 1.), relaxation, of_power_law(-0.4)) / largest;
  check::absolute("relaxation", of_relaxation, 0., 1e-5);
  check::absolute("over that at real frequencies", of_relaxation / at_real_frequencies, 5e-5, 5e-5);
  check::absolute("twice the duration, the same damping",
                  error_of(DampedContour(4., 1024, 1e8), relaxation, of_power_law(-0.4)) / largest,
                  0., 1e-8);

  // Creep goes on for ever, and has no response at real frequencies (infinite at zero).
  const auto creep = [](const Complex s) { return std::pow(s, -0.4); };
  const auto crept = of_power_law(0.4);
  check::absolute("creep", error_of(contour, creep, crept) / crept(0.5), 0., 1e-4);
  check::absolute("creep in twice the duration",
                  error_of(DampedContour(4., 1024, 1e8), creep, crept) / crept(0.5), 0., 1e-7);

  // An oscillator whose vibration is there at the end. Its response to an impulse is omega
  // e^(-damping t) sin(omega t) = Im(omega e^(-p t)); of t^m/m! an exponential makes
  // (-1/p)^(m + 1) (e^(-p t) - sum of (-p t)^k/k! to k = m).
  const double omega = 2. * M_PI * 3., damping = 0.4;
  const auto oscillator = [&](const Complex s)
  { return omega * omega / ((s + damping) * (s + damping) + omega * omega); };
  const auto vibration = [&](const double t)
  {
    using Long = std::complex<long double>;
    const Long p(damping, -omega);
    return spline(t,
                  [&](const long double part)
                  {
                    Long sum = std::exp(-p * part), term = 1.;
                    for (unsigned int k = 0; k <= degree; ++k)
                    {
                      sum -= term;
                      term *= -p * part / (k + 1.L);
                    }
                    const Long factor = std::pow(Long(-1.) / (p * Long(knot)), degree) / -p;
                    return std::tgamma(degree + 1.L) * omega * (factor * sum).imag();
                  });
  };
  check::absolute("oscillator",
                  error_of(DampedContour(2., 512, 1e6), oscillator, vibration) / largest, 0., 1e-6);
  const double coarse = error_of(DampedContour(2., 64, 1e6), oscillator, vibration),
               fine = error_of(DampedContour(2., 128, 1e6), oscillator, vibration);
  check::is_true("more samples", fine < coarse / 50.);

  check::throws<std::invalid_argument>(
      "no duration", [] { DampedContour(0., 8); }, "duration");
  check::throws<std::invalid_argument>(
      "samples", [&] { contour.transform({1.}); }, "each time");
  check::throws<std::invalid_argument>(
      "values", [&] { contour.history({1.}); }, "each point");
}
} // namespace test_of_damped_contour
