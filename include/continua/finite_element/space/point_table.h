#ifndef continua_finite_element_space_point_table_h
#define continua_finite_element_space_point_table_h

#include <continua/finite_element/space/quadrature_cells.h>
#include <continua/linear_algebra/block_sums.h>

#include <cstddef>
#include <vector>

namespace Continua
{
/**
 * The shape functions of a component of a field at all points of the reference cell: their values,
 * and their derivatives along the coordinates where these are wanted. What one function has at all
 * points stands together, a row of the table: its values, then each derivative (NumbersAtPoints).
 */
template <int dim>
class PointTable
{
public:
  enum class Field
  {
    velocity,
    pressure
  };
  /// `cells` need not outlive it.
  PointTable(const QuadratureCells<dim> &cells, Field field, bool with_slopes);

  std::size_t n_functions() const { return functions; }
  /// Numbers of a row: those at points, and zeros behind them.
  std::size_t size() const { return row_size; }
  /// Where in a row a number at a point is: 0 the value, then the derivatives.
  std::size_t place(const unsigned int q, const std::size_t number = 0) const
  {
    return number * points + q;
  }

  /// Sets the `size()` values at points of the field with `n_functions()` entries.
  void set_values(const double *const entries, double *const values) const
  {
    add_up_rows(entries, functions, table.data(), row_size, values);
  }
  /// Sets the `n_functions()` sums over the points of each function times what stands there.
  void set_sums(const double *const at_points, double *const sums) const
  {
    multiply_rows(at_points, functions, table.data(), row_size, sums);
  }

private:
  std::size_t functions, points, row_size;
  std::vector<double> table; ///< [function][number, point]
};
} // namespace Continua

#endif
