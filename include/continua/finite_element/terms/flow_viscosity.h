#ifndef continua_finite_element_terms_flow_viscosity_h
#define continua_finite_element_terms_flow_viscosity_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/finite_element/terms/flow_point.h>
#include <continua/finite_element/terms/tested.h>

namespace Continua
{
/// int 2 eta dev sym grad U : grad v, with eta of the material or of its FlowCurve.
struct FlowViscosity
{
  static constexpr PowerKind power = &NonlinearPowers::viscosity;

  template <int dim, typename Number>
  static void add(const FlowPoint<dim, Number> &point, Tested<dim, Number> &tested)
  {
    const Number factor = 2. * point.viscosity;
    tested.add_stress(factor * point.strain_rate, factor * point.across, point.hoop);
  }
  template <int dim, typename Number>
  static void add_derivative(const FlowPoint<dim, Number> &point,
                             const FlowChange<dim, Number> &change,
                             Tested<dim, Number> &tested)
  {
    dealii::Tensor<2, dim, Number> rate;
    Number across = 0.;
    FlowPoint<dim, Number>::set_deviator(change.velocity_gradient, change.divergence,
                                         point.hoop * change.velocity[1], rate, across);
    // d eta = (d eta/d g)/g * 2 dev D : d dev D.
    const Number along = 4. * point.viscosity_slope *
                         (scalar_product(point.strain_rate, rate) + point.across * across);
    const Number factor = 2. * point.viscosity;
    tested.add_stress(factor * rate + along * point.strain_rate,
                      factor * across + along * point.across, point.hoop);
  }
};
} // namespace Continua

#endif
