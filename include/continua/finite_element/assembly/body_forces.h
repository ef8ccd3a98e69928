#ifndef continua_finite_element_assembly_body_forces_h
#define continua_finite_element_assembly_body_forces_h

#include <continua/continuum/problem.h>
#include <continua/finite_element/space/quadrature_cells.h>
#include <continua/finite_element/space/space.h>
#include <continua/finite_element/terms/body_force.h>
#include <continua/time_integration/step.h>

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/base/tensor.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/vector.h>

namespace Continua
{
/// Makes what BodyForce has at the quadrature points of a cell.
template <int dim>
class BodyForces
{
public:
  using Cell = QuadratureCell<dim>;

  /// All must outlive it; `quadrature`: that of the cells.
  BodyForces(const Space<dim> &space,
             const Problem &problem,
             const QuadratureCells<dim> &cells,
             const dealii::Quadrature<dim> &quadrature);

  /// Whether the cell has such a term. If so, makes its points those of the cell under a
  /// displacement at its dofs [m], in that step.
  bool visit(const Cell &cell, const Step &of_state, const dealii::Vector<double> &displacement);
  /// Of the cell that was visited.
  BodyForcePoint<dim> point(unsigned int q) const;
  /// The same with its slope and what the velocity moves the place by [s].
  BodyForcePoint<dim> point_with_slope(unsigned int q, double displacement_by_velocity) const;

private:
  const Problem &problem;
  const QuadratureCells<dim> &cells;
  const bool depends_on_space;
  dealii::FEValues<dim> places; ///< undeformed
  Step step;
  const Cell *present = nullptr;
  const dealii::Vector<double> *displacements = nullptr; ///< of the cell `present`

  dealii::Point<dim> place(unsigned int q) const;
  /// rho b + f at a place [N/m^3].
  dealii::Tensor<1, dim> force(const dealii::Point<dim> &place) const;
};
} // namespace Continua

#endif
