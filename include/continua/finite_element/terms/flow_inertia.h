#ifndef continua_finite_element_terms_flow_inertia_h
#define continua_finite_element_terms_flow_inertia_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/finite_element/terms/flow_point.h>
#include <continua/finite_element/terms/tested.h>

namespace Continua
{
/// int rho(p) v . dU/dt.
struct FlowInertia
{
  static constexpr PowerKind power = &NonlinearPowers::inertia;

  template <int dim, typename Number>
  static void add(const FlowPoint<dim, Number> &point, Tested<dim, Number> &tested)
  {
    tested.by_value += point.density * point.acceleration;
  }
  template <int dim, typename Number>
  static void add_derivative(const FlowPoint<dim, Number> &point,
                             const FlowChange<dim, Number> &change,
                             Tested<dim, Number> &tested)
  {
    tested.by_value += point.density * change.acceleration + change.density * point.acceleration;
  }
  /// Per volume [J/m^3].
  template <int dim, typename Number>
  static Number energy(const FlowPoint<dim, Number> &point)
  {
    return 0.5 * point.density * point.velocity.norm_square();
  }
};
} // namespace Continua

#endif
