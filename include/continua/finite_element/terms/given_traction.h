#ifndef continua_finite_element_terms_given_traction_h
#define continua_finite_element_terms_given_traction_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/finite_element/terms/flow_face_point.h>
#include <continua/finite_element/terms/tested_on_face.h>

namespace Continua
{
/// -int v . t da over the present faces of a liquid on a mesh that moves, t the traction that is
/// given at the present place, or -p n of a cavity.
struct GivenTraction
{
  static constexpr PowerKind power = &NonlinearPowers::load;

  template <int dim>
  static void add(const FlowFacePoint<dim> &point, TestedOnFace<dim> &tested)
  {
    tested.by_value -= point.traction;
  }
  /// None: the mesh is held.
  template <int dim>
  static void
  add_derivative(const FlowFacePoint<dim> &, const FlowFaceChange<dim> &, TestedOnFace<dim> &)
  {
  }
};
} // namespace Continua

#endif
