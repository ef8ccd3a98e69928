#include <continua/linear_algebra/direct_solver.h>

namespace Continua
{
const Words<DirectSolver> &direct_solver_words()
{
  static const Words<DirectSolver> words = {{"automatic", DirectSolver::automatic},
                                            {"cholmod", DirectSolver::cholmod},
                                            {"mumps", DirectSolver::mumps},
                                            {"umfpack", DirectSolver::umfpack}};
  return words;
}
} // namespace Continua
