#ifndef continua_finite_element_terms_solid_volume_h
#define continua_finite_element_terms_solid_volume_h

#include <continua/base/of_each.h>
#include <continua/continuum/nonlinear_terms.h>
#include <continua/finite_element/terms/solid_point.h>

#include <cmath>

namespace Continua
{
/**
 * The row of volume, int q (1/b) ( ln(J/det F0) + p/K ) J dV; as a rate, int q ( div U + (dp/dt)/K
 * ) J dV. A law with a mean stress s of its own has (p + s)/K in the place of ln(J/det F0) + p/K.
 */
struct SolidVolume
{
  static constexpr PowerKind power = nullptr;

  template <int dim, typename Number>
  static void add(const SolidPoint<dim, Number> &point, Tested<dim, Number> &tested)
  {
    tested.of_volume += point.volume_ratio() * row(point);
  }
  template <int dim, typename Number>
  static void add_derivative(const SolidPoint<dim, Number> &point,
                             const SolidChange<dim, Number> &change,
                             Tested<dim, Number> &tested)
  {
    const SolidScheme &scheme = point.scheme;
    const double b = scheme.displacement_by_velocity;
    Number row_change = scheme.inverse_bulk_modulus *
                        (scheme.volume_is_rate ? change.pressure_rate : change.pressure / b);
    if (scheme.has_own_mean_stress)
      // As a rate without the change of the slope itself, which the rate multiplies.
      row_change +=
          scheme.inverse_bulk_modulus *
          (point.mean_stress_slope * (scheme.volume_is_rate ? symmetrize(change.velocity_gradient)
                                                            : symmetrize(change.elastic) / b));
    else if (scheme.volume_is_rate)
      row_change += trace(change.velocity_gradient);
    else
      row_change += (trace(change.moved) - change.stress_free_ratio) / b;
    tested.of_volume += point.volume_ratio() * (row_change + trace(change.moved) * row(point));
  }

private:
  /// [1/s].
  template <int dim, typename Number>
  static Number row(const SolidPoint<dim, Number> &point)
  {
    const SolidScheme &scheme = point.scheme;
    const Number of_pressure =
        scheme.inverse_bulk_modulus * (scheme.volume_is_rate
                                           ? point.pressure_rate
                                           : point.pressure / scheme.displacement_by_velocity);
    if (scheme.has_own_mean_stress)
      return of_pressure + scheme.inverse_bulk_modulus *
                               (scheme.volume_is_rate
                                    ? point.mean_stress_slope * symmetrize(point.velocity_gradient)
                                    : point.mean_stress / scheme.displacement_by_velocity);
    if (scheme.volume_is_rate)
      return of_pressure + trace(point.velocity_gradient);
    return of_pressure + (of_each([](const double change) { return std::log1p(change); },
                                  point.kinematics.volume_change()) -
                          std::log(point.stress_free_ratio)) /
                             scheme.displacement_by_velocity;
  }
};
} // namespace Continua

#endif
