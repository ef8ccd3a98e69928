#ifndef continua_finite_element_solvers_iterative_preconditioner_plan_h
#define continua_finite_element_solvers_iterative_preconditioner_plan_h

#include <continua/linear_algebra/distributed_vector.h>
#include <continua/linear_algebra/velocity_blocks.h>

#include <vector>

namespace Continua
{
/// What is decided before a preconditioner of a step's system is made: its blocks, and how each of
/// them is inverted.
struct PreconditionerPlan
{
  VelocityBlocks parts;
  /// Local indices of the pressures that are factored together with the stiff velocities.
  std::vector<unsigned int> stiff_pressures;
  DistributedVector mobility; ///< D of the Schur complement [s/kg]
  /// Whether D is known, by inertia or by friction; else the mass form serves alone.
  bool has_mobility = false;
  /// Whether the stiff velocities and pressures have one factor.
  bool has_joint_block = false;
  /// Whether the velocities outside the stiff block are relaxed by products without a matrix.
  bool relaxes_without_matrix = false;
  /// Whether these products are those of a multigrid, else of a polynomial.
  bool fluid_has_multigrid = false;
};
} // namespace Continua

#endif
