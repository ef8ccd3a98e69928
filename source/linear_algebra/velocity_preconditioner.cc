#include <continua/linear_algebra/matrix_product.h>
#include <continua/linear_algebra/velocity_preconditioner.h>

#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

namespace
{
/// Smoothed aggregation node by node, that keeps the modes.
void make_multigrid(const SubMatrix &block,
                    const VelocityBlocks &blocks,
                    TrilinosWrappers::PreconditionAMG &multigrid)
{
  const std::vector<unsigned int> &rows = block.rows();
  std::vector<double> modes;
  for (const std::vector<double> &mode : blocks.modes)
    for (const unsigned int row : rows)
      modes.push_back(mode[row]);
  modes.resize(std::max<std::size_t>(modes.size(), 1));
  Teuchos::ParameterList list;
  ML_Epetra::SetDefaults("SA", list);
  list.set("ML output", 0);
  list.set("PDE equations", static_cast<int>(blocks.n_components));
  list.set("null space: type", "pre-computed");
  list.set("null space: dimension", static_cast<int>(blocks.modes.size()));
  list.set("null space: vectors", modes.data());
  list.set("null space: add default vectors", false);
  list.set("aggregation: type", "Uncoupled");
  list.set("aggregation: threshold", 0.);
  list.set("smoother: type", "Chebyshev");
  list.set("smoother: sweeps", 2);
  list.set("smoother: Chebyshev alpha", 20.);
  list.set("coarse: max size", 1000);
  list.set("coarse: type", "Amesos-KLU");
  multigrid.initialize(block.matrix(), list);
}
} // namespace

VelocityPreconditioner::VelocityPreconditioner(const TrilinosWrappers::SparseMatrix &matrix,
                                               const VelocityBlocks &blocks)
    : VelocityPreconditioner(matrix, nullptr, nullptr, blocks, {})
{
}

VelocityPreconditioner::VelocityPreconditioner(const TrilinosWrappers::SparseMatrix &matrix,
                                               const TrilinosWrappers::SparseMatrix &divergence,
                                               const TrilinosWrappers::SparseMatrix &compression,
                                               const VelocityBlocks &blocks,
                                               const std::vector<unsigned int> &stiff_pressures)
    : VelocityPreconditioner(matrix, &divergence, &compression, blocks, stiff_pressures)
{
}

VelocityPreconditioner::VelocityPreconditioner(
    const TrilinosWrappers::SparseMatrix &matrix,
    const TrilinosWrappers::SparseMatrix *const divergence,
    const TrilinosWrappers::SparseMatrix *const compression,
    const VelocityBlocks &blocks,
    const std::vector<unsigned int> &stiff_pressures)
    : matrix(matrix),
      divergence(divergence),
      has_stiff(Utilities::MPI::max(blocks.stiff.size(), matrix.get_mpi_communicator()) > 0),
      has_fluid(Utilities::MPI::max(blocks.fluid.size(), matrix.get_mpi_communicator()) > 0),
      stiff_is_direct(blocks.stiff_is_direct),
      fluid_is_viscous(blocks.fluid_is_viscous)
{
  const IndexSet owned = matrix.locally_owned_range_indices();
  residual.reinit(owned, matrix.get_mpi_communicator());
  correction.reinit(residual);
  if (divergence != nullptr)
  {
    saddle_point = std::make_unique<SaddlePointBlock>(
        matrix.trilinos_matrix(), divergence->trilinos_matrix(), compression->trilinos_matrix(),
        blocks.stiff, stiff_pressures);
    pressure_residual.reinit(divergence->locally_owned_range_indices(),
                             divergence->get_mpi_communicator());
    pressure_work.reinit(pressure_residual);
  }
  else if (has_stiff)
  {
    stiff = std::make_unique<SubMatrix>(matrix.trilinos_matrix(), blocks.stiff);
    if (stiff_is_direct)
    {
      const SymmetricTriplets triangle = stiff->lower_triangle();
      stiff_factor = make_symmetric_factor(DirectSolver::automatic, true, triangle.values.size(),
                                           matrix.get_mpi_communicator());
      stiff_factor->factorize(triangle, stiff->owned());
    }
    else
      make_multigrid(*stiff, blocks, stiff_multigrid);
  }
  if (has_fluid && fluid_is_viscous)
  {
    fluid = std::make_unique<SubMatrix>(matrix.trilinos_matrix(), blocks.fluid);
    make_multigrid(*fluid, blocks, fluid_multigrid);
  }
  if (has_fluid && !fluid_is_viscous)
    relaxation.initialize(matrix);
  part.resize(std::max(blocks.stiff.size(), blocks.fluid.size()));
  part_of_solution.resize(part.size());
}

VelocityPreconditioner::~VelocityPreconditioner() = default;

void VelocityPreconditioner::apply(const SubMatrix &block,
                                   const TrilinosWrappers::PreconditionAMG &multigrid,
                                   DistributedVector &target,
                                   const DistributedVector &source)
{
  part.resize(part_of_solution.size());
  block.gather(source.begin(), part.data());
  const Epetra_Vector right_hand_side(View, block.matrix().RowMap(), part.data());
  Epetra_Vector solution(View, block.matrix().RowMap(), part_of_solution.data());
  multigrid.trilinos_operator().ApplyInverse(right_hand_side, solution);
  block.scatter_add(part_of_solution.data(), target.begin());
}

void VelocityPreconditioner::relax(DistributedVector &target, const DistributedVector &source)
{
  if (fluid_is_viscous)
  {
    apply(*fluid, fluid_multigrid, target, source);
    return;
  }
  relaxation.vmult(correction, source);
  target.add(1., correction);
}

void VelocityPreconditioner::leave_residual(const DistributedVector &target,
                                            const DistributedVector &source)
{
  multiply(matrix, residual, target);
  residual.sadd(-1., 1., source);
}

void VelocityPreconditioner::add_stiff(DistributedVector &target, const DistributedVector &source)
{
  if (saddle_point)
  {
    pressure_residual = 0.;
    saddle_point->add_solution(source.begin(), pressure_residual.begin(), target.begin(),
                               pressure_work.begin());
  }
  else if (stiff_is_direct)
  {
    part.resize(stiff->rows().size()); // within its capacity
    stiff->gather(source.begin(), part.data());
    stiff_factor->solve(part);
    stiff->scatter_add(part.data(), target.begin());
  }
  else
    apply(*stiff, stiff_multigrid, target, source);
}

void VelocityPreconditioner::solve_stiff(DistributedVector &target, const DistributedVector &source)
{
  target = 0.;
  add_stiff(target, source);
}

void VelocityPreconditioner::vmult(DistributedVector &target, const DistributedVector &source)
{
  target = 0.;
  if (has_fluid)
    relax(target, source);
  if (has_stiff)
  {
    if (has_fluid)
      leave_residual(target, source);
    else
      residual.equ(1., source);
    add_stiff(target, residual);
    if (has_fluid)
    {
      leave_residual(target, source);
      relax(target, residual);
    }
  }
}

void VelocityPreconditioner::vmult(DistributedVector &velocity,
                                   DistributedVector &pressure,
                                   const DistributedVector &momentum,
                                   const DistributedVector &mass)
{
  const auto leave_momentum = [&]()
  {
    leave_residual(velocity, momentum);
    multiply_transposed(*divergence, correction, pressure);
    residual.add(1., correction);
  };
  velocity = 0.;
  if (has_fluid)
  {
    leave_momentum();
    relax(velocity, residual);
  }
  leave_momentum();
  multiply(*divergence, pressure_residual, velocity);
  pressure_residual.add(1., mass);
  saddle_point->add_solution(residual.begin(), pressure_residual.begin(), velocity.begin(),
                             pressure.begin());
  if (has_fluid)
  {
    leave_momentum();
    relax(velocity, residual);
  }
}
} // namespace Continua
