#ifndef continua_finite_element_space_values_at_points_h
#define continua_finite_element_space_values_at_points_h

#include <continua/continuum/kinematics.h>
#include <continua/finite_element/space/quadrature_cells.h>

#include <deal.II/base/tensor.h>
#include <deal.II/lac/vector.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace Continua
{
/**
 * A field of a cell at all of its quadrature points: of each component the value, and the
 * derivatives along the coordinates of the reference cell where they are wanted. What a shape
 * function has at all points stands together, so that the sums over the functions go into vector
 * registers; BLAS would spend more on its own calls, the matrices are that small.
 */
template <int dim>
class ValuesAtPoints
{
public:
  enum class Field
  {
    velocity, ///< with dim components, one after the other
    pressure
  };
  /// `cells` need not outlive it.
  ValuesAtPoints(const QuadratureCells<dim> &cells, Field field, bool with_slopes);

  /// Takes the entries of a cell.
  void set(const dealii::Vector<double> &entries);

  double value(const unsigned int component, const unsigned int q) const
  {
    return values[component * padded + n_rows * q];
  }
  /// The gradient, with the inverse of a Jacobian as QuadratureCell has it; with slopes only.
  dealii::Tensor<1, dim> gradient(const unsigned int component,
                                  const unsigned int q,
                                  const dealii::Tensor<2, dim> &inverse_jacobian) const
  {
    const double *const slope = &values[component * padded + n_rows * q + 1];
    dealii::Tensor<1, dim> result;
    for (unsigned int s = 0; s < dim; ++s)
      for (unsigned int d = 0; d < dim; ++d)
        result[d] += slope[s] * inverse_jacobian[s][d];
    return result;
  }

  /// The 3x3 gradient of a velocity by the reference place, as QuadratureCells::gradient().
  dealii::Tensor<2, 3> space_gradient(const unsigned int q,
                                      const typename QuadratureCell<dim>::Point &point) const
  {
    dealii::Tensor<2, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      result[c] = gradient(c, q, point.inverse_jacobian);
    // On the axis the hoop strain is the radial one.
    return whole_gradient<dim>(result,
                               std::isfinite(point.hoop) ? point.hoop * value(1, q) : result[1][1]);
  }

private:
  /// Numbers that are summed at a time.
  static constexpr std::size_t block = 8;

  std::size_t n_functions, n_rows; ///< n_rows: numbers at a point
  std::size_t padded;              ///< numbers of a component at all points, in whole blocks
  std::vector<double> table;       ///< [function][point, row]
  std::vector<double> values;      ///< [component][point, row]
};
} // namespace Continua

#endif
