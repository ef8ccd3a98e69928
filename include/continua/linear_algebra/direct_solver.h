#ifndef continua_linear_algebra_direct_solver_h
#define continua_linear_algebra_direct_solver_h

#include <continua/base/words.h>

namespace Continua
{
/// The libraries that factor a matrix; see make_symmetric_factor() and make_unsymmetric_factor().
enum class DirectSolver
{
  automatic,
  cholmod,
  mumps,
  umfpack
};

const Words<DirectSolver> &direct_solver_words();
} // namespace Continua

#endif
