#include <continua/linear_algebra/multigrid_solver.h>

#include <continua/base/input_error.h>
#include <continua/linear_algebra/function_as_matrix.h>

#include <deal.II/lac/solver_cg.h>

#include <sstream>
#include <utility>
#include <vector>

namespace Continua
{
using namespace dealii;

namespace
{
constexpr unsigned int most_iterations = 500;
} // namespace

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
  const double size = right_hand_side.l2_norm();
  if (size == 0.)
  {
    solution = 0.;
    return;
  }
  SolverControl control(most_iterations, tolerance * size);
  try
  {
    SolverCG<DistributedVector>(control).solve(entries, solution, right_hand_side, preconditioner);
  }
  catch (const SolverControl::NoConvergence &error)
  {
    std::ostringstream text;
    text << "conjugate gradients for the motion of the mesh left " << error.last_residual / size
         << " of the right-hand side after " << error.last_step
         << " iterations; use Linear solver/Type = direct";
    throw StepFailure(text.str());
  }
  if (!is_used)
    first_iterations = control.last_step();
  is_used = true;
  is_worn = is_worn || (2 * control.last_step() > 3 * first_iterations &&
                        control.last_step() > first_iterations + 5);
}
} // namespace Continua
