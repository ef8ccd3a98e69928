#ifndef continua_finite_element_space_deformed_face_point_h
#define continua_finite_element_space_deformed_face_point_h

#include <continua/continuum/kinematics.h>
#include <continua/finite_element/space/space.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace Continua
{
/// A quadrature point of a face of a body in finite deformation, with the shape functions of one
/// component of the velocity of its cell. Displacements are those of the cell, component by
/// component [m].
template <int dim>
struct DeformedFacePoint
{
  dealii::Point<dim> place;  ///< undeformed [m]
  dealii::Tensor<1, 3> area; ///< N dA, undeformed, out of the body [m^2]
  double hoop = 0.;          ///< 1/R in axisymmetry, else 0 [1/m]
  std::vector<double> values;
  std::vector<dealii::Tensor<1, dim>> gradients; ///< by the undeformed place [1/m]

  unsigned int n_functions() const { return values.size(); }
  Kinematics kinematics(const dealii::Vector<double> &displacement) const;
  /// The value of a field with these entries in the cell, component by component.
  dealii::Tensor<1, dim> value_of(const dealii::Vector<double> &entries) const;
  /// The derivative of n da by the displacement of a shape function along each direction [m]; the
  /// motion and n da are those of the point.
  std::array<dealii::Tensor<1, 3>, dim> area_derivatives(const Kinematics &motion,
                                                         const dealii::Tensor<1, 3> &present_area,
                                                         unsigned int function) const;
};

/// The points of a face for which the values were made, with places, normals, weights, and values
/// and gradients of a scalar element.
template <int dim>
std::vector<DeformedFacePoint<dim>> deformed_face_points(const Space<dim> &space,
                                                         const dealii::FEFaceValues<dim> &values);
} // namespace Continua

#endif
