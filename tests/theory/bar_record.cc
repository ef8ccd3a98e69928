// What laws show in tests of a bar: closed forms of a spring and a dash pot, and of a power law;
// the entries of a law, read as a material, are the same law.

#include "../parameter_text.h"

#include <continua/theory/bar_law.h>
#include <continua/theory/bar_record.h>

#include <cmath>
#include <complex>

#include "../unit_test.h"

namespace test_of_bar_record
{
using namespace Continua;

namespace
{
constexpr double pi = 3.14159265358979323846;

double value_of(const BarLaw &law,
                const std::vector<double> &constants,
                const BarQuantity quantity,
                const double abscissa,
                const double loading_time = 0.)
{
  BarRecord record;
  record.quantity = quantity;
  record.loading_time = loading_time;
  record.abscissae = {abscissa};
  return record.predicted(law.material(constants))[0];
}

std::complex<double>
modulus_of(const BarLaw &law, const std::vector<double> &constants, const double frequency)
{
  BarRecord record;
  record.quantity = BarQuantity::modulus;
  record.abscissae = {frequency, frequency};
  const std::vector<double> values = record.predicted(law.material(constants));
  return {values[0], values[1]};
}

/// The material that a parameter file gets from the entries has the modulus of the law.
void read_back(const std::string &type,
               const double poissons_ratio,
               const std::vector<double> &constants)
{
  const std::shared_ptr<const BarLaw> made = make_bar_law(type, poissons_ratio, 2);
  const BarLaw &law = *made;
  std::string text = "subsection Materials\nsubsection wall\nset Density = 1000\n";
  for (const auto &[key, value] : law.entries(constants))
    text += "set " + key + " = " + value + "\n";
  ParameterFile file = parameters_of(text + "end\nend\n");
  const Material material = read_material(file.root().subsection("Materials").subsection("wall"),
                                          Model::three_dimensional);
  for (const double omega : {0.1, 3., 70.})
  {
    const std::complex<double> expected = law.material(constants).complex_young_modulus(omega);
    check::absolute(law.description() + " of Poisson's ratio " +
                        std::to_string(poissons_ratio).substr(0, 4) + ", read back at " +
                        std::to_string(omega).substr(0, 4) + " 1/s",
                    std::abs(material.complex_young_modulus(omega) / expected - 1.), 0., 2e-6);
  }
}
} // namespace

UNIT_TEST(bar_record)
{
  const double t = 0.3, loading = 0.2, mu = 1e3, tau = 0.1;
  const std::shared_ptr<const BarLaw> maxwell = make_bar_law("maxwell");
  check::relative("maxwell: step", value_of(*maxwell, {mu, tau}, BarQuantity::relaxation, t),
                  3. * mu * std::exp(-t / tau), 1e-12);
  check::relative(
      "maxwell: ramp", value_of(*maxwell, {mu, tau}, BarQuantity::relaxation, t, loading),
      3. * mu * tau / loading * (std::exp((loading - t) / tau) - std::exp(-t / tau)), 1e-12);
  check::relative("maxwell: creep", value_of(*maxwell, {mu, tau}, BarQuantity::creep, t),
                  (1. + t / tau) / (3. * mu), 1e-12);
  const double young = 2e3, viscosity = 40.;
  check::relative(
      "kelvin-voigt: creep",
      value_of(*make_bar_law("kelvin-voigt"), {young, viscosity}, BarQuantity::creep, t),
      (1. - std::exp(-young * t / (3. * viscosity))) / young, 1e-12);
  const std::complex<double> of_dash_pot =
      modulus_of(*make_bar_law("kelvin-voigt"), {young, viscosity}, 2.);
  check::relative("kelvin-voigt: storage modulus", of_dash_pot.real(), young, 1e-12);
  check::relative("kelvin-voigt: loss modulus", of_dash_pot.imag(), 3. * viscosity * 4. * pi,
                  1e-12);
  // Of a constant Poisson's ratio each branch has 2 (1 + nu) mu.
  const std::vector<double> series = {4e5, 3e4, 5e4, 10., 0.5};
  const std::shared_ptr<const BarLaw> prony = make_bar_law("prony", 0.3, 2);
  check::relative("prony: step", value_of(*prony, series, BarQuantity::relaxation, t),
                  4e5 + 2.6 * (3e4 * std::exp(-t / 10.) + 5e4 * std::exp(-t / 0.5)), 1e-12);
  const std::complex<double> i_omega(0., 4. * pi),
      exact = 4e5 + 2.6 * (3e4 * i_omega * 10. / (1. + i_omega * 10.) +
                           5e4 * i_omega * 0.5 / (1. + i_omega * 0.5));
  check::absolute("prony: modulus", std::abs(modulus_of(*prony, series, 2.) / exact - 1.), 0.,
                  1e-12);
  const std::shared_ptr<const BarLaw> power_law = make_bar_law("power law");
  check::relative("power law: step",
                  value_of(*power_law, {1.3e6, 0.065}, BarQuantity::relaxation, t),
                  1.3e6 * std::pow(t, -0.065), 1e-14);
  check::relative(
      "power law: ramp", value_of(*power_law, {1.3e6, 0.065}, BarQuantity::relaxation, t, loading),
      1.3e6 / (loading * 0.935) * (std::pow(t, 0.935) - std::pow(t - loading, 0.935)), 1e-12);
  check::relative(
      "hookean: after the loading",
      value_of(*make_bar_law("hookean", 0.3), {5e5}, BarQuantity::relaxation, t, loading), 5e5,
      1e-14);

  read_back("hookean", 0.3, {5e5});
  for (const double poissons_ratio : {0.5, 0.3})
  {
    read_back("maxwell", poissons_ratio, {mu, tau});
    read_back("kelvin-voigt", poissons_ratio, {young, viscosity});
    read_back("prony", poissons_ratio, series);
    read_back("power law", poissons_ratio, {1.3e6, 0.065});
  }

  BarRecord record;
  record.quantity = BarQuantity::creep;
  record.abscissae = {1., 2.};
  record.values = {2e-6, 3e-6};
  record.noise_units = {2e-6, 4e-6};
  const DataRecord data = record.data_record(0.1);
  check::equal("data: name", data.name, "creep");
  check::relative("data: value over its unit", data.values[1], 0.75, 1e-14);
  check::relative("prediction over its unit",
                  record.scaled_prediction(make_bar_law("hookean")->material({5e5}))[1], 0.5,
                  1e-14);
  record.is_logarithmic = true;
  check::relative("data: logarithm", record.data_record(0.1).values[1], std::log(3e-6), 1e-14);
  check::relative("prediction: logarithm",
                  record.scaled_prediction(make_bar_law("hookean")->material({5e5}))[1],
                  std::log(2e-6), 1e-12);
  check::throws<std::logic_error>(
      "unknown law", []() { make_bar_law("no law"); }, "no law");
  check::throws<std::logic_error>(
      "no branch", []() { make_bar_law("prony", 0.5, 0); }, "one branch at least");
}
} // namespace test_of_bar_record
