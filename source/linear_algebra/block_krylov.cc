#include <continua/linear_algebra/block_krylov.h>

#include <continua/linear_algebra/convergence_factor.h>
#include <continua/linear_algebra/function_as_matrix.h>
#include <continua/linear_algebra/gmres_data.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <cmath>
#include <limits>

namespace Continua
{
using namespace dealii;

BlockKrylov::BlockKrylov(const Method method, const unsigned int basis_size)
    : method(method), basis_size(basis_size)
{
}

void BlockKrylov::reinit(const DistributedVector &velocity, const DistributedVector &pressure)
{
  for (BlockVector *vector : {&scale, &right_hand_side, &solution, &rows})
  {
    vector->reinit(2);
    vector->block(0).reinit(velocity);
    vector->block(1).reinit(pressure);
    vector->collect_sizes();
  }
}

void BlockKrylov::set_right_hand_side(const DistributedVector &momentum,
                                      const DistributedVector &mass)
{
  right_hand_side.block(0).equ(1., momentum);
  right_hand_side.block(1).equ(1., mass);
  right_hand_side.scale(scale);
  solution = 0.;
}

void BlockKrylov::multiply(const Product &product,
                           BlockVector &target,
                           const BlockVector &source) const
{
  product(source.block(0), source.block(1), target.block(0), target.block(1));
  target.scale(scale);
}

bool BlockKrylov::take_guess(const Product &product,
                             const DistributedVector &velocity,
                             const DistributedVector &pressure)
{
  solution.block(0).equ(1., velocity);
  solution.block(1).equ(1., pressure);
  multiply(product, rows, solution);
  rows.add(-1., right_hand_side);
  if (rows.l2_norm() < right_hand_side.l2_norm())
    return true;
  solution = 0.;
  return false;
}

KrylovReport BlockKrylov::solve(const Product &product,
                                const Inverse &inverse,
                                const double size,
                                const double tolerance,
                                const unsigned int maximum_iterations,
                                DistributedVector &velocity,
                                DistributedVector &pressure)
{
  const auto multiply_scaled = [&](BlockVector &target, const BlockVector &source)
  { multiply(product, target, source); };
  const auto precondition = [&](BlockVector &target, const BlockVector &source)
  {
    rows.equ(1., source);
    inverse(rows.block(0), rows.block(1), target.block(0), target.block(1));
  };
  const FunctionAsMatrix<decltype(multiply_scaled)> matrix{multiply_scaled};
  const FunctionAsMatrix<decltype(precondition)> preconditioner{precondition};
  KrylovReport report;
  if (size > 0.)
  {
    SolverControl control(maximum_iterations, tolerance * size);
    control.enable_history_data();
    try
    {
      if (method == Method::gmres)
        SolverGMRES<BlockVector>(control, memory, gmres_data<BlockVector>(basis_size))
            .solve(matrix, solution, right_hand_side, preconditioner);
      else
        SolverFGMRES<BlockVector>(control, memory, fgmres_data<BlockVector>(basis_size))
            .solve(matrix, solution, right_hand_side, preconditioner);
    }
    catch (const SolverControl::NoConvergence &)
    {
      report.converged = false;
    }
    report.iterations = control.last_step();
    report.late_factor = late_factor(control.get_history_data());
    report.residual = control.last_value() / size;
  }
  else
  {
    solution = 0.;
    report.residual = size;
  }
  if (std::isnan(report.residual))
    solution = std::numeric_limits<double>::quiet_NaN();
  velocity.equ(1., solution.block(0));
  pressure.equ(1., solution.block(1));
  return report;
}
} // namespace Continua
