#ifndef continua_finite_element_terms_mesh_stress_h
#define continua_finite_element_terms_mesh_stress_h

#include <continua/continuum/kinematics.h>
#include <continua/finite_element/terms/point_change.h>
#include <continua/finite_element/terms/tested.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <cmath>

namespace Continua
{
/// The mesh of the liquids as a body, at a point of the undeformed mesh. Its unknown is the
/// displacement of the mesh, in the place of the velocity of a PointChange. `Number`: double, or
/// several points at once.
template <typename Number = double>
struct MeshPoint
{
  bool is_hyperelastic = true;
  dealii::Tensor<2, 3, Number> displacement_gradient; ///< Grad d [1]
  Number hoop = 0.;                                   ///< 1/R in axisymmetry, else 0 [1/m]
  dealii::Tensor<2, 3, Number> inverse;               ///< (1 + Grad d)^-1 [1]
};

/**
 * int P : Grad z, the equilibrium of MeshMotion's body for k = 1: elastic
 * P = Grad d + (Grad d)^T + 2 div d 1, hyperelastic P = F - F^-T. P has no unit.
 */
struct MeshStress
{
  template <int dim, typename Number>
  static void add(const MeshPoint<Number> &point, Tested<dim, Number> &tested)
  {
    const dealii::Tensor<2, 3, Number> &gradient = point.displacement_gradient;
    add_stress(point,
               point.is_hyperelastic ? gradient + unit<Number>() - transpose(point.inverse)
                                     : elastic_stress(gradient),
               tested);
  }
  template <int dim, typename Number>
  static void add_derivative(const MeshPoint<Number> &point,
                             const PointChange<dim, Number> &change,
                             Tested<dim, Number> &tested)
  {
    const Number of_circle = point.hoop * change.velocity[1];
    const dealii::Tensor<2, 3, Number> gradient =
        whole_gradient(change.velocity_gradient, of_circle);
    add_stress(point,
               point.is_hyperelastic
                   ? gradient + transpose(point.inverse * gradient * point.inverse)
                   : elastic_stress(gradient),
               tested);
  }
  /// As that of Kinematics.
  template <int dim, typename Number>
  static dealii::Tensor<2, 3, Number> whole_gradient(const dealii::Tensor<2, dim, Number> &gradient,
                                                     const Number &of_circle)
  {
    dealii::Tensor<2, 3, Number> result;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        result[c][d] = gradient[c][d];
    if (dim == 2)
      result[2][2] = of_circle;
    return result;
  }
  /// (tr C - 2 ln J)/2, whose derivative by F is the hyperelastic P.
  static double energy(const MeshPoint<> &point)
  {
    const Kinematics kinematics(point.displacement_gradient);
    return 0.5 * kinematics.deformation_gradient().norm_square() -
           std::log(kinematics.volume_ratio());
  }

private:
  template <typename Number>
  static dealii::Tensor<2, 3, Number> unit()
  {
    return dealii::unit_symmetric_tensor<3, Number>();
  }
  template <typename Number>
  static dealii::Tensor<2, 3, Number> elastic_stress(const dealii::Tensor<2, 3, Number> &gradient)
  {
    const Number mean = 2. * trace(gradient);
    return gradient + transpose(gradient) + mean * unit<Number>();
  }
  template <int dim, typename Number>
  static void add_stress(const MeshPoint<Number> &point,
                         const dealii::Tensor<2, 3, Number> &stress,
                         Tested<dim, Number> &tested)
  {
    dealii::Tensor<2, dim, Number> plane;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        plane[c][d] = stress[c][d];
    tested.add_stress(plane, stress[2][2], point.hoop);
  }
};
} // namespace Continua

#endif
