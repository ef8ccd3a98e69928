#ifndef continua_base_expected_value_h
#define continua_base_expected_value_h

#include <continua/base/parameter_section.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * One line of the section Expected: `set [PROBE: ]NAME = VALUE [UNIT] +- TOLERANCE [UNIT | %]`, or
 * a bound `NAME = < VALUE [UNIT]` or `NAME = > VALUE [UNIT]`. Without a unit the value is SI; the
 * tolerance has the unit of the value unless it has its own of the same dimension; a % is of the
 * value's magnitude.
 */
struct ExpectedValue
{
  std::string key; ///< left of the equals sign, as written
  std::string name;
  std::string probe;          ///< empty: any probe that has this quantity
  double value = 0.;          ///< in the unit written
  std::string unit;           ///< as written
  double tolerance = 0.;      ///< absolute, in the unit written
  std::string tolerance_text; ///< as written: "0.2 %"
  bool upper_bound = false;   ///< `< VALUE`
  bool lower_bound = false;   ///< `> VALUE`
  std::string value_text;     ///< value and unit as written: "3.3624 Hz"
  /// The changes of the command line that exclude the quantity; empty: it is compared.
  std::string excluded_by = {};
};

/// Parses one line, `key` left and `text` right of the equals sign. Throws std::invalid_argument
/// with the reason.
ExpectedValue parse_expected_value(const std::string &key, const std::string &text);

/// The section Expected, parsed; throws InputError for a line that is malformed.
std::vector<ExpectedValue> read_expected(ParameterSection section);
} // namespace Continua

#endif
