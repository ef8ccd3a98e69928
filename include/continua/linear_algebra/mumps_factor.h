#ifndef continua_linear_algebra_mumps_factor_h
#define continua_linear_algebra_mumps_factor_h

#include <continua/linear_algebra/mumps_solver.h>
#include <continua/linear_algebra/symmetric_factor.h>

namespace Continua
{
/// MUMPS's L D L^T of a symmetric matrix on any number of ranks.
class MumpsFactor : public SymmetricFactor
{
public:
  /// `quasi_definite`: there is a factor in every order of elimination, so MUMPS does not pivot.
  MumpsFactor(bool quasi_definite, MPI_Comm communicator);

  void factorize(SymmetricTriplets matrix, const std::vector<int> &owned) override;
  void solve(std::vector<double> &x) override { solver.solve(x); }
  double n_entries() const override { return solver.n_entries(); }
  double memory() const override { return solver.memory(); }
  std::string name() const override;

private:
  std::size_t count_negative_pivots() const override { return solver.n_negative_pivots(); }

  const bool quasi_definite;
  MumpsSolver<double> solver;
};
} // namespace Continua

#endif
