#ifndef continua_linear_algebra_velocity_preconditioner_h
#define continua_linear_algebra_velocity_preconditioner_h

#include <continua/linear_algebra/distributed_vector.h>
#include <continua/linear_algebra/saddle_point_block.h>
#include <continua/linear_algebra/sub_matrix.h>
#include <continua/linear_algebra/symmetric_factor.h>

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// What a preconditioner of the velocities is told of them.
struct VelocityBlocks
{
  std::vector<unsigned int> stiff; ///< local indices, node by node
  std::vector<unsigned int> fluid; ///< the others, node by node
  bool stiff_is_direct = true;     ///< else algebraic multigrid
  bool fluid_is_viscous = false;   ///< algebraic multigrid on the fluid, else relaxation
  /// Motions that take next to no force, by mode and local index: rigid ones.
  std::vector<std::vector<double>> modes;
  unsigned int n_components = 1; ///< unknowns of a node
};

/**
 * An approximate inverse of A = a0 rho M + alpha S whose alpha jumps by orders of magnitude between
 * fluid and solid: relaxation on all unknowns, then a solve with the block of the stiff ones, then
 * relaxation again, each on the residual that the others left.
 *
 * With pressures of the stiff unknowns the stiff block is that of [A -B^T; -B -C], factored as one:
 * the solve then finds these pressures, too, and a change of volume needs no other care.
 */
class VelocityPreconditioner
{
public:
  /// `matrix` must outlive it.
  VelocityPreconditioner(const dealii::TrilinosWrappers::SparseMatrix &matrix,
                         const VelocityBlocks &blocks);
  /// With the local indices of the stiff pressures; B must outlive it. The stiff block is direct.
  VelocityPreconditioner(const dealii::TrilinosWrappers::SparseMatrix &matrix,
                         const dealii::TrilinosWrappers::SparseMatrix &divergence,
                         const dealii::TrilinosWrappers::SparseMatrix &compression,
                         const VelocityBlocks &blocks,
                         const std::vector<unsigned int> &stiff_pressures);
  ~VelocityPreconditioner();

  /// Without stiff pressures: target = the approximate inverse times source.
  void vmult(DistributedVector &target, const DistributedVector &source);
  /// With them: the velocity, and the stiff ones of `pressure`, whose others are known.
  void vmult(DistributedVector &velocity,
             DistributedVector &pressure,
             const DistributedVector &momentum,
             const DistributedVector &mass);
  bool has_pressures() const { return saddle_point != nullptr; }
  /// target = what the stiff unknowns alone do under the source, zero elsewhere: by the factor, or
  /// by one cycle of multigrid. There have to be stiff ones.
  void solve_stiff(DistributedVector &target, const DistributedVector &source);

  /// Of the stiff block; null if there is none.
  const SymmetricFactor *factor() const
  {
    return saddle_point ? &saddle_point->factor() : stiff_factor.get();
  }

private:
  const dealii::TrilinosWrappers::SparseMatrix &matrix;
  const dealii::TrilinosWrappers::SparseMatrix *const divergence; ///< null without pressures
  std::unique_ptr<SaddlePointBlock> saddle_point;
  std::unique_ptr<SubMatrix> stiff, fluid;
  std::unique_ptr<SymmetricFactor> stiff_factor;
  dealii::TrilinosWrappers::PreconditionAMG stiff_multigrid, fluid_multigrid;
  dealii::TrilinosWrappers::PreconditionSSOR relaxation;
  bool has_stiff, has_fluid, stiff_is_direct, fluid_is_viscous;
  DistributedVector residual, correction, pressure_residual, pressure_work;
  std::vector<double> part, part_of_solution;

  VelocityPreconditioner(const dealii::TrilinosWrappers::SparseMatrix &matrix,
                         const dealii::TrilinosWrappers::SparseMatrix *divergence,
                         const dealii::TrilinosWrappers::SparseMatrix *compression,
                         const VelocityBlocks &blocks,
                         const std::vector<unsigned int> &stiff_pressures);
  void add_stiff(DistributedVector &target, const DistributedVector &source);
  void relax(DistributedVector &target, const DistributedVector &source);
  void apply(const SubMatrix &block,
             const dealii::TrilinosWrappers::PreconditionAMG &multigrid,
             DistributedVector &target,
             const DistributedVector &source);
  void leave_residual(const DistributedVector &target, const DistributedVector &source);
};
} // namespace Continua

#endif
