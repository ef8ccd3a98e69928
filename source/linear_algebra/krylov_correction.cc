#include <continua/linear_algebra/krylov_correction.h>

#include <continua/linear_algebra/function_as_matrix.h>

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <limits>

namespace Continua
{
using namespace dealii;

void KrylovCorrection::reinit(const DistributedVector &velocity, const DistributedVector &pressure)
{
  velocity_work.reinit(velocity);
  pressure_work.reinit(pressure);
  for (BlockVector *vector : {&right_hand_side, &solution, &scaled_back})
  {
    vector->reinit(2);
    vector->block(0).reinit(velocity);
    vector->block(1).reinit(pressure);
    vector->collect_sizes();
  }
}

unsigned int KrylovCorrection::solve(const Derivative &derivative,
                                     const Inverse &inverse,
                                     const Residuals &residuals,
                                     const double tolerance,
                                     const unsigned int maximum_iterations,
                                     DistributedVector &velocity_change,
                                     DistributedVector &pressure_change)
{
  const auto apply_inverse =
      [&](const BlockVector &scaled, DistributedVector &velocity, DistributedVector &pressure)
  {
    scaled_back.block(0).equ(residuals.momentum_scale, scaled.block(0));
    scaled_back.block(1).equ(residuals.mass_scale, scaled.block(1));
    inverse(scaled_back.block(0), scaled_back.block(1), velocity, pressure);
  };
  const auto multiply = [&](BlockVector &target, const BlockVector &source)
  {
    apply_inverse(source, velocity_work, pressure_work);
    derivative(velocity_work, pressure_work, target.block(0), target.block(1));
    target.block(0) *= 1. / residuals.momentum_scale;
    target.block(1) *= 1. / residuals.mass_scale;
  };
  right_hand_side.block(0).equ(1. / residuals.momentum_scale, residuals.momentum);
  right_hand_side.block(1).equ(1. / residuals.mass_scale, residuals.mass);
  solution = 0.;
  IterationNumberControl control(maximum_iterations, tolerance * right_hand_side.l2_norm());
  SolverGMRES<BlockVector> gmres(control, memory,
                                 SolverGMRES<BlockVector>::AdditionalData(maximum_iterations + 2));
  try
  {
    gmres.solve(FunctionAsMatrix<decltype(multiply)>{multiply}, solution, right_hand_side,
                PreconditionIdentity());
  }
  catch (const SolverControl::NoConvergence &)
  {
    // A product is no number. Nor is the correction then, which the next residual shows.
    solution = std::numeric_limits<double>::quiet_NaN();
  }
  apply_inverse(solution, velocity_change, pressure_change);
  return control.last_step();
}
} // namespace Continua
