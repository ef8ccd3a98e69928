#include <continua/theory/tube_section.h>

namespace Continua
{
double TubeSection::wall_thickness() const
{
  double sum = 0.;
  for (const double thickness : layer_thicknesses)
    sum += thickness;
  return sum;
}

std::complex<double> TubeSection::membrane_modulus(const std::complex<double> &omega) const
{
  std::complex<double> sum = 0.;
  for (unsigned int i = 0; i < layers.size(); ++i)
    sum += layers[i].complex_young_modulus(omega) * layer_thicknesses[i];
  return sum / wall_thickness();
}

double TubeSection::wall_density() const
{
  double sum = 0.;
  for (unsigned int i = 0; i < layers.size(); ++i)
    sum += layers[i].density * layer_thicknesses[i];
  return sum / wall_thickness();
}

std::complex<double> TubeSection::poisson_ratio(const std::complex<double> &omega) const
{
  std::complex<double> sum = 0., weights = 0.;
  for (unsigned int i = 0; i < layers.size(); ++i)
  {
    const std::complex<double> young = layers[i].complex_young_modulus(omega),
                               weight = young * layer_thicknesses[i];
    sum += weight * (0.5 * young / layers[i].complex_shear_modulus(omega) - 1.);
    weights += weight;
  }
  return sum / weights;
}
} // namespace Continua
