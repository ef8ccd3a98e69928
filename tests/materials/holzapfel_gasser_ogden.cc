// Fibres along the axis of a tensile test by hand, fibres that are compressed, an isotropic family,
// and fibres that do not stiffen.

#include <continua/materials/holzapfel_gasser_ogden.h>
#include <continua/materials/neo_hookean.h>

#include "../unit_test.h"
#include "strain_at_point.h"

namespace test_of_holzapfel_gasser_ogden
{
using namespace Continua;
using namespace strain_at_point;

namespace
{
constexpr double mu_of_matrix = 1.3, k1 = 0.8, k2 = 1.5;

PointStrain uniaxial(const double l, const std::vector<dealii::Tensor<1, 3>> &fibres)
{
  Tensor2 f;
  f[0][0] = l;
  f[1][1] = f[2][2] = 1. / std::sqrt(l);
  return strain_of(f, fibres);
}

double axial_stress(const StrainLaw &law, const PointStrain &strain)
{
  Symmetric2 stress;
  law.set_stress(strain, stress);
  return stress[0][0] - stress[2][2];
}
} // namespace

UNIT_TEST(holzapfel_gasser_ogden)
{
  const double l = 1.2;
  const dealii::Tensor<1, 3> x({1., 0., 0.}), y({0., 1., 0.}), oblique({0.6, 0., 0.8});
  const NeoHookean matrix(mu_of_matrix);
  {
    const HolzapfelGasserOgden law(mu_of_matrix, k1, k2, 0.);
    const double e = l * l - 1.;
    check::relative("fibres along the axis", axial_stress(law, uniaxial(l, {x})),
                    mu_of_matrix * (l * l - 1. / l) + 2. * k1 * e * std::exp(k2 * e * e) * l * l,
                    1e-14);
    check::relative("both families add", axial_stress(law, uniaxial(l, {x, x})),
                    mu_of_matrix * (l * l - 1. / l) + 4. * k1 * e * std::exp(k2 * e * e) * l * l,
                    1e-14);
    check::relative("energy", law.energy(uniaxial(l, {x})),
                    matrix.energy(uniaxial(l, {})) + k1 / (2. * k2) * (std::exp(k2 * e * e) - 1.),
                    1e-14);
    check::relative("fibres across bear nothing", axial_stress(law, uniaxial(l, {y})),
                    axial_stress(matrix, uniaxial(l, {})), 1e-15);
    check::relative("fibres along bear no pressure", axial_stress(law, uniaxial(0.8, {x})),
                    axial_stress(matrix, uniaxial(0.8, {})), 1e-15);
    check::relative("energy of fibres that are compressed", law.energy(uniaxial(0.8, {x})),
                    matrix.energy(uniaxial(0.8, {})), 1e-15);
    Symmetric2 stress, of_matrix;
    dealii::SymmetricTensor<4, 3> tangent, tangent_of_matrix;
    law.set_tangent(uniaxial(l, {y}), stress, tangent);
    matrix.set_tangent(uniaxial(l, {}), of_matrix, tangent_of_matrix);
    check::absolute("tangent with them", (tangent - tangent_of_matrix).norm(), 0., 1e-14);
  }
  {
    // E = (tr Bb - 3)/3 does not depend on the direction.
    const HolzapfelGasserOgden law(mu_of_matrix, k1, k2, 1. / 3.);
    const double e = (l * l + 2. / l - 3.) / 3.;
    for (const dealii::Tensor<1, 3> &direction : {x, y, oblique})
      check::relative("isotropic family", axial_stress(law, uniaxial(l, {direction})),
                      (mu_of_matrix + 2. / 3. * k1 * e * std::exp(k2 * e * e)) * (l * l - 1. / l),
                      1e-13);
  }
  {
    const HolzapfelGasserOgden constant(mu_of_matrix, k1, 0., 0.1),
        nearly(mu_of_matrix, k1, 1e-12, 0.1);
    check::relative("fibres that do not stiffen: stress",
                    axial_stress(constant, uniaxial(l, {oblique})),
                    axial_stress(nearly, uniaxial(l, {oblique})), 1e-11);
    check::relative("fibres that do not stiffen: energy", constant.energy(uniaxial(l, {oblique})),
                    nearly.energy(uniaxial(l, {oblique})), 1e-11);
  }
}
} // namespace test_of_holzapfel_gasser_ogden
