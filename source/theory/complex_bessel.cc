#include <continua/theory/complex_bessel.h>

#include <acb_hypgeom.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace Continua
{
namespace
{
using Function = void (*)(acb_t, const acb_t, const acb_t, slong);

/// Bits of relative accuracy that make the error less than 1e-14 (2^-47).
constexpr slong required_bits = 49;
constexpr slong first_bessel_precision = 64;
constexpr slong largest_bessel_precision = 1 << 16;

/// A number of Arb that frees itself.
class Number
{
public:
  Number() { acb_init(value); }
  explicit Number(const Complex z) : Number() { acb_set_d_d(value, z.real(), z.imag()); }
  explicit Number(const unsigned int n) : Number() { acb_set_ui(value, n); }
  ~Number() { acb_clear(value); }
  Number(const Number &) = delete;
  Number &operator=(const Number &) = delete;

  acb_t value;
};

/// One function at one argument.
struct Call
{
  Call(const unsigned int n, const Complex z) : order(n), argument(z)
  {
    if (!std::isfinite(z.real()) || !std::isfinite(z.imag()))
      throw std::domain_error("A Bessel function was asked for at an argument that is not finite.");
  }

  Number order;
  Number argument;
};

Complex rounded(const Number &number)
{
  const Complex result(arf_get_d(arb_midref(acb_realref(number.value)), ARF_RND_NEAR),
                       arf_get_d(arb_midref(acb_imagref(number.value)), ARF_RND_NEAR));
  if (!std::isfinite(result.real()) || !std::isfinite(result.imag()))
    throw std::domain_error("A Bessel function or ratio is too large for double precision.");
  return result;
}

bool is_certain(const Number &number)
{
  return acb_is_zero(number.value) ||
         (acb_is_finite(number.value) && acb_rel_accuracy_bits(number.value) >= required_bits);
}

/// function(above), over function(below) unless that is null.
Complex certified(const Function function, const Call &above, const Call *below)
{
  Number result, denominator;
  for (slong precision = first_bessel_precision; precision <= largest_bessel_precision;
       precision *= 2)
  {
    function(result.value, above.order.value, above.argument.value, precision);
    if (below != nullptr)
    {
      function(denominator.value, below->order.value, below->argument.value, precision);
      if (acb_is_zero(denominator.value))
        throw std::domain_error("A ratio of Bessel functions has the denominator 0.");
      acb_div(result.value, result.value, denominator.value, precision);
    }
    if (is_certain(result))
      return rounded(result);
  }
  throw std::runtime_error("A Bessel function could not be computed to full accuracy.");
}

Complex ratio(const Function function,
              const unsigned int m,
              const Complex a,
              const unsigned int n,
              const Complex b)
{
  const Call above(m, a), below(n, b);
  return certified(function, above, &below);
}
} // namespace

Complex bessel_j(const unsigned int n, const Complex z)
{
  return certified(acb_hypgeom_bessel_j, Call(n, z), nullptr);
}

Complex bessel_j_ratio(const unsigned int m, const Complex a, const unsigned int n, const Complex b)
{
  return ratio(acb_hypgeom_bessel_j, m, a, n, b);
}

Complex bessel_i_ratio(const unsigned int m, const Complex a, const unsigned int n, const Complex b)
{
  return ratio(acb_hypgeom_bessel_i, m, a, n, b);
}
} // namespace Continua
