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
  const auto is_same_law =
      [](const std::optional<PowerLaw> &one, const std::optional<PowerLaw> &other)
  {
    return one.has_value() == other.has_value() &&
           (!one || (one->modulus == other->modulus && one->exponent == other->exponent &&
                     one->poissons_ratio == other->poissons_ratio));
  };
  const std::vector<Branch> &branches = a.shear.branches, &other_branches = b.shear.branches;
  const std::vector<BulkBranch> &bulk_branches = a.compression.bulk_branches(),
                                &other_bulk_branches = b.compression.bulk_branches();
  return a.density == b.density && a.inverse_bulk_modulus() == b.inverse_bulk_modulus() &&
         a.shear.viscosity == b.shear.viscosity &&
         is_same_law(a.shear.power_law, b.shear.power_law) &&
         std::equal(branches.begin(), branches.end(), other_branches.begin(), other_branches.end(),
                    is_same_branch) &&
         std::equal(bulk_branches.begin(), bulk_branches.end(), other_bulk_branches.begin(),
                    other_bulk_branches.end(), is_same_bulk_branch);
}
} // namespace

bool operator==(const TubeSection &a, const TubeSection &b)
{
  return a.inner_radius == b.inner_radius && a.mean_pressure == b.mean_pressure &&
         a.tethered == b.tethered && a.radial_stiffness == b.radial_stiffness &&
         a.radial_damping == b.radial_damping && a.axial_stiffness == b.axial_stiffness &&
         a.axial_damping == b.axial_damping && a.layer_thicknesses == b.layer_thicknesses &&
         is_same(a.fluid, b.fluid) &&
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
  return layers.empty() ? 0. : sum / wall_thickness();
}

std::complex<double> TubeSection::radial_support(const std::complex<double> &omega) const
{
  return radial_stiffness + std::complex<double>(0., 1.) * omega * radial_damping;
}

std::complex<double> TubeSection::axial_support(const std::complex<double> &omega) const
{
  return axial_stiffness + std::complex<double>(0., 1.) * omega * axial_damping;
}

std::complex<double> TubeSection::hoop_modulus(const std::complex<double> &omega) const
{
  if (layers.empty())
    return 0.;
  const std::complex<double> support = radial_support(omega), of_wall = membrane_modulus(omega);
  if (support == 0.)
    return of_wall;
  // p R = E h/psi u/R + k (R + h) u, where psi is that of the wall's axial hold.
  const std::complex<double> nu = poisson_ratio(omega), psi = tethered ? 1. - nu * nu : 1.;
  const double thickness = wall_thickness();
  return of_wall + psi * support * inner_radius * (inner_radius + thickness) / thickness;
}

double TubeSection::wall_density() const
{
  double sum = 0.;
  for (unsigned int i = 0; i < layers.size(); ++i)
    sum += layers[i].density * layer_thicknesses[i];
  return layers.empty() ? 0. : sum / wall_thickness();
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
  return layers.empty() ? 0. : sum / weights;
}
} // namespace Continua
