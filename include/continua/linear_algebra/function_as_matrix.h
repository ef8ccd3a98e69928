#ifndef continua_linear_algebra_function_as_matrix_h
#define continua_linear_algebra_function_as_matrix_h

namespace Continua
{
/// What deal.II's solvers ask of a matrix or a preconditioner, of a function (target, source) that
/// must outlive it.
template <typename Function>
struct FunctionAsMatrix
{
  const Function &function;
  template <typename Vector>
  void vmult(Vector &target, const Vector &source) const
  {
    function(target, source);
  }
};
} // namespace Continua

#endif
