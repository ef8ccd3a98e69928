#ifndef continua_linear_algebra_chebyshev_polynomial_h
#define continua_linear_algebra_chebyshev_polynomial_h

#include <deal.II/base/subscriptor.h>
#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/precondition.h>

#include <functional>

namespace Continua
{
/**
 * A rough and symmetric inverse of a matrix A >= 0 in single precision. The error that it leaves is
 * a Chebyshev polynomial in D^-1 A, D the diagonal, that is small for the eigenvalues between a
 * part of the largest one and that one (Adams et al., J. Comput. Phys. 188 (2003) 593). It needs
 * products with A only.
 */
class ChebyshevPolynomial
{
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<float>;
  /// target = A source. Collective.
  using Product = std::function<void(Vector &target, const Vector &source)>;

  /// The entries of `inverse_diagonal` are zero where A is left out: the inverse is zero there, and
  /// the rest of A is as if its rows and columns were not. An application takes one product less
  /// than the degree. `eigenvalue_ratio`: of the largest to the smallest eigenvalue that is
  /// damped [1]. Collective.
  ChebyshevPolynomial(Product product,
                      const Vector &inverse_diagonal,
                      unsigned int degree,
                      double eigenvalue_ratio);

  /// target = the rough inverse times source, which may have entries where A is left out. Allocates
  /// nothing. Collective.
  void apply(Vector &target, const Vector &source) const { polynomial.vmult(target, source); }
  /// What it takes for the largest eigenvalue of D^-1 A [1].
  double largest_eigenvalue() const { return eigenvalue; }

private:
  /// As the polynomial of the library wants it.
  class Operator : public dealii::Subscriptor
  {
  public:
    Operator(Product product, const dealii::types::global_dof_index n_rows);
    void vmult(Vector &target, const Vector &source) const { product(target, source); }
    dealii::types::global_dof_index m() const { return n_rows; }
    /// The polynomial has its diagonal already.
    float el(unsigned int, unsigned int) const;

  private:
    const Product product;
    const dealii::types::global_dof_index n_rows;
  };

  Operator a;
  dealii::PreconditionChebyshev<Operator, Vector, dealii::DiagonalMatrix<Vector>> polynomial;
  double eigenvalue = 0.;

  void find_largest_eigenvalue(const Vector &inverse_diagonal, unsigned int n_steps);
};
} // namespace Continua

#endif
