// The frequency below which a part of a signal's energy lies: of a sine its own, of pulses from
// their Fourier integrals.

#include <continua/signal/energy_frequency.h>

#include "../unit_test.h"

#include <functional>

namespace test_of_energy_frequency
{
using namespace Continua;

namespace
{
double of(const std::function<double(double)> &signal, const double end, const double part = 0.9)
{
  const unsigned int n = 1 << 14;
  std::vector<double> samples(n);
  for (unsigned int i = 0; i < n; ++i)
    samples[i] = signal(i * end / n);
  return energy_frequency(samples, end / n, part);
}
} // namespace

UNIT_TEST(energy_frequency)
{
  check::relative("sine",
                  of([](const double t) { return 3. + std::sin(2. * M_PI * 20. * t); }, 20.), 20.,
                  2e-3);
  // exp(-((t - t0)/w)^2) has the energy spectrum of a normal distribution with the standard
  // deviation 1/(2 pi w) in frequency, 90 % of which lies within 1.644853627 of it. Of the mean
  // that is taken away w sqrt(pi)/end is left, with an energy of 0.09 % of the whole.
  const auto gaussian = [](const double t) { return std::exp(-std::pow((t - 2.) / 0.01, 2)); };
  check::relative("Gaussian pulse", of(gaussian, 20.), 1.644853627 / (2. * M_PI * 0.01), 5e-3);
  check::relative("Gaussian pulse, half", of(gaussian, 20., 0.5), 0.6744897502 / (2. * M_PI * 0.01),
                  5e-3);
  // Integrals of sinc^2 and of the squared spectrum of a Hann window up to f T = 0.8485 and 0.9499
  // are 0.9 of those up to infinity (mpmath.quad).
  check::relative("rectangular pulse", of([](const double t) { return t < 0.05 ? 1. : 0.; }, 20.),
                  0.8485 / 0.05, 5e-3);
  check::relative("sine squared pulse",
                  of([](const double t)
                     { return t < 0.05 ? std::pow(std::sin(M_PI * t / 0.05), 2) : 0.; },
                     20.),
                  0.9499 / 0.05, 5e-3);
  // A pulse that the end of the time cuts off keeps its frequency; what goes on for ever keeps its
  // samples.
  const auto pulse = [](const double t)
  { return t < 0.05 ? std::pow(std::sin(M_PI * t / 0.05), 2) : 0.; };
  const std::vector<double> whole = samples_of_whole_pulse(pulse, 0.02, 1000);
  check::absolute("samples of a pulse cut off at 0.4 of it", whole.size(), 4000., 0.);
  const std::vector<double> cut(whole.begin(), whole.begin() + 1000);
  check::is_true("cut off it would seem shorter",
                 energy_frequency(cut, 2e-5) > 1.2 * energy_frequency(whole, 2e-5));
  check::absolute("samples of a pulse that is over",
                  samples_of_whole_pulse(pulse, 0.1, 1000).size(), 1000., 0.);
  check::absolute(
      "samples of an oscillation",
      samples_of_whole_pulse([](const double t) { return std::sin(t); }, 1.7, 1000).size(), 1000.,
      0.);
  check::absolute("samples of a ramp",
                  samples_of_whole_pulse([](const double t) { return 3. * t; }, 1.7, 1000).size(),
                  1000., 0.);
  check::absolute("samples of a constant",
                  samples_of_whole_pulse([](const double) { return 2.; }, 1.7, 1000).size(), 1000.,
                  0.);
  check::absolute("constant", of([](const double) { return 0.1; }, 1.), 0., 0.);
  check::absolute("nothing", energy_frequency({}, 1.), 0., 0.);
}
} // namespace test_of_energy_frequency
