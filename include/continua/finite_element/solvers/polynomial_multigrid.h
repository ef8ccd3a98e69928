#ifndef continua_finite_element_solvers_polynomial_multigrid_h
#define continua_finite_element_solvers_polynomial_multigrid_h

#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/linear_velocities.h>
#include <continua/finite_element/products/matrix_free_product.h>
#include <continua/finite_element/products/polynomial_cycle.h>
#include <continua/linear_algebra/divergence_augmentation.h>
#include <continua/linear_algebra/velocity_cycle.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * A PolynomialCycle for the stiff velocities of A + B^T W B. The products of the relaxation have no
 * matrix and are of single precision: this class stores no matrix of the quadratic velocities.
 *
 * The relaxation takes B^T W B as it is. With the integral of W div v div u in its place, which is
 * nearly the same for smooth velocities, FGMRES takes 1.3 to 1.9 times as many iterations (a bar of
 * 8,000 unknowns): the pressure's Schur complement belongs to B^T W B. The matrix of the linear
 * velocities has the integral, whose entries couple the nodes of one cell only.
 */
template <int dim>
class PolynomialMultigrid : public VelocityCycle
{
public:
  using Product = MatrixFreeProduct<dim, float>;

  /// `cells`: a product that shares its cells. Space and constraints must outlive it.
  /// `coefficients.volumetric` is that of the linear velocities. `stiff`: a flag for each owned
  /// velocity. `augmentation`: W. `supports`: a matrix that is added to A; may be null.
  /// `most_factor_bytes`: of the factor of the linear velocities [bytes]; 0: there is none.
  /// Collective.
  PolynomialMultigrid(const Product &cells,
                      const Space<dim> &space,
                      const BoundaryConstraints<dim> &constraints,
                      const typename Product::Coefficients &coefficients,
                      const std::vector<bool> &stiff,
                      const dealii::TrilinosWrappers::SparseMatrix &divergence,
                      const DistributedVector &augmentation,
                      std::unique_ptr<dealii::TrilinosWrappers::SparseMatrix> supports,
                      double most_factor_bytes);

  /// Else the linear velocities have algebraic multigrid.
  bool has_linear_factor() const { return cycle->has_linear_factor(); }
  /// What relaxes the quadratic velocities, and what solves for the linear ones.
  std::string name() const { return cycle->name(); }
  void add_cycle(DistributedVector &target, const DistributedVector &source) override;

private:
  using Vector = typename Product::Vector;

  const std::unique_ptr<dealii::TrilinosWrappers::SparseMatrix> supports; ///< null without
  LinearVelocities<dim> linear_velocities;
  const std::unique_ptr<Product> product; ///< right at the stiff velocities alone
  DivergenceAugmentation<dim> augmentation;
  std::unique_ptr<PolynomialCycle<dim>> cycle;
  Vector right_hand_side, solution;
  DistributedVector support_velocity, support_force; ///< empty without supports

  void multiply(Vector &target, const Vector &source);
};
} // namespace Continua

#endif
