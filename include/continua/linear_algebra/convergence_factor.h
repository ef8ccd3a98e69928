#ifndef continua_linear_algebra_convergence_factor_h
#define continua_linear_algebra_convergence_factor_h

#include <continua/linear_algebra/distributed_vector.h>

#include <functional>

namespace Continua
{
/// target = a linear function of source. Collective.
using LinearFunction =
    std::function<void(DistributedVector &target, const DistributedVector &source)>;

/**
 * How good a preconditioner is for a block of a matrix, that is for some of its rows and the same
 * columns: the factor by which one iteration of FGMRES with it reduces the residual. It takes 20
 * iterations, or fewer that reduce the residual to 1e-10, and averages over the second half of
 * them. Residuals are measured with the inverse of the diagonal. The right-hand side is without any
 * order. 0 is an exact inverse, 1 one that does not help.
 */
double convergence_factor(const LinearFunction &matrix,
                          const LinearFunction &preconditioner,
                          const DistributedVector &diagonal,
                          const DistributedVector &is_of_block);
} // namespace Continua

#endif
