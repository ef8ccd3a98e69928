#ifndef continua_linear_algebra_unsymmetric_mumps_factor_h
#define continua_linear_algebra_unsymmetric_mumps_factor_h

#include <continua/linear_algebra/mumps_solver.h>
#include <continua/linear_algebra/unsymmetric_factor.h>

namespace Continua
{
/// MUMPS's L U with pivoting on any number of ranks.
class UnsymmetricMumpsFactor : public UnsymmetricFactor
{
public:
  explicit UnsymmetricMumpsFactor(MPI_Comm communicator);

  void factorize(const Triplets &matrix, const std::vector<int> &owned) override;
  void solve(std::vector<double> &x) override { solver.solve(x); }
  double n_entries() const override { return solver.n_entries(); }
  double memory() const override { return solver.memory(); }
  std::string name() const override;

private:
  MumpsSolver<double> solver;
};
} // namespace Continua

#endif
