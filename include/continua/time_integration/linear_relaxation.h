#ifndef continua_time_integration_linear_relaxation_h
#define continua_time_integration_linear_relaxation_h

namespace Continua
{
/**
 * The exact x at the end of a step for dx/dt = U - x/tau and a U that is linear in the step:
 * decay x_old + of_old U_old + of_new U_new.
 */
struct LinearRelaxation
{
  double decay;          ///< [1]
  double of_old, of_new; ///< [s]

  /// `step` and `relaxation_time` tau [s], both positive.
  LinearRelaxation(double step, double relaxation_time);
};
} // namespace Continua

#endif
