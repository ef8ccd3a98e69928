#include <continua/linear_algebra/matrix_product.h>
#include <continua/linear_algebra/matrix_relaxation.h>

namespace Continua
{
using namespace dealii;

MatrixRelaxation::MatrixRelaxation(const TrilinosWrappers::SparseMatrix &matrix,
                                   const VelocityBlocks &blocks)
    : matrix(matrix),
      correction(matrix.locally_owned_range_indices(), matrix.get_mpi_communicator())
{
  if (blocks.fluid_is_viscous)
    multigrid = std::make_unique<BlockMultigrid>(matrix, blocks.fluid, blocks);
  else
    sweep.initialize(matrix);
}

void MatrixRelaxation::add_relaxed(DistributedVector &velocity, const DistributedVector &residual)
{
  if (multigrid)
  {
    multigrid->add_cycle(velocity, residual);
    return;
  }
  sweep.vmult(correction, residual);
  velocity.add(1., correction);
}

void MatrixRelaxation::leave_residual(DistributedVector &residual,
                                      const DistributedVector &velocity,
                                      const DistributedVector &source)
{
  multiply(matrix, residual, velocity);
  residual.sadd(-1., 1., source);
}
} // namespace Continua
