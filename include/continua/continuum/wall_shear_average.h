#ifndef continua_continuum_wall_shear_average_h
#define continua_continuum_wall_shear_average_h

#include <continua/continuum/operators.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state_visitor.h>

namespace Continua
{
/**
 * The wall shear stress tau over time, at the nodes of the walls: the integrals of tau and of |tau|
 * over a window of the run. From them follow the time-averaged wall shear stress, int |tau| dt/T,
 * and the oscillatory shear index, (1 - |int tau dt|/int |tau| dt)/2 (D. N. Ku, D. P. Giddens, C.
 * K. Zarins, S. Glagov, Pulsatile flow and atherosclerosis in the human carotid bifurcation,
 * Arteriosclerosis 5 (1985) 293-302; X. He, D. N. Ku, Pulsatile flow in the human left coronary
 * artery bifurcation, J. Biomech. Eng. 118 (1996) 74-82). Both integrals are made by the
 * trapezoidal rule over the steps, and over the part of a step that is in the window. A part of the
 * state.
 */
class WallShearAverage
{
public:
  /// Both must outlive it.
  WallShearAverage(const Problem &problem, Operators &operators)
      : problem(problem), operators(operators)
  {
  }

  /// Whether anybody asks for it: else nothing of it is computed or kept.
  bool is_on() const { return problem.wall_shear_window.is_kept; }
  /// The mesh is another one.
  void reinit();
  void visit(StateVisitor &visitor);
  /// The run begins with this state.
  void start(const State &state);
  /// The state was carried over to another mesh.
  void follow_mesh(const State &state);
  /// A step has led from its start to this state.
  void advance(const Step &step, const State &state);

  /// int tau dt at the nodes of the walls, 0 at others [Pa s].
  const DistributedVector &integral() const { return sum; }
  /// int |tau| dt, in each component of the nodes [Pa s].
  const DistributedVector &integral_of_magnitude() const { return magnitude_sum; }
  /// The part of the window that is over [s].
  double duration() const { return time; }

private:
  const Problem &problem;
  Operators &operators;
  // The state.
  DistributedVector present, sum, magnitude_sum;
  double time = 0.;
  // Work space.
  DistributedVector next, between, magnitudes;

  /// Adds tau at a fraction of the step, times a weight [s].
  void add(double fraction, double weight);
};
} // namespace Continua

#endif
