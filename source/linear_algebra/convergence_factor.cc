#include <continua/linear_algebra/convergence_factor.h>

#include <continua/linear_algebra/function_as_matrix.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

double convergence_factor(const LinearFunction &matrix,
                          const LinearFunction &preconditioner,
                          const DistributedVector &diagonal,
                          const DistributedVector &is_of_block)
{
  constexpr unsigned int n_iterations = 20;
  constexpr double small_enough = 1e-10;

  // Roots of the diagonal and of its inverse, zero outside of the block.
  DistributedVector scale(is_of_block), inverse_scale(is_of_block), work(is_of_block);
  for (unsigned int i = 0; i < scale.locally_owned_size(); ++i)
  {
    const double root = std::sqrt(diagonal.begin()[i]);
    scale.begin()[i] /= root;
    inverse_scale.begin()[i] *= root;
  }
  const auto multiply = [&](DistributedVector &target, const DistributedVector &source)
  {
    work.equ(1., source);
    work.scale(is_of_block);
    matrix(target, work);
    target.scale(scale);
  };
  const auto precondition = [&](DistributedVector &target, const DistributedVector &source)
  {
    work.equ(1., source);
    work.scale(inverse_scale);
    preconditioner(target, work);
    target.scale(is_of_block);
  };

  // Without order, and the same on any number of ranks.
  DistributedVector solution(is_of_block), right_hand_side(is_of_block);
  const IndexSet owned = solution.locally_owned_elements();
  for (unsigned int i = 0; i < solution.locally_owned_size(); ++i)
    solution.begin()[i] = scale.begin()[i] * std::sin(1e4 * (1. + owned.nth_index_in_set(i)));
  multiply(right_hand_side, solution);
  solution = 0.;
  const double size = right_hand_side.l2_norm();
  if (size == 0.)
    return 0.;
  IterationNumberControl control(n_iterations, small_enough * size);
  GrowingVectorMemory<DistributedVector> memory;
  SolverFGMRES<DistributedVector> solver(
      control, memory, SolverFGMRES<DistributedVector>::AdditionalData(n_iterations + 1));
  try
  {
    solver.solve(FunctionAsMatrix<decltype(multiply)>{multiply}, solution, right_hand_side,
                 FunctionAsMatrix<decltype(precondition)>{precondition});
  }
  catch (const SolverControl::NoConvergence &)
  {
    // A product is no number.
    return 1.;
  }
  return std::pow(control.last_value() / size, 1. / std::max(1u, control.last_step()));
}
} // namespace Continua
