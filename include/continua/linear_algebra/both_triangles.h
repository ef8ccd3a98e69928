#ifndef continua_linear_algebra_both_triangles_h
#define continua_linear_algebra_both_triangles_h

#include <continua/linear_algebra/symmetric_factor.h>
#include <continua/linear_algebra/unsymmetric_factor.h>

#include <memory>

namespace Continua
{
/// A symmetric matrix given to a factor that takes no advantage of the symmetry: to compare with,
/// and for small matrices that need pivoting.
class BothTriangles : public SymmetricFactor
{
public:
  explicit BothTriangles(std::unique_ptr<UnsymmetricFactor> factor);

  void factorize(SymmetricTriplets matrix, const std::vector<int> &owned) override;
  void solve(std::vector<double> &x) override { factor->solve(x); }
  double n_entries() const override { return factor->n_entries(); }
  double memory() const override { return factor->memory(); }
  std::string name() const override { return factor->name(); }

private:
  std::unique_ptr<UnsymmetricFactor> factor;
};
} // namespace Continua

#endif
