#ifndef continua_finite_element_polynomial_multigrid_h
#define continua_finite_element_polynomial_multigrid_h

#include <continua/finite_element/linear_velocities.h>
#include <continua/finite_element/matrix_free_product.h>
#include <continua/linear_algebra/block_multigrid.h>
#include <continua/linear_algebra/chebyshev_polynomial.h>
#include <continua/linear_algebra/divergence_augmentation.h>
#include <continua/linear_algebra/velocity_cycle.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * Multigrid in the degree of the velocities, for the stiff ones of A + B^T W B. The quadratic
 * velocities are relaxed by Chebyshev polynomials, before and after the linear ones have had a
 * cycle of algebraic multigrid. The products of the relaxation have no matrix and are of single
 * precision: this class stores no matrix of the quadratic velocities.
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

  /// All but `coefficients`, `stiff` (a flag for each owned velocity) and `augmentation` (W) must
  /// outlive it. `coefficients.volumetric` is that of the linear velocities. `supports`: a matrix
  /// that is added to A; may be null. Collective.
  PolynomialMultigrid(const Space<dim> &space,
                      const BoundaryConstraints<dim> &constraints,
                      const typename Product::Coefficients &coefficients,
                      const std::vector<bool> &stiff,
                      const dealii::TrilinosWrappers::SparseMatrix &divergence,
                      const DistributedVector &augmentation,
                      std::unique_ptr<dealii::TrilinosWrappers::SparseMatrix> supports,
                      InstructionSet instruction_set);

  void add_cycle(DistributedVector &target, const DistributedVector &source) override;

private:
  using Vector = typename Product::Vector;

  const std::unique_ptr<dealii::TrilinosWrappers::SparseMatrix> supports; ///< null without
  LinearVelocities<dim> linear_velocities;
  std::unique_ptr<Product> product;
  DivergenceAugmentation<dim> augmentation;
  std::unique_ptr<ChebyshevPolynomial> relaxation;
  std::unique_ptr<BlockMultigrid> coarse_cycle;
  std::vector<unsigned int> stiff_rows; ///< local indices
  Vector right_hand_side, solution, residual, correction;
  DistributedVector fine, support_force, coarse_source, coarse_solution;

  void multiply(Vector &target, const Vector &source);
  void leave_residual();
};
} // namespace Continua

#endif
