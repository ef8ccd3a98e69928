#ifndef continua_continuum_cavity_coupling_h
#define continua_continuum_cavity_coupling_h

#include <continua/continuum/balanced_step.h>
#include <continua/continuum/cavity_state.h>
#include <continua/continuum/operators.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state_visitor.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <functional>
#include <vector>

namespace Continua
{
/**
 * The cavities of a problem, whose volumes are given and whose pressures are unknowns of Newton's
 * iteration. With the kept factor K of the tangent, the residual r, the volume V and its derivative
 * b . dU by a change of the velocity, and the forces c of a pressure of 1 Pa, an iteration solves
 *
 *   K dU - c dp = r,     b . dU = V_given - V
 *
 * by block elimination: K x = r, K y = c, dp = (V_given - V - b . x)/(b . y), dU = x + y dp.
 * Several cavities have a small matrix in the place of b . y. K alone may be singular or have
 * negative eigenvalues, as at and beyond the largest pressure of a balloon: at a state that is not
 * singular with its volume held, the sum stays finite. On a mesh that moves K leaves out the motion
 * of the liquid's mesh; where the iteration takes GMRES for x, it does for y, too.
 *
 * V is that at the level which the step balances.
 */
class CavityCoupling
{
public:
  /// Both must outlive it.
  CavityCoupling(const Problem &problem, Operators &operators);

  bool is_empty() const { return conditions.empty(); }
  /// The state of t = 0, without pressures.
  void initialise();
  /// The mesh has changed; the pressures stay. After the operators' setup().
  void build();

  /// Takes the volumes that are given at the step: those at its balance time, on the way to rest as
  /// far from the volumes at rest as the share of the loads says. Throws RunError if one is not
  /// positive.
  void begin_step(const Step &step);
  /// Takes volumes and derivatives at an iterate's displacement.
  void measure(const BalancedStep &balanced);
  /// The largest difference of a volume from the one given, over the latter, at that iterate.
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
              std::vector<double> &cavity_pressures);

  /// The pressures [Pa], by cavity.
  std::vector<double> pressures() const;
  /// Takes those that a step has found.
  void finish_step(const BalancedStep &balanced);
  /// The present pressures, and the volumes at a displacement.
  const std::vector<CavityState> &states(const DistributedVector &displacement);
  /// The same, as they were taken last.
  const std::vector<CavityState> &states() const { return present; }
  /// Whether a given volume jumps between the two times [s].
  bool jumps(double begin, double end) const;
  /// Hands over all that a step changes.
  void visit(StateVisitor &visitor);

private:
  struct Cavity
  {
    double rest_volume = 0.; ///< in the mesh [m^3]
    double given_volume = 0., volume = 0.;
    DistributedVector derivative, force;
    DistributedVector velocity_response, pressure_response;
  };

  const Problem &problem;
  Operators &operators;
  const std::vector<unsigned int> conditions; ///< by cavity
  std::vector<Cavity> cavities;
  std::vector<CavityState> present;
  // Work space.
  DistributedVector momentum, mass, zero_velocity;
  dealii::FullMatrix<double> matrix;
  dealii::Vector<double> differences, changes;
};
} // namespace Continua

#endif
