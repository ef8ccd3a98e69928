#ifndef continua_finite_element_terms_flow_volume_h
#define continua_finite_element_terms_flow_volume_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/finite_element/terms/flow_point.h>
#include <continua/finite_element/terms/tested.h>

namespace Continua
{
/// The row of volume, int q m with m = c(p) (dp/dt + U . grad p) + div U: the balance of mass over
/// the density.
struct FlowVolume
{
  static constexpr PowerKind power = nullptr;

  template <int dim, typename Number>
  static void add(const FlowPoint<dim, Number> &point, Tested<dim, Number> &tested)
  {
    tested.of_volume += point.source;
  }
  template <int dim, typename Number>
  static void add_derivative(const FlowPoint<dim, Number> & /*point*/,
                             const FlowChange<dim, Number> &change,
                             Tested<dim, Number> &tested)
  {
    tested.of_volume += change.source;
  }
};
} // namespace Continua

#endif
