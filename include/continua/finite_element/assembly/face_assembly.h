#ifndef continua_finite_element_assembly_face_assembly_h
#define continua_finite_element_assembly_face_assembly_h

#include <continua/continuum/kinematics.h>
#include <continua/finite_element/space/deformed_face_point.h>
#include <continua/finite_element/terms/point_change.h>
#include <continua/finite_element/terms/tested_on_face.h>

#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace Continua
{
/**
 * From what terms give at the quadrature points of a face: the rows of its cell, and the matrix of
 * their derivative. As CellAssembly it differentiates the terms in the few directions at a point:
 * the value and the derivatives, by the undeformed place, of each component of velocity, and the
 * value of the pressure. Velocities stand component by component.
 */
template <int dim>
class FaceAssembly
{
public:
  /// Adds to rows of momentum what a point gives, times its weight.
  void add(const DeformedFacePoint<dim> &shapes,
           double weight,
           const TestedOnFace<dim> &tested,
           dealii::Vector<double> &rows) const;
  /// Adds the derivative at a point, times its weight, to the matrix of the cell, velocities first.
  /// `motion`: of the point, by whose present place the gradients of a change are.
  /// `pressure_values`: the shape functions of the pressure; null: the terms have none.
  /// `differentiate(change, tested)` adds what the derivative in the direction of a PointChange
  /// gives.
  template <typename Differentiate>
  void add_derivative(const DeformedFacePoint<dim> &shapes,
                      const Kinematics *const motion,
                      const std::vector<double> *const pressure_values,
                      const double weight,
                      const Differentiate &differentiate,
                      dealii::FullMatrix<double> &matrix)
  {
    const auto column_of = [&](const PointChange<dim> &change)
    {
      TestedOnFace<dim> tested;
      differentiate(change, tested);
      return weight * tested.by_value;
    };
    for (unsigned int d = 0; d < dim; ++d)
    {
      for (unsigned int k = 0; k <= (motion == nullptr ? 0 : dim); ++k)
      {
        PointChange<dim> change;
        if (k == 0)
          change.velocity[d] = 1.;
        for (unsigned int e = 0; k > 0 && e < dim; ++e)
          change.velocity_gradient[d][e] = motion->inverse()[k - 1][e];
        by_velocity[k] = column_of(change);
      }
      add_products(shapes, d, motion != nullptr, matrix);
    }
    if (pressure_values == nullptr)
      return;
    PointChange<dim> change;
    change.pressure = 1.;
    add_products_with_pressures(shapes, *pressure_values, column_of(change), matrix);
  }

private:
  /// What the value (0) and the derivatives (1 ...) of a component of velocity give.
  std::array<dealii::Tensor<1, dim>, dim + 1> by_velocity;
  std::vector<double> row; ///< work space

  /// Adds these for one component of velocity times test and trial functions.
  void add_products(const DeformedFacePoint<dim> &shapes,
                    unsigned int component,
                    bool has_derivatives,
                    dealii::FullMatrix<double> &matrix);
  static void add_products_with_pressures(const DeformedFacePoint<dim> &shapes,
                                          const std::vector<double> &pressure_values,
                                          const dealii::Tensor<1, dim> &by_pressure,
                                          dealii::FullMatrix<double> &matrix);
};
} // namespace Continua

#endif
