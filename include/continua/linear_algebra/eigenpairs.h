#ifndef continua_linear_algebra_eigenpairs_h
#define continua_linear_algebra_eigenpairs_h

#include <mpi.h>

#include <complex>
#include <functional>
#include <vector>

namespace Continua
{
/// y = A x on this rank's share of the entries; y has the size of x. Collective; what it throws
/// goes through to the caller of dominant_eigenpairs().
using LinearMap = std::function<void(const std::vector<double> &x, std::vector<double> &y)>;

/// A x = value x, with x = real + i imaginary.
struct Eigenpair
{
  std::complex<double> value;
  std::vector<double> real, imaginary; ///< this rank's share; `imaginary` is zero for a real value
  double residual = 0.;                ///< |A x - value x| / |value x|
};

/**
 * The `n_wanted` eigenvalues of largest magnitude of a linear map A of which only products are
 * known, and their vectors, by SLEPc's Krylov-Schur method (V. Hernandez, J. E. Roman, V. Vidal,
 * SLEPc, ACM Trans. Math. Software 31 (2005)). The largest magnitude comes first. `n_local` entries
 * are on this rank. Of two conjugate values the one with positive imaginary part is returned and
 * counts once.
 *
 * The method begins with one vector and may miss further copies of a multiple value. So it is asked
 * again for the largest value of what the found vectors leave of the map, until that is smaller
 * than all that are returned. Then none is missing.
 *
 * Fewer pairs come back where the map has fewer values that are not zero (below 1e-12 of the
 * largest). Throws RunError if the method does not converge.
 */
std::vector<Eigenpair> dominant_eigenpairs(const LinearMap &map,
                                           unsigned int n_local,
                                           unsigned int n_wanted,
                                           MPI_Comm communicator);

/// Of A = S M with S symmetric and M symmetric, positive semi-definite: A is self-adjoint in the
/// inner product M, hence all values and vectors are real and the vectors orthogonal in M. They are
/// sought among the vectors that are orthogonal in M to those `found` before. Further copies of a
/// multiple value may be missing: the caller counts.
std::vector<Eigenpair> dominant_eigenpairs(const LinearMap &symmetric_map,
                                           const LinearMap &inner_product,
                                           unsigned int n_local,
                                           unsigned int n_wanted,
                                           MPI_Comm communicator,
                                           const std::vector<Eigenpair> &found = {});
} // namespace Continua

#endif
