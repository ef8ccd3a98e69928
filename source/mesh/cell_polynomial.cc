#include <continua/mesh/cell_polynomial.h>

#include <deal.II/base/polynomials_bernstein.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
/// From the values of a polynomial at these points to its Bernstein coefficients, row by row.
std::vector<double> bernstein_of_values(const std::vector<Point<1>> &points)
{
  const unsigned int n = points.size(), degree = n - 1;
  FullMatrix<double> at_points(n, n), inverse(n, n);
  for (unsigned int j = 0; j < n; ++j)
  {
    const PolynomialsBernstein<double> polynomial(j, degree);
    for (unsigned int i = 0; i < n; ++i)
      at_points(i, j) = polynomial.value(points[i][0]);
  }
  inverse.invert(at_points);
  std::vector<double> result;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      result.push_back(inverse(i, j));
  return result;
}
} // namespace

template <int dim>
CellPolynomial<dim>::CellPolynomial(const unsigned int degree)
    : basis(
          Polynomials::generate_complete_Lagrange_basis(QGaussLobatto<1>(degree + 1).get_points())),
      to_bernstein(bernstein_of_values(QGaussLobatto<1>(degree + 1).get_points())),
      values(Utilities::pow(degree + 1, dim), 0.)
{
}

template <int dim>
void CellPolynomial<dim>::set(const std::vector<double> &at_points)
{
  AssertDimension(at_points.size(), values.size());
  values = at_points;
}

template <int dim>
typename CellPolynomial<dim>::Factors
CellPolynomial<dim>::factors(const Point<dim> &unit, const unsigned int n_derivatives) const
{
  Factors result;
  std::array<double, 3> of_one{};
  for (unsigned int d = 0; d < dim; ++d)
  {
    for (unsigned int order = 0; order <= n_derivatives; ++order)
      result[d][order].resize(basis.size());
    for (unsigned int i = 0; i < basis.size(); ++i)
    {
      basis[i].value(unit[d], n_derivatives, of_one.data());
      for (unsigned int order = 0; order <= n_derivatives; ++order)
        result[d][order][i] = of_one[order];
    }
  }
  return result;
}

template <int dim>
double CellPolynomial<dim>::sum(const Factors &factors,
                                const std::array<unsigned int, dim> &orders) const
{
  const unsigned int n = basis.size();
  const std::vector<double> &of_x = factors[0][orders[0]];
  const double *value = values.data();
  double result = 0.;
  for (unsigned int k = 0; k < (dim > 2 ? n : 1); ++k)
  {
    double plane = 0.;
    for (unsigned int j = 0; j < n; ++j, value += n)
    {
      double line = 0.;
      for (unsigned int i = 0; i < n; ++i)
        line += of_x[i] * value[i];
      plane += factors[1][orders[1]][j] * line;
    }
    result += dim > 2 ? factors[dim - 1][orders[dim - 1]][k] * plane : plane;
  }
  return result;
}

template <int dim>
double CellPolynomial<dim>::value(const Point<dim> &unit) const
{
  return sum(factors(unit, 0), {});
}

template <int dim>
Tensor<1, dim> CellPolynomial<dim>::gradient(const Point<dim> &unit) const
{
  const Factors of_point = factors(unit, 1);
  Tensor<1, dim> result;
  for (unsigned int d = 0; d < dim; ++d)
  {
    std::array<unsigned int, dim> orders{};
    orders[d] = 1;
    result[d] = sum(of_point, orders);
  }
  return result;
}

template <int dim>
SymmetricTensor<2, dim> CellPolynomial<dim>::hessian(const Point<dim> &unit) const
{
  const Factors of_point = factors(unit, 2);
  SymmetricTensor<2, dim> result;
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int e = d; e < dim; ++e)
    {
      std::array<unsigned int, dim> orders{};
      ++orders[d];
      ++orders[e];
      result[d][e] = sum(of_point, orders);
    }
  return result;
}

template <int dim>
bool CellPolynomial<dim>::may_vanish() const
{
  // Between the least and the largest coefficient the polynomial stays. What round-off may have
  // changed of a coefficient counts as zero.
  const unsigned int n = basis.size();
  std::vector<double> coefficients = values, line(n);
  unsigned int stride = 1;
  for (unsigned int d = 0; d < dim; ++d, stride *= n)
    for (unsigned int first = 0; first < coefficients.size(); ++first)
      if (first / stride % n == 0)
      {
        for (unsigned int i = 0; i < n; ++i)
        {
          line[i] = 0.;
          for (unsigned int j = 0; j < n; ++j)
            line[i] += to_bernstein[i * n + j] * coefficients[first + j * stride];
        }
        for (unsigned int i = 0; i < n; ++i)
          coefficients[first + i * stride] = line[i];
      }
  const auto [least, largest] = std::minmax_element(coefficients.begin(), coefficients.end());
  const double round_off = 1e-12 * std::max(std::abs(*least), std::abs(*largest));
  return *least <= round_off && *largest >= -round_off;
}

template class CellPolynomial<2>;
template class CellPolynomial<3>;
} // namespace Continua
