#include <continua/base/unit_scale.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace Continua
{
namespace
{
struct Unit
{
  const char *name;
  double factor;
  int power_of_ten;
  Dimension dimension;
  bool takes_prefix;
};

constexpr Dimension mass{1, 0, 0};
constexpr Dimension force{1, 1, -2};
constexpr Dimension energy{1, 2, -2};
constexpr Dimension volume{0, 3, 0};

// Conventional millimetre of mercury: density 13595.1 kg/m^3, standard gravity 9.80665 m/s^2; of
// water 1000 kg/m^3.
constexpr double standard_gravity = 9.80665;
constexpr std::array<Unit, 26> known_units{{
    {"m", 1., 0, Dimensions::length, true},
    {"s", 1., 0, Dimensions::time, true},
    {"sec", 1., 0, Dimensions::time, true},
    {"second", 1., 0, Dimensions::time, true},
    {"seconds", 1., 0, Dimensions::time, true},
    {"g", 1., -3, mass, true},
    {"N", 1., 0, force, true},
    {"Pa", 1., 0, Dimensions::pressure, true},
    {"J", 1., 0, energy, true},
    {"W", 1., 0, Dimensions::power, true},
    {"l", 1., -3, volume, true},
    {"L", 1., -3, volume, true},
    {"cc", 1., -6, volume, false},
    {"Hz", 1., 0, Dimensions::frequency, true},
    {"bar", 1., 5, Dimensions::pressure, true},
    {"P", 1., -1, Dimensions::viscosity, true},
    {"min", 60., 0, Dimensions::time, false},
    {"h", 3600., 0, Dimensions::time, false},
    {"t", 1., 3, mass, false},
    {"mmHg", 13.5951 * standard_gravity, 0, Dimensions::pressure, false},
    {"cmH2O", standard_gravity, 1, Dimensions::pressure, false},
    {"dyn", 1., -5, force, false},
    {"%", 1., -2, Dimensions::none, false},
    {"1", 1., 0, Dimensions::none, false},
    {"rad", 1., 0, Dimensions::none, false},
    {"deg", dealii::numbers::PI / 180., 0, Dimensions::none, false},
}};

struct Prefix
{
  const char *name;
  int power_of_ten;
};
constexpr std::array<Prefix, 11> prefixes{{{"n", -9},
                                           {"u", -6},
                                           {"\u00b5", -6}, // micro sign
                                           {"\u03bc", -6}, // Greek mu
                                           {"m", -3},
                                           {"c", -2},
                                           {"d", -1},
                                           {"h", 2},
                                           {"k", 3},
                                           {"M", 6},
                                           {"G", 9}}};

/// A product of powers of units: a scale into SI and a dimension.
struct Scale
{
  UnitScale scale;
  Dimension dimension;

  void multiply(const Scale &other, const int power)
  {
    scale.factor *= std::pow(other.scale.factor, power);
    scale.power_of_ten += power * other.scale.power_of_ten;
    dimension.mass += power * other.dimension.mass;
    dimension.length += power * other.dimension.length;
    dimension.time += power * other.dimension.time;
  }
};

Scale named_unit(const std::string &name)
{
  // Names that stand alone come first: "min" is no milli-inch, "h" no prefix.
  for (const Unit &unit : known_units)
    if (name == unit.name)
      return {{unit.factor, unit.power_of_ten}, unit.dimension};
  for (const Prefix &prefix : prefixes)
    for (const Unit &unit : known_units)
      if (unit.takes_prefix && name == std::string(prefix.name) + unit.name)
        return {{unit.factor, prefix.power_of_ten + unit.power_of_ten}, unit.dimension};
  throw std::invalid_argument("unit '" + name + "' is unknown");
}

/// A unit with its power behind it: cm3, s-1.
Scale unit_with_power(const std::string &name)
{
  const std::size_t digit = name.size() - 1;
  std::size_t end = digit;
  if (end > 0 && (name[end - 1] == '-' || name[end - 1] == '+'))
    --end;
  if (end == 0 || name[digit] < '1' || name[digit] > '9' ||
      std::isalpha(static_cast<unsigned char>(name[end - 1])) == 0)
    return named_unit(name);
  Scale scale;
  scale.multiply(named_unit(name.substr(0, end)),
                 (name[end] == '-' ? -1 : 1) * (name[digit] - '0'));
  return scale;
}

/// The unit with raised digits as powers, and with points between factors as blanks:
/// "cm\u00b3\u00b7s\u207b\u00b9" as "cm^3 s^-1".
std::string in_plain_letters(std::string unit)
{
  static const std::vector<std::pair<std::string, std::string>> replacements = {
      {"\u207b", "^-"}, {"\u207a", "^+"}, {"\u00b9", "^1"}, {"\u00b2", "^2"}, {"\u00b3", "^3"},
      {"\u2074", "^4"}, {"\u2075", "^5"}, {"\u2076", "^6"}, {"\u2077", "^7"}, {"\u2078", "^8"},
      {"\u2079", "^9"}, {"\u00b7", " "},  {"\u22c5", " "},  {"-^", "-"},      {"+^", "+"}};
  for (const auto &[special, plain] : replacements)
    for (std::size_t i = unit.find(special); i != std::string::npos; i = unit.find(special, i))
      unit.replace(i, special.size(), plain);
  return unit;
}

/// Reads "kg/m^3", "N/(m s)" from left to right.
class UnitParser
{
public:
  explicit UnitParser(const std::string &text) : text(text) {}

  Scale parse()
  {
    const Scale scale = product();
    if (position < text.size())
      fail("has a ')' too many");
    return scale;
  }

private:
  const std::string &text;
  std::size_t position = 0;
  unsigned int depth = 0; ///< of the brackets that are open

  [[noreturn]] void fail(const std::string &reason) const
  {
    throw std::invalid_argument("unit '" + text + "' " + reason);
  }

  void skip_blanks()
  {
    while (position < text.size() && std::isspace(static_cast<unsigned char>(text[position])))
      ++position;
  }

  bool next_is(const char letter)
  {
    skip_blanks();
    if (position == text.size() || text[position] != letter)
      return false;
    ++position;
    return true;
  }

  Scale product()
  {
    Scale scale = power();
    while (true)
    {
      skip_blanks();
      if (position == text.size() || text[position] == ')')
        return scale;
      if (next_is('/'))
        scale.multiply(power(), -1);
      else
      {
        next_is('*');
        scale.multiply(power(), 1);
      }
    }
  }

  Scale power()
  {
    const Scale base = factor();
    if (!next_is('^'))
      return base;
    skip_blanks();
    if (position < text.size() && text[position] == '+')
      ++position;
    int exponent = 0;
    const char *const begin = text.data() + position;
    const auto result = std::from_chars(begin, text.data() + text.size(), exponent);
    if (result.ec != std::errc() || std::abs(exponent) > 9)
      fail("wants a whole number after '^'");
    position += static_cast<std::size_t>(result.ptr - begin);
    Scale scale;
    scale.multiply(base, exponent);
    return scale;
  }

  Scale factor()
  {
    if (next_is('('))
    {
      constexpr unsigned int deepest_brackets_of_unit = 20;
      if (++depth > deepest_brackets_of_unit)
        throw std::invalid_argument("the unit has more than " +
                                    std::to_string(deepest_brackets_of_unit) +
                                    " brackets one inside the other");
      const Scale scale = product();
      --depth;
      if (!next_is(')'))
        fail("lacks a ')'");
      return scale;
    }
    const std::size_t begin = position;
    while (position < text.size() &&
           std::string(" \t*/^()").find(text[position]) == std::string::npos)
      ++position;
    if (position == begin)
      fail("is incomplete");
    return unit_with_power(text.substr(begin, position - begin));
  }
};

std::string power_text(const std::string &unit, const int exponent)
{
  return exponent == 1 ? unit : unit + "^" + std::to_string(exponent);
}
} // namespace

bool Dimension::operator==(const Dimension &other) const
{
  return mass == other.mass && length == other.length && time == other.time;
}

std::string Dimension::unit() const
{
  // What people do not write in kilogram, metre and second.
  const std::array<std::pair<Dimension, const char *>, 10> derived{
      {{Dimensions::pressure, "Pa"},
       {Dimensions::viscosity, "Pa s"},
       {Dimensions::force_density, "N/m^3"},
       {Dimensions::power, "W"},
       {Dimensions::flow_resistance, "Pa s/m^3"},
       {Dimensions::compliance, "m^3/Pa"},
       {force, "N"},
       {energy, "J"},
       {{1, 0, -2}, "N/m"},
       {{1, -2, -1}, "Pa s/m"}}};
  for (const auto &[dimension, name] : derived)
    if (*this == dimension)
      return name;

  std::string numerator, denominator;
  for (const auto &[name, exponent] :
       std::array<std::pair<const char *, int>, 3>{{{"kg", mass}, {"m", length}, {"s", time}}})
    if (exponent > 0)
      numerator += (numerator.empty() ? "" : " ") + power_text(name, exponent);
    else if (exponent < 0)
      denominator += "/" + power_text(name, -exponent);
  return (numerator.empty() ? "1" : numerator) + denominator;
}

double times_power_of_ten(const double number, const int power)
{
  if (power == 0 || number == 0. || !std::isfinite(number))
    return number;
  std::array<char, 40> text{};
  char *const end = text.data() + text.size();
  const auto written = std::to_chars(text.data(), end, number, std::chars_format::scientific);
  char *const exponent = std::find(text.data(), written.ptr, 'e') + 1;
  int old_power = 0;
  // from_chars takes no plus sign.
  std::from_chars(exponent + (*exponent == '+' ? 1 : 0), written.ptr, old_power);
  const auto shifted = std::to_chars(exponent, end, old_power + power);
  double result = 0.;
  if (std::from_chars(text.data(), shifted.ptr, result).ec == std::errc())
    return result;
  return number * std::pow(10., power); // infinite, or 0 for all a number can hold
}

double UnitScale::in_si(const double number) const
{
  const double shifted = times_power_of_ten(number, power_of_ten);
  return factor == 1. ? shifted : shifted * factor;
}

UnitScale unit_scale(const std::string &unit, Dimension &dimension)
{
  const std::string plain = in_plain_letters(unit);
  const Scale scale = UnitParser(plain).parse();
  dimension = scale.dimension;
  return scale.scale;
}

double unit_factor(const std::string &unit, Dimension &dimension)
{
  return unit_scale(unit, dimension).in_si(1.);
}

double parse_quantity(const std::string &text, const Dimension &dimension)
{
  const std::string blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string::npos)
    throw std::invalid_argument("there is no number");
  const std::string trimmed = text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);

  // from_chars knows no plus sign, but reads the words nan and inf.
  const char *const end = trimmed.data() + trimmed.size();
  const char *first = trimmed.data();
  if (*first == '+' && first + 1 < end && first[1] != '-')
    ++first;
  double number = 0.;
  const auto result = std::from_chars(first, end, number);
  if (result.ec == std::errc::result_out_of_range)
    throw std::invalid_argument("'" + trimmed + "' is beyond the numbers a computer can hold");
  if (result.ec != std::errc())
    throw std::invalid_argument("'" + trimmed + "' is no number");
  if (!std::isfinite(number))
    throw std::invalid_argument("'" + trimmed + "' is no finite number");

  const std::size_t unit_begin =
      trimmed.find_first_not_of(blanks, static_cast<std::size_t>(result.ptr - trimmed.data()));
  if (unit_begin == std::string::npos)
    return number;
  if (trimmed[unit_begin] == ',')
    throw std::invalid_argument("'" + trimmed + "' is no number; the decimal sign is a point");
  Dimension found;
  UnitScale scale;
  try
  {
    scale = unit_scale(trimmed.substr(unit_begin), found);
  }
  catch (const std::invalid_argument &exception)
  {
    throw std::invalid_argument("'" + trimmed + "' cannot be read: " + exception.what());
  }
  if (!(found == dimension))
    throw std::invalid_argument("'" + trimmed + "' has the wrong unit: it is in " + found.unit() +
                                ", not in " + dimension.unit());
  const double value = scale.in_si(number);
  if (!std::isfinite(value))
    throw std::invalid_argument("'" + trimmed + "' is beyond the numbers a computer can hold");
  return value;
}

std::string usual_units(const Dimension &dimension)
{
  static const std::vector<std::string> units{
      "m",      "cm",      "mm",      "um",    "m^2",      "cm^2",      "mm^2",      "s",
      "ms",     "min",     "h",       "Hz",    "kHz",      "m/s",       "cm/s",      "mm/s",
      "m/s^2",  "mm/s^2",  "kg",      "g",     "kg/m^3",   "g/cm^3",    "Pa",        "kPa",
      "MPa",    "GPa",     "bar",     "mmHg",  "cmH2O",    "Pa s",      "mPa s",     "cP",
      "m^3",    "l",       "ml",      "m^3/s", "l/min",    "ml/s",      "cm^3/s",    "m^2/s",
      "mm^2/s", "N",       "kN",      "N/m",   "mN/m",     "N/m^3",     "kN/m^3",    "W",
      "mW",     "J",       "mJ",      "%",     "Pa s/m^3", "MPa s/m^3", "mmHg s/ml", "dyn s/cm^5",
      "m^3/Pa", "mm^3/Pa", "ml/mmHg", "Pa/m",  "kPa/m",    "MPa/m",     "kPa s/m"};
  // Every entry with a unit asks.
  static const std::vector<Dimension> dimensions = []
  {
    std::vector<Dimension> of_units(units.size());
    for (std::size_t i = 0; i < units.size(); ++i)
      unit_factor(units[i], of_units[i]);
    return of_units;
  }();
  const std::string si = dimension.unit();
  std::string text = si == "1" ? "" : si;
  for (std::size_t i = 0; i < units.size(); ++i)
    if (dimensions[i] == dimension && units[i] != si)
      text += (text.empty() ? "" : ", ") + units[i];
  return text;
}

std::string shortest_number(const double value)
{
  std::array<char, 32> buffer{};
  char *const end = buffer.data() + buffer.size();
  // Shortest in letters would be 2e-04 for 0.0002.
  const double size = std::abs(value);
  const bool everyday = value == 0. || (size >= 1e-4 && size < 1e7);
  const auto result = everyday ? std::to_chars(buffer.data(), end, value, std::chars_format::fixed)
                               : std::to_chars(buffer.data(), end, value);
  return std::string(buffer.data(), result.ptr);
}

std::string named_value(const double value, const std::string &unit)
{
  return shortest_number(value) + " " + unit;
}

std::string with_value_in_si(const std::string &name)
{
  const std::size_t colon = std::min(name.find(':'), name.size());
  const std::string head = name.substr(0, colon);
  const std::array<std::pair<Dimension, const char *>, 3> units{
      {{Dimensions::length, "m"}, {Dimensions::time, "s"}, {Dimensions::frequency, "Hz"}}};
  // "43mm" behind the last blank, "43 mm" behind the one before.
  std::size_t blank = head.rfind(' ');
  for (int n_words = 1; n_words <= 2 && blank != std::string::npos && blank > 0; ++n_words)
  {
    for (const auto &[dimension, unit] : units)
      try
      {
        const std::string text = head.substr(blank + 1);
        // A number alone is part of the name.
        if (std::isdigit(static_cast<unsigned char>(text.back())) == 0)
          return head.substr(0, blank + 1) + named_value(parse_quantity(text, dimension), unit) +
                 name.substr(colon);
      }
      catch (const std::invalid_argument &)
      {
        // No such quantity.
      }
    blank = head.rfind(' ', blank - 1);
  }
  return name;
}
} // namespace Continua
