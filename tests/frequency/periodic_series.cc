// Poisson's kernel, a sum of harmonics in closed form, and its derivative.

#include "../unit_test.h"

#include <continua/frequency/periodic_series.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace test_of_periodic_series
{
using namespace Continua;
using Complex = std::complex<double>;

namespace
{
constexpr double ratio = 0.7, period = 0.8;

/// 1 + 2 sum of ratio^n cos(n phase).
double kernel(const double time)
{
  return (1. - ratio * ratio) /
         (1. - 2. * ratio * std::cos(2. * M_PI * time / period) + ratio * ratio);
}

Complex amplitude(const unsigned int n)
{
  return n == 0 ? 1. : 2. * std::pow(ratio, n);
}
} // namespace

UNIT_TEST(periodic_series)
{
  unsigned int n_asked = 0;
  const PeriodicSeries series(
      period,
      [&](const unsigned int n)
      {
        ++n_asked;
        return std::vector<Complex>{amplitude(n), Complex(3.) * (n == 0 ? 1. : 0.)};
      });
  check::is_true("each harmonic is asked for once", n_asked == series.n_harmonics() + 1);
  check::is_true("has converged", series.has_converged());
  const double range = kernel(0.) - kernel(0.5 * period);
  double largest = 0.;
  for (unsigned int j = 0; j < 100; ++j)
    largest = std::max(largest, std::abs(series.value(0, 0.008 * j) - kernel(0.008 * j)));
  check::absolute("values", largest / range, 0., 1e-3);
  // What the last third of N harmonics adds, 2 (ratio^(2N/3 + 1) + ... + ratio^N), is a thousandth.
  const auto last_third = [&](const unsigned int n)
  {
    double sum = 0.;
    for (unsigned int k = n - n / 3 + 1; k <= n; ++k)
      sum += 2. * std::pow(ratio, k);
    return sum / range;
  };
  check::relative("change", series.changes()[0], last_third(series.n_harmonics()), 1e-3);
  check::is_true("no fewer would do", last_third(series.n_harmonics()) <= 1e-3 &&
                                          last_third(series.n_harmonics() - 1) > 1e-3);
  check::absolute("a constant", series.value(1, 0.3), 3., 1e-14);
  check::absolute("a constant does not change", series.changes()[1], 0., 0.);

  // The rate asks for more harmonics than its integral.
  const PeriodicSeries rate(
      period, [](const unsigned int n)
      { return std::vector<Complex>{amplitude(n) * Complex(0., 2. * M_PI * n / period)}; });
  check::is_true("a rate", rate.has_converged() && rate.n_harmonics() > series.n_harmonics() + 5);
  const double t = 0.1, h = 1e-4;
  check::absolute("its value", rate.value(0, t), (kernel(t + h) - kernel(t - h)) / (2. * h),
                  1e-3 * 2. * M_PI / period * range);

  // Only what counts.
  PeriodicSeriesOptions first_counts;
  first_counts.is_compared = {true, false};
  const PeriodicSeries both(
      period,
      [](const unsigned int n) {
        return std::vector<Complex>{amplitude(n),
                                    amplitude(n) * Complex(0., 2. * M_PI * n / period)};
      },
      first_counts);
  check::is_true("the rate does not count",
                 both.n_harmonics() == series.n_harmonics() && both.changes()[1] > 1e-3);

  // A second group of harmonics behind a gap, as of straight lines between the rows of a table: the
  // last third says nothing of it, the load does.
  const auto gap = [](const unsigned int n) {
    return std::vector<Complex>{n <= 3 ? 1. : n >= 40 && n <= 42 ? 0.1 : 1e-9};
  };
  PeriodicSeriesOptions known_load;
  for (unsigned int n = 0; n < 100; ++n)
    known_load.load.push_back(std::abs(gap(n)[0]));
  check::is_true("a gap without the load", PeriodicSeries(period, gap).n_harmonics() < 40);
  const PeriodicSeries over_gap(period, gap, known_load);
  check::is_true("a gap with the load", over_gap.has_converged() && over_gap.n_harmonics() >= 42);

  PeriodicSeriesOptions few;
  few.most_harmonics = 10;
  const PeriodicSeries cut(
      period, [](const unsigned int n) { return std::vector<Complex>{amplitude(n)}; }, few);
  check::is_true("too few harmonics", !cut.has_converged() && cut.n_harmonics() == 10);
  check::throws<std::invalid_argument>(
      "quantities of the harmonics",
      [] { PeriodicSeries(1., [](const unsigned int n) { return std::vector<Complex>(n + 1); }); },
      "same quantities");
  check::throws<std::invalid_argument>(
      "no period", [] { PeriodicSeries(0., [](unsigned int) { return std::vector<Complex>(1); }); },
      "period");
}
} // namespace test_of_periodic_series
