#ifndef continua_finite_element_space_numbers_at_points_h
#define continua_finite_element_space_numbers_at_points_h

#include <deal.II/base/tensor.h>

#include <cstddef>

namespace Continua
{
/// The geometry of a cell at a quadrature point.
template <int dim>
struct CellPoint
{
  double weight = 0.; ///< in an integral over the body
  double hoop = 0.;   ///< 1/r in axisymmetry, else 0 [1/m]
  /// [d][e]: the derivative of the coordinate d of the reference cell by the place along e [1/m].
  dealii::Tensor<2, dim> inverse_jacobian;
};

/// Numbers of a field at all points of a cell: of each component its values, one point after the
/// other, and behind them in the same way its derivatives along each coordinate of the reference
/// cell, where it has them. `Number`: double or const double.
template <typename Number>
struct NumbersAtPoints
{
  Number *values = nullptr;
  std::size_t component_size = 0; ///< from one component to the next
};
} // namespace Continua

#endif
