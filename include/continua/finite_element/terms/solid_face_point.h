#ifndef continua_finite_element_terms_solid_face_point_h
#define continua_finite_element_terms_solid_face_point_h

#include <continua/continuum/kinematics.h>
#include <continua/finite_element/terms/point_change.h>

#include <deal.II/base/tensor.h>

namespace Continua
{
/// The state of a solid in finite deformation at a point of a face. Integrals are over the
/// undeformed face.
template <int dim>
struct SolidFacePoint
{
  Kinematics kinematics;                ///< F = I + Grad D
  double weight = 0.;                   ///< dA of the point, undeformed [m^2]
  dealii::Tensor<1, 3> area;            ///< n da over dA, n out of the body [1]
  double hoop = 0.;                     ///< 1/r of the present place in axisymmetry, else 0 [1/m]
  double displacement_by_velocity = 0.; ///< b = dD/dU [s]
  double pressure = 0.;                 ///< on the face: given, or of a cavity [Pa]

  explicit SolidFacePoint(const Kinematics &kinematics) : kinematics(kinematics) {}
};

/// What follows there from a change of the unknowns.
template <int dim>
struct SolidFaceChange
{
  dealii::Tensor<1, 3> area; ///< of n da over dA

  SolidFaceChange(const SolidFacePoint<dim> &point, const PointChange<dim> &change)
  {
    // d(n da) = div(dD) n da - (grad dD)^T n da.
    const dealii::Tensor<2, 3> moved =
        point.displacement_by_velocity *
        whole_gradient<dim>(change.velocity_gradient, point.hoop * change.velocity[1]);
    area = trace(moved) * point.area - point.area * moved;
  }
};
} // namespace Continua

#endif
