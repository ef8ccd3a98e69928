// A polynomial on the unit cell against its formula: value, derivatives, and whether it may be zero
// somewhere.

#include <continua/mesh/cell_polynomial.h>

#include "../unit_test.h"

#include <deal.II/base/quadrature_lib.h>

#include <functional>
#include <string>

namespace test_of_cell_polynomial
{
using namespace Continua;
using namespace dealii;

namespace
{
template <int dim>
CellPolynomial<dim> polynomial_of(const unsigned int degree,
                                  const std::function<double(const Point<dim> &)> &formula)
{
  std::vector<double> values;
  const QGaussLobatto<dim> nodes(degree + 1);
  for (const Point<dim> &point : nodes.get_points())
    values.push_back(formula(point));
  CellPolynomial<dim> result(degree);
  result.set(values);
  return result;
}

/// x^3 - 2 x y^2, in space times (1 + z^3).
template <int dim>
void check_derivatives()
{
  const std::string text = std::to_string(dim) + "-D, ";
  const auto space = [](const Point<dim> &p)
  { return dim == 3 ? 1. + p[dim - 1] * p[dim - 1] * p[dim - 1] : 1.; };
  const CellPolynomial<dim> polynomial =
      polynomial_of<dim>(3, [&](const Point<dim> &p)
                         { return (p[0] * p[0] * p[0] - 2. * p[0] * p[1] * p[1]) * space(p); });
  Point<dim> p;
  for (unsigned int d = 0; d < dim; ++d)
    p[d] = 0.3 + 0.25 * d;
  const double x = p[0], y = p[1], z = p[dim - 1];
  check::absolute(text + "value", polynomial.value(p), (x * x * x - 2. * x * y * y) * space(p),
                  1e-14);
  Tensor<1, dim> gradient;
  gradient[0] = (3. * x * x - 2. * y * y) * space(p);
  gradient[1] = -4. * x * y * space(p);
  SymmetricTensor<2, dim> hessian;
  hessian[0][0] = 6. * x * space(p);
  hessian[0][1] = -4. * y * space(p);
  hessian[1][1] = -4. * x * space(p);
  if (dim == 3)
  {
    gradient[dim - 1] = (x * x * x - 2. * x * y * y) * 3. * z * z;
    hessian[0][dim - 1] = (3. * x * x - 2. * y * y) * 3. * z * z;
    hessian[1][dim - 1] = -4. * x * y * 3. * z * z;
    hessian[dim - 1][dim - 1] = (x * x * x - 2. * x * y * y) * 6. * z;
  }
  check::absolute(text + "gradient", (polynomial.gradient(p) - gradient).norm(), 0., 1e-13);
  check::absolute(text + "second derivatives", (polynomial.hessian(p) - hessian).norm(), 0., 1e-12);
}

void check_zeros(const std::string &name,
                 const bool has_zeros,
                 const std::function<double(const Point<2> &)> &formula)
{
  check::is_true(name, polynomial_of<2>(4, formula).may_vanish() == has_zeros);
}
} // namespace

UNIT_TEST(cell_polynomial)
{
  check_derivatives<2>();
  check_derivatives<3>();
  check_zeros("a positive one", false, [](const Point<2> &p) { return 0.1 + p[0] + p[1]; });
  check_zeros("a negative one", false, [](const Point<2> &p) { return p[0] * p[1] - 1.1; });
  check_zeros("a zero in the middle", true, [](const Point<2> &p) { return p[0] - 0.4 * p[1]; });
  check_zeros("a zero on an edge", true, [](const Point<2> &p) { return 1. - p[1]; });
  // Positive at all points of the Gauss-Lobatto rule: the next ones are 0.16 away.
  check_zeros("zeros between the points", true,
              [](const Point<2> &p) { return (p[0] - 0.34) * (p[0] - 0.34) - 0.01; });
}
} // namespace test_of_cell_polynomial
