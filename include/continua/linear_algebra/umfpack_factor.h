#ifndef continua_linear_algebra_umfpack_factor_h
#define continua_linear_algebra_umfpack_factor_h

#include <continua/linear_algebra/unsymmetric_factor.h>

#include <memory>

namespace Continua
{
/**
 * UMFPACK's L U with threshold pivoting and scaled rows, on one rank. UMFPACK tries its orderings
 * and takes the best: with its symmetric strategy where the places of the entries are symmetric,
 * even if many entries of the diagonal are zero, such as those of an incompressible liquid's
 * pressures; its own strategy where a factor has `most_growth` times the entries that this
 * promises. Of its factor the two triangles are kept as PackedTriangle, and solved with here. The
 * order is kept for further matrices with entries at the same places, until a factor has
 * `most_growth` times the entries that the symmetric strategy promises or, with UMFPACK's own
 * strategy, those of the first factor: trying the orderings takes as long as the numbers.
 *
 * Why: for 800 unknowns (40 x 10 cells, two unknowns each, 15 entries a row) a solve takes 18
 * microseconds; UMFPACK's own takes 63 and KLU's 60. With three unknowns a cell 48 against 124 and
 * 113; with 12,800 unknowns 4.0 milliseconds against 6.9 and 9.4 (benchmark_unsymmetric_solve).
 */
class UmfpackFactor : public UnsymmetricFactor
{
public:
  UmfpackFactor();
  ~UmfpackFactor() override;

  /// `owned` must hold every index of the matrix once.
  void factorize(const Triplets &matrix, const std::vector<int> &owned) override;
  void solve(std::vector<double> &x) override;
  void forget_analysis() override;
  double n_entries() const override;
  double memory() const override;
  std::string name() const override;

  static constexpr double most_growth = 1.5;

private:
  struct Analysis;
  struct Data;
  std::unique_ptr<Analysis> analysis; ///< null: the next factor makes one
  std::unique_ptr<Data> data;
};
} // namespace Continua

#endif
