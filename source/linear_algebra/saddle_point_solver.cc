#include <continua/linear_algebra/saddle_point_solver.h>

#include <continua/linear_algebra/convergence_factor.h>
#include <continua/linear_algebra/function_as_matrix.h>
#include <continua/linear_algebra/matrix_product.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Continua
{
using namespace dealii;

SaddlePointSolver::SaddlePointSolver(const unsigned int restart_length)
    : restart_length(restart_length)
{
}

void SaddlePointSolver::reinit(const Blocks &blocks)
{
  velocity_work.reinit(blocks.velocity.diagonal());
  pressure_work.reinit(blocks.compression.locally_owned_range_indices(),
                       blocks.compression.get_mpi_communicator());
  augmented.reinit(pressure_work);
  for (BlockVector *vector : {&scale, &inverse_scale, &right_hand_side, &solution, &product})
  {
    vector->reinit(2);
    vector->block(0).reinit(velocity_work);
    vector->block(1).reinit(pressure_work);
    vector->collect_sizes();
  }
}

void SaddlePointSolver::multiply_blocks(const Blocks &blocks,
                                        BlockVector &target,
                                        const BlockVector &source)
{
  if (blocks.whole)
  {
    blocks.whole(source.block(0), source.block(1), target.block(0), target.block(1));
    return;
  }
  blocks.velocity.multiply(target.block(0), source.block(0));
  blocks.divergence.multiply_transposed(velocity_work, source.block(1));
  target.block(0).add(-1., velocity_work);
  blocks.divergence.multiply(target.block(1), source.block(0));
  multiply(blocks.compression, pressure_work, source.block(1));
  target.block(1).sadd(-1., -1., pressure_work);
  if (blocks.further)
    blocks.further(source.block(0), source.block(1), target.block(0), target.block(1));
}

void SaddlePointSolver::balance(const DistributedVector &momentum, const DistributedVector &mass)
{
  right_hand_side.block(0).equ(1., momentum);
  right_hand_side.block(1).equ(1., mass);
  right_hand_side.scale(scale);
  const double of_momentum = right_hand_side.block(0).l2_norm(),
               of_mass = right_hand_side.block(1).l2_norm();
  double ratio = largest_balance;
  if (of_mass > 0.)
    ratio = std::max(1. / largest_balance, std::min(largest_balance, of_momentum / of_mass));
  scale.block(1) *= ratio;
  inverse_scale.block(1) *= 1. / ratio;
}

KrylovReport SaddlePointSolver::solve(const Blocks &blocks,
                                      VelocityPreconditioner &velocity_inverse,
                                      SchurComplement &schur_complement,
                                      const DistributedVector &augmentation,
                                      const DistributedVector &momentum,
                                      const DistributedVector &mass,
                                      DistributedVector &velocity,
                                      DistributedVector &pressure,
                                      const double tolerance,
                                      const unsigned int maximum_iterations,
                                      const bool balances_equations)
{
  for (unsigned int i = 0; i < velocity_work.locally_owned_size(); ++i)
    inverse_scale.block(0).begin()[i] = std::sqrt(blocks.velocity.diagonal().begin()[i]);
  for (unsigned int i = 0; i < pressure_work.locally_owned_size(); ++i)
    inverse_scale.block(1).begin()[i] = std::sqrt(schur_complement.diagonal().begin()[i]);
  for (unsigned int b = 0; b < 2; ++b)
    for (unsigned int i = 0; i < scale.block(b).locally_owned_size(); ++i)
      scale.block(b).begin()[i] = 1. / inverse_scale.block(b).begin()[i];
  if (balances_equations)
    balance(momentum, mass);

  // The operator, its rows scaled; and the preconditioner of such rows.
  const auto multiply_scaled = [&](BlockVector &target, const BlockVector &source)
  {
    multiply_blocks(blocks, target, source);
    target.scale(scale);
  };
  const auto precondition = [&](BlockVector &target, const BlockVector &source)
  {
    product.equ(1., source);
    product.scale(inverse_scale);
    // p = -S^-1 g, and A u = f + B^T (p - W (g + C p)).
    schur_complement.vmult(target.block(1), product.block(1));
    target.block(1) *= -1.;
    const bool has_pressures = velocity_inverse.has_pressures();
    augmented.equ(1., target.block(1));
    if (!has_pressures)
    {
      multiply(blocks.compression, augmented, target.block(1));
      augmented.add(1., product.block(1));
      augmented.scale(augmentation);
      augmented.sadd(-1., 1., target.block(1));
    }
    blocks.divergence.multiply_transposed(velocity_work, augmented);
    product.block(0).add(1., velocity_work);
    if (has_pressures)
      velocity_inverse.vmult(target.block(0), target.block(1), product.block(0), product.block(1));
    else
      velocity_inverse.vmult(target.block(0), product.block(0));
  };

  right_hand_side.block(0).equ(1., momentum);
  right_hand_side.block(1).equ(1., mass);
  right_hand_side.scale(scale);
  solution.block(0).equ(1., velocity);
  solution.block(1).equ(1., pressure);
  double size = std::max(right_hand_side.block(0).l2_norm(), right_hand_side.block(1).l2_norm());
  multiply_scaled(product, solution);
  product.add(-1., right_hand_side);
  if (product.l2_norm() < right_hand_side.l2_norm())
  {
    const auto take = [&size](DistributedVector &term, const DistributedVector &scale_of_rows)
    {
      term.scale(scale_of_rows);
      size = std::max(size, term.l2_norm());
    };
    blocks.velocity.multiply(velocity_work, velocity);
    take(velocity_work, scale.block(0));
    blocks.divergence.multiply_transposed(velocity_work, pressure);
    take(velocity_work, scale.block(0));
    blocks.divergence.multiply(pressure_work, velocity);
    take(pressure_work, scale.block(1));
    multiply(blocks.compression, pressure_work, pressure);
    take(pressure_work, scale.block(1));
  }
  else
    solution = 0.;

  KrylovReport report;
  if (size > 0.)
  {
    SolverControl control(maximum_iterations, tolerance * size);
    control.enable_history_data();
    SolverFGMRES<BlockVector> solver(control, memory,
                                     SolverFGMRES<BlockVector>::AdditionalData(restart_length));
    try
    {
      solver.solve(FunctionAsMatrix<decltype(multiply_scaled)>{multiply_scaled}, solution,
                   right_hand_side, FunctionAsMatrix<decltype(precondition)>{precondition});
    }
    catch (const SolverControl::NoConvergence &)
    {
      report.converged = false;
    }
    report.iterations = control.last_step();
    report.late_factor = late_factor(control.get_history_data());
    report.residual = control.last_value() / size;
  }
  else if (std::isnan(size))
  {
    // A load is no number. Nor is the solution then, which whoever takes it has to notice.
    solution = std::numeric_limits<double>::quiet_NaN();
    report.residual = size;
  }
  else
    solution = 0.;
  velocity.equ(1., solution.block(0));
  pressure.equ(1., solution.block(1));
  return report;
}
} // namespace Continua
