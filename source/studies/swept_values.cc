#include <continua/studies/swept_values.h>

#include <continua/base/is_unit.h>
#include <continua/base/parameter_text.h>
#include <continua/base/quoted_name.h>
#include <continua/base/units.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iomanip>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace Continua
{
namespace
{
constexpr unsigned int most_values_of_a_range = 10000;

struct NumberAndUnit
{
  double number;
  std::string unit; ///< as written; empty: none

  std::string text() const { return shortest_number(number) + (unit.empty() ? "" : " " + unit); }
};

/// Nothing if the text does not begin with a number.
std::optional<NumberAndUnit> number_and_unit(const std::string &text)
{
  double number = 0.;
  const char *const end = text.data() + text.size();
  const auto result = std::from_chars(text.data() + (text.compare(0, 1, "+") == 0), end, number);
  if (result.ec != std::errc())
    return {};
  return NumberAndUnit{number, collapse_blanks(std::string(result.ptr, end))};
}

/// A number with a unit or without, and nothing else.
bool is_quantity(const std::string &text)
{
  const auto value = number_and_unit(text);
  return value && (value->unit.empty() || is_unit(value->unit));
}

/// At the commas outside of parentheses and quotes, without blanks at the ends.
std::vector<std::string> items_of(const std::string &text)
{
  std::vector<std::string> items(1);
  const std::vector<bool> quoted = quoted_letters(text);
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    depth += quoted[i] ? 0 : text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    if (text[i] == ',' && depth == 0 && !quoted[i])
      items.emplace_back();
    else
      items.back() += text[i];
  }
  for (std::string &item : items)
  {
    item = collapse_blanks(item);
    if (item.empty())
      throw std::invalid_argument("there is nothing between two commas or at an end of the list");
  }
  return items;
}

/// "(4, 2)" -> "4, 2". Parentheses that are part of an expression, "(a) + (b)", stay.
std::string without_parentheses(const std::string &item)
{
  if (item.size() < 2 || item.front() != '(' || item.back() != ')' ||
      item.find(',') == std::string::npos)
    return item;
  const std::vector<bool> quoted = quoted_letters(item);
  int depth = 0;
  for (std::size_t i = 0; i + 1 < item.size(); ++i)
  {
    depth += quoted[i] ? 0 : item[i] == '(' ? 1 : item[i] == ')' ? -1 : 0;
    if (depth == 0)
      return item;
  }
  return collapse_blanks(item.substr(1, item.size() - 2));
}

/// The ends, the number of values, and how they are placed, as written.
struct WrittenRange
{
  std::string first, last, count;
  bool is_logarithmic;
};

/// Nothing if the item is a value: what stands before " to " is no number.
std::optional<WrittenRange> written_range(const std::string &item)
{
  const std::size_t to = item.find(" to ");
  if (to == std::string::npos || !is_quantity(collapse_blanks(item.substr(0, to))))
    return {};
  WrittenRange range;
  range.first = collapse_blanks(item.substr(0, to));
  std::string rest = item.substr(to + 4);
  const std::size_t in = rest.rfind(" in ");
  if (in == std::string::npos)
    throw std::invalid_argument("the range '" + item + "' does not say how many values it has");
  range.last = collapse_blanks(rest.substr(0, in));
  range.count = collapse_blanks(rest.substr(in + 4));
  const std::size_t blank = range.count.find(' ');
  const std::string spacing = blank == std::string::npos ? "" : range.count.substr(blank + 1);
  if (!spacing.empty() && spacing != "logarithmic" && spacing != "linear")
    throw std::invalid_argument("'" + spacing + "' of the range '" + item +
                                "' is neither linear nor logarithmic");
  range.is_logarithmic = spacing == "logarithmic";
  range.count = range.count.substr(0, blank);
  return range;
}

unsigned int number_of_values(const std::string &text, const std::string &item)
{
  unsigned int count = 0;
  const char *const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, count);
  if (result.ec != std::errc() || result.ptr != end || count > most_values_of_a_range)
    throw std::invalid_argument("'" + text + "' of the range '" + item +
                                "' is no number of values (from 2 to " +
                                std::to_string(most_values_of_a_range) + ")");
  if (count < 2)
    throw std::invalid_argument("the range '" + item +
                                "' has two ends, and so two values at least");
  return count;
}

double rounded(const double value, const int digits)
{
  std::ostringstream text;
  text << std::setprecision(digits) << value;
  return std::stod(text.str());
}

/// With six digits, which keep the names of the values short, or as many more as move none by more
/// than a hundredth of its distance from the next.
std::vector<double> rounded(const std::vector<double> &values)
{
  constexpr int least = 6, most = std::numeric_limits<double>::max_digits10;
  std::vector<double> result(values.size());
  for (int digits = least; digits <= most; ++digits)
  {
    bool is_near = true;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      result[i] = rounded(values[i], digits);
      for (const std::size_t next : {i - 1, i + 1})
        is_near = is_near &&
                  (next >= values.size() ||
                   std::abs(result[i] - values[i]) <= 0.01 * std::abs(values[next] - values[i]));
    }
    if (is_near)
      break;
  }
  return result;
}

/// What a value means, however it is written.
struct Meaning
{
  bool is_number;
  double number; ///< [SI]
  Dimension dimension;
  std::string word;
};

Meaning meaning_of(const std::string &value)
{
  Meaning meaning{is_quantity(value), 0., Dimension(), without_quotes(value)};
  if (!meaning.is_number)
    return meaning;
  const NumberAndUnit written = *number_and_unit(value);
  meaning.number =
      written.number * unit_factor(written.unit.empty() ? "1" : written.unit, meaning.dimension);
  return meaning;
}

bool is_same(const Meaning &one, const Meaning &other)
{
  if (!one.is_number || !other.is_number)
    return one.word == other.word;
  // Factors of units bring in their round-off.
  return std::abs(one.number - other.number) <=
             1e-14 * std::max(std::abs(one.number), std::abs(other.number)) &&
         one.dimension == other.dimension;
}

void refuse_twice(const std::vector<std::string> &values)
{
  std::vector<Meaning> meanings;
  meanings.reserve(values.size());
  for (const std::string &value : values)
  {
    const Meaning meaning = meaning_of(value);
    const auto same =
        std::find_if(meanings.begin(), meanings.end(),
                     [&meaning](const Meaning &other) { return is_same(other, meaning); });
    if (same != meanings.end())
    {
      const std::string &first = values[static_cast<std::size_t>(same - meanings.begin())];
      throw std::invalid_argument("the value '" + value + "' stands there twice" +
                                  (first == value ? "" : ", first as '" + first + "'"));
    }
    meanings.push_back(meaning);
  }
}

/// `last`: with the unit that it has in the list.
std::vector<std::string> values_of(const WrittenRange &range, const std::string &item)
{
  NumberAndUnit first = *number_and_unit(range.first);
  const std::optional<NumberAndUnit> last = number_and_unit(range.last);
  if (!last || !is_quantity(range.last))
    throw std::invalid_argument("'" + range.last + "' of the range '" + item +
                                "' is no number with a unit");
  if (first.unit.empty())
    first.unit = last->unit;
  double end = last->number;
  if (last->unit != first.unit)
  {
    Dimension of_first, of_last;
    const double factor_of_first = unit_factor(first.unit.empty() ? "1" : first.unit, of_first),
                 factor_of_last = unit_factor(last->unit.empty() ? "1" : last->unit, of_last);
    if (!(of_first == of_last))
      throw std::invalid_argument("the ends of the range '" + item +
                                  "' have units of different dimensions");
    end *= factor_of_last / factor_of_first;
  }
  if (!(end > first.number))
    throw std::invalid_argument("the range '" + item + "' does not end above its beginning");
  if (range.is_logarithmic && first.number <= 0.)
    throw std::invalid_argument("the logarithmic range '" + item + "' does not begin above zero");
  const unsigned int n = number_of_values(range.count, item);
  std::vector<double> numbers;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double part = static_cast<double>(i) / (n - 1);
    numbers.push_back(range.is_logarithmic ? first.number * std::pow(end / first.number, part)
                                           : first.number + (end - first.number) * part);
  }
  numbers = rounded(numbers);
  std::vector<std::string> values = {first.text()};
  for (unsigned int i = 1; i + 1 < n; ++i)
    values.push_back(NumberAndUnit{numbers[i], first.unit}.text());
  values.push_back(last->text());
  return values;
}
} // namespace

std::vector<std::string> swept_values(const std::string &text)
{
  if (collapse_blanks(text).empty())
    throw std::invalid_argument("it lists no value");
  const std::vector<std::string> items = items_of(text);
  // The unit behind the last number.
  const auto last_range = written_range(items.back());
  const std::string last = last_range ? last_range->last : items.back();
  const std::string last_unit = is_quantity(last) ? number_and_unit(last)->unit : "";
  std::vector<std::string> values;
  for (const std::string &item : items)
  {
    if (const auto range = written_range(item))
    {
      WrittenRange complete = *range;
      if (is_quantity(range->last) && number_and_unit(range->last)->unit.empty() &&
          !last_unit.empty())
        complete.last += " " + last_unit;
      for (const std::string &value : values_of(complete, item))
        values.push_back(value);
      continue;
    }
    std::string value = without_parentheses(item);
    if (is_quantity(item) && number_and_unit(item)->unit.empty() && !last_unit.empty())
      value.append(" ").append(last_unit);
    values.push_back(value);
  }
  refuse_twice(values);
  if (std::all_of(values.begin(), values.end(), is_quantity))
  {
    // In "30 kPa, 25" the second is hardly meant as 25 Pa.
    const auto has_unit = [](const std::string &value)
    { return !number_and_unit(value)->unit.empty(); };
    const bool any = std::any_of(values.begin(), values.end(), has_unit);
    for (const std::string &value : values)
      if (any && !has_unit(value) && number_and_unit(value)->number != 0.)
        throw std::invalid_argument("'" + value + "' has no unit, but others in the list have");
  }
  return values;
}
} // namespace Continua
