#include <continua/linear_algebra/convergence_factor.h>

#include <continua/linear_algebra/function_as_matrix.h>
#include <continua/linear_algebra/gmres_data.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <cmath>
#include <vector>

namespace Continua
{
using namespace dealii;

double late_factor(const std::vector<double> &residuals)
{
  if (residuals.size() < 2 || residuals.back() == 0.)
    return 0.;
  const std::size_t last = residuals.size() - 1, middle = last / 2;
  return std::pow(residuals[last] / residuals[middle], 1. / (last - middle));
}

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
    if (is_of_block.begin()[i] > 0.)
    {
      inverse_scale.begin()[i] = std::sqrt(diagonal.begin()[i]);
      scale.begin()[i] = 1. / inverse_scale.begin()[i];
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
  };

  // The phase grows with the square of the index, so that all wave lengths occur alike.
  DistributedVector solution(is_of_block), right_hand_side(is_of_block);
  const IndexSet owned = solution.locally_owned_elements();
  for (unsigned int i = 0; i < solution.locally_owned_size(); ++i)
  {
    const double index = owned.nth_index_in_set(i);
    right_hand_side.begin()[i] *= std::sin(index * (index + 1.));
  }
  solution = 0.;
  const double size = right_hand_side.l2_norm();
  if (size == 0.)
    return 0.;
  IterationNumberControl control(n_iterations, small_enough * size);
  control.enable_history_data();
  GrowingVectorMemory<DistributedVector> memory;
  SolverFGMRES<DistributedVector> solver(control, memory,
                                         fgmres_data<DistributedVector>(n_iterations + 1));
  bool is_number = true;
  try
  {
    solver.solve(FunctionAsMatrix<decltype(multiply)>{multiply}, solution, right_hand_side,
                 FunctionAsMatrix<decltype(precondition)>{precondition});
  }
  catch (const SolverControl::NoConvergence &)
  {
    // A product is no number.
    is_number = false;
  }
  memory.release_unused_memory(); // the run may go on
  return is_number ? late_factor(control.get_history_data()) : 1.;
}
} // namespace Continua
