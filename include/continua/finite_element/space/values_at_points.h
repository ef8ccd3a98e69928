#ifndef continua_finite_element_space_values_at_points_h
#define continua_finite_element_space_values_at_points_h

#include <continua/continuum/kinematics.h>
#include <continua/finite_element/space/point_table.h>
#include <continua/finite_element/space/quadrature_cells.h>

#include <deal.II/base/tensor.h>
#include <deal.II/lac/vector.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace Continua
{
/// A field of a cell at all of its quadrature points: of each component the value, and the
/// derivatives along the coordinates of the reference cell where they are wanted.
template <int dim>
class ValuesAtPoints
{
public:
  using Field = typename PointTable<dim>::Field;

  /// `cells` need not outlive it. A velocity has dim components, one after the other.
  ValuesAtPoints(const QuadratureCells<dim> &cells, const Field field, const bool with_slopes)
      : table(cells, field, with_slopes),
        values((field == Field::velocity ? dim : 1) * table.size(), 0.)
  {
  }

  /// Takes the entries of a cell.
  void set(const dealii::Vector<double> &entries)
  {
    for (std::size_t c = 0; c * table.size() < values.size(); ++c)
      table.set_values(entries.begin() + c * table.n_functions(), &values[c * table.size()]);
  }

  double value(const unsigned int component, const unsigned int q) const
  {
    return values[component * table.size() + table.place(q)];
  }
  /// The gradient, with the inverse of a Jacobian as QuadratureCell has it; with slopes only.
  dealii::Tensor<1, dim> gradient(const unsigned int component,
                                  const unsigned int q,
                                  const dealii::Tensor<2, dim> &inverse_jacobian) const
  {
    const double *const slopes = &values[component * table.size() + table.place(0, 1)];
    dealii::Tensor<1, dim> result;
    for (unsigned int s = 0; s < dim; ++s)
      for (unsigned int d = 0; d < dim; ++d)
        result[d] += slopes[table.place(q, s)] * inverse_jacobian[s][d];
    return result;
  }

  /// All of them.
  NumbersAtPoints<const double> numbers() const { return {values.data(), table.size()}; }
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
  PointTable<dim> table;
  std::vector<double> values; ///< [component], by place in a row
};
} // namespace Continua

#endif
