#include <continua/linear_algebra/mixed_precision_solver.h>

#include <continua/linear_algebra/function_as_matrix.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace Continua
{
using namespace dealii;

void MixedPrecisionSolver::reinit(const DistributedVector &velocity,
                                  const DistributedVector &pressure)
{
  for (BlockVector *vector : {&right_hand_side, &solution})
  {
    vector->reinit(2);
    vector->block(0).reinit(velocity);
    vector->block(1).reinit(pressure);
    vector->collect_sizes();
  }
  packed.resize(velocity.locally_owned_size() + pressure.locally_owned_size());
}

KrylovReport MixedPrecisionSolver::solve(const Product &product,
                                         SinglePrecisionFactor &factor,
                                         const DistributedVector &momentum,
                                         const DistributedVector &mass,
                                         DistributedVector &velocity,
                                         DistributedVector &pressure,
                                         const double tolerance,
                                         const unsigned int maximum_iterations)
{
  const std::vector<double> &scale = factor.scale();
  assert(scale.size() == packed.size());
  const auto scale_rows = [&scale](BlockVector &rows)
  {
    auto factor_of_row = scale.begin();
    for (unsigned int b = 0; b < 2; ++b)
      for (double &row : rows.block(b))
        row *= *factor_of_row++;
  };
  const auto multiply = [&](BlockVector &target, const BlockVector &source)
  {
    product(source.block(0), source.block(1), target.block(0), target.block(1));
    scale_rows(target);
  };
  const auto precondition = [&](BlockVector &target, const BlockVector &source)
  {
    const auto middle = std::copy(source.block(0).begin(), source.block(0).end(), packed.begin());
    std::copy(source.block(1).begin(), source.block(1).end(), middle);
    for (std::size_t k = 0; k < packed.size(); ++k)
      packed[k] /= scale[k];
    factor.solve(packed);
    std::copy(packed.begin(), middle, target.block(0).begin());
    std::copy(middle, packed.end(), target.block(1).begin());
  };

  right_hand_side.block(0).equ(1., momentum);
  right_hand_side.block(1).equ(1., mass);
  scale_rows(right_hand_side);
  solution = 0.;
  KrylovReport report;
  const double size = right_hand_side.l2_norm();
  if (size > 0.)
  {
    SolverControl control(maximum_iterations, tolerance * size);
    // No restart: the vectors of few iterations are all kept.
    SolverFGMRES<BlockVector> solver(
        control, memory, SolverFGMRES<BlockVector>::AdditionalData(maximum_iterations + 1));
    try
    {
      solver.solve(FunctionAsMatrix<decltype(multiply)>{multiply}, solution, right_hand_side,
                   FunctionAsMatrix<decltype(precondition)>{precondition});
    }
    catch (const SolverControl::NoConvergence &)
    {
      report.converged = false;
    }
    report.iterations = control.last_step();
    report.residual = control.last_value() / size;
  }
  else if (std::isnan(size))
  {
    // A load is no number. Nor is the solution then, which whoever takes it has to notice.
    solution = std::numeric_limits<double>::quiet_NaN();
    report.residual = size;
  }
  velocity.equ(1., solution.block(0));
  pressure.equ(1., solution.block(1));
  return report;
}
} // namespace Continua
