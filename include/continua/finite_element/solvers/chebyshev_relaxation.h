#ifndef continua_finite_element_solvers_chebyshev_relaxation_h
#define continua_finite_element_solvers_chebyshev_relaxation_h

#include <continua/finite_element/solvers/matrix_free_relaxation.h>
#include <continua/linear_algebra/chebyshev_polynomial.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * Relaxes the velocities outside the stiff block by a Chebyshev polynomial of degree 2 for the
 * eigenvalues between an eighth of the largest one and that one. The fluid's A is inertia above
 * all, whose eigenvalues lie that close together on every mesh. A grad-div that is as large as the
 * inertia spreads them; then it takes more iterations.
 */
template <int dim>
class ChebyshevRelaxation : public MatrixFreeRelaxation<dim>
{
public:
  using typename MatrixFreeRelaxation<dim>::Product;

  /// See MatrixFreeRelaxation. Collective.
  ChebyshevRelaxation(const Product &cells,
                      const typename Product::Coefficients &coefficients,
                      const std::vector<unsigned int> &fluid);

  /// What it takes for the largest eigenvalue of D^-1 A [1].
  double largest_eigenvalue() const { return polynomial->largest_eigenvalue(); }

private:
  using typename MatrixFreeRelaxation<dim>::Vector;

  std::unique_ptr<ChebyshevPolynomial> polynomial;

  void make(const Vector &diagonal) override;
  void apply(Vector &solution, const Vector &right_hand_side) override;
};
} // namespace Continua

#endif
