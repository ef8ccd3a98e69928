#ifndef continua_linear_algebra_convergence_factor_h
#define continua_linear_algebra_convergence_factor_h

#include <continua/linear_algebra/distributed_vector.h>

#include <functional>
#include <vector>

namespace Continua
{
/// target = a linear function of source. Collective.
using LinearFunction =
    std::function<void(DistributedVector &target, const DistributedVector &source)>;

/// The factor by which an iteration reduces the residual, from the residuals of a solve, the one at
/// its start included: on average over the second half, since the first iterations remove what is
/// easy. 0 if there was none, or nothing is left.
double late_factor(const std::vector<double> &residuals);

/**
 * How good a preconditioner is for a block of a matrix, that is for some of its rows and the same
 * columns: the late factor of FGMRES with it, in 20 iterations, or in fewer that reduce the
 * residual to 1e-10. Residuals are measured with the inverse of the diagonal, which must be
 * positive in the block. The right-hand side is without any order. 0 is an exact inverse, 1 one
 * that does not help; 1, too, if a product is no number.
 */
double convergence_factor(const LinearFunction &matrix,
                          const LinearFunction &preconditioner,
                          const DistributedVector &diagonal,
                          const DistributedVector &is_of_block);
} // namespace Continua

#endif
