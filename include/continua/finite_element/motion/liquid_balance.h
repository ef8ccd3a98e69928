#ifndef continua_finite_element_motion_liquid_balance_h
#define continua_finite_element_motion_liquid_balance_h

#include <continua/continuum/liquid_mass.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state.h>
#include <continua/continuum/state_visitor.h>
#include <continua/continuum/step_solution.h>
#include <continua/finite_element/space/deformed_face_point.h>
#include <continua/finite_element/space/quadrature_cells.h>
#include <continua/finite_element/space/space.h>

#include <deal.II/lac/vector.h>

#include <vector>

namespace Continua
{
/**
 * The mass of the liquids on a mesh that moves, and what has flowed in. The equations hold the
 * mass at each instant (int q div U = 0 with q = 1), but the volume of the present shape is no
 * linear function of the displacement: what a step of time leaves between the two is its error.
 */
template <int dim>
class LiquidBalance
{
public:
  /// Both must outlive it.
  LiquidBalance(const Space<dim> &space, const Problem &problem);

  /// The mesh has changed.
  void reinit();
  /// A step has ended: adds what has flowed in. Collective.
  void finish_step(const StepSolution &solution);
  /// Of a state. Collective.
  LiquidMass mass(const State &state);
  /// Hands over the part of the state.
  void visit(StateVisitor &visitor);

private:
  using Cell = QuadratureCell<dim>;
  /// A face of a liquid on the boundary of the body.
  struct Face
  {
    std::size_t cell; ///< its place in the cells
    std::vector<DeformedFacePoint<dim>> points;
    std::vector<std::vector<double>> pressure_values; ///< [point][function]
  };

  const Space<dim> &space;
  const Problem &problem;
  QuadratureCells<dim> cells;
  std::vector<Face> faces;
  double inflow = 0., older_inflow = 0.;              ///< over time, and one step before [kg]
  DistributedVector displacement, velocity, pressure; ///< with ghost entries
  dealii::Vector<double> cell_displacement, cell_velocity, cell_pressure;

  /// What flows in at a level that a step has balanced [kg/s]. Collective.
  double rate(const StepSolution &solution);
};
} // namespace Continua

#endif
