#ifndef continua_finite_element_terms_streamline_terms_h
#define continua_finite_element_terms_streamline_terms_h

#include <continua/continuum/problem.h>
#include <continua/finite_element/space/space.h>
#include <continua/finite_element/terms/cell_state.h>
#include <continua/finite_element/terms/streamline.h>
#include <continua/time_integration/step.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>

#include <vector>

namespace Continua
{
/**
 * What Streamline has at the points of a cell besides the flow: the viscous force by second
 * derivatives, the body force, and
 *
 *   tau = ( (2/dt)^2 + (2 |U|/h)^2 + (12 eta/(rho0 h^2))^2 )^(-1/2),
 *
 * h the size of a cell (Convection::cell_size()), U what carries. On a mesh that moves all of this
 * is by the present place, h included.
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
  /// Sets it at a point of that cell, from its flow.
  void set_point(unsigned int q, const CellState<dim> &state, StreamlinePoint<dim> &point);
  /// eta (lap + 1/3 grad div) of each velocity of the cell at the point that was set [N s/m^4].
  const std::vector<dealii::Tensor<1, dim>> &viscous_forces() const { return forces; }

private:
  const Space<dim> &space;
  const Problem &problem;
  dealii::FEValues<dim> values;
  Step step;
  unsigned int region = 0;
  double undeformed_size = 0., size = 0.;     ///< of the cell [m]
  dealii::Point<dim> place;                   ///< of the point
  std::vector<dealii::Tensor<1, dim>> forces; ///< viscous_forces()

  /// Sets these, the place and the size at the present place of a point.
  void set_viscous_forces(unsigned int q, const CellState<dim> &state);
  /// Sets those of one function from its derivatives by the present place.
  void set_viscous_forces_of(unsigned int function,
                             const CellState<dim> &state,
                             double value,
                             const dealii::Tensor<1, dim> &first,
                             const dealii::Tensor<2, dim> &second);
  double viscosity() const { return problem.materials[region].shear.viscosity; }
  /// tau at a speed [s].
  double time_scale(double speed) const;
};
} // namespace Continua

#endif
