#ifndef continua_finite_element_solvers_harmonic_factors_h
#define continua_finite_element_solvers_harmonic_factors_h

#include <continua/finite_element/solvers/harmonic_matrix.h>
#include <continua/linear_algebra/mumps_solver.h>

#include <mpi.h>

#include <complex>
#include <memory>
#include <vector>

namespace Continua
{
/**
 * Factors of the matrix at several s side by side: each rank has one of its own, of the whole
 * matrix, and no message passes while it is made. One analysis serves all. Right-hand sides and
 * solutions are spread over the ranks, and travel to the rank with the factor and back.
 */
class HarmonicFactors
{
public:
  using Complex = std::complex<double>;
  using Columns = std::vector<std::vector<Complex>>; ///< owned entries of right-hand sides

  /// `matrix` must outlive it. `owned`: the global indices of this rank's entries, in their order.
  HarmonicFactors(const HarmonicMatrix &matrix, std::vector<int> owned, MPI_Comm communicator);

  /// So many factors there can be at a time: that of the ranks.
  unsigned int n_side_by_side() const { return n_ranks; }
  /// Makes the factor of the k-th coefficients on rank k. Throws RunError, of a matrix without an
  /// inverse SingularMatrix. Collective.
  void factorize(const std::vector<HarmonicCoefficients> &coefficients);
  /// The number of the coefficients whose factor the last factorize() could not make, if it threw.
  unsigned int failed() const { return first_failed; }
  /// Of the k-th factor the k-th right-hand sides become the solutions. Collective.
  void solve(std::vector<Columns> &columns);
  /// Of the k-th factor, on all ranks. Collective.
  Complex log_determinant(unsigned int k) const;
  /// Of the factors in use, on all ranks [bytes].
  double memory() const { return bytes; }
  double n_entries() const { return entries; }

private:
  const HarmonicMatrix &matrix;
  const MPI_Comm communicator;
  int rank = 0, n_ranks = 1, first_failed = 0;
  std::vector<int> n_owned_by_rank, starts_by_rank; ///< in `owned_of_all`
  std::vector<int> owned_of_all;                    ///< rank by rank
  MumpsSolver<Complex> solver;
  bool is_analysed = false;
  double bytes = 0., entries = 0.;
  std::vector<Complex> values, travelling, columns_here; ///< work space
};
} // namespace Continua

#endif
