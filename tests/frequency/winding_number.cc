// Zeros and poles of functions that are known, one of which turns thousands of times.

#include "../unit_test.h"

#include <continua/frequency/winding_number.h>

#include <cmath>
#include <functional>
#include <vector>

namespace test_of_winding_number
{
using namespace Continua;
using Complex = std::complex<double>;

namespace
{
/// Between 1 and 10 rad/s, from a little right of the imaginary axis to a damping ratio of 0.9.
const PlaneSector sector = {1., 10., 0.5 * M_PI - 0.02, 0.5 * M_PI + std::asin(0.9)};

/// The sum of the logarithms of s - zero less that of the poles.
std::function<Complex(Complex)> logarithm(const std::vector<Complex> &zeros,
                                          const std::vector<Complex> &poles = {})
{
  return [zeros, poles](const Complex s)
  {
    Complex sum = 0.;
    for (const Complex &zero : zeros)
      sum += std::log(s - zero);
    for (const Complex &pole : poles)
      sum -= std::log(s - pole);
    return sum;
  };
}

void count(const std::string &name,
           const std::function<Complex(Complex)> &function,
           const int number)
{
  const WindingNumber result = winding_number(function, sector);
  check::is_true(name, result.is_known && result.number == number && result.n_evaluations < 300);
}
} // namespace

UNIT_TEST(winding_number)
{
  count("no zero", logarithm({{0., 0.5}, {0., 11.}, {-3., 0.}, {0.3, 5.}}), 0);
  count("two zeros", logarithm({{-0.1, 2.}, {-1., 7.}, {0., 12.}}), 2);
  count("one on the axis, without damping", logarithm({{0., 3.}}), 1);
  count("twice the same", logarithm({{-0.1, 2.}, {-0.1, 2.}}), 2);
  count("next to the contour", logarithm({{-1e-3, 1. + 2e-6}, {0., 1. - 2e-6}}), 1);
  count("a pole", logarithm({{-0.1, 2.}, {-0.5, 3.}, {-0.2, 4.}}, {{-1., 5.}}), 2);

  // As a determinant: unknowns without stiffness, slow relaxations, modes beyond the band.
  std::vector<Complex> many = {{-0.01, 1.5}, {-0.2, 4.}, {-0.3, 4.1}, {-2., 9.}};
  for (unsigned int k = 0; k < 5000; ++k)
  {
    many.emplace_back(0., 0.);
    many.emplace_back(-0.01 * k, 0.);
    many.emplace_back(-0.1 * k, 12. + k);
    many.emplace_back(-0.1 * k, -12. - k);
  }
  count("four of thousands", logarithm(many), 4);

  const WindingNumber short_of = winding_number(logarithm(many), sector, 20);
  check::is_true("too few evaluations", !short_of.is_known && short_of.n_evaluations <= 21);
}
} // namespace test_of_winding_number
