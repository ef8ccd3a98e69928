#ifndef continua_linear_algebra_block_multigrid_h
#define continua_linear_algebra_block_multigrid_h

#include <continua/linear_algebra/distributed_vector.h>
#include <continua/linear_algebra/sub_matrix.h>
#include <continua/linear_algebra/velocity_blocks.h>
#include <continua/linear_algebra/velocity_cycle.h>

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <vector>

namespace Continua
{
/// Algebraic multigrid for some of the velocities: smoothed aggregation node by node, that keeps
/// the modes.
class BlockMultigrid : public VelocityCycle
{
public:
  /// `rows`: the local indices of its velocities. Modes and number of components are those of
  /// `blocks`.
  BlockMultigrid(const dealii::TrilinosWrappers::SparseMatrix &matrix,
                 const std::vector<unsigned int> &rows,
                 const VelocityBlocks &blocks);

  void add_cycle(DistributedVector &target, const DistributedVector &source) override;

private:
  SubMatrix block;
  dealii::TrilinosWrappers::PreconditionAMG multigrid;
  std::vector<double> part, part_of_solution;
};
} // namespace Continua

#endif
