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

  template <int dim>
  static void add(const SolidPoint<dim> &point, Tested<dim> &tested)
  {
    const double scaled = point.volume_ratio() * point.pressure;
    point.add_stress(-scaled * unit(), tested);
  }
  template <int dim>
  static void
  add_derivative(const SolidPoint<dim> &point, const SolidChange<dim> &change, Tested<dim> &tested)
  {
    const double scaled = point.volume_ratio() * point.pressure,
                 scaled_change = point.volume_ratio() * change.pressure;
    point.add_stress(scaled * transpose(change.moved) -
                         (scaled * trace(change.moved) + scaled_change) * unit(),
                     tested);
  }

private:
  static dealii::Tensor<2, 3> unit() { return dealii::unit_symmetric_tensor<3>(); }
};
} // namespace Continua

#endif
