#ifndef continua_finite_element_streamline_terms_h
#define continua_finite_element_streamline_terms_h

#include <continua/continuum/problem.h>
#include <continua/finite_element/flow_point.h>
#include <continua/finite_element/inflow_terms.h>
#include <continua/finite_element/space.h>
#include <continua/time_integration/step.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Continua
{
/**
 * The streamline-upwind Petrov-Galerkin terms of the momentum equation (A. N. Brooks, T. J. R.
 * Hughes, Comput. Methods Appl. Mech. Engrg. 32 (1982) 199-259), times 1 - phase:
 *
 *   int tau ((U . grad) v) . r,
 *   r = rho (dU/dt + (U . grad) U) - eta (lap U + 1/3 grad div U) + grad p - rho0 b,
 *
 * the residual inside the cell, with the viscosity eta of a newtonian liquid, and
 *
 *   tau = ( (2/dt)^2 + (2 |U|/h)^2 + (12 eta/(rho0 h^2))^2 )^(-1/2),
 *
 * h the size of a cell (Convection::cell_size()). They vanish for the exact solution.
 *
 * On a mesh that moves all of this is by the present place, h included, and the velocity that
 * carries, U - W with convection and -W without, stands in the place of the U that carries.
 */
template <int dim>
class StreamlineTerms
{
public:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  /// `quadrature`: that of the points which are given to it. The first two must outlive it.
  StreamlineTerms(const Space<dim> &space,
                  const Problem &problem,
                  const dealii::Quadrature<dim> &quadrature);

  bool are_on() const { return problem.convection.stabilisation == ConvectionStabilisation::supg; }
  /// Makes the shape functions and sizes those of the cell in that step.
  void visit(const Cell &cell, const Step &step);
  /// tau r at a point, times its weight: what (U . grad) v is multiplied by.
  dealii::Tensor<1, dim>
  force(const FlowPoint<dim> &point, unsigned int q, const CellState<dim> &state);
  /// Adds the derivative of the rows of momentum by the cell's velocities, then its pressures, with
  /// the acceleration following as the step has it.
  void add_derivative(const FlowPoint<dim> &point,
                      const FlowFunctions<dim> &functions,
                      unsigned int q,
                      const CellState<dim> &state,
                      dealii::FullMatrix<double> &matrix);

private:
  const Space<dim> &space;
  const Problem &problem;
  const dealii::FE_Q<dim> scalar_element;
  dealii::FEValues<dim> values;
  Step step;
  unsigned int region = 0;
  double size_at_rest = 0., size = 0.; ///< of the cell [m]
  dealii::Point<dim> place;            ///< of the point
  // At a point: test functions along the flow and the derivatives of r by the velocities.
  std::vector<double> along;
  std::vector<dealii::Tensor<1, dim>> residual_slopes;
  /// eta (lap + 1/3 grad div) of the velocity's shape functions at a point.
  std::vector<dealii::Tensor<1, dim>> viscous_forces;

  /// Sets these, the place and the size at the present place of a point.
  void set_point(unsigned int q, const CellState<dim> &state);
  /// Sets those of one function from its derivatives by the present place.
  void set_viscous_forces(unsigned int function,
                          const CellState<dim> &state,
                          double value,
                          const dealii::Tensor<1, dim> &first,
                          const dealii::Tensor<2, dim> &second);
  double viscosity() const { return problem.materials[region].shear.viscosity; }
  /// tau at a speed [s].
  double time_scale(double speed) const;
  dealii::Tensor<1, dim> residual(const FlowPoint<dim> &point, const CellState<dim> &state) const;
};
} // namespace Continua

#endif
