#ifndef continua_signal_expression_h
#define continua_signal_expression_h

#include <continua/base/parameter_section.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * A number of (x, y, z, t): a quantity with a unit ("10 mmHg"), a muParser expression in SI
 * ("1e3*sin(pi*t)"), or terms with a quantity as a factor ("1 kPa + 10 mmHg*sin(pi*t)", see
 * formula_in_si()). In axisymmetry x is the axial and y the radial coordinate.
 *
 * Variables: x, y, z [m], t [s]. Constants: pi, e. Functions: if(condition, a, b), min, max, sum,
 * avg (any number of arguments), abs, sign, floor, ceil, rint, step (0 below 0, else 1), exp, ln
 * and log (natural), log2, log10, pow, sqrt, sin, cos, tan, asin, acos, atan, atan2, sinh, cosh,
 * tanh, asinh, acosh, atanh, erf, erfc, j0, j1 (Bessel functions of the first kind). Operators: + -
 * * / ^ (a power binds stronger than a sign), < <= > >= == != && || ?:.
 *
 * An expression without variables is a constant and must be finite. The first value of the others
 * that is not finite is noted, see value_not_finite(). Copies are independent; one object is not to
 * be evaluated by two threads at once.
 */
class Expression
{
public:
  Expression(double constant = 0.);
  /// Throws std::invalid_argument with a reason if `text` does not parse, has an unknown symbol or
  /// a unit of another dimension, or is a constant that is not finite.
  Expression(const std::string &text, const Dimension &dimension);
  ~Expression();
  Expression(const Expression &);
  Expression &operator=(const Expression &);

  /// `point` has three coordinates [m] (z = 0 in two dimensions), `time` in s; the value is in SI.
  double operator()(const double *point, double time) const;
  /// Whether t occurs in the text, even where it has no effect ("0*t").
  bool depends_on_time() const;
  /// Whether x, y or z occurs in the text.
  bool depends_on_space() const;
  /// Neither, and the value is 0.
  bool is_zero() const;
  const std::string &text() const;

  /// What messages call it: "case.prm:12: 'Boundaries/inlet/Pressure'".
  void set_place(const std::string &name);
  /// Of all expressions, the first value on this rank that was not finite, with its place, point
  /// and time, for the reason of a run that fails by it; empty if there was none.
  static const std::string &value_not_finite();

private:
  struct Parser;
  std::string source;
  std::string formula; ///< the same in SI
  double constant;
  std::unique_ptr<Parser> parser; ///< null if constant
  bool time_dependent = false;
  bool space_dependent = false;

  void note_not_finite(const double *point, double time, double value) const;
};

/// Declares `key` in `section` with an expression as its value; `expression` is the default.
void add_expression(ParameterSection &section,
                    const std::string &key,
                    Expression &expression,
                    const Dimension &dimension,
                    const std::string &text);
/// The same for a vector with comma-separated components (commas in parentheses do not separate);
/// exactly `n_components` must be given, or none, which leaves `expressions` as it is.
void add_expressions(ParameterSection &section,
                     const std::string &key,
                     std::vector<Expression> &expressions,
                     unsigned int n_components,
                     const Dimension &dimension,
                     const std::string &text);
} // namespace Continua

#endif
