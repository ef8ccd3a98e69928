#include <continua/materials/saint_venant_kirchhoff.h>

#include <continua/materials/isochoric_strain.h>
#include <continua/materials/isochoric_stress.h>

namespace Continua
{
using namespace dealii;

namespace
{
SymmetricTensor<2, 3> left_strain(const PointStrain &strain)
{
  return symmetrize(strain.gradient * transpose(strain.gradient));
}

/// tr T changes by this times e: 1 : c + 2 T, where T changes by c : e + g T + T g^T and
/// c : e = lambda b (b : e) + 2 mu b e b.
SymmetricTensor<2, 3> trace_derivative(const SymmetricTensor<2, 3> &b,
                                       const SymmetricTensor<2, 3> &whole_stress,
                                       const double modulus,
                                       const double lambda)
{
  return lambda * trace(b) * b + 2. * modulus * square(b) + 2. * whole_stress;
}
} // namespace

SaintVenantKirchhoff::SaintVenantKirchhoff(const double shear_modulus, const double lambda)
    : modulus(shear_modulus), lambda(lambda)
{
}

SymmetricTensor<2, 3> SaintVenantKirchhoff::whole_stress(const PointStrain &strain) const
{
  const SymmetricTensor<2, 3> twice = twice_green_strain(strain.gradient);
  const SymmetricTensor<2, 3> material =
      0.5 * lambda * trace(twice) * unit_symmetric_tensor<3>() + modulus * twice;
  return symmetrize(strain.gradient * material * transpose(strain.gradient));
}

void SaintVenantKirchhoff::set_stress(const PointStrain &strain,
                                      SymmetricTensor<2, 3> &stress) const
{
  stress = deviator(whole_stress(strain));
}

void SaintVenantKirchhoff::set_tangent(const PointStrain &strain,
                                       SymmetricTensor<2, 3> &stress,
                                       SymmetricTensor<4, 3> &tangent) const
{
  const SymmetricTensor<2, 3> b = left_strain(strain), whole = whole_stress(strain);
  stress = deviator(whole);
  // What the mean of T takes from g T + T g^T comes back, and the mean itself changes.
  tangent =
      lambda * dyadic_product(b, b) + 2. * modulus * both_sides_product(b) +
      2. / 3. * trace(whole) * identity_tensor<3>() -
      1. / 3. *
          dyadic_product(unit_symmetric_tensor<3>(), trace_derivative(b, whole, modulus, lambda));
}

double SaintVenantKirchhoff::energy(const PointStrain &strain) const
{
  const SymmetricTensor<2, 3> green = 0.5 * twice_green_strain(strain.gradient);
  return 0.5 * lambda * trace(green) * trace(green) + modulus * (green * green);
}

void SaintVenantKirchhoff::set_mean_of(const SymmetricTensor<2, 3> &whole,
                                       const PointStrain &strain,
                                       double &mean_stress,
                                       SymmetricTensor<2, 3> &derivative) const
{
  mean_stress = trace(whole) / (3. * strain.determinant);
  derivative = 1. / (3. * strain.determinant) *
                   trace_derivative(left_strain(strain), whole, modulus, lambda) -
               mean_stress * unit_symmetric_tensor<3>();
}

void SaintVenantKirchhoff::set_mean_stress(const PointStrain &strain,
                                           double &mean_stress,
                                           SymmetricTensor<2, 3> &derivative) const
{
  set_mean_of(whole_stress(strain), strain, mean_stress, derivative);
}

void SaintVenantKirchhoff::set_stresses(const PointStrain &strain,
                                        SymmetricTensor<2, 3> &stress,
                                        double &mean_stress,
                                        SymmetricTensor<2, 3> &derivative) const
{
  const SymmetricTensor<2, 3> whole = whole_stress(strain);
  stress = deviator(whole);
  set_mean_of(whole, strain, mean_stress, derivative);
}
} // namespace Continua
