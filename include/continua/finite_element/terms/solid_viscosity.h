#ifndef continua_finite_element_terms_solid_viscosity_h
#define continua_finite_element_terms_solid_viscosity_h

#include <continua/base/deviatoric_part.h>
#include <continua/continuum/nonlinear_terms.h>
#include <continua/finite_element/terms/solid_point.h>

namespace Continua
{
/// int J 2 eta dev sym grad U : grad v.
struct SolidViscosity
{
  static constexpr PowerKind power = &NonlinearPowers::viscosity;

  template <int dim, typename Number>
  static void add(const SolidPoint<dim, Number> &point, Tested<dim, Number> &tested)
  {
    if (point.scheme.viscosity != 0.)
      point.add_stress(point.viscous_stress(), tested);
  }
  template <int dim, typename Number>
  static void add_derivative(const SolidPoint<dim, Number> &point,
                             const SolidChange<dim, Number> &change,
                             Tested<dim, Number> &tested)
  {
    if (point.scheme.viscosity == 0.)
      return;
    const auto stress = static_cast<dealii::Tensor<2, 3, Number>>(point.viscous_stress());
    const dealii::SymmetricTensor<2, 3, Number> of_rate =
        (2. * point.scheme.viscosity * point.volume_ratio()) *
        deviatoric_part(symmetrize(change.velocity_gradient));
    point.add_stress(static_cast<dealii::Tensor<2, 3, Number>>(of_rate) +
                         trace(change.moved) * stress - stress * transpose(change.moved),
                     tested);
  }
};
} // namespace Continua

#endif
