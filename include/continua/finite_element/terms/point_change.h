#ifndef continua_finite_element_terms_point_change_h
#define continua_finite_element_terms_point_change_h

#include <deal.II/base/tensor.h>

namespace Continua
{
/// A change of the unknowns at a point: the direction in which a term is differentiated. `Number`:
/// double, or several points at once.
template <int dim, typename Number = double>
struct PointChange
{
  dealii::Tensor<1, dim, Number> velocity; ///< [m/s]
  dealii::Tensor<2, dim, Number>
      velocity_gradient; ///< [component][direction], as the state's [1/s]
  Number pressure = 0.;  ///< [Pa]
  dealii::Tensor<1, dim, Number> pressure_gradient; ///< as the state's [Pa/m]
  dealii::Tensor<1, dim, Number> viscous_force;     ///< of StreamlinePoint [N/m^3]
};
} // namespace Continua

#endif
