#include <continua/finite_element/solvers/stalled_block.h>

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
    return "The residual is no number: a load, a coefficient or the state of the run is none";

  const bool is_linear = factors.tangent_terms == TangentTerms::none,
             is_finite = factors.tangent_terms == TangentTerms::finite_deformation;
  const std::string for_tangents = "a smaller time step, or Linear solver/Type = direct";
  const std::string of_small_strains =
      "its preconditioner is that of small strains in the shape of the mesh, which is poor for "
      "thin bodies that rotate and for fibres that stiffen";

  std::ostringstream text;
  text << std::setprecision(2)
       << "Of its residual an iteration leaves, on average at the end: with all blocks together "
       << factors.of_all;
  if (factors.has_stiff && factors.stiff_is_direct)
    text << (is_linear ? ", the stiff block alone 0, since it has a factor"
                       : ", the stiff block has a factor of its linear terms");
  else if (factors.has_stiff)
    text << ", the stiff block alone " << factors.of_stiff;
  if (factors.has_fluid)
    text << ", the fluid block alone " << factors.of_fluid;
  text << ". ";

  if (factors.residual < of_round_off)
    text << "What is left is round-off: use a larger "
         << (is_linear ? "Linear solver/Tolerance" : "Newton/Krylov tolerance");
  else if (factors.of_stiff >= stalling_factor && factors.of_stiff > factors.of_fluid)
    text << "So the stiff block stalls: "
         << (is_finite ? of_small_strains + ". Use " + for_tangents
             : is_linear
                 ? "use Linear solver/Stiff block = direct"
                 : "use Linear solver/Stiff block = direct, a smaller time step, or Type = direct");
  else if (factors.of_fluid >= stalling_factor)
    text << "So the fluid block stalls: use "
         << (!is_linear                  ? for_tangents
             : !factors.fluid_is_viscous ? "Linear solver/Fluid block = algebraic multigrid"
             : factors.has_inertia       ? for_tangents
                                         : "Linear solver/Type = direct");
  else if (factors.of_all < stalling_factor)
    text << "No block stalls: use more Linear solver/Maximum iterations"
         << (is_linear ? "" : ", or a smaller time step");
  else if (parameters.schur_complement == SchurApproximation::simple)
    text << "So the block of the pressure stalls, or what couples the blocks: use "
            "Linear solver/Schur complement = cahouet-chabard";
  else if (is_finite && factors.has_stiff && factors.stiff_is_direct)
    text << "So the stiff block stalls, or what couples the blocks: " << of_small_strains
         << ". Use " << for_tangents;
  else
    text << "So the block of the pressure stalls, or what couples the blocks: use "
         << (parameters.restart_length < parameters.maximum_iterations
                 ? "a larger Linear solver/Restart length, or Type = direct"
             : is_linear ? "Linear solver/Type = direct"
                         : for_tangents);
  return text.str();
}
} // namespace Continua
