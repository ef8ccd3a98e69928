#include <continua/base/entry_type.h>

#include <continua/base/joined.h>
#include <continua/base/nearest_name.h>
#include <continua/base/numeric_entry.h>
#include <continua/base/parameter_text.h>
#include <continua/base/quoted_name.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
/// "1450 kg/m^3".
std::string quantity_text(const double value, const Dimension &dimension)
{
  const std::string unit = dimension.unit();
  return shortest_number(value) + (unit == "1" ? "" : " " + unit);
}

/// "> 0", ">= 0 and < 0.5", "<= 3 m"; empty if there is no bound.
std::string range_text(const Range &range, const Dimension &dimension)
{
  const auto bound = [&dimension](const double value)
  { return value == 0. ? std::string("0") : quantity_text(value, dimension); };
  std::string text;
  if (std::isfinite(range.lower))
    text = (range.lower_open ? "> " : ">= ") + bound(range.lower);
  if (std::isfinite(range.upper))
    text += (text.empty() ? "" : " and ") + std::string(range.upper_open ? "< " : "<= ") +
            bound(range.upper);
  return text;
}

/// At the commas outside parentheses and quotes; the items without blanks at their ends.
std::vector<std::string> split(const std::string &text)
{
  std::vector<std::string> items;
  if (text.empty())
    return items;
  items.emplace_back();
  const std::vector<bool> quoted = quoted_letters(text);
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const char letter = text[i];
    depth += quoted[i] ? 0 : letter == '(' ? 1 : letter == ')' ? -1 : 0;
    if (letter == ',' && depth == 0 && !quoted[i])
      items.emplace_back();
    else
      items.back() += letter;
  }
  for (std::string &item : items)
    item = collapse_blanks(item);
  return items;
}

template <typename T, typename Function>
std::string list_text(const std::vector<T> &values, const Function &write)
{
  std::vector<std::string> words(values.size());
  std::transform(values.begin(), values.end(), words.begin(), write);
  return joined(words);
}

/// What follows the number, if there is a number and something follows.
std::string unit_of(const std::string &item)
{
  double number = 0.;
  const char *const end = item.data() + item.size();
  const auto result = std::from_chars(item.data() + (item.compare(0, 1, "+") == 0), end, number);
  return result.ec == std::errc() ? collapse_blanks(std::string(result.ptr, end)) : "";
}

std::string integer_range_text(const unsigned int lower, const unsigned int upper)
{
  return upper == std::numeric_limits<unsigned int>::max()
             ? "whole number >= " + std::to_string(lower)
             : "whole number from " + std::to_string(lower) + " to " + std::to_string(upper);
}

double read_quantity(const std::string &text, const Dimension &dimension, const Range &range)
{
  const double value = parse_quantity(text, dimension);
  if (!contains(range, value))
    throw std::invalid_argument(text + " is out of range");
  return value;
}

unsigned int
read_integer(const std::string &text, const unsigned int lower, const unsigned int upper)
{
  long long number = 0;
  const char *const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  if (result.ec == std::errc::invalid_argument || result.ptr != end)
    throw std::invalid_argument("'" + text + "' is no whole number");
  if (result.ec != std::errc() || number < lower || number > upper)
    throw std::invalid_argument(text + " is out of range");
  return static_cast<unsigned int>(number);
}

void refuse_empty_items(const std::vector<std::string> &items)
{
  if (std::find(items.begin(), items.end(), "") != items.end())
    throw std::invalid_argument("there is nothing between two commas or at an end of the list");
}

std::string quantity_remedy(const Dimension &dimension, const Range &range, const bool list)
{
  const std::string bounds = range_text(range, dimension);
  const std::string units = usual_units(dimension);
  return (list ? "Give values" : "Give a value") + (bounds.empty() ? "" : " " + bounds) +
         (units.empty() ? "" : ", with a unit like " + units);
}

NumericForm whole_numbers(const bool is_list, const unsigned int lower, const unsigned int upper)
{
  return {is_list, true, Dimensions::none,
          Range{static_cast<double>(lower), static_cast<double>(upper), false, false}};
}

std::string itself(const std::string &text)
{
  return text;
}

std::string write_integer(const unsigned int value)
{
  return std::to_string(value);
}

std::vector<double>
read_quantities(const std::string &text, const Dimension &dimension, const Range &range)
{
  const std::vector<std::string> items = split(text);
  refuse_empty_items(items);
  const std::string last_unit = items.empty() ? "" : unit_of(items.back());
  const bool any_unit = std::any_of(items.begin(), items.end(),
                                    [](const std::string &item) { return !unit_of(item).empty(); });
  std::vector<double> values;
  for (const std::string &item : items)
  {
    const bool has_unit = !unit_of(item).empty();
    const std::string complete = has_unit || last_unit.empty() ? item : item + " " + last_unit;
    values.push_back(read_quantity(complete, dimension, range));
    // In "30 kPa, 25" the second is hardly meant as 25 Pa.
    if (!has_unit && last_unit.empty() && any_unit && values.back() != 0.)
      throw std::invalid_argument("'" + item + "' has no unit, but others in the list have");
  }
  return values;
}
} // namespace

EntryType<double> quantity_type(const double value, const Dimension &dimension, const Range &range)
{
  const std::string bounds = range_text(range, dimension);
  const bool has_default = std::isfinite(value) && contains(range, value);
  return {has_default ? quantity_text(value, dimension) : "",
          "number" + (bounds.empty() ? "" : " " + bounds),
          dimension.unit(),
          false,
          quantity_remedy(dimension, range, false),
          [dimension, range](const std::string &text)
          { return read_quantity(text, dimension, range); },
          shortest_number,
          NumericForm{false, false, dimension, range}};
}

EntryType<std::vector<double>> quantity_list_type(const std::vector<double> &values,
                                                  const Dimension &dimension,
                                                  const Range &range)
{
  const std::string bounds = range_text(range, dimension);
  const bool has_default = std::all_of(values.begin(), values.end(),
                                       [&](const double value)
                                       { return std::isfinite(value) && contains(range, value); });
  return {has_default ? list_text(values, [&](const double value)
                                  { return quantity_text(value, dimension); })
                      : "",
          "list of numbers" + (bounds.empty() ? "" : " " + bounds),
          dimension.unit(),
          true,
          quantity_remedy(dimension, range, true) + ", separated by commas",
          [dimension, range](const std::string &text)
          { return read_quantities(text, dimension, range); },
          [](const std::vector<double> &numbers) { return list_text(numbers, shortest_number); },
          NumericForm{true, false, dimension, range}};
}

EntryType<unsigned int>
integer_type(const unsigned int value, const unsigned int lower, const unsigned int upper)
{
  const std::string range = integer_range_text(lower, upper);
  return {lower <= value && value <= upper ? write_integer(value) : "",
          range,
          "",
          false,
          "Give a " + range,
          [lower, upper](const std::string &text) { return read_integer(text, lower, upper); },
          write_integer,
          whole_numbers(false, lower, upper)};
}

EntryType<std::vector<unsigned int>> integer_list_type(const std::vector<unsigned int> &values,
                                                       const unsigned int lower)
{
  constexpr unsigned int upper = std::numeric_limits<unsigned int>::max();
  return {list_text(values, write_integer),
          "list of " + integer_range_text(lower, upper),
          "",
          true,
          "Give whole numbers >= " + std::to_string(lower) + ", separated by commas",
          [lower](const std::string &text)
          {
            const std::vector<std::string> items = split(text);
            refuse_empty_items(items);
            std::vector<unsigned int> numbers;
            for (const std::string &item : items)
              numbers.push_back(read_integer(item, lower, upper));
            return numbers;
          },
          [](const std::vector<unsigned int> &numbers)
          { return list_text(numbers, write_integer); },
          whole_numbers(true, lower, upper)};
}

EntryType<bool> truth_type(const bool value)
{
  const auto write = [](const bool truth) { return std::string(truth ? "true" : "false"); };
  return {write(value),
          "true, false (or yes, no)",
          "",
          false,
          "Give true or false",
          [](const std::string &text)
          {
            const bool yes = text == "true" || text == "yes";
            if (!yes && text != "false" && text != "no")
              throw std::invalid_argument("'" + text + "' is neither true nor false");
            return yes;
          },
          write};
}

EntryType<std::string> text_type(const std::string &value)
{
  return {value, "text", "", true, "", itself, itself};
}

EntryType<std::vector<std::string>> word_list_type(const std::vector<std::string> &values)
{
  return {joined(values),
          "list of words",
          "",
          true,
          "Give words separated by commas",
          [](const std::string &text)
          {
            std::vector<std::string> items = split(text);
            refuse_empty_items(items);
            std::transform(items.begin(), items.end(), items.begin(), without_quotes);
            return items;
          },
          [](const std::vector<std::string> &words) {
            return list_text(words,
                             [](const std::string &word) { return quoted_name(word, "#,"); });
          }};
}

EntryType<std::string> choice_type(const std::string &value,
                                   const std::vector<std::string> &choices)
{
  const std::string list = joined(choices);
  return {value,
          list,
          "",
          false,
          "Give one of: " + list,
          [choices](const std::string &text)
          {
            if (std::find(choices.begin(), choices.end(), text) == choices.end())
            {
              const std::string nearest = nearest_name(text, choices);
              throw std::invalid_argument(
                  "'" + text + "' does not exist" +
                  (nearest.empty() ? "" : ". Did you mean '" + nearest + "'?"));
            }
            return text;
          },
          itself};
}
} // namespace Continua
