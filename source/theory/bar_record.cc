#include <continua/theory/bar_record.h>

#include <continua/theory/uniaxial_response.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <functional>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
/// The answers of a bar, by a law.
struct BarAnswers
{
  std::function<double(double)> step_modulus;                   ///< of the time [Pa]
  std::function<double(double, double)> ramp_modulus;           ///< of loading time and time [Pa]
  std::function<double(double)> compliance;                     ///< of the time [1/Pa]
  std::function<std::complex<double>(double)> modulus_at_omega; ///< [Pa]
};

BarAnswers answers_of(const PowerLawResponse &law)
{
  BarAnswers answers;
  answers.step_modulus = [law](const double time) { return law.c * std::pow(time, -law.n); };
  answers.ramp_modulus = [law](const double loading_time, const double time)
  { return law.ramp_stress(1., loading_time, time); };
  answers.compliance = [law](const double time) { return law.step_strain(1., time); };
  answers.modulus_at_omega = [law](const double omega) { return law.modulus(omega); };
  return answers;
}

BarAnswers answers_of(const UniaxialResponse &bar)
{
  BarAnswers answers;
  answers.step_modulus = [bar](const double time) { return bar.relaxation().decay(time); };
  answers.ramp_modulus = [bar](const double loading_time, const double time)
  { return bar.ramp_stress(1., loading_time, time); };
  answers.compliance = [bar](const double time) { return bar.step_strain(1., time); };
  answers.modulus_at_omega = [bar](const double omega) { return bar.modulus(omega); };
  return answers;
}
} // namespace

std::string BarRecord::name() const
{
  return quantity == BarQuantity::relaxation ? "relaxation"
         : quantity == BarQuantity::creep    ? "creep"
                                             : "modulus";
}

std::string BarRecord::unit() const
{
  return quantity == BarQuantity::creep ? "1/Pa" : "Pa";
}

std::vector<double> BarRecord::predicted(const Material &material) const
{
  const BarAnswers bar = material.has_power_law()
                             ? answers_of(PowerLawResponse{material.shear.power_law->modulus,
                                                           material.shear.power_law->exponent})
                             : answers_of(UniaxialResponse(material));
  std::vector<double> result;
  for (std::size_t i = 0; i < abscissae.size(); ++i)
    if (quantity == BarQuantity::relaxation)
      result.push_back(loading_time > 0. ? bar.ramp_modulus(loading_time, abscissae[i])
                                         : bar.step_modulus(abscissae[i]));
    else if (quantity == BarQuantity::creep)
      result.push_back(bar.compliance(abscissae[i]));
    else
    {
      const std::complex<double> modulus = bar.modulus_at_omega(2. * PI * abscissae[i]);
      result.push_back(i % 2 == 0 ? modulus.real() : modulus.imag());
    }
  return result;
}

DataRecord BarRecord::data_record(const double standard_deviation) const
{
  DataRecord record;
  record.name = name();
  record.unit = "1";
  record.interval = 0.;
  record.times = abscissae;
  record.values = scaled(values);
  record.noise.standard_deviation = standard_deviation;
  return record;
}

std::vector<double> BarRecord::scaled_prediction(const Material &material) const
{
  return scaled(predicted(material));
}

std::vector<double> BarRecord::scaled(std::vector<double> numbers) const
{
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = is_logarithmic ? std::log(numbers[i]) : numbers[i] / noise_units[i];
  return numbers;
}
} // namespace Continua
