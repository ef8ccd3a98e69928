#ifndef continua_signal_expression_h
#define continua_signal_expression_h

#include <continua/base/parameter_section.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * A number of (x, y, z, t): a quantity with a unit ("10 mmHg") or a muParser expression in SI ("1e3*sin(pi*t)"; pi and
 * e are known, also if(condition, a, b), min, max, abs, exp, log, sqrt, pow, sin ... erf, besselj-free). In axisymmetry x
 * is the axial and y the radial coordinate. Throws InputError (through the section it is read from) if it does not
 * parse, has an unknown variable or a unit of another dimension, or is not finite at (0,0,0,0) when that is reported by the parser as an error.
 */
class Expression
{
public:
  Expression(double constant = 0.);
  /// Throws std::invalid_argument with a reason.
  Expression(const std::string &text, const Dimension &dimension);
  ~Expression();
  Expression(const Expression &);
  Expression &operator=(const Expression &);

  /// `point` has three coordinates (z = 0 in two dimensions).
  double operator()(const double *point, double time) const;
  bool depends_on_time() const;
  bool depends_on_space() const;
  /// Neither, and the value is 0.
  bool is_zero() const;
  const std::string &text() const;

private:
  struct Parser;
  std::string source;
  double constant;
  std::unique_ptr<Parser> parser; ///< null if constant
  bool time_dependent = false;
  bool space_dependent = false;
};

/// Declares `key` in `section` with an expression as its value.
void add_expression(ParameterSection &section,
                    const std::string &key,
                    Expression &expression,
                    const Dimension &dimension,
                    const std::string &text);
/// The same for a vector with comma-separated components (commas in parentheses do not separate); exactly
/// `n_components` must be given, or none, which leaves `expressions` as it is.
void add_expressions(ParameterSection &section,
                     const std::string &key,
                     std::vector<Expression> &expressions,
                     unsigned int n_components,
                     const Dimension &dimension,
                     const std::string &text);
} // namespace Continua

#endif
