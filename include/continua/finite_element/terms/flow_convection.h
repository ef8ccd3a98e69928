#ifndef continua_finite_element_terms_flow_convection_h
#define continua_finite_element_terms_flow_convection_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/finite_element/terms/flow_point.h>
#include <continua/finite_element/terms/tested.h>

namespace Continua
{
/**
 * int v . rho(p) ( (U . grad) U + s m U ), with what carries in the place of the first U and the
 * source m of the row of volume; s is 1/2 in the skew form and 0 in the convective one. Temam
 * (1968) has the skew form of an incompressible liquid; with m in the place of div U it holds for
 * any law of the density: the power of inertia and convection is d/dt int rho/2 U^2 + the flux of
 * rho/2 U^2 through the boundary.
 */
struct FlowConvection
{
  static constexpr PowerKind power = &NonlinearPowers::convection;

  template <int dim, typename Number>
  static void add(const FlowPoint<dim, Number> &point, Tested<dim, Number> &tested)
  {
    tested.by_value += point.density * (point.velocity_gradient * point.carrier +
                                        (point.scheme.skew * point.source) * point.velocity);
  }
  template <int dim, typename Number>
  static void add_derivative(const FlowPoint<dim, Number> &point,
                             const FlowChange<dim, Number> &change,
                             Tested<dim, Number> &tested)
  {
    const Number skew_source = point.scheme.skew * point.source;
    tested.by_value +=
        point.density *
            (change.velocity_gradient * point.carrier + point.velocity_gradient * change.carrier +
             skew_source * change.velocity + (point.scheme.skew * change.source) * point.velocity) +
        change.density * (point.velocity_gradient * point.carrier + skew_source * point.velocity);
  }
};
} // namespace Continua

#endif
