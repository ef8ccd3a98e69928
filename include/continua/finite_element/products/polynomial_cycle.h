#ifndef continua_finite_element_products_polynomial_cycle_h
#define continua_finite_element_products_polynomial_cycle_h

#include <continua/finite_element/products/linear_velocities.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/chebyshev_polynomial.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/linear_algebra/velocity_cycle.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * A symmetric cycle of multigrid in the degree for a matrix of quadratic velocities, or of other
 * vectors on their nodes, that has products alone. The quadratic ones are relaxed by Chebyshev
 * polynomials in single precision, before and after the linear ones have been solved for: by their
 * factor where it is small, otherwise by a cycle of algebraic multigrid.
 *
 * The linear velocities of a cell that is longer than thick bend poorly. The degree of the
 * polynomials, and the range of eigenvalues that they damp, grow with the ratio of the lengths.
 */
template <int dim>
class PolynomialCycle
{
public:
  using Vector = ChebyshevPolynomial::Vector;

  /// `diagonal`: of the matrix. `taken`: a flag for each owned velocity; those with a flag, without
  /// a constraint and with a positive diagonal are solved for, the others are as if their rows and
  /// columns were not. `n_regions`: of the mesh. `coarse_matrix`: of the linear velocities.
  /// `most_factor_bytes`: of their factor [bytes]; 0: there is none. Space, constraints and linear
  /// velocities must outlive it. Collective.
  PolynomialCycle(const Space<dim> &space,
                  const dealii::AffineConstraints<double> &constraints,
                  const LinearVelocities<dim> &linear_velocities,
                  const std::vector<bool> &taken,
                  unsigned int n_regions,
                  ChebyshevPolynomial::Product product,
                  const Vector &diagonal,
                  const dealii::TrilinosWrappers::SparseMatrix &coarse_matrix,
                  double most_factor_bytes);

  /// Else the linear velocities have algebraic multigrid.
  bool has_linear_factor() const { return is_factored; }
  /// The degree of the polynomials, and what solves for the linear velocities.
  std::string name() const;
  /// Local indices of the velocities that are solved for.
  const std::vector<unsigned int> &solved() const { return rows; }
  /// Sets the entries of the solution that are solved for to what a cycle from zero finds; others
  /// of the right-hand side have no effect. Collective.
  void apply(Vector &solution, const Vector &right_hand_side);

private:
  const LinearVelocities<dim> &linear_velocities;
  const ChebyshevPolynomial::Product product;
  const unsigned int degree;
  std::unique_ptr<ChebyshevPolynomial> relaxation;
  std::unique_ptr<VelocityCycle> coarse_cycle;
  std::string coarse_name;
  bool is_factored = false;
  std::vector<unsigned int> rows;
  Vector residual, correction;
  DistributedVector fine, coarse_source, coarse_solution;

  void make_coarse_cycle(const Space<dim> &space,
                         const dealii::TrilinosWrappers::SparseMatrix &coarse_matrix,
                         double most_factor_bytes);
  void leave_residual(const Vector &solution, const Vector &right_hand_side);
};
} // namespace Continua

#endif
