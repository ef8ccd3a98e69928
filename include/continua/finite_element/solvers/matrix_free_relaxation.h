#ifndef continua_finite_element_solvers_matrix_free_relaxation_h
#define continua_finite_element_solvers_matrix_free_relaxation_h

#include <continua/finite_element/products/matrix_free_product.h>
#include <continua/linear_algebra/velocity_relaxation.h>

#include <memory>
#include <vector>

namespace Continua
{
/// Relaxes the velocities outside the stiff block by products without a matrix, of single
/// precision.
template <int dim>
class MatrixFreeRelaxation : public VelocityRelaxation
{
public:
  using Product = MatrixFreeProduct<dim, float>;

  /// Adds a lambda of each cell to those of the regions: Coefficients::volumetric_of_cells [Pa s].
  /// Makes the relaxation anew. Collective.
  void set_volumetric_of_cells(const std::vector<double> &volumetric);
  void add_relaxed(DistributedVector &velocity, const DistributedVector &residual) override;
  void leave_residual(DistributedVector &residual,
                      const DistributedVector &velocity,
                      const DistributedVector &source) override;

protected:
  using Vector = typename Product::Vector;

  /// The relaxation needs the cells of the fluid only, the residual needs all.
  const std::unique_ptr<Product> product, product_at_fluid;
  typename Product::Coefficients coefficients;
  std::vector<bool> is_fluid; ///< of each owned velocity

  /// `cells`: a product that shares its cells. `fluid`: local indices of the velocities that are
  /// relaxed; those of constrained ones are skipped. A derived class calls
  /// set_volumetric_of_cells() when it is constructed. Collective.
  MatrixFreeRelaxation(const Product &cells,
                       const typename Product::Coefficients &coefficients,
                       const std::vector<unsigned int> &fluid);

private:
  Vector source_entries, target_entries;

  /// The products have their coefficients. `diagonal`: of the matrix; 0 at constrained entries.
  virtual void make(const Vector &diagonal) = 0;
  /// Sets the rough solution at the velocities that are relaxed; elsewhere zero.
  virtual void apply(Vector &solution, const Vector &right_hand_side) = 0;
};
} // namespace Continua

#endif
