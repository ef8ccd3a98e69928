// Responses with resonances, with sound in a line (infinitely many) and with a power law are known
// between the frequencies after few computations.

#include "../unit_test.h"

#include <continua/frequency/frequency_refinement.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace test_of_frequency_refinement
{
using namespace Continua;
using Complex = std::complex<double>;

namespace
{
/// The largest error between the frequencies, over the largest response there.
double error_of(const FrequencyRefinement &refinement,
                const std::function<Complex(double)> &response,
                const double lowest,
                const double highest)
{
  double largest = 0., scale = 0.;
  for (unsigned int i = 0; i <= 2000; ++i)
  {
    const double frequency = lowest + (highest - lowest) * i / 2000.;
    const Complex exact = response(frequency);
    scale = std::max(scale, std::abs(exact));
    largest = std::max(
        largest,
        std::abs(refinement.approximation().value(0, {0., 2. * M_PI * frequency}) - exact));
  }
  return largest / scale;
}

void compare(const std::string &name,
             const std::function<Complex(double)> &response,
             const double lowest,
             const double highest,
             const bool is_logarithmic,
             const std::size_t most)
{
  std::size_t n_computed = 0;
  FrequencyRefinementOptions options;
  options.tolerance = 1e-4;
  const FrequencyRefinement refinement(
      lowest, highest, is_logarithmic,
      [&](const std::vector<double> &frequencies)
      {
        std::vector<std::vector<Complex>> result;
        for (const double frequency : frequencies)
          result.push_back({response(frequency), 1.});
        n_computed += frequencies.size();
        return result;
      },
      options);
  check::is_true(name + ": has converged",
                 refinement.has_converged() && refinement.difference_at_checks() <= 1e-4);
  check::absolute(name + ": error between the frequencies",
                  error_of(refinement, response, lowest, highest), 0., 1e-4);
  check::is_true(name + ": few frequencies", refinement.frequencies().size() <= most);
  check::is_true(name + ": each is computed once", n_computed == refinement.frequencies().size());
  check::is_true(name + ": they increase",
                 std::is_sorted(refinement.frequencies().begin(), refinement.frequencies().end()));
}
} // namespace

UNIT_TEST(frequency_refinement)
{
  // Three resonances with damping ratios of 1 %: 20 half widths apart.
  compare(
      "resonances",
      [](const double f)
      {
        Complex sum = 0.;
        for (const double f0 : {30., 47., 80.})
          sum += 1. / (f0 * f0 - f * f + Complex(0., 0.02) * f0 * f);
        return sum;
      },
      1., 100., false, 40);
  // Input impedance of a closed line with losses: a pole and a zero every 10 Hz.
  compare(
      "line", [](const double f) { return 1. / std::tanh(Complex(0.1, 2. * M_PI * f / 20.)); }, 2.,
      95., false, 50);
  compare(
      "power law on a logarithmic scale",
      [](const double f)
      {
        const Complex s(0., 2. * M_PI * f);
        return 1. / (s * s / 1e4 + 1. + std::pow(s, 0.3));
      },
      0.01, 100., true, 40);

  // Off the axis a resonance without damping is known, too: its pole is where it is.
  FrequencyRefinementOptions tilted;
  tilted.tilt = 0.05;
  const auto undamped = [](const std::vector<double> &frequencies)
  {
    std::vector<std::vector<Complex>> result;
    for (const double frequency : frequencies)
    {
      const Complex s = 2. * M_PI * frequency * Complex(0.05, 1.);
      result.push_back({1. / (s * s + 900.) + 1. / (s * s + 1600.)});
    }
    return result;
  };
  const FrequencyRefinement without_damping(1., 10., false, undamped, tilted);
  double nearest = 1e300;
  for (const Complex &pole : without_damping.approximation().poles())
    nearest = std::min(nearest, std::abs(pole - Complex(0., 40.)));
  check::is_true("without damping", without_damping.has_converged());
  check::absolute("pole without damping", nearest, 0., 1e-5);

  const auto noise = [](const std::vector<double> &frequencies)
  {
    std::vector<std::vector<Complex>> result;
    for (const double frequency : frequencies)
      result.push_back({std::sin(1e5 * frequency)});
    return result;
  };
  FrequencyRefinementOptions few;
  few.most_frequencies = 30;
  const FrequencyRefinement hopeless(1., 2., false, noise, few);
  check::is_true("noise does not converge",
                 !hopeless.has_converged() && hopeless.difference_at_checks() > 1e-3);
  check::is_true("the most frequencies",
                 hopeless.frequencies().size() >= 30 && hopeless.frequencies().size() <= 32);
  check::throws<std::invalid_argument>(
      "band", [&] { FrequencyRefinement(2., 1., false, noise); }, "band");
  check::throws<std::invalid_argument>(
      "zero on a logarithmic scale", [&] { FrequencyRefinement(0., 1., true, noise); }, "band");
}
} // namespace test_of_frequency_refinement
