#include <continua/theory/uniaxial_response.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
/// M(s)/s of springs side by side that each relax with a time of their own.
void add_branch(UniaxialSpectrum &modulus_over_s, const double modulus, const double time)
{
  modulus_over_s.add(modulus, std::isinf(time) ? 0. : 1. / time);
}
} // namespace

UniaxialResponse::UniaxialResponse(const Material &material)
{
  UniaxialSpectrum shear(material.shear.viscosity);
  for (const Branch &branch : material.shear.branches)
    add_branch(shear, branch.shear_modulus, branch.relaxation_time);
  creep_spectrum.add(1. / 3., shear.inverse());
  if (material.compression.bulk_branches().empty())
    creep_spectrum.add(1. / 9., UniaxialSpectrum(material.inverse_bulk_modulus()));
  else
  {
    UniaxialSpectrum bulk;
    for (const BulkBranch &branch : material.compression.bulk_branches())
      add_branch(bulk, branch.bulk_modulus, branch.relaxation_time);
    creep_spectrum.add(1. / 9., bulk.inverse());
  }
  relaxation_spectrum = creep_spectrum.inverse();
}

std::complex<double> UniaxialResponse::modulus(const double omega) const
{
  return 1. / creep_spectrum({0., omega});
}

double UniaxialResponse::ramp_stress(const double strain,
                                     const double loading_time,
                                     const double time) const
{
  const double held_for = time > loading_time ? time - loading_time : -1.;
  return strain / loading_time *
         (relaxation_spectrum.integral(time) - relaxation_spectrum.integral(held_for));
}

double UniaxialResponse::step_strain(const double stress, const double time) const
{
  return stress * creep_spectrum.integral(time);
}

double
UniaxialResponse::sine_stress(const double amplitude, const double omega, const double time) const
{
  // The rate of strain, amplitude omega cos(omega t), folded with the relaxation modulus.
  const double sine = std::sin(omega * time), cosine = std::cos(omega * time);
  double value = relaxation_spectrum.constant() * cosine;
  for (const UniaxialSpectrum::Line &line : relaxation_spectrum.lines())
    value += line.weight * (line.rate * (cosine - std::exp(-line.rate * time)) + omega * sine) /
             (line.rate * line.rate + omega * omega);
  return amplitude * omega * value;
}

std::complex<double> PowerLawResponse::modulus(const double omega) const
{
  return c * std::tgamma(1. - n) * std::pow(std::complex<double>(0., omega), n);
}

double PowerLawResponse::ramp_stress(const double strain,
                                     const double loading_time,
                                     const double time) const
{
  const auto power = [this](const double t) { return t > 0. ? std::pow(t, 1. - n) : 0.; };
  return c * strain / (loading_time * (1. - n)) * (power(time) - power(time - loading_time));
}

double PowerLawResponse::step_strain(const double stress, const double time) const
{
  const double angle = n * dealii::numbers::PI;
  return stress * std::pow(time, n) * std::sin(angle) / (angle * c);
}
} // namespace Continua
