#include <continua/network/wall_material.h>

#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
/// Of complex moduli, for materials whose Poisson's ratio is the same at all times.
constexpr double tolerance = 1e-9;
} // namespace

WallMaterial WallMaterial::of(const Material &material)
{
  if (!material.is_solid())
    throw std::domain_error("is a liquid");
  if (material.has_power_law())
    throw std::domain_error("relaxes by a power law, and a vessel by branches");
  if (material.strain_law)
    throw std::domain_error("has a law of finite deformation");
  const double shear_modulus = material.long_term_shear_modulus(),
               mu_over_bulk = shear_modulus * material.long_term_inverse_bulk_modulus();
  if (!(shear_modulus > 0.))
    throw std::domain_error("has no spring that never relaxes");
  WallMaterial wall;
  wall.youngs_modulus = 9. * shear_modulus / (3. + mu_over_bulk);
  wall.poissons_ratio = 0.5 * wall.youngs_modulus / shear_modulus - 1.;
  wall.relaxation.damping_time = material.shear.viscosity / shear_modulus;
  for (const Branch &branch : material.shear.branches)
    if (std::isfinite(branch.relaxation_time))
      wall.relaxation.branches.push_back(
          {branch.shear_modulus / shear_modulus, branch.relaxation_time});
  // With another Poisson's ratio at another time Young's modulus has other branches.
  for (const double omega : {1e-2, 1., 1e2, 1e4})
  {
    const std::complex<double> shear = material.complex_shear_modulus(omega),
                               expected = shear / shear_modulus * wall.youngs_modulus;
    if (std::abs(material.complex_young_modulus(omega) - expected) > tolerance * std::abs(expected))
      throw std::domain_error("has a Poisson's ratio that depends on time");
  }
  return wall;
}
} // namespace Continua
