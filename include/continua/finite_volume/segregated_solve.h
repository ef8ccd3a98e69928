#ifndef continua_finite_volume_segregated_solve_h
#define continua_finite_volume_segregated_solve_h

#include <continua/finite_volume/loop_monitor.h>
#include <continua/finite_volume/loop_residual.h>
#include <continua/finite_volume/momentum_predictor.h>
#include <continua/finite_volume/pressure_equation.h>

#include <functional>
#include <string>

namespace Continua
{
/**
 * The thesis's way to solve the equations of a step: component by component in a loop (its section
 * 3.4 and figure 3.5), what is not on the compact stencil taken from the last pass. Converged, it
 * is the solution of CoupledSolve. Matrices and factors are made in reinit() and kept; the loop
 * allocates nothing.
 *
 * A pass (a correction) of the displacement and the velocity form is one solve for each component;
 * with explicit pressure the pressure is computed after it; in the velocity-pressure form PISO
 * follows, with `Pressure corrections` pressure equations.
 */
template <int dim>
class SegregatedSolve : public CellWiseSolve<dim>
{
public:
  /// Gets every correction as soon as it is made.
  using Sink = std::function<void(const LoopCorrection &)>;

  explicit SegregatedSolve(const CellWiseSystem<dim> &system, Sink sink = {});

  void reinit() override;
  /// Throws RunError if the loop diverges, and at its cap if that is asked for.
  void solve(const DistributedVector &momentum,
             const DistributedVector &mass,
             DistributedVector &velocity,
             DistributedVector &pressure,
             StepReport &report) override;
  double factor_entries() const override;
  double factor_memory() const override;
  std::string name() const override;

private:
  using Vector = typename SplitEquations<dim>::Vector;

  const CellWiseSystem<dim> &system;
  const Sink sink;
  const Formulation formulation;
  /// Whether faces get their velocity from their own equations rather than by the links'
  /// stiffness c alpha.
  const bool faces_balance;
  SplitEquations<dim> equations;
  FaceLinks<dim> links;
  MomentumPredictor<dim> predictor;
  FaceBalance<dim> faces;
  PressureEquation<dim> pressure_equation;
  LoopResidual momentum_residual, continuity_residual;
  LoopMonitor monitor;
  // Right side, unknowns, residual, change of the unknowns, and products of the matrices of
  // predictor and pressure equation with the unknowns.
  Vector right_side, unknowns, residual, change, products;
  Vector lack; ///< what the predictor's equations lack within PISO
  Vector work;

  /// The predictor and what follows it; returns the correction's residuals.
  LoopCorrection correct();
  void predict();
  void compute_pressure();
  /// PISO's loop; returns the residual of the last pressure equation.
  double correct_pressure();
  /// U += what the predictor's equations lack over their diagonal: H(U)/a_P with the last velocity.
  void update_by_diagonal();
  /// Solves the pressure equation and corrects pressure and velocity.
  void solve_pressure_equation();
  /// Moves the cells by the change that is in `change`, and the faces with them.
  void move_cells();
  void balance_faces();
};
} // namespace Continua

#endif
