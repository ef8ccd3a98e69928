// Exact answers of a bar to the material tests: partial fractions against closed forms of few
// branches, against the law in the frequency domain, and against numerical quadrature.

#include <continua/theory/uniaxial_response.h>

#include <gsl/gsl_integration.h>

#include <functional>

#include "../unit_test.h"
#include "../viscoelastic_solid.h"

namespace test_of_uniaxial_response
{
using namespace Continua;

namespace
{
const double never = std::numeric_limits<double>::infinity();

double quadrature(const std::function<double(double)> &function, const double a, const double b)
{
  gsl_integration_workspace *const space = gsl_integration_workspace_alloc(1000);
  gsl_function wrapped;
  wrapped.function = [](const double x, void *const f)
  { return (*static_cast<const std::function<double(double)> *>(f))(x); };
  wrapped.params = const_cast<std::function<double(double)> *>(&function);
  double value = 0., error = 0.;
  gsl_integration_qags(&wrapped, a, b, 1e-8, 1e-9, 1000, space, &value, &error);
  gsl_integration_workspace_free(space);
  return value;
}

/// The partial fractions against the law, on a wide band.
void check_modulus(const std::string &name, const Material &law)
{
  const UniaxialResponse response(law);
  double of_creep = 0., of_relaxation = 0.;
  for (double omega = 1e-4; omega < 2e6; omega *= 3.)
  {
    const std::complex<double> exact = law.complex_young_modulus(omega), s(0., omega);
    of_creep = std::max(of_creep, std::abs(response.modulus(omega) / exact - 1.));
    of_relaxation = std::max(of_relaxation, std::abs(s * response.relaxation()(s) / exact - 1.));
  }
  check::absolute(name + ": J(s)", of_creep, 0., 1e-12);
  check::absolute(name + ": Y(s)", of_relaxation, 0., 1e-10);
  bool positive = response.creep().constant() >= 0. && response.relaxation().constant() >= 0.;
  for (const UniaxialSpectrum *spectrum : {&response.creep(), &response.relaxation()})
    for (const UniaxialSpectrum::Line &line : spectrum->lines())
      positive = positive && line.weight > 0. && line.rate >= 0.;
  check::is_true(name + ": Stieltjes", positive);

  // The sine's answer: what is left once its start has died away is the complex modulus, and at any
  // time the convolution of the rate of strain with the relaxation modulus.
  const double omega = 7., time = 1.3;
  double folded = response.relaxation().constant() * omega * std::cos(omega * time);
  double begin = 0.;
  for (const double end : {time - 1e-2, time - 1e-3, time})
  {
    // The fastest of the branches forgets within 1e-4 s.
    folded +=
        quadrature([&](const double t)
                   { return response.relaxation().decay(time - t) * omega * std::cos(omega * t); },
                   begin, end);
    begin = end;
  }
  check::relative(name + ": sine", response.sine_stress(1., omega, time), folded, 1e-9);
}
} // namespace

UNIT_TEST(uniaxial_response)
{
  const double mu = 1000., tau = 0.1, eta = 100., k = 2000.;
  {
    // f = 2 + 3/(s + 1): s f = 0 at s = 0 and at s = -5/2; 1/(s f) = (s + 1)/(s (2 s + 5)).
    UniaxialSpectrum f(2.);
    f.add(1., 1.);
    f.add(2., 1.);
    const UniaxialSpectrum inverse = f.inverse();
    check::is_true("inverse: poles", inverse.lines().size() == 2 && inverse.constant() == 0.);
    check::relative("inverse: pole", inverse.lines()[1].rate, 2.5, 1e-14);
    check::relative("inverse: weight", inverse.lines()[1].weight, 0.3, 1e-14);
    check::relative("inverse: weight at 0", inverse.lines()[0].weight, 0.2, 1e-14);
    const UniaxialSpectrum twice = inverse.inverse();
    check::relative("inverse of the inverse: constant", twice.constant(), 2., 1e-13);
    check::relative("inverse of the inverse: weight", twice.lines()[0].weight, 3., 1e-13);
    check::relative("inverse of the inverse: rate", twice.lines()[0].rate, 1., 1e-13);
  }
  {
    const UniaxialResponse hookean(viscoelastic_solid(1. / k, 0., {{mu, never}}));
    const double young = 9. * k * mu / (3. * k + mu);
    check::relative("hookean: held", hookean.ramp_stress(0.01, 0.2, 5.), 0.01 * young, 1e-14);
    check::relative("hookean: half loaded", hookean.ramp_stress(0.01, 0.2, 0.1), 0.005 * young,
                    1e-14);
    check::relative("hookean: creep", hookean.step_strain(10., 0.3), 10. / young, 1e-14);
    check::relative("hookean: sine", hookean.sine_stress(0.01, 7., 0.3),
                    0.01 * young * std::sin(2.1), 1e-13);
  }
  {
    // Incompressible Kelvin-Voigt: sigma = 3 (mu eps + eta deps/dt).
    const UniaxialResponse solid(viscoelastic_solid(0., eta, {{mu, never}}));
    check::relative("kelvin-voigt: creep", solid.step_strain(10., 0.25),
                    10. / (3. * mu) * (1. - std::exp(-2.5)), 1e-13);
    check::relative("kelvin-voigt: loading", solid.ramp_stress(0.01, 0.2, 0.1),
                    3. * (mu * 0.005 + eta * 0.05), 1e-13);
    check::relative("kelvin-voigt: held", solid.ramp_stress(0.01, 0.2, 0.3), 3. * mu * 0.01, 1e-13);
    check::relative("kelvin-voigt: sine", solid.sine_stress(0.01, 7., 0.3),
                    0.03 * (mu * std::sin(2.1) + eta * 7. * std::cos(2.1)), 1e-13);
  }
  {
    // Incompressible Maxwell: the flow rate is stress/(3 mu tau) for ever.
    const UniaxialResponse solid(viscoelastic_solid(0., 0., {{mu, tau}}));
    check::relative("maxwell: creep", solid.step_strain(10., 0.25), 10. / (3. * mu) * (1. + 2.5),
                    1e-13);
    check::relative("maxwell: held", solid.ramp_stress(0.01, 0.2, 0.5),
                    3. * mu * 0.05 * tau * (1. - std::exp(-2.)) * std::exp(-3.), 1e-13);
  }
  {
    // Compressible Maxwell: Y(s)/s = 9 K mu/(3 K (s + 1/tau) + mu s): one rate, slower than 1/tau.
    const UniaxialResponse solid(viscoelastic_solid(1. / k, 0., {{mu, tau}}));
    const double rate = 3. * k / (3. * k + mu) / tau, young = 9. * k * mu / (3. * k + mu);
    check::is_true("compressible maxwell: one exponential", solid.relaxation().lines().size() == 1);
    check::relative("compressible maxwell: rate", solid.relaxation().lines()[0].rate, rate, 1e-13);
    check::relative("compressible maxwell: modulus", solid.relaxation().decay(0.2),
                    young * std::exp(-rate * 0.2), 1e-13);
  }

  const std::vector<Branch> branches = {{1000., never}, {2000., 0.1}, {500., 1.},
                                        {300., 1e-4},   {800., 30.},  {100., 0.11}};
  check_modulus("elastic volume change", viscoelastic_solid(1. / k, 0., branches));
  check_modulus("incompressible", viscoelastic_solid(0., 0., branches));
  check_modulus("with a dash pot", viscoelastic_solid(1. / k, 3., branches));
  check_modulus("no spring", viscoelastic_solid(1. / k, 0., {{2000., 0.1}, {500., 1.}}));
  check_modulus(
      "volume change that relaxes",
      viscoelastic_solid(1. / 5000., 0., branches, {{2000., never}, {2000., 0.5}, {1000., 0.1}}));
  check_modulus("all of it relaxes", viscoelastic_solid(1. / 3000., 0., {{2000., 0.1}, {500., 1.}},
                                                        {{2000., 0.1}, {1000., 3.}}));

  // The power law: the thesis's wall.
  const PowerLawResponse wall{1.3e6, 0.065};
  check::relative("power law: tan delta", wall.modulus(3.).imag() / wall.modulus(3.).real(),
                  std::tan(0.065 * std::acos(-1.) / 2.), 1e-12);
  check::relative("power law: a ramp long past", wall.ramp_stress(0.03, 1e-3, 100.),
                  0.03 * 1.3e6 * std::pow(100. - 5e-4, -0.065), 1e-8);
  check::relative("power law: at the ramp's end", wall.ramp_stress(0.03, 0.1, 0.1),
                  0.03 * 1.3e6 * std::pow(0.1, -0.065) / 0.935, 1e-13);
  // Creep under relaxation gives back the step: int_0^t Y(t - t') J'(t') dt' = 1; t' = u^(1/n)
  // takes the singularity of J' at 0 away.
  const double n = wall.n, at = 2.;
  const double folded =
      quadrature([&](const double u) { return std::pow(at - std::pow(u, 1. / n), -n); }, 0.,
                 std::pow(at, n)) *
      wall.c * wall.step_strain(1., 1.);
  check::relative("power law: creep under relaxation", folded, 1., 1e-6);
}
} // namespace test_of_uniaxial_response
