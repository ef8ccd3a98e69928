// Prony series fitted to laws: to the power law of the thesis's tubes (section 5.3, table 6.3), of
// which six branches were known to come within 2e-4 to 5e-4 from 0.5 to 100 Hz, and to Prony
// series, which must come back. A modulus 1/omega is followed best by a spring alone, within 9/11
// over a decade.

#include <continua/materials/power_law_fit.h>
#include <continua/materials/prony_series.h>

#include "../unit_test.h"

#include <cmath>
#include <complex>

namespace test_of_prony_series
{
using namespace Continua;

namespace
{
/// c Gamma(1 - n) (i omega)^n (equation 5.6)
ComplexModulus power_law(const double c, const double n)
{
  return [=](const double omega)
  { return c * std::tgamma(1. - n) * std::pow(std::complex<double>(0., omega), n); };
}

bool all_positive(const PronySeries &series)
{
  bool positive = series.spring > 0.;
  for (std::size_t k = 0; k < series.moduli.size(); ++k)
    positive = positive && series.moduli[k] > 0. && series.times[k] > 0. &&
               (k == 0 || series.times[k] < series.times[k - 1]);
  return positive;
}

/// Largest |series/law - 1| at frequencies [Hz] other than the fit's own.
double error(const PronySeries &series,
             const ComplexModulus &law,
             const double lowest,
             const double highest)
{
  double largest = 0.;
  for (unsigned int i = 0; i <= 7919; ++i)
  {
    const double omega = 2. * M_PI * lowest * std::pow(highest / lowest, i / 7919.);
    largest = std::max(largest, std::abs(series.modulus(omega) / law(omega) - 1.));
  }
  return largest;
}
} // namespace

UNIT_TEST(prony_series)
{
  const ComplexModulus law = power_law(1.3e6, 0.065);
  const PronySeries six = fit_prony_series(law, 0.5, 100., 6);
  check::is_true("six branches, positive, the longest time first",
                 six.moduli.size() == 6 && all_positive(six));
  check::is_true("six branches: within 5e-4 from 0.5 to 100 Hz", six.error < 5e-4);
  check::is_true("six branches: within 2.5e-4", six.error < 2.5e-4);
  check::relative("six branches: the error that is reported", six.error, error(six, law, 0.5, 100.),
                  1e-3);
  // tan delta = tan(n pi/2) at all frequencies; an error e of the modulus turns it by e at most.
  double largest = 0.;
  for (double frequency = 0.5; frequency < 100.; frequency *= 1.01)
  {
    const std::complex<double> modulus = six.modulus(2. * M_PI * frequency);
    largest = std::max(largest, std::abs(modulus.imag() / modulus.real() - 0.1024505));
  }
  check::is_true("six branches: loss tangent 0.1025 within the error", largest < 1.02 * six.error);

  const PronySeries eight = fit_prony_series(law, 0.5, 100., 8);
  check::is_true("eight branches: ten times closer", eight.error < 0.1 * six.error);
  const PronySeries few = fit_prony_series_within(law, 0.5, 100., 5e-4);
  check::is_true("as few as meet 5e-4: six", few.moduli.size() == 6 && few.error <= 5e-4 &&
                                                 fit_prony_series(law, 0.5, 100., 5).error > 5e-4);
  const ComplexModulus steep = power_law(1e6, 0.3);
  const PronySeries of_steep = fit_prony_series_within(steep, 0.5, 100., 5e-4);
  check::is_true("n = 0.3: within 5e-4", of_steep.error <= 5e-4 && all_positive(of_steep) &&
                                             error(of_steep, steep, 0.5, 100.) <= 5.01e-4);
  const ComplexModulus steeper = power_law(1e6, 0.7);
  const PronySeries wide = fit_prony_series_within(steeper, 0.1, 1000., 1e-3);
  check::is_true("n = 0.7, four decades: within 1e-3", wide.error <= 1e-3 && all_positive(wide));
  const PronySeries spring =
      fit_prony_series([](double) { return std::complex<double>(7e5); }, 1., 10., 2);
  check::relative("a spring alone", spring.modulus(20.).real(), 7e5, 1e-9);

  PronySeries exact;
  exact.spring = 1e6;
  exact.moduli = {2e5, 3e5, 1e5};
  exact.times = {0.1, 0.01, 0.002};
  const PronySeries again =
      fit_prony_series([&exact](const double omega) { return exact.modulus(omega); }, 0.5, 100., 3);
  check::relative("a Prony series returns itself: spring", again.spring, exact.spring, 1e-7);
  for (unsigned int k = 0; k < 3; ++k)
  {
    check::relative("a Prony series returns itself: modulus", again.moduli[k], exact.moduli[k],
                    1e-7);
    check::relative("a Prony series returns itself: time", again.times[k], exact.times[k], 1e-7);
  }

  check::throws<std::range_error>(
      "a modulus that falls with frequency, which no springs have",
      []
      {
        fit_prony_series_within([](const double omega) { return std::complex<double>(1. / omega); },
                                1., 10., 1e-3);
      },
      "up to 40 branches.*closer than 0\\.8");
  check::throws<std::domain_error>(
      "a law without a modulus",
      [] { fit_prony_series([](double) { return std::complex<double>(-1., 1.); }, 1., 10., 2); },
      "no positive storage modulus at 1 Hz");

  // The branches of a material.
  Material material;
  material.shear.power_law = PowerLaw{1.3e6, 0.065, {}, {}};
  Material stiffer = material;
  stiffer.shear.power_law->modulus = 2.3e6;
  const PronySeries shear = fit_power_law(material, 0.5, 100.);
  fit_power_law(stiffer, 0.5, 100.);
  check::relative("shear modulus: a third of Young's", shear.spring, few.spring / 3., 1e-6);
  bool same = material.shear.branches.size() == 7 && stiffer.shear.branches.size() == 7 &&
              std::isinf(material.shear.branches[0].relaxation_time);
  for (unsigned int k = 0; k < 7 && same; ++k)
    same = material.shear.branches[k].relaxation_time == stiffer.shear.branches[k].relaxation_time;
  check::is_true("the times do not depend on c, bit by bit", same);

  material.compression = Compression::elastic(1. / 5e6);
  const PronySeries compressible = fit_power_law(material, 0.5, 100.);
  const double omega = 2. * M_PI * 7.;
  Material branches_alone = material;
  branches_alone.shear.power_law.reset();
  check::is_true("elastic volume change: Young's modulus follows the law",
                 std::abs(branches_alone.complex_young_modulus(omega) / law(omega) - 1.) <
                     1.1 * compressible.error);

  material.compression = Compression();
  material.shear.power_law->poissons_ratio = 0.45;
  const PronySeries constant_ratio = fit_power_law(material, 0.5, 100.);
  branches_alone = material;
  branches_alone.shear.power_law.reset();
  check::is_true("constant Poisson's ratio: Young's modulus follows the law",
                 std::abs(branches_alone.complex_young_modulus(omega) / law(omega) - 1.) <=
                     1.01 * constant_ratio.error);
  // nu = 3 K/(6 K + 2 mu) (3 - 2 mu/K) / 3 = (3 K - 2 mu)/(6 K + 2 mu)
  const std::complex<double> mu = branches_alone.complex_shear_modulus(omega);
  const std::complex<double> bulk = 1. / branches_alone.complex_inverse_bulk_modulus(omega);
  const std::complex<double> ratio = (3. * bulk - 2. * mu) / (6. * bulk + 2. * mu);
  check::absolute("constant Poisson's ratio", ratio.real(), 0.45, 1e-12);
  check::absolute("constant Poisson's ratio: real", ratio.imag(), 0., 1e-12);
}
} // namespace test_of_prony_series
