// Known transforms, there and back for even, odd and prime numbers of samples.

#include "../unit_test.h"

#include <continua/signal/fourier_transform.h>

#include <stdexcept>

namespace test_of_fourier_transform
{
using namespace Continua;

UNIT_TEST(fourier_transform)
{
  // A cosine of 3 periods with phase 0.4, amplitude 2, on a constant 5: X_3 = n e^(0.4 i).
  for (const std::size_t n : {16u, 15u, 13u})
  {
    const std::string name = std::to_string(n) + " samples: ";
    std::vector<double> samples(n);
    for (std::size_t j = 0; j < n; ++j)
      samples[j] = 5. + 2. * std::cos(2. * M_PI * 3. * j / n + 0.4);
    const auto spectrum = fourier_transform(samples);
    check::is_true(name + "size", spectrum.size() == n / 2 + 1);
    double others = 0.;
    for (std::size_t k = 1; k < spectrum.size(); ++k)
      if (k != 3)
        others = std::max(others, std::abs(spectrum[k]));
    check::absolute(name + "mean", std::abs(spectrum[0] - 5. * n), 0., 1e-12);
    check::absolute(name + "cosine", std::abs(spectrum[3] - std::polar(1. * n, 0.4)), 0., 1e-12);
    check::absolute(name + "nothing else", others, 0., 1e-12);
    const auto back = inverse_fourier_transform(spectrum, n);
    double error = 0.;
    for (std::size_t j = 0; j < n; ++j)
      error = std::max(error, std::abs(back[j] - samples[j]));
    check::absolute(name + "and back", error, 0., 1e-13);
  }
  // The alternating sequence is the highest frequency of an even number of samples.
  const auto highest = fourier_transform({1., -1., 1., -1.});
  check::absolute("highest frequency", std::abs(highest[2] - 4.), 0., 1e-15);
  check::absolute("one sample", std::abs(fourier_transform({3.})[0] - 3.), 0., 0.);
  check::is_true("power of two", next_power_of_two(1) == 1 && next_power_of_two(5) == 8 &&
                                     next_power_of_two(64) == 64);
  check::throws<std::invalid_argument>(
      "no sample", [] { fourier_transform({}); }, "no sample");
  check::throws<std::invalid_argument>(
      "size of a spectrum",
      [] {
        inverse_fourier_transform({1., 2.}, 4);
      },
      "n/2");
}
} // namespace test_of_fourier_transform
