#ifndef continua_finite_element_terms_flow_pressure_h
#define continua_finite_element_terms_flow_pressure_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/finite_element/terms/flow_point.h>
#include <continua/finite_element/terms/tested.h>

namespace Continua
{
/// -int p div v.
struct FlowPressure
{
  static constexpr PowerKind power = &NonlinearPowers::compression;

  template <int dim, typename Number>
  static void add(const FlowPoint<dim, Number> &point, Tested<dim, Number> &tested)
  {
    tested.add_mean_stress(-point.pressure, point.hoop);
  }
  template <int dim, typename Number>
  static void add_derivative(const FlowPoint<dim, Number> &point,
                             const FlowChange<dim, Number> &change,
                             Tested<dim, Number> &tested)
  {
    tested.add_mean_stress(-change.pressure, point.hoop);
  }
};
} // namespace Continua

#endif
