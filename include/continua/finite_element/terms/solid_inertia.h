#ifndef continua_finite_element_terms_solid_inertia_h
#define continua_finite_element_terms_solid_inertia_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/finite_element/terms/solid_point.h>

namespace Continua
{
/// int rho0 v . dU/dt over the volume free of stress.
struct SolidInertia
{
  static constexpr PowerKind power = &NonlinearPowers::inertia;

  template <int dim, typename Number>
  static void add(const SolidPoint<dim, Number> &point, Tested<dim, Number> &tested)
  {
    tested.by_value += (point.scheme.density * point.mass_ratio) * point.acceleration;
  }
  template <int dim, typename Number>
  static void add_derivative(const SolidPoint<dim, Number> &point,
                             const SolidChange<dim, Number> &change,
                             Tested<dim, Number> &tested)
  {
    tested.by_value += (point.scheme.density * point.mass_ratio) * change.acceleration;
  }
  /// Per reference volume [J/m^3].
  template <int dim>
  static double energy(const SolidPoint<dim> &point)
  {
    return 0.5 * point.scheme.density * point.stress_free_ratio * point.velocity.norm_square();
  }
};
} // namespace Continua

#endif
