#ifndef continua_finite_element_terms_inflow_traction_h
#define continua_finite_element_terms_inflow_traction_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/finite_element/terms/flow_face_point.h>
#include <continua/finite_element/terms/tested_on_face.h>

namespace Continua
{
/**
 * -int v . rho(p)/2 min((U - W) . n, 0) U da
 *
 * at the open ends whose pressure is the total one where liquid flows in. What flows in along the
 * normal then has the pressure that is given less rho/2 U^2. With the skew form of convection it
 * takes the kinetic energy that the inflow would carry into the body, so that the energy of the
 * body is bounded (Bazilevs, Gohean, Hughes, Moser and Zhang, Comput. Methods Appl. Mech. Engrg.
 * 198 (2009) 3534; Bertoglio and Caiazzo, Comput. Mech. 54 (2014) 711). It is 0 where liquid flows
 * out.
 */
struct InflowTraction
{
  static constexpr PowerKind power = &NonlinearPowers::inflow;

  template <int dim>
  static void add(const FlowFacePoint<dim> &point, TestedOnFace<dim> &tested)
  {
    tested.by_value -= (0.5 * point.density * point.inflow()) * point.velocity;
  }
  template <int dim>
  static void add_derivative(const FlowFacePoint<dim> &point,
                             const FlowFaceChange<dim> &change,
                             TestedOnFace<dim> &tested)
  {
    tested.by_value -=
        0.5 * (point.density * (change.inflow * point.velocity + point.inflow() * change.velocity) +
               (change.density * point.inflow()) * point.velocity);
  }
};
} // namespace Continua

#endif
