#ifndef continua_linear_algebra_unsymmetric_factor_h
#define continua_linear_algebra_unsymmetric_factor_h

#include <continua/linear_algebra/direct_solver.h>

#include <mpi.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// All entries of a square matrix of global size n, spread over ranks in any way; entries that
/// occur twice add.
struct Triplets
{
  int n = 0;
  std::vector<int> rows; ///< global, from 0
  std::vector<int> columns;
  std::vector<double> values;

  /// Throws std::invalid_argument if an entry lies outside the matrix, if the three vectors differ
  /// in length or if one of `owned` is no index of the matrix.
  void check(const std::vector<int> &owned) const;
};

/**
 * The factor L U of a general matrix, made once and kept for many solves. Knows no mesh; the rows
 * may have very different scales. All methods are collective over the communicator.
 */
class UnsymmetricFactor
{
public:
  virtual ~UnsymmetricFactor() = default;

  /**
   * Analyses and factors; what an analysis before has found may be used again for a matrix with the
   * same places of entries. `owned` are the global indices whose right-hand side and solution
   * entries this rank holds (any order, each index on exactly one rank). Throws RunError if the
   * matrix is singular, naming the solver and what it said.
   */
  virtual void factorize(const Triplets &matrix, const std::vector<int> &owned) = 0;

  /// The next factor is made as the first one: it depends on the matrix alone.
  virtual void forget_analysis() {}

  /// In: the right-hand side's owned entries in the order of `owned`; out: the solution's.
  /// Allocates nothing.
  virtual void solve(std::vector<double> &x) = 0;

  /// Entries of the factor over all ranks, and its memory in bytes.
  virtual double n_entries() const = 0;
  virtual double memory() const = 0;
  virtual std::string name() const = 0;
};

/// `automatic`: UMFPACK's factor on one rank, MUMPS on several - a fixed rule, so that runs and
/// restarts are bit-equal on one rank (on several, MUMPS's last bits vary). `umfpack` and `mumps`
/// choose; CHOLMOD has no such factor. Unusable choices throw std::invalid_argument with the
/// reason.
std::unique_ptr<UnsymmetricFactor> make_unsymmetric_factor(DirectSolver choice,
                                                           MPI_Comm communicator);
} // namespace Continua

#endif
