#ifndef continua_linear_algebra_mumps_solver_h
#define continua_linear_algebra_mumps_solver_h

#include <continua/linear_algebra/factor_estimate.h>

#include <mpi.h>

#include <functional>
#include <memory>
#include <vector>

namespace Continua
{
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
 * MumpsFactor, SinglePrecisionFactor and UnsymmetricMumpsFactor share. The numbers in its messages
 * are MUMPS's INFOG(1) and INFOG(2). MPI must be initialised before, and finalised after, the
 * object lives. Number: double or float.
 */
template <typename Number>
class MumpsSolver
{
public:
  MumpsSolver(MumpsSymmetry symmetry, MPI_Comm communicator);
  ~MumpsSolver();

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
  /// Allocates nothing of its own; MUMPS does inside.
  void solve(std::vector<Number> &x);
  double n_entries() const;
  /// What MUMPS used in the factorisation, in whole megabytes; more than the factor alone.
  double memory() const;

private:
  struct Data;
  std::unique_ptr<Data> data;
  const MumpsSymmetry symmetry;
  const MPI_Comm communicator;
};
} // namespace Continua

#endif
