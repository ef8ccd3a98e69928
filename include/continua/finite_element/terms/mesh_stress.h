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
/// The mesh of the liquids as a body, at a point of the mesh at rest. Its unknown is the
/// displacement of the mesh, in the place of the velocity of a PointChange.
struct MeshPoint
{
  bool is_hyperelastic = true;
  dealii::Tensor<2, 3> displacement_gradient; ///< Grad d [1]
  double hoop = 0.;                           ///< 1/R in axisymmetry, else 0 [1/m]
  dealii::Tensor<2, 3> inverse;               ///< (1 + Grad d)^-1 [1]
};

/**
 * int P : Grad z, the equilibrium of MeshMotion's body for k = 1: elastic
 * P = Grad d + (Grad d)^T + 2 div d 1, hyperelastic P = F - F^-T. P has no unit.
 */
struct MeshStress
{
  template <int dim>
  static void add(const MeshPoint &point, Tested<dim> &tested)
  {
    const dealii::Tensor<2, 3> &gradient = point.displacement_gradient;
    add_stress(point,
               point.is_hyperelastic ? gradient + unit() - transpose(point.inverse)
                                     : elastic_stress(gradient),
               tested);
  }
  template <int dim>
  static void
  add_derivative(const MeshPoint &point, const PointChange<dim> &change, Tested<dim> &tested)
  {
    const dealii::Tensor<2, 3> gradient =
        whole_gradient<dim>(change.velocity_gradient, point.hoop * change.velocity[1]);
    add_stress(point,
               point.is_hyperelastic
                   ? gradient + transpose(point.inverse * gradient * point.inverse)
                   : elastic_stress(gradient),
               tested);
  }
  /// (tr C - 2 ln J)/2, whose derivative by F is the hyperelastic P.
  static double energy(const MeshPoint &point)
  {
    const Kinematics kinematics(point.displacement_gradient);
    return 0.5 * kinematics.deformation_gradient().norm_square() -
           std::log(kinematics.volume_ratio());
  }

private:
  static dealii::Tensor<2, 3> unit() { return dealii::unit_symmetric_tensor<3>(); }
  static dealii::Tensor<2, 3> elastic_stress(const dealii::Tensor<2, 3> &gradient)
  {
    return gradient + transpose(gradient) + 2. * trace(gradient) * unit();
  }
  template <int dim>
  static void
  add_stress(const MeshPoint &point, const dealii::Tensor<2, 3> &stress, Tested<dim> &tested)
  {
    dealii::Tensor<2, dim> plane;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        plane[c][d] = stress[c][d];
    tested.add_stress(plane, stress[2][2], point.hoop);
  }
};
} // namespace Continua

#endif
