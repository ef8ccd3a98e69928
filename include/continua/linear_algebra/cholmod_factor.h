#ifndef continua_linear_algebra_cholmod_factor_h
#define continua_linear_algebra_cholmod_factor_h

#include <continua/linear_algebra/symmetric_factor.h>

#include <memory>

namespace Continua
{
/**
 * CHOLMOD's simplicial L D L^T without pivoting, for symmetric quasi-definite matrices on one rank:
 * the factor exists for every symmetric permutation [R. J. Vanderbei, Symmetric quasidefinite
 * matrices, SIAM J. Optim. 5 (1995)], so the order of elimination is chosen for few entries alone
 * (approximate minimum degree or nested dissection, whichever gives fewer).
 */
class CholmodFactor : public SymmetricFactor
{
public:
  CholmodFactor();
  ~CholmodFactor() override;

  /**
   * `owned` must hold every index of the matrix once. A pivot that lost all its digits, |d_k| <=
   * 1e-13 |a_kk|, counts as zero: RunError. In large matrices rounding can hide a singularity.
   */
  void factorize(SymmetricTriplets matrix, const std::vector<int> &owned) override;
  void solve(std::vector<double> &x) override;
  double n_entries() const override;
  double memory() const override;
  std::string name() const override;

private:
  std::size_t count_negative_pivots() const override;

  struct Data;
  std::unique_ptr<Data> data;
};
} // namespace Continua

#endif
