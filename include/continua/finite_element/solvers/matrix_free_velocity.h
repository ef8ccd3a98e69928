#ifndef continua_finite_element_solvers_matrix_free_velocity_h
#define continua_finite_element_solvers_matrix_free_velocity_h

#include <continua/continuum/system_coefficients.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/matrix_free_product.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/velocity_operator.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>
#include <vector>

namespace Continua
{
/// T^T A T of a step's system without its matrix, with a one on the diagonal of constrained and
/// hanging velocities. Quadratic velocities only. Supports, which act on boundaries, have a matrix.
template <int dim>
class MatrixFreeVelocity : public VelocityOperator
{
public:
  using Product = MatrixFreeProduct<dim, double>;

  /// Space, operators and constraints must outlive it; the latter must be those of the product.
  MatrixFreeVelocity(const Space<dim> &space,
                     const std::vector<RegionOperators> &operators,
                     const BoundaryConstraints<dim> &constraints,
                     std::shared_ptr<Product> product);

  /// Takes the coefficients of the products. Collective.
  void set(const SystemCoefficients &coefficients);
  void multiply(DistributedVector &target, const DistributedVector &source) const override;
  /// momentum = A velocity - B^T pressure, and adds B velocity to `volume`: see MatrixFreeProduct,
  /// whose arrays of pressures these are.
  void multiply_coupled(DistributedVector &momentum,
                        double *volume,
                        const DistributedVector &velocity,
                        const double *pressure) const;
  const DistributedVector &diagonal() const override { return diagonal_entries; }
  /// The part of the supports, with a one on the diagonal of constrained velocities; null without.
  /// Of the last set().
  const dealii::TrilinosWrappers::SparseMatrix *support_matrix() const
  {
    return is_supported ? &supports : nullptr;
  }

private:
  const Space<dim> &space;
  const std::vector<RegionOperators> &operators;
  const BoundaryConstraints<dim> &constraints;
  const std::shared_ptr<Product> product;
  std::vector<unsigned int> constrained; ///< local indices of owned ones
  bool is_supported = false;
  dealii::TrilinosWrappers::SparseMatrix supports;
  DistributedVector diagonal_entries;
  mutable DistributedVector support_forces;
  mutable typename Product::Vector source_entries, target_entries;

  /// From a product of the cells to that of the whole system.
  void finish(DistributedVector &target, const DistributedVector &source) const;
};
} // namespace Continua

#endif
