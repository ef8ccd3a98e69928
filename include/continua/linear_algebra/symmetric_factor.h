#ifndef continua_linear_algebra_symmetric_factor_h
#define continua_linear_algebra_symmetric_factor_h

#include <continua/linear_algebra/direct_solver.h>
#include <continua/linear_algebra/factor_estimate.h>

#include <mpi.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace Continua
{
/// The lower triangle (row >= column) of a symmetric matrix of global size n, spread over ranks in
/// any way; entries that occur twice add.
struct SymmetricTriplets
{
  int n = 0;
  std::vector<int> rows; ///< global, from 0
  std::vector<int> columns;
  std::vector<double> values;

  /// Throws std::invalid_argument if an entry lies above the diagonal or outside the matrix, if the
  /// three vectors differ in length or if one of `owned` is no index of the matrix.
  void check(const std::vector<int> &owned) const;
};

/**
 * The factor L D L^T of a symmetric matrix, made once and kept for many solves. Knows no mesh. All
 * methods are collective over the communicator.
 */
class SymmetricFactor
{
public:
  virtual ~SymmetricFactor() = default;

  /// Called on every rank between analysis and factorisation; not by UMFPACK, which has no
  /// estimate.
  std::function<void(const FactorEstimate &)> announce;
  /// Whether n_negative_pivots() will be asked for; set before factorize().
  bool counts_pivots = false;
  /// Whether the order of the unknowns that an analysis has found is used again for a matrix with
  /// entries at the same places, where the solver can; set before factorize(). The factor is the
  /// same. It takes the memory of these places.
  bool keeps_analysis = false;

  /**
   * Analyses and factors. `owned` are the global indices whose right-hand side and solution entries
   * this rank holds (any order, each index on exactly one rank). Move the matrix in if nothing else
   * needs it: its memory then goes with the factorisation. Throws RunError if the matrix is
   * singular, naming the solver and what it said.
   */
  virtual void factorize(SymmetricTriplets matrix, const std::vector<int> &owned) = 0;

  /// In: the right-hand side's owned entries in the order of `owned`; out: the solution's.
  /// Allocates nothing.
  virtual void solve(std::vector<double> &x) = 0;

  /// The number of negative eigenvalues of the matrix, by Sylvester's law of inertia: that of the
  /// negative pivots, on all ranks. Throws std::logic_error without `counts_pivots`, RunError if
  /// the solver does not know it.
  std::size_t n_negative_pivots() const;

  /// Entries of the factor over all ranks, and its memory in bytes.
  virtual double n_entries() const = 0;
  virtual double memory() const = 0;
  virtual std::string name() const = 0;

private:
  /// Of n_negative_pivots(); the solver does not know the number unless this is overridden.
  virtual std::size_t count_negative_pivots() const;
};

/// A factor would need more memory than it may.
struct FactorTooLarge : std::runtime_error
{
  explicit FactorTooLarge(double bytes)
      : std::runtime_error("the factor is too large"), bytes(bytes)
  {
  }
  double bytes; ///< of its entries on all ranks, by an estimate or the analysis
};

/// Up to so many entries of the lower triangle `automatic` takes CHOLMOD on one rank: about 100,000
/// unknowns in two dimensions, 20,000 in three. There its solve is a quarter faster than MUMPS's or
/// better and its factorisation no matter; beyond, MUMPS factors many times faster (the manual's
/// chapter on performance has the measurements).
constexpr std::size_t largest_simplicial_matrix = 2000000;

/**
 * `automatic`: CHOLMOD's simplicial factor on one rank where the matrix is quasi-definite (1/K > 0
 * everywhere) and has no more than `largest_simplicial_matrix` entries, MUMPS otherwise - a fixed
 * rule, so that runs and restarts are bit-equal on one rank (on several, MUMPS's last bits vary).
 * `cholmod`, `mumps`, and (for comparison) `umfpack` choose. `quasi_definite` false makes MUMPS
 * pivot and refuses cholmod. `n_entries`: of the lower triangle, on this rank. Unusable choices
 * throw std::invalid_argument with the reason.
 */
std::unique_ptr<SymmetricFactor> make_symmetric_factor(DirectSolver choice,
                                                       bool quasi_definite,
                                                       std::size_t n_entries,
                                                       MPI_Comm communicator);

/**
 * A factor of a quasi-definite block of a matrix, for a preconditioner. With more than
 * `largest_simplicial_matrix` entries on all ranks it is MUMPS's in single precision, which takes
 * half the memory of one in double precision; with fewer it is the automatic one. Throws
 * FactorTooLarge on all ranks, before the factorisation, where its entries on all ranks would need
 * more than `most_bytes`. Collective.
 */
std::unique_ptr<SymmetricFactor> make_block_factor(SymmetricTriplets matrix,
                                                   const std::vector<int> &owned,
                                                   double most_bytes,
                                                   MPI_Comm communicator);
} // namespace Continua

#endif
