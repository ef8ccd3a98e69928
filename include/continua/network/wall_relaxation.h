#ifndef continua_network_wall_relaxation_h
#define continua_network_wall_relaxation_h

#include <vector>

namespace Continua
{
/**
 * How the pressure of a wall depends on its past. Beside the pressure p(A) of the wall law stand
 *
 *     damping_time dp/dA dA/dt                            (Kelvin and Voigt), and for each branch
 * q_k, dq_k/dt = share_k dp/dA dA/dt - q_k/relaxation_time (Maxwell).
 *
 * For small waves the wall has the modulus Y (1 + i omega damping_time + sum_k share_k i omega
 * tau_k/(1 + i omega tau_k)), where Y is the long-term one of the wall law.
 */
struct WallRelaxation
{
  struct Branch
  {
    double share;           ///< modulus over the long-term modulus [1]
    double relaxation_time; ///< [s]
  };
  double damping_time = 0.; ///< viscosity over the long-term modulus [s]
  std::vector<Branch> branches;

  bool is_elastic() const { return damping_time == 0. && branches.empty(); }
};
} // namespace Continua

#endif
