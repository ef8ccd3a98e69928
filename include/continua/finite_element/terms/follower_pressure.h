#ifndef continua_finite_element_terms_follower_pressure_h
#define continua_finite_element_terms_follower_pressure_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/finite_element/terms/solid_face_point.h>
#include <continua/finite_element/terms/tested_on_face.h>

namespace Continua
{
/**
 * int v . p n da,   n da = J F^-T N dA:
 *
 * a pressure on a solid in finite deformation, which follows its face. One that is given and
 * depends on the place has that of the undeformed place.
 */
struct FollowerPressure
{
  static constexpr PowerKind power = &NonlinearPowers::load;

  template <int dim>
  static void add(const SolidFacePoint<dim> &point, TestedOnFace<dim> &tested)
  {
    add_pressure(point.pressure, point.area, tested);
  }
  template <int dim>
  static void add_derivative(const SolidFacePoint<dim> &point,
                             const SolidFaceChange<dim> &change,
                             TestedOnFace<dim> &tested)
  {
    add_pressure(point.pressure, change.area, tested);
  }

private:
  template <int dim>
  static void
  add_pressure(const double pressure, const dealii::Tensor<1, 3> &area, TestedOnFace<dim> &tested)
  {
    for (unsigned int c = 0; c < dim; ++c)
      tested.by_value[c] += pressure * area[c];
  }
};
} // namespace Continua

#endif
