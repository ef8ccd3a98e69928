// Waves that are known at stations are found again; what stations cannot tell is refused.

#include "../unit_test.h"

#include <continua/frequency/travelling_waves.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace test_of_travelling_waves
{
using namespace Continua;
using Complex = std::complex<double>;

namespace
{
struct Known
{
  Complex g, forward, backward; ///< both amplitudes at the first station
};

std::vector<Complex> at(const std::vector<double> &positions, const std::vector<Known> &waves)
{
  std::vector<Complex> values;
  for (const double z : positions)
  {
    Complex sum = 0.;
    for (const Known &wave : waves)
      sum += wave.forward * std::exp(-wave.g * (z - positions[0])) +
             wave.backward * std::exp(wave.g * (z - positions[0]));
    values.push_back(sum);
  }
  return values;
}

std::vector<double> equidistant(const unsigned int n, const double distance)
{
  std::vector<double> positions;
  for (unsigned int k = 0; k < n; ++k)
    positions.push_back(0.1 + k * distance);
  return positions;
}
} // namespace

UNIT_TEST(travelling_waves)
{
  const double omega = 2. * M_PI * 20.;
  const Known slow{{0.8, 12.}, {100., 20.}, {-30., 40.}};
  const Known fast{{0.1, 3.}, {5., 0.}, {0., 8.}};

  const std::vector<double> three = equidistant(3, 0.05);
  const TravellingWaves one = fit_travelling_waves(three, {at(three, {slow})}, omega);
  check::is_true("one wave", one.refusal.empty() && one.waves.size() == 1);
  check::absolute("propagation", std::abs(one.waves[0].propagation - slow.g), 0., 1e-9);
  check::relative("speed", one.waves[0].speed, omega / 12., 1e-9);
  check::absolute("attenuation", one.waves[0].attenuation, 0.8, 1e-9);
  check::absolute("forward", std::abs(one.waves[0].forward[0] - slow.forward), 0., 1e-7);
  // At the last station, 0.1 m behind the first.
  check::absolute("backward",
                  std::abs(one.waves[0].backward[0] - slow.backward * std::exp(0.1 * slow.g)), 0.,
                  1e-7);
  check::is_true("no deviation of as many numbers as unknowns",
                 std::isnan(one.waves[0].speed_deviation));

  const std::vector<double> uneven = {0., 0.03, 0.11, 0.13, 0.2};
  const TravellingWaves found = fit_travelling_waves(uneven, {at(uneven, {slow})}, omega);
  check::absolute("uneven stations", std::abs(found.waves[0].propagation - slow.g), 0., 1e-9);

  // A pressure and a displacement, whose amplitudes differ and whose waves are the same.
  const std::vector<double> nine = equidistant(9, 0.05);
  const Known other_slow{slow.g, {2e-6, 0.}, {0., 1e-6}},
      other_fast{fast.g, {4e-6, 1e-6}, {3e-6, 0.}};
  TravellingWavesOptions two;
  two.n_waves = 2;
  const TravellingWaves both = fit_travelling_waves(
      nine, {at(nine, {slow, fast}), at(nine, {other_fast, other_slow})}, omega, two);
  check::is_true("two waves", both.waves.size() == 2 && both.misfit < 1e-10);
  check::absolute("the slow one comes first", std::abs(both.waves[0].propagation - slow.g), 0.,
                  1e-7);
  check::absolute("the fast one", std::abs(both.waves[1].propagation - fast.g), 0., 1e-7);
  check::absolute("its forward displacement",
                  std::abs(both.waves[1].forward[1] - other_fast.forward) / 1e-6, 0., 1e-6);
  const TravellingWaves too_few = fit_travelling_waves(nine, {at(nine, {slow, fast})}, omega);
  check::is_true("one wave for two leaves a misfit", too_few.misfit > 0.01);

  // Noise: the errors of many fits have the standard deviations that the fits state.
  std::mt19937 generator(5);
  std::normal_distribution<double> noise(0., 0.5);
  double squares = 0., stated = 0.;
  const unsigned int n_fits = 100;
  for (unsigned int i = 0; i < n_fits; ++i)
  {
    std::vector<Complex> values = at(nine, {slow});
    for (Complex &value : values)
      value += Complex(noise(generator), noise(generator));
    const TravellingWave wave = fit_travelling_waves(nine, {values}, omega).waves[0];
    squares += std::pow(wave.attenuation - 0.8, 2);
    stated += wave.attenuation_deviation * wave.attenuation_deviation;
  }
  check::relative("standard deviation", std::sqrt(stated / squares), 1., 0.2);

  // Stations 0.4 m apart, three quarters of a wave: only a start tells which wave is meant.
  const std::vector<double> far = equidistant(4, 0.4);
  const TravellingWaves alias = fit_travelling_waves(far, {at(far, {slow})}, omega);
  TravellingWavesOptions started;
  started.start = {{0., 11.}};
  const TravellingWaves meant = fit_travelling_waves(far, {at(far, {slow})}, omega, started);
  check::absolute("the longest wave", alias.waves[0].propagation.imag(), 2. * M_PI / 0.4 - 12.,
                  1e-6);
  check::absolute("with a start", std::abs(meant.waves[0].propagation - slow.g), 0., 1e-8);

  const auto refusal = [&](const std::vector<double> &positions, const std::vector<Known> &waves,
                           const unsigned int n_waves = 1)
  {
    TravellingWavesOptions options;
    options.n_waves = n_waves;
    const TravellingWaves fit =
        fit_travelling_waves(positions, {at(positions, waves)}, omega, options);
    return fit.waves.empty() ? fit.refusal : "nothing";
  };
  check::equal("two stations", refusal({0., 0.1}, {slow}),
               "3 stations are the least for 1 waves that go both ways, and there are 2");
  check::equal("four stations for two waves", refusal(equidistant(4, 0.05), {slow, fast}, 2),
               "5 stations are the least for 2 waves that go both ways, and there are 4");
  check::equal("five values for six unknowns", refusal(equidistant(5, 0.05), {slow, fast}, 2),
               "there are fewer values than unknown numbers of the waves");
  const Known undamped{{0., 10. * M_PI}, {1., 0.}, {0.5, 0.2}};
  check::is_true("half a wave", check::matches(refusal(equidistant(4, 0.1), {undamped}),
                                               "multiples of half a wave"));
  check::is_true("too near", check::matches(refusal(equidistant(3, 1e-5), {slow}), "too near"));
  check::equal("nothing there", refusal(three, {}),
               "there are fewer values than unknown numbers of the waves");
  check::throws<std::invalid_argument>(
      "positions",
      [&] {
        fit_travelling_waves({0., 0., 1.}, {{1., 1., 1.}}, 1.);
      },
      "increase");
  check::throws<std::invalid_argument>(
      "frequency",
      [&] {
        fit_travelling_waves(three, {{1., 1., 1.}}, 0.);
      },
      "frequency");
  check::throws<std::invalid_argument>(
      "a field",
      [&] {
        fit_travelling_waves(three, {{1., 1.}}, 1.);
      },
      "each station");
}
} // namespace test_of_travelling_waves
