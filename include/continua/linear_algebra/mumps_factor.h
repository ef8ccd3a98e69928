#ifndef continua_linear_algebra_mumps_factor_h
#define continua_linear_algebra_mumps_factor_h

#include <continua/linear_algebra/symmetric_factor.h>

#include <memory>

namespace Continua
{
/**
 * MUMPS's multifrontal L D L^T of a general symmetric matrix (SYM = 2) on any number of ranks,
 * without iterative refinement. The numbers in its messages are MUMPS's INFOG(1) and INFOG(2). MPI
 * must be initialised before, and finalised after, the object lives.
 */
class MumpsFactor : public SymmetricFactor
{
public:
  /// `quasi_definite`: there is a factor in every order of elimination, so MUMPS does not pivot,
  /// which saves entries where coefficients jump; a matrix that is singular all the same may then
  /// pass unnoticed.
  MumpsFactor(bool quasi_definite, MPI_Comm communicator);
  ~MumpsFactor() override;

  /// With pivoting, a pivot of at most 1e-13 of the scaled matrix counts as zero: RunError. In
  /// large matrices rounding can hide a singularity.
  void factorize(const SymmetricTriplets &matrix, const std::vector<int> &owned) override;
  /// Allocates nothing of its own; MUMPS does inside.
  void solve(std::vector<double> &x) override;
  double n_entries() const override;
  /// What MUMPS used in the factorisation, in whole megabytes; more than the factor alone.
  double memory() const override;
  std::string name() const override;

private:
  struct Data;
  std::unique_ptr<Data> data;
  const bool quasi_definite;
  const MPI_Comm communicator;
};
} // namespace Continua

#endif
