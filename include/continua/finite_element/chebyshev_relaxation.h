#ifndef continua_finite_element_chebyshev_relaxation_h
#define continua_finite_element_chebyshev_relaxation_h

#include <continua/finite_element/boundary_constraints.h>
#include <continua/finite_element/matrix_free_product.h>
#include <continua/finite_element/space.h>
#include <continua/linear_algebra/velocity_relaxation.h>

#include <deal.II/base/subscriptor.h>
#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/precondition.h>

#include <memory>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * Relaxes the velocities outside the stiff block. The error is a Chebyshev polynomial of degree 2
 * in D^-1 A, D the diagonal, for the eigenvalues between an eighth of the largest one and that one
 * (Adams et al., J. Comput. Phys. 188 (2003) 593). Products have no matrix and are of single
 * precision. The fluid's A is inertia above all, whose eigenvalues lie that close together on every
 * mesh.
 */
template <int dim>
class ChebyshevRelaxation : public VelocityRelaxation
{
public:
  using Product = MatrixFreeProduct<dim, float>;

  /// `fluid`: local indices of the velocities that are relaxed; those of constrained ones are
  /// skipped. Space and constraints must outlive it. Collective.
  ChebyshevRelaxation(const Space<dim> &space,
                      const BoundaryConstraints<dim> &constraints,
                      const typename Product::Coefficients &coefficients,
                      const std::vector<unsigned int> &fluid,
                      InstructionSet instruction_set);

  void add_relaxed(DistributedVector &velocity, const DistributedVector &residual) override;
  void leave_residual(DistributedVector &residual,
                      const DistributedVector &velocity,
                      const DistributedVector &source) override;
  /// What it takes for the largest eigenvalue of D^-1 A [1].
  double largest_eigenvalue() const { return eigenvalue; }

private:
  using Vector = typename Product::Vector;
  /// As the Chebyshev polynomial of the library wants it.
  class Operator : public dealii::Subscriptor
  {
  public:
    Operator(std::unique_ptr<Product> product, const dealii::types::global_dof_index n_rows)
        : product(std::move(product)), n_rows(n_rows)
    {
    }

    void vmult(Vector &target, const Vector &source) const { product->multiply(target, source); }
    dealii::types::global_dof_index m() const { return n_rows; }
    /// The polynomial has its diagonal already.
    float el(unsigned int, unsigned int) const
    {
      AssertThrow(false, dealii::ExcNotImplemented());
      return 0.f;
    }

    const std::unique_ptr<Product> product;

  private:
    const dealii::types::global_dof_index n_rows;
  };
  using Polynomial =
      dealii::PreconditionChebyshev<Operator, Vector, dealii::DiagonalMatrix<Vector>>;

  Operator a;
  Polynomial polynomial;
  Vector source_entries, target_entries;
  double eigenvalue = 0.;

  void find_largest_eigenvalue(const Vector &inverse_diagonal);
};
} // namespace Continua

#endif
