#ifndef continua_linear_algebra_mumps_solver_h
#define continua_linear_algebra_mumps_solver_h

#include <continua/linear_algebra/factor_estimate.h>

#include <mpi.h>

#include <complex>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace Continua
{
enum class MumpsScaling
{
  of_mumps, ///< of rows and columns, by their entries
  /// The matrix is scaled already. On several ranks MUMPS then sends far less in a solve: with a
  /// scaling of its own it sends the scaling's vectors to all ranks in each one.
  none
};

enum class MumpsSymmetry
{
  unsymmetric, ///< L U; all entries are given
  symmetric,   ///< L D L^T; one triangle is given
  /// The same without pivoting, for matrices that have a factor in every order of elimination. It
  /// saves entries where coefficients jump; a matrix that is singular all the same may pass
  /// unnoticed.
  quasi_definite
};

/**
 * MUMPS's multifrontal factor on any number of ranks, without iterative refinement: what
 * MumpsFactor, SinglePrecisionFactor, UnsymmetricMumpsFactor and HarmonicFactors share. The numbers
 * in its messages are MUMPS's INFOG(1) and INFOG(2). MPI must be initialised before, and finalised
 * after, the object lives. Number: double, float or std::complex<double>, whose matrices are
 * symmetric and not Hermitian.
 */
template <typename Number>
class MumpsSolver
{
public:
  MumpsSolver(MumpsSymmetry symmetry, MumpsScaling scaling, MPI_Comm communicator);
  ~MumpsSolver();

  /// Whether n_negative_pivots() will be asked for; set before factorize(). On several ranks the
  /// last block is then MUMPS's own and not ScaLAPACK's, whose pivots MUMPS does not count.
  bool counts_pivots = false;
  /// Whether log_determinant() will be asked for; set before factorize() or keep_pattern().
  bool computes_determinant = false;

  /// What factorize() would announce for a matrix with such entries. There is no factor then.
  FactorEstimate analyse(int n, std::vector<int> rows, std::vector<int> columns);
  /// Entries (global indices from 0) are spread over ranks in any way, those that occur twice add.
  /// With pivoting, a pivot of at most 1e-13 of the scaled matrix counts as zero: RunError. In
  /// large matrices, and in single precision, rounding can hide a singularity. `announce`: called
  /// between analysis and factorisation.
  void factorize(int n,
                 std::vector<int> rows,
                 std::vector<int> columns,
                 std::vector<Number> values,
                 const std::vector<int> &owned,
                 const std::function<void(const FactorEstimate &)> &announce = {});
  /// On one rank: makes the analysis of matrices that have their entries at the same places, for
  /// factorize_values(). Entries that occur twice add.
  FactorEstimate keep_pattern(int n, std::vector<int> rows, std::vector<int> columns);
  /// The factor of the matrix with these values in the kept pattern, in its order.
  void factorize_values(std::vector<Number> &values);
  /// Allocates nothing of its own; MUMPS does inside.
  void solve(std::vector<Number> &x);
  /// On one rank: n_columns right-hand sides in global order, one behind the other, become the
  /// solutions.
  void solve_columns(std::vector<Number> &columns, int n_columns);
  /// The logarithm of the determinant, of the matrix before it was scaled.
  std::complex<double> log_determinant() const;
  double n_entries() const;
  /// On all ranks, of a symmetric matrix.
  std::size_t n_negative_pivots() const;
  /// What MUMPS used in the factorisation, in whole megabytes; more than the factor alone.
  double memory() const;

private:
  struct Data;
  /// Begins anew and makes the analysis. Indices from 1; MUMPS keeps no array of entries.
  FactorEstimate
  analyse_from_one(int n, std::vector<int> &rows, std::vector<int> &columns, Number *values);
  std::unique_ptr<Data> data;
  const MumpsSymmetry symmetry;
  const MumpsScaling scaling;
  const MPI_Comm communicator;
};
} // namespace Continua

#endif
