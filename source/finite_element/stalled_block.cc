#include <continua/finite_element/stalled_block.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace Continua
{
std::string describe_stalled_block(const BlockFactors &factors,
                                   const LinearSolverParameters &parameters)
{
  constexpr double stalling_factor = 0.8;
  /// Of the residual that round-off leaves.
  constexpr double of_round_off = 1e-13;
  if (!std::isfinite(factors.residual) || !std::isfinite(factors.of_all))
    return "The residual is no number: a load or a coefficient of the run is none";

  std::ostringstream text;
  text << std::setprecision(2)
       << "Of its residual an iteration leaves, on average at the end: with all blocks together "
       << factors.of_all;
  if (factors.has_stiff && factors.stiff_is_direct)
    text << ", the stiff block alone 0, since it has a factor";
  else if (factors.has_stiff)
    text << ", the stiff block alone " << factors.of_stiff;
  if (factors.has_fluid)
    text << ", the fluid block alone " << factors.of_fluid;
  text << ". ";

  if (factors.residual < of_round_off)
    text << "What is left is round-off: use a larger Linear solver/Tolerance";
  else if (factors.of_stiff >= stalling_factor && factors.of_stiff > factors.of_fluid)
    text << "So the stiff block stalls: use Linear solver/Stiff block = direct";
  else if (factors.of_fluid >= stalling_factor)
    text << "So the fluid block stalls: use "
         << (!factors.fluid_is_viscous ? "Linear solver/Fluid block = algebraic multigrid"
             : factors.has_inertia     ? "a smaller Time/Time step, or Linear solver/Type = direct"
                                       : "Linear solver/Type = direct");
  else if (factors.of_all >= stalling_factor)
    text << "So the block of the pressure stalls, or what couples the blocks: use "
         << (parameters.schur_complement == SchurApproximation::simple
                 ? "Linear solver/Schur complement = cahouet-chabard"
             : parameters.restart_length < parameters.maximum_iterations
                 ? "a larger Linear solver/Restart length, or Type = direct"
                 : "Linear solver/Type = direct");
  else
    text << "No block stalls: use more Linear solver/Maximum iterations";
  return text.str();
}
} // namespace Continua
