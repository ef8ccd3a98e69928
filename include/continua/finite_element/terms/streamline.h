#ifndef continua_finite_element_terms_streamline_h
#define continua_finite_element_terms_streamline_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/finite_element/terms/flow_point.h>
#include <continua/finite_element/terms/tested.h>

namespace Continua
{
/// A liquid at a point with what Streamline needs besides.
template <int dim, typename Number = double>
struct StreamlinePoint : FlowPoint<dim, Number>
{
  dealii::Tensor<1, dim, Number> viscous_force; ///< eta (lap U + 1/3 grad div U) [N/m^3]
  dealii::Tensor<1, dim, Number> body_force;    ///< rho0 b [N/m^3]
  Number time_scale = 0.;                       ///< tau [s]
  Number time_scale_slope = 0.; ///< d tau = that times what carries . its change [s^3/m^2]
};

/**
 * The streamline-upwind Petrov-Galerkin term of the momentum equation (A. N. Brooks, T. J. R.
 * Hughes, Comput. Methods Appl. Mech. Engrg. 32 (1982) 199-259),
 *
 *   int tau ((U . grad) v) . r,
 *   r = rho (dU/dt + (U . grad) U) - eta (lap U + 1/3 grad div U) + grad p - rho0 b,
 *
 * the residual inside the cell, with the viscosity eta of a newtonian liquid and what carries in
 * the place of both U that carry. It vanishes for the exact solution.
 */
struct Streamline
{
  static constexpr PowerKind power = &NonlinearPowers::stabilisation;

  template <int dim, typename Number>
  static void add(const StreamlinePoint<dim, Number> &point, Tested<dim, Number> &tested)
  {
    tested.by_gradient += outer_product(point.time_scale * residual(point), point.carrier);
  }
  template <int dim, typename Number>
  static void add_derivative(const StreamlinePoint<dim, Number> &point,
                             const FlowChange<dim, Number> &change,
                             Tested<dim, Number> &tested)
  {
    const dealii::Tensor<1, dim, Number> here = residual(point);
    const dealii::Tensor<1, dim, Number> residual_change =
        point.density * (change.acceleration + change.velocity_gradient * point.carrier +
                         point.velocity_gradient * change.carrier) +
        change.density * (point.acceleration + point.velocity_gradient * point.carrier) +
        change.pressure_gradient - change.viscous_force;
    const Number time_change = point.time_scale_slope * (point.carrier * change.carrier);
    tested.by_gradient +=
        outer_product(point.time_scale * residual_change + time_change * here, point.carrier) +
        outer_product(point.time_scale * here, change.carrier);
  }

private:
  template <int dim, typename Number>
  static dealii::Tensor<1, dim, Number> residual(const StreamlinePoint<dim, Number> &point)
  {
    return point.density * (point.acceleration + point.velocity_gradient * point.carrier) +
           point.pressure_gradient - point.viscous_force - point.body_force;
  }
};
} // namespace Continua

#endif
