#ifndef continua_finite_element_terms_grad_div_h
#define continua_finite_element_terms_grad_div_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/finite_element/terms/flow_point.h>
#include <continua/finite_element/terms/tested.h>

#include <algorithm>
#include <limits>

namespace Continua
{
/// int gamma m div v, with gamma = gamma_0 + gamma_1 |U| (Convection): it vanishes for the exact
/// solution, whose source m is 0.
struct GradDiv
{
  static constexpr PowerKind power = &NonlinearPowers::stabilisation;

  template <int dim, typename Number>
  static void add(const FlowPoint<dim, Number> &point, Tested<dim, Number> &tested)
  {
    tested.add_mean_stress(point.gamma() * point.source, point.hoop);
  }
  template <int dim, typename Number>
  static void add_derivative(const FlowPoint<dim, Number> &point,
                             const FlowChange<dim, Number> &change,
                             Tested<dim, Number> &tested)
  {
    // At rest the speed has no derivative: there U . dU is 0.
    const Number speed =
        std::max(point.velocity.norm(), Number(std::numeric_limits<double>::min()));
    const Number speed_change = point.velocity * change.velocity / speed;
    tested.add_mean_stress(point.gamma() * change.source +
                               point.grad_div_over_speed * speed_change * point.source,
                           point.hoop);
  }
};
} // namespace Continua

#endif
