#include <continua/linear_algebra/chebyshev_polynomial.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
/// For a polynomial of degree 3 or less. A polynomial amplifies the eigenvalues above the one that
/// it is made for, the more the higher its degree is. A higher degree therefore takes more steps.
constexpr unsigned int n_power_steps = 25;
/// Power steps approach the largest eigenvalue from below.
constexpr double eigenvalue_margin = 1.15;
} // namespace

ChebyshevPolynomial::Operator::Operator(Product product_of_rows,
                                        const types::global_dof_index n_rows)
    : product(std::move(product_of_rows)), n_rows(n_rows)
{
}

float ChebyshevPolynomial::Operator::el(unsigned int, unsigned int) const
{
  AssertThrow(false, ExcNotImplemented());
  return 0.f;
}

ChebyshevPolynomial::ChebyshevPolynomial(Product product,
                                         const Vector &inverse_diagonal,
                                         const unsigned int degree,
                                         const double eigenvalue_ratio)
    : a(std::move(product), inverse_diagonal.size())
{
  find_largest_eigenvalue(inverse_diagonal, n_power_steps * std::max(degree, 3u) / 3);
  decltype(polynomial)::AdditionalData data;
  data.degree = degree;
  data.smoothing_range = eigenvalue_ratio;
  data.eig_cg_n_iterations = 0; // the eigenvalue is given
  data.max_eigenvalue = eigenvalue;
  data.preconditioner = std::make_shared<DiagonalMatrix<Vector>>();
  data.preconditioner->get_vector() = inverse_diagonal;
  polynomial.initialize(a, data);
}

void ChebyshevPolynomial::find_largest_eigenvalue(const Vector &inverse_diagonal,
                                                  const unsigned int n_steps)
{
  Vector source(inverse_diagonal), target(inverse_diagonal);
  // Any start that is no eigenvector.
  const auto first = source.locally_owned_elements().n_elements() > 0
                         ? source.locally_owned_elements().nth_index_in_set(0)
                         : 0;
  for (unsigned int i = 0; i < source.locally_owned_size(); ++i)
    source.local_element(i) =
        inverse_diagonal.local_element(i) > 0.f ? std::sin(1.f + 2.f * ((first + i) % 1009)) : 0.f;
  float norm = source.l2_norm();
  for (unsigned int step = 0; step < n_steps && norm > 0.f; ++step)
  {
    source *= 1.f / norm;
    a.vmult(target, source);
    source = target;
    source.scale(inverse_diagonal);
    norm = source.l2_norm();
    eigenvalue = eigenvalue_margin * norm;
  }
  // Without a row the polynomial is never used on anything but zeros.
  if (!(eigenvalue > 0.))
    eigenvalue = 1.;
}
} // namespace Continua
