#include <continua/linear_algebra/multigrid_solver.h>

#include <continua/linear_algebra/conjugate_gradients.h>
#include <continua/linear_algebra/function_as_matrix.h>

#include <utility>
#include <vector>

namespace Continua
{
using namespace dealii;

MultigridSolver::MultigridSolver(const TrilinosWrappers::SparsityPattern &pattern,
                                 VelocityBlocks blocks)
    : blocks(std::move(blocks)), entries(pattern)
{
}

void MultigridSolver::take()
{
  entries.compress(VectorOperation::add);
  std::vector<bool> is_coupled(entries.local_size(), false);
  for (const unsigned int row : blocks.fluid)
    is_coupled[row] = true;
  const auto first = entries.local_range().first;
  for (unsigned int row = 0; row < is_coupled.size(); ++row)
    if (!is_coupled[row])
      entries.set(first + row, first + row, 1.);
  entries.compress(VectorOperation::insert);
  if (multigrid != nullptr && !is_worn)
    return;
  multigrid = std::make_unique<BlockMultigrid>(entries, blocks.fluid, blocks);
  is_used = is_worn = false;
}

void MultigridSolver::solve(DistributedVector &solution,
                            const DistributedVector &right_hand_side,
                            const double tolerance)
{
  const auto precondition = [this](DistributedVector &target, const DistributedVector &source)
  {
    target.equ(1., source);
    for (const unsigned int row : blocks.fluid)
      target.begin()[row] = 0.;
    multigrid->add_cycle(target, source);
  };
  const FunctionAsMatrix<decltype(precondition)> preconditioner{precondition};
  if (right_hand_side.l2_norm() == 0.)
  {
    solution = 0.;
    return;
  }
  const unsigned int n_iterations = solve_mesh_by_conjugate_gradients(
      entries, preconditioner, solution, right_hand_side, tolerance);
  if (!is_used)
    first_iterations = n_iterations;
  is_used = true;
  is_worn =
      is_worn || (2 * n_iterations > 3 * first_iterations && n_iterations > first_iterations + 5);
}
} // namespace Continua
