#ifndef continua_time_integration_step_h
#define continua_time_integration_step_h

#include <array>

namespace Continua
{
/// How the branches' internal displacements and the pressure follow the velocity within a step.
enum class Update
{
  trapezoidal, ///< by the mean of old and new velocity (equations 2.16, 2.25)
  implicit,    ///< by the same formula as the velocity
  midpoint     ///< implicit over half a step, then extrapolated: Crank-Nicolson
};

/**
 * One internal displacement over a step: D_new = velocity D_U + old D_old + older D_older +
 * velocity_old U_old, where D_new and U stand for the level at which the equations are balanced
 * (for Crank-Nicolson the middle of the step).
 */
struct BranchCoefficients
{
  double velocity = 0.;     ///< of U at the balanced level [s]
  double old = 0.;          ///< of D at the step's start
  double older = 0.;        ///< of D one step before
  double velocity_old = 0.; ///< of U at the step's start [s]
};

/**
 * One time step as coefficients: dU/dt = a0 U + a1 U_old + a2 U_older at the balanced level. Made
 * by the factory functions below and checked on its own; the solver only multiplies and adds.
 */
struct Step
{
  double time_old = 0.; ///< [s] at the start
  double time = 0.;     ///< [s] at the end
  /// Its size [s] as it was asked for: time - time_old has another round-off in every step, and so
  /// would the matrix.
  double duration = 0.;
  double balance_time = 0.;         ///< [s] at which the equations are balanced and the loads taken
  double a0 = 0., a1 = 0., a2 = 0.; ///< [1/s]
  /// Of the older state from the step's start [s], to which a2 belongs; where no state has that
  /// distance it is one between three earlier ones. Of a step that extrapolates: the size of the
  /// one before it; 0: there is none.
  double older_distance = 0.;
  /// Whether it starts the scheme: what was before it does not go on smoothly.
  bool is_start = false;
  /// The time b in p = p_plus - K b div U (and C = M_p / (K b)) [s].
  double pressure_time = 0.;
  double pressure_old = 1.;   ///< weight of p_old in p_plus
  double pressure_older = 0.; ///< weight of p_older in p_plus
  /// Whether p_plus also has - K b div U_old (the trapezoidal rule).
  bool divergence_old = false;
  /// Whether x_new = 2 x - x_old follows the solve.
  bool extrapolate = false;
  Update update = Update::implicit;
  /// Of all loads, prescribed velocities and pressures behind outlets [1].
  double load_factor = 1.;
  /// Whether it is one on the way to a steady state. Nothing acts then that a state at rest does
  /// not have, however long it would last: outlets stand as in a steady flow, branches have
  /// relaxed, and neither the viscosity of a solid nor the damping of a support is there.
  bool finds_steady_state = false;
  /// Whether it is one of the search for the unloaded shape: the displacement then leads from that
  /// shape to the mesh, which has the shape under the loads.
  bool finds_unloaded_shape = false;

  double size() const { return duration; }
  /// The coefficients of a branch of relaxation time tau [s]; infinite tau is allowed.
  BranchCoefficients branch(double relaxation_time) const;
  /// Whether that branch relaxes so fast within the step that the exponential update is taken.
  bool branch_is_exponential(double relaxation_time) const;
};

/// Backward Euler from `time_old` over `size` (equation 3.44).
Step euler_step(double time_old, double size, Update update);
/**
 * One solve of the steady equations, with Step::finds_steady_state: without inertia (unless
 * `with_inertia`), the displacement of a solid is its velocity times `size` after what it was. The
 * size [s] weighs the velocity that a solid still has against that of a liquid beside it.
 */
Step static_step(double size, bool with_inertia);
/// Second-order backward differencing after a step of `size_old` (equation 3.45, for changed steps
/// too).
Step backward_differencing_step(double time_old, double size, double size_old, Update update);
/// Crank-Nicolson: backward Euler over half of `size`, then extrapolation. `size_old` [s]: of the
/// step before it.
Step crank_nicolson_step(double time_old, double size, double size_old = 0.);
/// Of a step that has no solution.
inline constexpr int most_halvings = 6;
/// A step by the formulas of `parent` from `time_old` over `size`, after one of `size_old` [s].
Step step_like(const Step &parent, double time_old, double size, double size_old);
/// Both halves of a step; the second one ends at the very time at which the step ends.
std::array<Step, 2> halves_of(const Step &parent);
} // namespace Continua

#endif
