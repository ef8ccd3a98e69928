#ifndef continua_linear_algebra_velocity_preconditioner_h
#define continua_linear_algebra_velocity_preconditioner_h

#include <continua/linear_algebra/block_factor.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/linear_algebra/saddle_point_block.h>
#include <continua/linear_algebra/symmetric_factor.h>
#include <continua/linear_algebra/velocity_blocks.h>
#include <continua/linear_algebra/velocity_cycle.h>
#include <continua/linear_algebra/velocity_relaxation.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Epetra_Vector.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * An approximate inverse of A = a0 rho M + alpha S whose alpha jumps by orders of magnitude between
 * fluid and solid: relaxation of the fluid, then a solve with the block of the stiff velocities,
 * then relaxation again, each on the residual that the others left.
 *
 * With pressures of the stiff velocities the stiff block is that of [A -B^T; -B -C], factored as
 * one: the solve then finds these pressures, too, and a change of volume needs no other care.
 */
class VelocityPreconditioner
{
public:
  /// Of the matrix only the rows of the stiff velocities are used, and they are not kept. Without a
  /// relaxation all velocities but hanging ones must be stiff.
  VelocityPreconditioner(const dealii::TrilinosWrappers::SparseMatrix &matrix,
                         const VelocityBlocks &blocks,
                         std::unique_ptr<VelocityRelaxation> relaxation);
  /// With multigrid for the stiff velocities. `velocities`: a vector of them.
  VelocityPreconditioner(const DistributedVector &velocities,
                         std::unique_ptr<VelocityCycle> stiff_multigrid,
                         std::unique_ptr<VelocityRelaxation> relaxation);
  /// With the factored block of the stiff velocities and pressures, and the local indices of the
  /// latter. Of B it keeps the rows of these.
  VelocityPreconditioner(const dealii::TrilinosWrappers::SparseMatrix &divergence,
                         std::unique_ptr<SaddlePointBlock> stiff_block,
                         const std::vector<unsigned int> &stiff_pressures,
                         std::unique_ptr<VelocityRelaxation> relaxation);
  ~VelocityPreconditioner();

  /// Without stiff pressures: target = the approximate inverse times source.
  void vmult(DistributedVector &target, const DistributedVector &source);
  /// With them: the velocity, and the stiff ones of `pressure`, which are zero before; the others
  /// are known, and their forces are a part of `momentum`.
  void vmult(DistributedVector &velocity,
             DistributedVector &pressure,
             const DistributedVector &momentum,
             const DistributedVector &mass);
  bool has_pressures() const { return saddle_point != nullptr; }
  /// target = what the stiff velocities alone do under the source, zero elsewhere: by the factor,
  /// or by one cycle of multigrid. There have to be stiff ones.
  void solve_stiff(DistributedVector &target, const DistributedVector &source);
  /// target = the relaxation alone, without the stiff block; what it leaves at stiff velocities has
  /// no meaning. There has to be a fluid.
  void relax_fluid(DistributedVector &target, const DistributedVector &source);

  /// Of the stiff block; null if there is none.
  const SymmetricFactor *factor() const
  {
    if (saddle_point)
      return &saddle_point->factor();
    return stiff_factor ? &stiff_factor->factor() : nullptr;
  }

private:
  const std::unique_ptr<VelocityRelaxation> relaxation; ///< null without a fluid
  const bool has_stiff;
  std::unique_ptr<BlockFactor> stiff_factor;
  std::unique_ptr<VelocityCycle> stiff_multigrid;
  DistributedVector residual;

  // With stiff pressures.
  std::unique_ptr<SaddlePointBlock> saddle_point;
  std::vector<unsigned int> stiff_pressures;
  std::unique_ptr<Epetra_CrsMatrix> stiff_divergence; ///< rows of B
  std::unique_ptr<Epetra_Vector> pressure_part;
  DistributedVector velocity_work, pressure_residual, pressure_work;

  void add_stiff(DistributedVector &target, const DistributedVector &source);
};
} // namespace Continua

#endif
