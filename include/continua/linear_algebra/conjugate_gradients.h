#ifndef continua_linear_algebra_conjugate_gradients_h
#define continua_linear_algebra_conjugate_gradients_h

#include <continua/base/input_error.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <sstream>

namespace Continua
{
/**
 * Conjugate gradients for the motion of the mesh, from the solution that is given until the
 * residual is below `tolerance` times the right-hand side. Returns the number of iterations.
 * Collective. Throws StepFailure if it takes too many.
 */
template <typename Vector, typename Matrix, typename Preconditioner>
unsigned int solve_mesh_by_conjugate_gradients(const Matrix &matrix,
                                               const Preconditioner &preconditioner,
                                               Vector &solution,
                                               const Vector &right_hand_side,
                                               const double tolerance)
{
  constexpr unsigned int most_iterations = 500;
  const double size = right_hand_side.l2_norm();
  if (size == 0.)
  {
    solution = 0.;
    return 0;
  }
  dealii::SolverControl control(most_iterations, tolerance * size);
  try
  {
    dealii::SolverCG<Vector>(control).solve(matrix, solution, right_hand_side, preconditioner);
  }
  catch (const dealii::SolverControl::NoConvergence &error)
  {
    std::ostringstream text;
    text << "conjugate gradients for the motion of the mesh left " << error.last_residual / size
         << " of the right-hand side after " << error.last_step
         << " iterations; use Linear solver/Type = direct";
    throw StepFailure(text.str());
  }
  return control.last_step();
}
} // namespace Continua

#endif
