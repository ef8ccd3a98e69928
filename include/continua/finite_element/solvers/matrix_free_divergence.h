#ifndef continua_finite_element_solvers_matrix_free_divergence_h
#define continua_finite_element_solvers_matrix_free_divergence_h

#include <continua/finite_element/products/matrix_free_product.h>
#include <continua/finite_element/solvers/matrix_free_velocity.h>
#include <continua/finite_element/space/cell_sums.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/divergence_operator.h>

#include <memory>

namespace Continua
{
/// B T of a step's system without its matrix, for quadratic velocities and linear pressures.
template <int dim>
class MatrixFreeDivergence : public DivergenceOperator
{
public:
  using Product = MatrixFreeProduct<dim, double>;

  /// The product must have the constraints of the boundaries and the places of the pressures. The
  /// space must outlive it.
  MatrixFreeDivergence(const Space<dim> &space, std::shared_ptr<const Product> product);

  void multiply(DistributedVector &target, const DistributedVector &source) const override;
  void multiply_transposed(DistributedVector &target,
                           const DistributedVector &source) const override;
  /// momentum = A velocity - B^T pressure and mass = B velocity in one pass, with an A of the same
  /// product. Allocates nothing. Collective.
  void multiply_with(const MatrixFreeVelocity<dim> &a,
                     DistributedVector &momentum,
                     DistributedVector &mass,
                     const DistributedVector &velocity,
                     const DistributedVector &pressure) const;

private:
  const Space<dim> &space;
  const std::shared_ptr<const Product> product;
  mutable DistributedVector pressure_entries; ///< with those of other ranks and of hanging nodes
  mutable CellSums volume_sums;
  mutable typename Product::Vector velocity_entries;
};
} // namespace Continua

#endif
