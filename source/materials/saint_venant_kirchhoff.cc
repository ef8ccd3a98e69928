#include <continua/materials/saint_venant_kirchhoff.h>

namespace Continua
{
using namespace dealii;

SaintVenantKirchhoff::SaintVenantKirchhoff(const double shear_modulus, const double lambda)
    : modulus(shear_modulus), lambda(lambda)
{
}

void SaintVenantKirchhoff::set_stress(const PointStrain &strain,
                                      SymmetricTensor<2, 3> &stress) const
{
  set_stress<double>(strain, stress);
}

void SaintVenantKirchhoff::set_tangent(const PointStrain &strain,
                                       SymmetricTensor<2, 3> &stress,
                                       SymmetricTensor<4, 3> &tangent) const
{
  set_tangent<double>(strain, stress, tangent);
}

double SaintVenantKirchhoff::energy(const PointStrain &strain) const
{
  const SymmetricTensor<2, 3> green = 0.5 * twice_green_strain(strain.gradient);
  return 0.5 * lambda * trace(green) * trace(green) + modulus * (green * green);
}

void SaintVenantKirchhoff::set_mean_stress(const PointStrain &strain,
                                           double &mean_stress,
                                           SymmetricTensor<2, 3> &derivative) const
{
  set_mean_stress<double>(strain, mean_stress, derivative);
}

void SaintVenantKirchhoff::set_stresses(const PointStrain &strain,
                                        SymmetricTensor<2, 3> &stress,
                                        double &mean_stress,
                                        SymmetricTensor<2, 3> &derivative) const
{
  set_stresses<double>(strain, stress, mean_stress, derivative);
}
} // namespace Continua
