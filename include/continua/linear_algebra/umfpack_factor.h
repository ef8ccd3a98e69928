#ifndef continua_linear_algebra_umfpack_factor_h
#define continua_linear_algebra_umfpack_factor_h

#include <continua/linear_algebra/symmetric_factor.h>

#include <memory>

namespace Continua
{
/**
 * UMFPACK's unsymmetric L U with partial pivoting, called directly and without iterative
 * refinement: takes no advantage of the symmetry, and is here to compare the others with. One rank
 * only.
 */
class UmfpackFactor : public SymmetricFactor
{
public:
  UmfpackFactor();
  ~UmfpackFactor() override;

  /// `owned` must hold every index of the matrix once.
  void factorize(const SymmetricTriplets &matrix, const std::vector<int> &owned) override;
  void solve(std::vector<double> &x) override;
  double n_entries() const override;
  double memory() const override;
  std::string name() const override;

private:
  struct Data;
  std::unique_ptr<Data> data;
};
} // namespace Continua

#endif
