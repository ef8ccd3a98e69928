#ifndef continua_continuum_step_error_estimate_h
#define continua_continuum_step_error_estimate_h

#include <continua/base/archive.h>
#include <continua/time_integration/step.h>

#include <array>

namespace Continua
{
/**
 * How the local error of a step follows from its difference from a prediction, the polynomial of
 * the scheme's order through the velocities before it. Both are a multiple of the same derivative
 * of the velocity, U'' for backward Euler and U''' for the others, which cancels in their ratio.
 *
 * That ratio is found by letting the scheme itself make the same steps with y = s^q / q!, whose
 * derivative of order q is one. The levels that a prediction goes through have errors, which the
 * textbooks' constants leave out; for steps of one size those errors grow evenly and the ratio is
 * 1/2 (backward Euler), 2/9 (backward differencing) and 1/12 (Crank-Nicolson), after a change of
 * the size or of the older level's place it is another for some steps.
 */
class StepErrorEstimate
{
public:
  /// Of the state at the step's start, one step before, and two.
  using Weights = std::array<double, 3>;

  /// To be called after each step.
  void advance(const Step &step);
  /// Whether the last step's error is known: the levels that the prediction goes through follow the
  /// start of the scheme, and what the start left behind has decayed.
  bool is_known() const { return known; }
  /// Error = factor (U - sum of weights U_i), weights = prediction().
  double factor() const { return error_over_difference; }
  const Weights &prediction() const { return prediction_weights; }

  /// Whether the older level that a step asks for is not that of the last step's start.
  bool wants_another_level(const Step &step) const;
  /// The weights of the three levels in the state of another distance from the present one [s].
  Weights weights_of_level(double distance) const;

  void save(ArchiveWriter &archive) const;
  void load(const ArchiveReader &archive);
  static bool is_in(const ArchiveReader &archive);

private:
  /// Levels since the start of the scheme, its end counted.
  unsigned int n_levels = 0;
  bool known = false;
  /// Of the levels one and two steps before the present one [s].
  std::array<double, 2> distances{};
  /// Errors of y at the three levels, less that of the present one [s^q].
  Weights errors{};
  double error_over_difference = 0.;
  Weights prediction_weights{};
};
} // namespace Continua

#endif
