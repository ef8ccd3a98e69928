#ifndef continua_mesh_cell_polynomial_h
#define continua_mesh_cell_polynomial_h

#include <deal.II/base/point.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace Continua
{
/**
 * A polynomial on the unit cell, of one degree in each direction, by its values at the
 * Gauss-Lobatto points. It is summed direction by direction, so that a value costs about (degree +
 * 1)^dim operations. It also knows by its Bernstein coefficients where it cannot be zero.
 */
template <int dim>
class CellPolynomial
{
public:
  /// Zero. `degree` from 1.
  explicit CellPolynomial(unsigned int degree);

  /// (degree + 1)^dim.
  unsigned int n_values() const { return values.size(); }
  /// The values at the points of QGaussLobatto<dim>(degree + 1), x running first.
  void set(const std::vector<double> &at_points);

  double value(const dealii::Point<dim> &unit) const;
  dealii::Tensor<1, dim> gradient(const dealii::Point<dim> &unit) const;
  dealii::SymmetricTensor<2, dim> hessian(const dealii::Point<dim> &unit) const;
  /// False if it has one sign on the whole cell for certain.
  bool may_vanish() const;

private:
  /// By direction and order of the derivative: that of each basis polynomial of this direction.
  using Factors = std::array<std::array<std::vector<double>, 3>, dim>;

  std::vector<dealii::Polynomials::Polynomial<double>> basis; ///< of one direction
  std::vector<double> to_bernstein;                           ///< of one direction, of the values
  std::vector<double> values;

  Factors factors(const dealii::Point<dim> &unit, unsigned int n_derivatives) const;
  /// The derivative of this order in each direction.
  double sum(const Factors &factors, const std::array<unsigned int, dim> &orders) const;
};
} // namespace Continua

#endif
