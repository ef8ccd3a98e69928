// Roots of polynomials with known roots, and the factors of sequences made of known powers.

#include <continua/signal/linear_recurrence.h>

#include <cmath>
#include <stdexcept>

#include "../unit_test.h"

namespace test_of_linear_recurrence
{
using namespace Continua;

namespace
{
using Complex = std::complex<double>;

void expect(const std::string &name,
            const std::vector<Complex> &found,
            const std::vector<Complex> &exact)
{
  check::absolute(name + ", how many", found.size(), exact.size(), 0.);
  for (std::size_t i = 0; i < found.size() && i < exact.size(); ++i)
    check::absolute(name + " " + std::to_string(i), std::abs(found[i] - exact[i]), 0., 1e-9);
}

/// sum_j b_j G_j^k of factors that are real or come with their conjugates.
std::vector<double> sequence(const std::vector<Complex> &factors, const unsigned int length)
{
  std::vector<double> members;
  for (unsigned int k = 0; k < length; ++k)
  {
    Complex sum = 0.;
    for (const Complex factor : factors)
      sum += (1. + 0.3 * std::abs(factor)) * std::pow(factor, k);
    members.push_back(sum.real());
  }
  return members;
}

bool is_refused(const std::vector<double> &members, const unsigned int order)
{
  try
  {
    recurrence_factors(members, order);
  }
  catch (const std::invalid_argument &)
  {
    return true;
  }
  return false;
}
} // namespace

UNIT_TEST(linear_recurrence)
{
  // (z - 3)(z + 2)(z - 1/2) = z^3 - 3/2 z^2 - 11/2 z + 3.
  expect("roots", polynomial_roots({3., -5.5, -1.5, 1.}), {3., -2., 0.5});
  // 2 (z^2 - 2 z + 5).
  expect("a pair", polynomial_roots({10., -4., 2.}), {Complex(1., 2.), Complex(1., -2.)});

  const std::vector<Complex> pair = {std::polar(0.9, 0.4), std::polar(0.9, -0.4)};
  expect("a decaying oscillation", recurrence_factors(sequence(pair, 4), 2), pair);
  const std::vector<Complex> three = {-0.99, std::polar(0.5, 1.), std::polar(0.5, -1.)};
  expect("one that rings besides", recurrence_factors(sequence(three, 9), 3), three);

  check::is_true("a short sequence is refused", is_refused({1., 0.5, 0.2}, 2));
  check::is_true("fewer numbers are refused", is_refused({1., 0.5, 0.25, 0.125}, 2));
  check::is_true("zeros are refused", is_refused({0., 0., 0., 0.}, 2));
}
} // namespace test_of_linear_recurrence
