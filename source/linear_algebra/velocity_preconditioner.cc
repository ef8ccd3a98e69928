#include <continua/linear_algebra/block_multigrid.h>
#include <continua/linear_algebra/sub_matrix.h>
#include <continua/linear_algebra/velocity_preconditioner.h>

#include <deal.II/base/mpi.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_FEVector.h>
#include <Epetra_Map.h>

#include <utility>

namespace Continua
{
using namespace dealii;

VelocityPreconditioner::VelocityPreconditioner(
    const TrilinosWrappers::SparseMatrix &matrix,
    const VelocityBlocks &blocks,
    std::unique_ptr<VelocityRelaxation> relaxation_of_fluid)
    : relaxation(std::move(relaxation_of_fluid)),
      has_stiff(Utilities::MPI::max(blocks.stiff.size(), matrix.get_mpi_communicator()) > 0),
      residual(matrix.locally_owned_range_indices(), matrix.get_mpi_communicator())
{
  if (!has_stiff)
    return;
  if (blocks.stiff_is_direct)
    stiff_factor = std::make_unique<BlockFactor>(matrix, blocks.stiff, blocks.most_factor_bytes);
  else
    stiff_multigrid = std::make_unique<BlockMultigrid>(matrix, blocks.stiff, blocks);
}

VelocityPreconditioner::VelocityPreconditioner(
    const DistributedVector &velocities,
    std::unique_ptr<VelocityCycle> multigrid_of_stiff,
    std::unique_ptr<VelocityRelaxation> relaxation_of_fluid)
    : relaxation(std::move(relaxation_of_fluid)),
      has_stiff(true),
      stiff_multigrid(std::move(multigrid_of_stiff))
{
  residual.reinit(velocities);
}

VelocityPreconditioner::VelocityPreconditioner(
    const TrilinosWrappers::SparseMatrix &divergence,
    std::unique_ptr<SaddlePointBlock> stiff_block,
    const std::vector<unsigned int> &pressures_of_stiff,
    std::unique_ptr<VelocityRelaxation> relaxation_of_fluid)
    : relaxation(std::move(relaxation_of_fluid)),
      has_stiff(true),
      residual(divergence.locally_owned_domain_indices(), divergence.get_mpi_communicator()),
      saddle_point(std::move(stiff_block)),
      stiff_pressures(pressures_of_stiff)
{
  velocity_work.reinit(residual);
  pressure_residual.reinit(divergence.locally_owned_range_indices(),
                           divergence.get_mpi_communicator());
  pressure_work.reinit(pressure_residual);
  const Epetra_Map map(-1, static_cast<int>(stiff_pressures.size()), 0,
                       divergence.trilinos_matrix().Comm());
  stiff_divergence = std::make_unique<Epetra_CrsMatrix>(
      rows_of(divergence.trilinos_matrix(), stiff_pressures, map));
  pressure_part = std::make_unique<Epetra_Vector>(map);
}

VelocityPreconditioner::~VelocityPreconditioner() = default;

void VelocityPreconditioner::add_stiff(DistributedVector &target, const DistributedVector &source)
{
  if (saddle_point)
  {
    pressure_residual = 0.;
    saddle_point->add_solution(source.begin(), pressure_residual.begin(), target.begin(),
                               pressure_work.begin());
  }
  else if (stiff_factor)
    stiff_factor->add_cycle(target, source);
  else
    stiff_multigrid->add_cycle(target, source);
}

void VelocityPreconditioner::solve_stiff(DistributedVector &target, const DistributedVector &source)
{
  target = 0.;
  add_stiff(target, source);
}

void VelocityPreconditioner::relax_fluid(DistributedVector &target, const DistributedVector &source)
{
  target = 0.;
  relaxation->add_relaxed(target, source);
}

void VelocityPreconditioner::vmult(DistributedVector &target, const DistributedVector &source)
{
  target = 0.;
  if (!relaxation)
  {
    add_stiff(target, source);
    return;
  }
  relaxation->add_relaxed(target, source);
  if (!has_stiff)
    return;
  relaxation->leave_residual(residual, target, source);
  add_stiff(target, residual);
  relaxation->leave_residual(residual, target, source);
  relaxation->add_relaxed(target, residual);
}

void VelocityPreconditioner::vmult(DistributedVector &velocity,
                                   DistributedVector &pressure,
                                   const DistributedVector &momentum,
                                   const DistributedVector &mass)
{
  velocity = 0.;
  pressure_residual.equ(1., mass);
  if (!relaxation)
  {
    saddle_point->add_solution(momentum.begin(), pressure_residual.begin(), velocity.begin(),
                               pressure.begin());
    return;
  }
  relaxation->add_relaxed(velocity, momentum);
  relaxation->leave_residual(residual, velocity, momentum);
  stiff_divergence->Multiply(false, *velocity.trilinos_vector()(0), *pressure_part);
  for (std::size_t k = 0; k < stiff_pressures.size(); ++k)
    pressure_residual.begin()[stiff_pressures[k]] += (*pressure_part)[static_cast<int>(k)];
  saddle_point->add_solution(residual.begin(), pressure_residual.begin(), velocity.begin(),
                             pressure.begin());
  for (std::size_t k = 0; k < stiff_pressures.size(); ++k)
    (*pressure_part)[static_cast<int>(k)] = pressure.begin()[stiff_pressures[k]];
  stiff_divergence->Multiply(true, *pressure_part, *velocity_work.trilinos_vector()(0));
  velocity_work.add(1., momentum);
  relaxation->leave_residual(residual, velocity, velocity_work);
  relaxation->add_relaxed(velocity, residual);
}
} // namespace Continua
