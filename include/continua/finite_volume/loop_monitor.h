#ifndef continua_finite_volume_loop_monitor_h
#define continua_finite_volume_loop_monitor_h

#include <continua/continuum/continuum_solver.h>

#include <string>
#include <vector>

namespace Continua
{
/// Decides when a loop ends: below its tolerance, at its cap, or, by RunError, when it diverges.
class LoopMonitor
{
public:
  LoopMonitor(double tolerance, unsigned int maximum_corrections);

  /// A new step begins.
  void start();
  /// Takes a correction that was made and says whether the loop goes on. Throws RunError with the
  /// last residuals and what to do if the loop diverges: the residual is not finite, has grown in
  /// each of the last ten corrections, or is ten thousand times the smallest of the step.
  bool goes_on(const LoopCorrection &correction);
  bool converged() const { return is_converged; }
  const LoopCorrection &last() const { return history.back(); }

private:
  double tolerance;
  unsigned int maximum_corrections;
  bool is_converged = false;
  std::vector<LoopCorrection> history; ///< of the step; its memory is kept
  double smallest = 0.;
  unsigned int n_growths = 0; ///< one after the other

  [[noreturn]] void diverges() const;
};
} // namespace Continua

#endif
