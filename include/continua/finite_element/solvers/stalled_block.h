#ifndef continua_finite_element_solvers_stalled_block_h
#define continua_finite_element_solvers_stalled_block_h

#include <continua/finite_element/space/linear_solver_parameters.h>

#include <string>

namespace Continua
{
/// What a matrix has beside the linear terms, which are those of the preconditioner.
enum class TangentTerms
{
  none,
  convection,        ///< of the fluid
  finite_deformation ///< of the solid, and convection where the fluid has it
};

/// What the blocks of the preconditioner of IterativeStepSolver leave of a residual in an iteration
/// (see late_factor()), of a solve that has not converged.
struct BlockFactors
{
  TangentTerms tangent_terms = TangentTerms::none;
  double residual = 0.; ///< that is left, of the largest term of the equations
  double of_all = 0.;   ///< by all blocks together
  bool has_stiff = false, has_fluid = false;
  bool stiff_is_direct = false;        ///< the stiff block has a factor, and is not measured
  double of_stiff = 0., of_fluid = 0.; ///< by a block alone, of its own velocities
  bool fluid_is_viscous = false;       ///< the fluid block has multigrid, else relaxation
  bool has_inertia = true;
};

/// Names the block that stalls, what each one leaves, and the remedy. A block stalls that leaves
/// 0.8 or more: it needs ten iterations and more for a digit. What stalls and is no block of the
/// velocities is the block of the pressure or what couples the blocks. In finite deformation a
/// factor of the stiff block is not exact, and may stall, too.
std::string describe_stalled_block(const BlockFactors &factors,
                                   const LinearSolverParameters &parameters);
} // namespace Continua

#endif
