#ifndef continua_theory_ball_h
#define continua_theory_ball_h

#include <continua/theory/arb_headers.h>

#include <complex>

namespace Continua
{
/**
 * A complex number of many digits that carries a bound of its own error (a ball of the library
 * Arb), with the arithmetic of a number. Every operation works at `Ball::precision` bits, which
 * whoever needs more certain bits than came out raises (see WorkingPrecision). For the
 * determinants of wave theory: their Bessel functions nearly depend on each other, and their
 * exponents exceed those of a double.
 */
class Ball
{
public:
  /// Bits of the mantissa of every result, of the present scope.
  static inline thread_local slong precision = 256;

  Ball() { acb_init(number); }
  Ball(const std::complex<double> &value) : Ball()
  {
    arb_set_d(acb_realref(number), value.real());
    arb_set_d(acb_imagref(number), value.imag());
  }
  Ball(const double value) : Ball(std::complex<double>(value)) {}
  Ball(const Ball &other) : Ball() { acb_set(number, other.number); }
  Ball(Ball &&other) noexcept : Ball() { acb_swap(number, other.number); }
  Ball &operator=(const Ball &other)
  {
    acb_set(number, other.number);
    return *this;
  }
  Ball &operator=(Ball &&other) noexcept
  {
    acb_swap(number, other.number);
    return *this;
  }
  ~Ball() { acb_clear(number); }

  Ball &operator+=(const Ball &other)
  {
    acb_add(number, number, other.number, precision);
    return *this;
  }
  Ball &operator-=(const Ball &other)
  {
    acb_sub(number, number, other.number, precision);
    return *this;
  }
  Ball &operator*=(const Ball &other)
  {
    acb_mul(number, number, other.number, precision);
    return *this;
  }
  Ball &operator/=(const Ball &other)
  {
    acb_div(number, number, other.number, precision);
    return *this;
  }
  friend Ball operator+(Ball a, const Ball &b) { return a += b; }
  friend Ball operator-(Ball a, const Ball &b) { return a -= b; }
  friend Ball operator*(Ball a, const Ball &b) { return a *= b; }
  friend Ball operator/(Ball a, const Ball &b) { return a /= b; }
  friend Ball operator-(Ball a)
  {
    acb_neg(a.number, a.number);
    return a;
  }
  friend Ball square_root(Ball a)
  {
    acb_sqrt(a.number, a.number, precision);
    return a;
  }

  /// The midpoint, rounded.
  std::complex<double> value() const
  {
    return {arf_get_d(arb_midref(acb_realref(number)), ARF_RND_NEAR),
            arf_get_d(arb_midref(acb_imagref(number)), ARF_RND_NEAR)};
  }
  /// Bits of the larger part that are certain.
  slong accuracy() const { return acb_rel_accuracy_bits(number); }

  acb_t number;
};

/// Ball::precision for the time of a scope.
class WorkingPrecision
{
public:
  explicit WorkingPrecision(const slong precision) : previous(Ball::precision)
  {
    Ball::precision = precision;
  }
  ~WorkingPrecision() { Ball::precision = previous; }
  WorkingPrecision(const WorkingPrecision &) = delete;
  WorkingPrecision &operator=(const WorkingPrecision &) = delete;

private:
  const slong previous;
};

/// Gives back what the library keeps for the present thread: at the end of a thread.
inline void release_memory_of_balls()
{
  flint_cleanup();
}
} // namespace Continua

#endif
