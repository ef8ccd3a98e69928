#include <continua/base/expected_value.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
std::string trimmed(const std::string &text)
{
  const std::string blanks = " \t";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos)
    return "";
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

struct NumberWithUnit
{
  double number;
  std::string unit;
};

/// "3.3624 Hz" -> 3.3624 and "Hz".
NumberWithUnit split(const std::string &text, const std::string &what)
{
  const char *begin = text.data();
  const char *const end = begin + text.size();
  if (begin != end && *begin == '+')
    ++begin;
  NumberWithUnit result{};
  const std::from_chars_result parsed = std::from_chars(begin, end, result.number);
  if (parsed.ec != std::errc() || !std::isfinite(result.number))
    throw std::invalid_argument("the " + what + " '" + text + "' does not begin with a number");
  result.unit = trimmed(std::string(parsed.ptr, end));
  return result;
}

double tolerance_in_unit_of_value(const NumberWithUnit &tolerance, const ExpectedValue &expected)
{
  if (tolerance.number < 0.)
    throw std::invalid_argument("the tolerance is negative");
  if (tolerance.unit == "%")
  {
    if (expected.value == 0.)
      throw std::invalid_argument("a tolerance in % of the value 0 is 0; give an absolute one");
    return tolerance.number / 100. * std::abs(expected.value);
  }
  if (tolerance.unit.empty() || tolerance.unit == expected.unit)
    return tolerance.number;
  if (expected.unit.empty())
    throw std::invalid_argument("the tolerance has a unit, the value has none");
  Dimension of_tolerance, of_value;
  const double factor =
      unit_factor(tolerance.unit, of_tolerance) / unit_factor(expected.unit, of_value);
  if (!(of_tolerance == of_value))
    throw std::invalid_argument("the tolerance in '" + tolerance.unit +
                                "' has another dimension than the value in '" + expected.unit +
                                "'");
  return tolerance.number * factor;
}
} // namespace

ExpectedValue parse_expected_value(const std::string &key, const std::string &text)
{
  ExpectedValue result;
  result.key = key;
  // The last colon: a probe of several fields is called "PROBE: FIELD" itself.
  const std::size_t colon = key.rfind(':');
  if (colon != std::string::npos)
    result.probe = trimmed(key.substr(0, colon));
  result.name = trimmed(colon == std::string::npos ? key : key.substr(colon + 1));
  if (result.name.empty() || (colon != std::string::npos && result.probe.empty()))
    throw std::invalid_argument("the name is not 'QUANTITY' or 'PROBE: QUANTITY'");

  std::string value_part = trimmed(text);
  result.upper_bound = !value_part.empty() && value_part.front() == '<';
  result.lower_bound = !value_part.empty() && value_part.front() == '>';
  const bool is_bound = result.upper_bound || result.lower_bound;
  const std::size_t sign = value_part.find("+-");
  if (is_bound && sign != std::string::npos)
    throw std::invalid_argument("a bound has no tolerance");
  if (!is_bound && sign == std::string::npos)
    throw std::invalid_argument("the tolerance is missing");
  if (!is_bound)
    result.tolerance_text = trimmed(value_part.substr(sign + 2));
  result.value_text = trimmed(is_bound ? value_part.substr(1) : value_part.substr(0, sign));

  const NumberWithUnit value = split(result.value_text, "value");
  result.value = value.number;
  result.unit = value.unit;
  if (!result.unit.empty())
  {
    Dimension dimension;
    unit_factor(result.unit, dimension); // throws if there is no such unit
  }
  if (!is_bound)
    result.tolerance =
        tolerance_in_unit_of_value(split(result.tolerance_text, "tolerance"), result);
  return result;
}

std::vector<ExpectedValue> read_expected(ParameterSection section)
{
  std::vector<ExpectedValue> result;
  for (const auto &[key, text] : section.add_free_entries(
           "A quantity of the summary and the value it must have: VALUE [UNIT] +- TOLERANCE [UNIT "
           "or "
           "%], < VALUE or > VALUE; PROBE: before the name chooses one probe."))
    try
    {
      result.push_back(parse_expected_value(key, text));
    }
    catch (const std::invalid_argument &error)
    {
      section.refuse(
          key, error.what(),
          "Write for example 'set frequency = 3.36 Hz +- 0.5 %', 'set tip: maximum "
          "displacement = 0.6 m +- 2 mm' or 'set energy residual = < 1e-9'; a name with a "
          "'=' stands between double quotes");
    }
  return result;
}
} // namespace Continua
