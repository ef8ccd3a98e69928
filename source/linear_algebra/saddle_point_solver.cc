#include <continua/linear_algebra/saddle_point_solver.h>

#include <continua/linear_algebra/matrix_product.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

SaddlePointSolver::SaddlePointSolver(const unsigned int restart_length)
    : krylov(BlockKrylov::Method::fgmres, restart_length)
{
}

void SaddlePointSolver::reinit(const Blocks &blocks)
{
  velocity_work.reinit(blocks.velocity.diagonal());
  pressure_work.reinit(blocks.compression.locally_owned_range_indices(),
                       blocks.compression.get_mpi_communicator());
  augmented.reinit(pressure_work);
  krylov.reinit(velocity_work, pressure_work);
  inverse_scale.reinit(krylov.scale);
}

void SaddlePointSolver::multiply_blocks(const Blocks &blocks,
                                        const DistributedVector &velocity,
                                        const DistributedVector &pressure,
                                        DistributedVector &momentum,
                                        DistributedVector &mass)
{
  if (blocks.coupled)
    blocks.coupled(velocity, pressure, momentum, mass);
  else
  {
    blocks.velocity.multiply(momentum, velocity);
    blocks.divergence.multiply_transposed(velocity_work, pressure);
    momentum.add(-1., velocity_work);
    blocks.divergence.multiply(mass, velocity);
  }
  multiply(blocks.compression, pressure_work, pressure);
  mass.sadd(-1., -1., pressure_work);
}

void SaddlePointSolver::balance()
{
  const double of_momentum = krylov.scaled_right_hand_side().block(0).l2_norm(),
               of_mass = krylov.scaled_right_hand_side().block(1).l2_norm();
  double ratio = largest_balance;
  if (of_mass > 0.)
    ratio = std::max(1. / largest_balance, std::min(largest_balance, of_momentum / of_mass));
  krylov.scale.block(1) *= ratio;
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
  const DistributedVector *const diagonals[] = {&blocks.velocity.diagonal(),
                                                &schur_complement.diagonal()};
  for (unsigned int b = 0; b < 2; ++b)
    for (unsigned int i = 0; i < diagonals[b]->locally_owned_size(); ++i)
    {
      const double root = std::sqrt(diagonals[b]->begin()[i]);
      inverse_scale.block(b).begin()[i] = root;
      krylov.scale.block(b).begin()[i] = 1. / root;
    }
  krylov.set_right_hand_side(momentum, mass);
  if (balances_equations)
  {
    balance();
    krylov.set_right_hand_side(momentum, mass);
  }

  const Product of_blocks = [&](const DistributedVector &u, const DistributedVector &p,
                                DistributedVector &f, DistributedVector &g)
  { multiply_blocks(blocks, u, p, f, g); };
  const Product &product = blocks.tangent_product ? blocks.tangent_product : of_blocks;
  const auto precondition =
      [&](DistributedVector &f, DistributedVector &g, DistributedVector &u, DistributedVector &p)
  {
    f.scale(inverse_scale.block(0));
    g.scale(inverse_scale.block(1));
    // p = -S^-1 g, and A u = f + B^T (p - W (g + C p)).
    schur_complement.vmult(p, g);
    p *= -1.;
    const bool has_pressures = velocity_inverse.has_pressures();
    augmented.equ(1., p);
    if (!has_pressures)
    {
      multiply(blocks.compression, augmented, p);
      augmented.add(1., g);
      augmented.scale(augmentation);
      augmented.sadd(-1., 1., p);
    }
    blocks.divergence.multiply_transposed(velocity_work, augmented);
    f.add(1., velocity_work);
    if (has_pressures)
      velocity_inverse.vmult(u, p, f, g);
    else
      velocity_inverse.vmult(u, f);
  };

  double size = std::max(krylov.scaled_right_hand_side().block(0).l2_norm(),
                         krylov.scaled_right_hand_side().block(1).l2_norm());
  if (krylov.take_guess(product, velocity, pressure))
  {
    const auto take = [&](DistributedVector &term, const unsigned int block)
    {
      term.scale(krylov.scale.block(block));
      size = std::max(size, term.l2_norm());
    };
    blocks.velocity.multiply(velocity_work, velocity);
    take(velocity_work, 0);
    blocks.divergence.multiply_transposed(velocity_work, pressure);
    take(velocity_work, 0);
    blocks.divergence.multiply(pressure_work, velocity);
    take(pressure_work, 1);
    multiply(blocks.compression, pressure_work, pressure);
    take(pressure_work, 1);
  }
  return krylov.solve(product, precondition, size, tolerance, maximum_iterations, velocity,
                      pressure);
}
} // namespace Continua
