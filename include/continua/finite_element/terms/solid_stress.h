#ifndef continua_finite_element_terms_solid_stress_h
#define continua_finite_element_terms_solid_stress_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/finite_element/terms/solid_point.h>

namespace Continua
{
/// int tau : grad v, tau the deviatoric Kirchhoff stress of law and branches by the volume free of
/// stress.
struct SolidStress
{
  static constexpr PowerKind power = &NonlinearPowers::strain;

  template <int dim, typename Number>
  static void add(const SolidPoint<dim, Number> &point, Tested<dim, Number> &tested)
  {
    point.add_stress(point.stress, tested);
  }
  template <int dim, typename Number>
  static void add_derivative(const SolidPoint<dim, Number> &point,
                             const SolidChange<dim, Number> &change,
                             Tested<dim, Number> &tested)
  {
    const auto stress = static_cast<dealii::Tensor<2, 3, Number>>(point.stress);
    // d tau = C : e + g tau + tau g^T, less tau g^T of the gradient of v by a place that moves.
    auto acting =
        static_cast<dealii::Tensor<2, 3, Number>>(point.tangent * symmetrize(change.elastic)) +
        change.elastic * stress;
    if (point.unloading != nullptr)
      acting += stress * transpose(change.elastic) + change.stress_free_ratio * stress;
    point.add_stress(acting, tested);
  }
};
} // namespace Continua

#endif
