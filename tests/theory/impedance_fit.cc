// First-order responses for impedances: those that are a sum of them come back, others are met to
// the tolerance asked for, and no fit gives energy away.

#include <continua/theory/impedance_fit.h>
#include <continua/theory/matched_impedance.h>

#include "waves.h"

#include "../unit_test.h"

#include <functional>

namespace test_of_impedance_fit
{
using namespace waves;

namespace
{
using Complex = std::complex<double>;
using Value = dealii::FullMatrix<Complex>;

/// Along the line s = 1/s + i omega, from 1 to 1000 1/s.
std::vector<ImpedanceSample> samples_of(const std::function<Value(Complex)> &impedance)
{
  std::vector<ImpedanceSample> samples;
  for (unsigned int i = 0; i <= 40; ++i)
  {
    const Complex s(1., std::pow(10., 3. * i / 40.));
    samples.push_back({s, impedance(s), 1.});
  }
  return samples;
}

/// The error of a fit by hand.
double error_of(const Impedance &impedance, const std::vector<ImpedanceSample> &samples)
{
  double error = 0.;
  for (const ImpedanceSample &sample : samples)
  {
    const Value value = impedance.value(sample.s);
    for (unsigned int i = 0; i < value.m(); ++i)
      for (unsigned int j = 0; j < value.m(); ++j)
        error = std::max(error, sample.weight * std::abs(value(i, j) - sample.value(i, j)) /
                                    std::sqrt(std::abs(sample.value(i, i) * sample.value(j, j))));
  }
  return error;
}

bool is_passive(const Impedance &impedance)
{
  return smallest_resistance(impedance, std::vector<double>(impedance.n_ports(), 1.)) > 0.;
}

void check_fit(const std::string &name,
               const std::vector<ImpedanceSample> &samples,
               const double tolerance,
               const unsigned int most_terms)
{
  const ImpedanceFit fit = fit_impedance(samples, tolerance, 1e4);
  check::is_true(name + ": met", fit.error <= tolerance);
  check::absolute(name + ": error as told", error_of(fit.impedance, samples), fit.error, 1e-9);
  check::is_true(name + ": passive", is_passive(fit.impedance));
  check::is_true(name + ": few terms", fit.impedance.terms.size() <= most_terms);
}

void windkessel()
{
  const Impedance given = Impedance::windkessel(2e7, 3e8, 1e-10);
  const auto samples = samples_of([&](const Complex s) { return given.value(s); });
  const Impedance found = fit_impedance(samples, 1e-8, 1e6).impedance;
  check::is_true("windkessel: one term", found.terms.size() == 1);
  check::relative("windkessel: proximal resistance", found.direct(0, 0), 2e7, 1e-6);
  check::relative("windkessel: rate", found.terms[0].rate, 1. / 0.03, 1e-6);
  check::relative("windkessel: 1/compliance", found.terms[0].residue(0, 0), 1e10, 1e-6);

  const Impedance resistance =
      fit_impedance(samples_of([](const Complex s) { return Impedance::resistance(5.).value(s); }),
                    1e-8, 1e6)
          .impedance;
  check::is_true("resistance: no term", resistance.terms.empty());
  check::relative("resistance", resistance.direct(0, 0), 5., 1e-12);
}

void passivity()
{
  Impedance impedance = Impedance::windkessel(1., 2., 1.);
  check::relative("smallest resistance: at infinity", smallest_resistance(impedance, {1.}), 1.,
                  1e-12);
  impedance.terms[0].residue(0, 0) = -0.4; // 1 - 0.8 at zero
  check::relative("smallest resistance: at zero", smallest_resistance(impedance, {1.}), 0.2, 1e-12);
  // 1 - 4/(s + 1) + 4/(s + 2) at zero.
  impedance.terms = {Impedance::Term(), Impedance::Term()};
  for (unsigned int k = 0; k < 2; ++k)
  {
    impedance.terms[k].rate = k + 1.;
    impedance.terms[k].residue.reinit(1, 1);
    impedance.terms[k].residue(0, 0) = k == 0 ? -4. : 4.;
  }
  check::relative("smallest resistance: active", smallest_resistance(impedance, {1.}), -1., 1e-12);
  Impedance two;
  two.direct.reinit(2, 2);
  two.direct(0, 0) = two.direct(1, 1) = 2.;
  two.direct(0, 1) = two.direct(1, 0) = -1.5;
  check::relative("smallest resistance: two ports", smallest_resistance(two, {1., 1.}), 0.5, 1e-12);
  check::relative("smallest resistance: scaled", smallest_resistance(two, {2., 2.}), 0.25, 1e-12);
}

/// A viscoelastic wall's rises with frequency, a viscous liquid's falls.
void powers()
{
  const auto scalar = [](const Complex &value)
  {
    Value matrix(1, 1);
    matrix(0, 0) = value;
    return matrix;
  };
  constexpr unsigned int most = 8; // less than three for each of three decades
  check_fit("rising", samples_of([&](const Complex s) { return scalar(std::pow(s, 0.0325)); }),
            1e-3, most);
  check_fit("falling", samples_of([&](const Complex s) { return scalar(1. + std::pow(s, -0.5)); }),
            1e-3, most);
  check_fit("both, coupled",
            samples_of(
                [&](const Complex s)
                {
                  Value matrix(2, 2);
                  matrix(0, 0) = 5e6 * std::pow(s, 0.0325);
                  matrix(1, 1) = 1e10 * (1. + std::pow(s, -0.5));
                  matrix(0, 1) = matrix(1, 0) = -1e8 * std::pow(s, 0.1);
                  return matrix;
                }),
            1e-3, most);
  // What gives energy away at low frequencies is not followed there.
  const ImpedanceFit active = fit_impedance(
      samples_of([&](const Complex s) { return scalar(1. - 3. / (s / 10. + 1.)); }), 1e-3, 1e4);
  check::is_true("active: no fit", !(active.error <= 1e-3));
  check::is_true("active: what is returned is passive", is_passive(active.impedance));
}

/// Tube A behind an absorbing end of liquid and wall, over the band of a pulse of 50 ms.
void tube_a()
{
  TubeSection section = tube(12.5e-3, 0.1e-3, 880., 1.72e6, 0.49, 998., 1e-3);
  section.fluid.compression = Compression::elastic(1. / 2.2e9);
  section.layers[0] = Material();
  section.layers[0].density = 880.;
  section.layers[0].shear.power_law = PowerLaw{1.3e6, 0.065, {}, {}};
  std::vector<double> frequencies;
  for (unsigned int i = 0; i <= 25; ++i)
    frequencies.push_back(0.45 * std::pow(25. / 0.45, i / 25.));
  for (const auto &[name, end] : {std::make_pair("tube A, wall absorbing", WallEnd::absorbing),
                                  std::make_pair("tube A, wall clamped", WallEnd::clamped)})
  {
    const std::vector<Value> values = matched_impedances(section, end, 2.8, frequencies);
    std::vector<ImpedanceSample> samples;
    for (unsigned int i = 0; i < values.size(); ++i)
      samples.push_back({Complex(2.8, 2. * pi * frequencies[i]), values[i], 1.});
    check_fit(name, samples, 5e-3, 8);
  }
}
} // namespace

UNIT_TEST(impedance_fit)
{
  windkessel();
  passivity();
  powers();
  tube_a();
}
} // namespace test_of_impedance_fit
