#include <continua/signal/formula_quantities.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <stdexcept>
#include <system_error>

namespace Continua
{
namespace
{
bool is_digit(const char letter)
{
  return std::isdigit(static_cast<unsigned char>(letter)) != 0;
}

/// Of a word; bytes above 127 belong to the micro sign.
bool is_letter(const char letter)
{
  return std::isalpha(static_cast<unsigned char>(letter)) != 0 || (letter & 0x80) != 0;
}

/// Reads the formula from left to right.
class FormulaReader
{
public:
  FormulaReader(const std::string &formula, const Dimension &dimension)
      : text(formula), dimension(dimension)
  {
  }

  std::string in_si()
  {
    while (place < text.size())
      if (const char letter = text[place]; is_letter(letter) || letter == '_')
        copy_word();
      else if (is_digit(letter) || letter == '.')
        copy_number();
      else
        copy_sign();
    end_term();
    if (n_quantities == 0)
      return text;
    if (has_other_operators)
      fail("has a comparison or a choice beside the quantity " + last_quantity);
    if (has_bare_term && !(dimension == Dimensions::none))
      fail("has a term without a unit beside the quantity " + last_quantity);
    return result;
  }

private:
  const std::string &text;
  const Dimension &dimension;
  std::string result;
  std::size_t place = 0;
  unsigned int depth = 0, n_quantities = 0;
  char previous = '\0'; ///< the last character that was no blank
  bool term_has_quantity = false, term_is_empty = true;
  bool has_bare_term = false, has_other_operators = false;
  std::string last_quantity;

  [[noreturn]] void fail(const std::string &problem) const
  {
    throw std::invalid_argument(
        "'" + text + "' " + problem +
        ". In a formula a quantity is the factor of a term outside all brackets, as in "
        "QUANTITY*(1 + sin(t)), and all other numbers are in SI and have no unit");
  }

  void copy(const std::size_t end)
  {
    result.append(text, place, end - place);
    place = end;
    previous = result.back();
    term_is_empty = false;
  }

  std::size_t end_of_blanks(std::size_t i) const
  {
    while (i < text.size() && std::isspace(static_cast<unsigned char>(text[i])) != 0)
      ++i;
    return i;
  }

  std::size_t end_of_word(std::size_t i) const
  {
    while (i < text.size() && (is_letter(text[i]) || is_digit(text[i]) || text[i] == '_'))
      ++i;
    return i;
  }

  void copy_word() { copy(end_of_word(place)); }

  void copy_sign()
  {
    const char letter = text[place];
    if (std::isspace(static_cast<unsigned char>(letter)) != 0)
    {
      result += letter;
      ++place;
      return;
    }
    depth += letter == '(' ? 1 : 0;
    depth -= letter == ')' && depth > 0 ? 1 : 0;
    if (depth == 0 && std::string("<>=!&|?:,").find(letter) != std::string::npos)
      has_other_operators = true;
    const bool is_sum = letter == '+' || letter == '-';
    if (depth == 0 && is_sum && !term_is_empty &&
        std::string("*/^").find(previous) == std::string::npos)
      end_term();
    const bool begins_term = term_is_empty && is_sum;
    copy(place + 1);
    term_is_empty = begins_term;
  }

  void end_term()
  {
    has_bare_term = has_bare_term || !term_has_quantity;
    term_has_quantity = false;
    term_is_empty = true;
  }

  /// Where the unit that begins at `begin` ends; `begin` if there is none.
  std::size_t end_of_unit(const std::size_t begin) const
  {
    std::size_t end = begin, next = begin;
    while (true)
    {
      const std::size_t end_of_name = text[next] == '%' ? next + 1 : end_of_word(next);
      if (!is_unit(text.substr(next, end_of_name - next)) ||
          text[std::min(end_of_blanks(end_of_name), text.size() - 1)] == '(')
        return end;
      end = end_of_name;
      if (end < text.size() && text[end] == '^')
      {
        std::size_t of_power = end + 1;
        if (of_power < text.size() && (text[of_power] == '-' || text[of_power] == '+'))
          ++of_power;
        if (of_power < text.size() && is_digit(text[of_power]))
          end = of_power + 1;
      }
      next = end_of_blanks(end);
      if (next < text.size() && (text[next] == '*' || text[next] == '/'))
        next = end_of_blanks(next + 1);
      if (next >= text.size())
        return end;
    }
  }

  static bool is_unit(const std::string &name)
  {
    constexpr std::array<const char *, 6> symbols = {{"x", "y", "z", "t", "e", "pi"}};
    if (name.empty() || is_digit(name[0]) ||
        std::find(symbols.begin(), symbols.end(), name) != symbols.end())
      return false;
    try
    {
      Dimension ignored;
      unit_factor(name, ignored);
      return true;
    }
    catch (const std::invalid_argument &)
    {
      return false;
    }
  }

  void copy_number()
  {
    double number = 0.;
    const auto read = std::from_chars(text.data() + place, text.data() + text.size(), number);
    if (read.ec != std::errc())
    {
      copy(place + 1);
      return;
    }
    const std::size_t end = static_cast<std::size_t>(read.ptr - text.data());
    const std::size_t unit = end_of_blanks(end);
    const std::size_t after = unit < text.size() ? end_of_unit(unit) : unit;
    if (after == unit)
    {
      copy(end);
      return;
    }
    last_quantity = "'" + text.substr(place, after - place) + "'";
    check_place_of_quantity(after);
    Dimension found;
    const double factor = unit_factor(text.substr(unit, after - unit), found);
    if (!(found == dimension))
      fail("has the quantity " + last_quantity + " with the wrong unit: it is in " + found.unit() +
           ", not in " + dimension.unit());
    std::array<char, 40> buffer{};
    const auto written =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), number * factor);
    result += "(" + std::string(buffer.data(), written.ptr) + ")";
    previous = ')';
    place = after;
    term_is_empty = false;
    term_has_quantity = true;
    ++n_quantities;
  }

  void check_place_of_quantity(const std::size_t after) const
  {
    const std::size_t next = end_of_blanks(after);
    if (depth > 0)
      fail("has the quantity " + last_quantity + " inside brackets");
    if (term_has_quantity)
      fail("has a second quantity, " + last_quantity + ", in one term");
    if (previous != '\0' && std::string("+-*").find(previous) == std::string::npos)
      fail("has the quantity " + last_quantity + " behind '" + std::string(1, previous) + "'");
    if (next < text.size() && std::string("+-*/<>=!&|?:,").find(text[next]) == std::string::npos)
      fail("has something behind the quantity " + last_quantity + "; a product needs '*'");
  }
};
} // namespace

std::string formula_in_si(const std::string &formula, const Dimension &dimension)
{
  return FormulaReader(formula, dimension).in_si();
}
} // namespace Continua
