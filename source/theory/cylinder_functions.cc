#include <continua/theory/cylinder_functions.h>

#include <continua/theory/arb_headers.h>

#include <cmath>

namespace Continua
{
namespace
{
/// Where the terms of the series grow too much before they fall: what cancels are as many bits.
constexpr double largest_argument_of_series = 12.;

/// At most the magnitude of the number.
double magnitude_of(const Ball &number)
{
  mag_t bound;
  mag_init(bound);
  acb_get_mag(bound, number.number);
  const double magnitude = mag_get_d(bound);
  mag_clear(bound);
  return magnitude;
}

/// ln(z/2) + Euler's constant.
Ball logarithm_of_half(const Ball &argument)
{
  Ball half = argument, result;
  acb_mul_2exp_si(half.number, half.number, -1);
  acb_log(result.number, half.number, Ball::precision);
  arb_t euler;
  arb_init(euler);
  arb_const_euler(euler, Ball::precision);
  acb_add_arb(result.number, result.number, euler, Ball::precision);
  arb_clear(euler);
  return result;
}

Ball pi_ball()
{
  Ball result;
  acb_const_pi(result.number, Ball::precision);
  return result;
}

/// The sums over k from 0 of t, t/(k + 1) and t H, with t = (-z^2/4)^k/(k!)^2 and the harmonic
/// numbers H = 1 + 1/2 + ... + 1/k.
struct Sums
{
  Ball of_terms = 1., of_j1 = 1., of_harmonic;
};

Sums sums_of(const Ball &argument, const double magnitude)
{
  Ball square = argument * argument;
  acb_mul_2exp_si(square.number, square.number, -2);
  acb_neg(square.number, square.number);
  Sums sums;
  Ball term = 1., part;
  arb_t harmonic, inverse;
  arb_init(harmonic);
  arb_init(inverse);
  // Sizes by their binary logarithms, which may lie below the range of a double.
  const double of_square = 0.25 * magnitude * magnitude;
  const slong smallest = -Ball::precision - 8;
  double size = 0.; // at least that of the term
  for (ulong k = 1;; ++k)
  {
    term *= square;
    acb_div_ui(term.number, term.number, k * k, Ball::precision);
    size += std::log2(of_square / static_cast<double>(k * k)) + 1e-9;
    arb_set_ui(inverse, 1);
    arb_div_ui(inverse, inverse, k, Ball::precision);
    arb_add(harmonic, harmonic, inverse, Ball::precision);
    sums.of_terms += term;
    acb_div_ui(part.number, term.number, k + 1, Ball::precision);
    sums.of_j1 += part;
    acb_mul_arb(part.number, term.number, harmonic, Ball::precision);
    sums.of_harmonic += part;
    // Each further term is at most a quarter of the one before it, and its H at most twice as
    // large: together they are smaller than twice the next one, whose H is at most k + 1.
    const auto next = static_cast<double>(k + 1);
    if (4. * of_square < next * next && size + std::log2(next) < static_cast<double>(smallest))
      break;
  }
  arb_clear(harmonic);
  arb_clear(inverse);
  mag_t omitted;
  mag_init(omitted);
  mag_set_ui_2exp_si(omitted, 1, smallest);
  for (Ball *const sum : {&sums.of_terms, &sums.of_j1, &sums.of_harmonic})
    acb_add_error_mag(sum->number, omitted);
  mag_clear(omitted);
  return sums;
}
} // namespace

CylinderFunctions::CylinderFunctions(const Ball &argument)
{
  const double magnitude = magnitude_of(argument);
  if (magnitude > largest_argument_of_series)
  {
    acb_hypgeom_bessel_jy(j0.number, y0.number, Ball().number, argument.number, Ball::precision);
    acb_hypgeom_bessel_j(j1.number, Ball(1.).number, argument.number, Ball::precision);
  }
  else
  {
    const Sums sums = sums_of(argument, magnitude);
    j0 = sums.of_terms;
    j1 = argument * sums.of_j1;
    acb_mul_2exp_si(j1.number, j1.number, -1);
    y0 = logarithm_of_half(argument) * j0 - sums.of_harmonic;
    acb_mul_2exp_si(y0.number, y0.number, 1);
    y0 /= pi_ball();
  }
  Ball wronskian = argument * pi_ball();
  acb_mul_2exp_si(wronskian.number, wronskian.number, -1);
  y1 = (j1 * y0 - Ball(1.) / wronskian) / j0;
}
} // namespace Continua
