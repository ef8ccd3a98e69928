#ifndef continua_continuum_boundary_pressures_h
#define continua_continuum_boundary_pressures_h

#include <continua/continuum/cavity_state.h>
#include <continua/continuum/operators.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state_visitor.h>
#include <continua/continuum/step_solution.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <functional>
#include <vector>

namespace Continua
{
/**
 * The pressures of boundaries that are unknowns of Newton's iteration: of cavities, whose volumes
 * are given, and of sections of which a flow rate is given and its distribution is free. With the
 * kept factor K of the tangent, the residual r, the volume V and its derivative b . dU by a change
 * of the velocity, and the forces c of a pressure of 1 Pa, an iteration solves
 *
 *   K dU - c dp = r,     b . dU = V_given - V
 *
 * by block elimination: K x = r, K y = c, dp = (V_given - V - b . x)/(b . y), dU = x + y dp.
 * Several boundaries have a small matrix in the place of b . y. K alone may be singular or have
 * negative eigenvalues, as at and beyond the largest pressure of a balloon: at a state that is not
 * singular with its volume held, the sum stays finite. On a mesh that moves K leaves out the motion
 * of the liquid's mesh; where the iteration takes GMRES for x, it does for y, too.
 *
 * A section has its flow rate in the place of V. It is that into the body past the mesh, - q . (U -
 * W), with the present section q and the velocity W of the mesh. J. G. Heywood, R. Rannacher and S.
 * Turek (Int. J. Numer. Meth. Fluids 22 (1996) 325, section 3) have such conditions.
 *
 * All are those at the level which the step balances. In the middle of a step a flow rate is the
 * mean of those at both ends.
 */
class BoundaryPressures
{
public:
  /// Both must outlive it.
  BoundaryPressures(const Problem &problem, Operators &operators);

  bool is_empty() const { return conditions.empty(); }
  /// The state of t = 0, without pressures.
  void initialise();
  /// The mesh has changed; the pressures stay. After the operators' setup().
  void build();

  /// Takes what is given at the step: that at its balance time, on the way to a steady state as far
  /// from the undeformed volumes, or from no flow, as the share of the loads says. Throws RunError
  /// if a volume is not positive or a flow rate is no number.
  void begin_step(const Step &step);
  /// Takes volumes, flow rates and derivatives at an iterate.
  void measure(const StepSolution &solution);
  /// The largest difference of a volume from the one given, over the latter, at that iterate; of a
  /// flow rate over the largest one so far [1].
  double residual() const;
  /// Solves the equations of an iteration for right sides of momentum [N] and volume [m^3/s].
  using Solve = std::function<void(DistributedVector &momentum,
                                   DistributedVector &mass,
                                   DistributedVector &velocity,
                                   DistributedVector &pressure)>;
  /// The body's responses to the pressures at that iterate. Call after each new factor.
  void respond(const Solve &solve);
  /// The largest flow rate at a node of the surfaces that such a response stands for [m^3/s].
  double largest_flow() const;
  /// Completes the changes by which an iterate would follow without changes of the pressures, and
  /// adds those.
  void couple(const Step &step,
              DistributedVector &velocity_change,
              DistributedVector &pressure_change,
              std::vector<double> &boundary_pressures);

  /// The pressures [Pa], by boundary.
  std::vector<double> pressures() const;
  /// Takes those that a step has found.
  void finish_step(const StepSolution &solution);
  /// The present pressures, and the volumes at a displacement.
  const std::vector<CavityState> &states(const DistributedVector &displacement);
  /// The same, as they were taken last.
  const std::vector<CavityState> &states() const { return present; }
  /// Whether a given volume jumps between the two times [s].
  bool jumps(double begin, double end) const;
  /// Hands over all that a step changes.
  void visit(StateVisitor &visitor);

private:
  /// One boundary, with its equation.
  struct Row
  {
    int cavity = -1;               ///< its number among the cavities, -1 of a flow rate
    double undeformed_volume = 0.; ///< in the mesh [m^3]
    double given = 0., value = 0.; ///< volume [m^3], or flow rate into the body [m^3/s]
    double size = 0.;              ///< with which a flow rate is compared [m^3/s]
    /// Of the volume by the displacement, of a flow rate by the velocity [m^2].
    DistributedVector derivative;
    DistributedVector force; ///< of a pressure of 1 Pa [N]
    DistributedVector velocity_response, pressure_response;
  };

  const Problem &problem;
  Operators &operators;
  const std::vector<unsigned int> conditions; ///< by boundary
  std::vector<Row> rows;
  std::vector<CavityState> present;
  std::vector<double> largest_flow_rates; ///< that were given so far [m^3/s]; 0 of cavities
  // Work space.
  DistributedVector momentum, mass, zero_velocity;
  dealii::FullMatrix<double> matrix;
  dealii::Vector<double> differences, changes;

  /// Volume ratio [1], or flow rate of the whole section [m^3/s].
  const Waveform &given(unsigned int row) const;
  /// Of the cavities; empty if there are none [m^3].
  std::vector<double> volumes_at(const DistributedVector &displacement);
};
} // namespace Continua

#endif
