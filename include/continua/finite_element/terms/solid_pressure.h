#ifndef continua_finite_element_terms_solid_pressure_h
#define continua_finite_element_terms_solid_pressure_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/finite_element/terms/solid_point.h>

namespace Continua
{
/// -int J p div v.
struct SolidPressure
{
  static constexpr PowerKind power = &NonlinearPowers::compression;

  template <int dim, typename Number>
  static void add(const SolidPoint<dim, Number> &point, Tested<dim, Number> &tested)
  {
    const Number scaled = point.volume_ratio() * point.pressure;
    point.add_stress(-scaled * unit<Number>(), tested);
  }
  template <int dim, typename Number>
  static void add_derivative(const SolidPoint<dim, Number> &point,
                             const SolidChange<dim, Number> &change,
                             Tested<dim, Number> &tested)
  {
    const Number scaled = point.volume_ratio() * point.pressure,
                 scaled_change = point.volume_ratio() * change.pressure;
    point.add_stress(scaled * transpose(change.moved) -
                         (scaled * trace(change.moved) + scaled_change) * unit<Number>(),
                     tested);
  }

private:
  template <typename Number>
  static dealii::Tensor<2, 3, Number> unit()
  {
    return dealii::unit_symmetric_tensor<3, Number>();
  }
};
} // namespace Continua

#endif
