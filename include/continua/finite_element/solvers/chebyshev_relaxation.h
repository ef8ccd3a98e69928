#ifndef continua_finite_element_solvers_chebyshev_relaxation_h
#define continua_finite_element_solvers_chebyshev_relaxation_h

#include <continua/finite_element/products/matrix_free_product.h>
#include <continua/linear_algebra/chebyshev_polynomial.h>
#include <continua/linear_algebra/velocity_relaxation.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * Relaxes the velocities outside the stiff block by a Chebyshev polynomial of degree 2 for the
 * eigenvalues between an eighth of the largest one and that one. Products have no matrix and are of
 * single precision. The fluid's A is inertia above all, whose eigenvalues lie that close together
 * on every mesh. A grad-div that is as large as the inertia spreads them; then it takes more
 * iterations.
 */
template <int dim>
class ChebyshevRelaxation : public VelocityRelaxation
{
public:
  using Product = MatrixFreeProduct<dim, float>;

  /// `cells`: a product that shares its cells. `fluid`: local indices of the velocities that are
  /// relaxed; those of constrained ones are skipped. Collective.
  ChebyshevRelaxation(const Product &cells,
                      const typename Product::Coefficients &coefficients,
                      const std::vector<unsigned int> &fluid);

  /// Adds a lambda of each cell to those of the regions: Coefficients::volumetric_of_cells [Pa s].
  /// Finds the diagonal and the largest eigenvalue anew. Collective.
  void set_volumetric_of_cells(const std::vector<double> &volumetric);
  void add_relaxed(DistributedVector &velocity, const DistributedVector &residual) override;
  void leave_residual(DistributedVector &residual,
                      const DistributedVector &velocity,
                      const DistributedVector &source) override;
  /// What it takes for the largest eigenvalue of D^-1 A [1].
  double largest_eigenvalue() const { return polynomial->largest_eigenvalue(); }

private:
  using Vector = typename Product::Vector;

  /// The polynomial needs the cells of the fluid only, the residual needs all.
  const std::unique_ptr<Product> product, product_at_fluid;
  typename Product::Coefficients coefficients;
  std::vector<bool> is_fluid; ///< of each owned velocity
  Vector source_entries, target_entries;
  std::unique_ptr<ChebyshevPolynomial> polynomial;
};
} // namespace Continua

#endif
