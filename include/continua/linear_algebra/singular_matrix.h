#ifndef continua_linear_algebra_singular_matrix_h
#define continua_linear_algebra_singular_matrix_h

#include <continua/base/input_error.h>

namespace Continua
{
/// A factorisation met a pivot that is zero or has lost its digits. The matrix is singular, or has
/// a factor only with other pivots.
class SingularMatrix : public RunError
{
public:
  using RunError::RunError;
};
} // namespace Continua

#endif
