#ifndef continua_finite_element_flow_point_h
#define continua_finite_element_flow_point_h

#include <deal.II/base/tensor.h>

#include <vector>

namespace Continua
{
/// The state of a liquid at a quadrature point of a cell.
template <int dim>
struct FlowPoint
{
  double weight = 0.; ///< of the point in an integral over the body
  double pressure = 0., pressure_rate = 0., divergence = 0.;
  dealii::Tensor<1, dim> velocity, acceleration, pressure_gradient;
  dealii::Tensor<1, dim> carrier;           ///< the velocity that carries, by the mesh [m/s]
  dealii::Tensor<2, dim> velocity_gradient; ///< [c][d]: of component c along d
  dealii::Tensor<2, dim> strain_rate;       ///< deviatoric, in the plane or in space
  double across = 0., hoop = 0.;            ///< of it, across the plane; 1/r in axisymmetry
  double shear_rate = 0.;                   ///< of the FlowCurve
};

/// The shape functions at a quadrature point of a cell: of one component of the velocity, and of
/// the pressure.
template <int dim>
struct FlowFunctions
{
  const double *values = nullptr, *pressure_values = nullptr;
  std::vector<dealii::Tensor<1, dim>> gradients, pressure_gradients; ///< [1/m]
};
} // namespace Continua

#endif
