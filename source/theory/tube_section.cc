#include <continua/theory/tube_section.h>

#include <deal.II/base/numbers.h>

#include <algorithm>

namespace Continua
{
namespace
{
bool is_same(const Material &a, const Material &b)
{
  const auto is_same_branch = [](const Branch &one, const Branch &other)
  {
    return one.shear_modulus == other.shear_modulus && one.relaxation_time == other.relaxation_time;
  };
  const auto is_same_bulk_branch = [](const BulkBranch &one, const BulkBranch &other) {
    return one.bulk_modulus == other.bulk_modulus && one.relaxation_time == other.relaxation_time;
  };
  return a.density == b.density && a.inverse_bulk_modulus == b.inverse_bulk_modulus &&
         a.viscosity == b.viscosity && a.power_law_modulus == b.power_law_modulus &&
         a.power_law_exponent == b.power_law_exponent &&
         a.power_law_poissons_ratio == b.power_law_poissons_ratio &&
         std::equal(a.branches.begin(), a.branches.end(), b.branches.begin(), b.branches.end(),
                    is_same_branch) &&
         std::equal(a.bulk_branches.begin(), a.bulk_branches.end(), b.bulk_branches.begin(),
                    b.bulk_branches.end(), is_same_bulk_branch);
}
} // namespace

bool operator==(const TubeSection &a, const TubeSection &b)
{
  return a.inner_radius == b.inner_radius && a.tethered == b.tethered &&
         a.layer_thicknesses == b.layer_thicknesses && is_same(a.fluid, b.fluid) &&
         std::equal(a.layers.begin(), a.layers.end(), b.layers.begin(), b.layers.end(), is_same);
}

double TubeSection::wall_thickness() const
{
  double sum = 0.;
  for (const double thickness : layer_thicknesses)
    sum += thickness;
  return sum;
}

double TubeSection::wall_area() const
{
  const double thickness = wall_thickness();
  return dealii::numbers::PI * thickness * (2. * inner_radius + thickness);
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
