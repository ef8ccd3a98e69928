#include <continua/base/joined.h>
#include <continua/base/nearest_name.h>
#include <continua/base/numeric_entry.h>
#include <continua/base/parameter_store.h>
#include <continua/base/quoted_name.h>
#include <continua/base/undefined.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <stdexcept>

namespace Continua
{
namespace
{
using Declaration = ParameterStore::Declaration;

/// Names without blanks that do not count, and without quotes.
std::vector<std::string> names_of_path(const std::string &path)
{
  std::vector<std::string> names;
  for (const std::string &part : split_unquoted(path, '/'))
    names.push_back(without_quotes(collapse_blanks(part)));
  return names;
}

const Declaration *find_declaration(const std::vector<Declaration> &declarations,
                                    const std::vector<std::string> &path)
{
  const auto found =
      std::find_if(declarations.begin(), declarations.end(),
                   [&path](const Declaration &declaration) { return declaration.path() == path; });
  return found == declarations.end() ? nullptr : &*found;
}

/// Takes the place from the end of the last name: "Shear moduli 2"; 0 if there is none.
std::size_t take_place(std::vector<std::string> &path)
{
  std::string &key = path.back();
  const std::size_t blank = key.rfind(' ');
  if (blank == std::string::npos || blank == 0 || blank + 1 == key.size() ||
      key.find_first_not_of("0123456789", blank + 1) != std::string::npos || key.size() - blank > 6)
    return 0;
  const std::size_t place = std::stoul(key.substr(blank + 1));
  key.erase(blank);
  return place;
}

std::vector<double> numbers_of(const Declaration &declaration, const std::string &value)
{
  std::vector<double> numbers;
  const std::string text = declaration.one_form(value);
  for (const std::string &item : split_unquoted(text, ','))
    if (const std::string number = collapse_blanks(item); !number.empty())
      numbers.push_back(std::strtod(number.c_str(), nullptr));
  return numbers;
}
} // namespace

namespace
{
/// The numbers of an entry, and what they are.
struct Quantities
{
  NumericForm form;
  bool is_angle = false;
  std::vector<double> numbers;
};

/// Of a formula or an angle, whose text names its unit in brackets, where the value in the file is
/// a quantity, or a list of such; else nothing.
std::optional<Quantities> quantities_of_text(const Declaration &declaration,
                                             const std::string &value)
{
  const std::size_t begin = declaration.text.find('['), end = declaration.text.find(']');
  if (begin == std::string::npos || end == std::string::npos || end < begin)
    return std::nullopt;
  const std::string unit = declaration.text.substr(begin + 1, end - begin - 1);
  Quantities result;
  result.is_angle = unit == "deg or rad";
  if (!result.is_angle)
    try
    {
      unit_factor(unit, result.form.dimension);
    }
    catch (const std::invalid_argument &)
    {
      return std::nullopt;
    }
  for (const std::string &item : split_unquoted(value, ','))
    try
    {
      result.numbers.push_back(parse_quantity(collapse_blanks(item), result.form.dimension));
    }
    catch (const std::invalid_argument &)
    {
      return std::nullopt;
    }
  result.form.is_list = result.numbers.size() > 1;
  return result;
}

std::optional<Quantities> quantities_of(const ParameterStore &store,
                                        const Declaration &declaration,
                                        const NumericEntry::Kind kind)
{
  const std::string value = store.value(declaration);
  if (declaration.number)
    return Quantities{*declaration.number, false, numbers_of(declaration, value)};
  if (kind == NumericEntry::Kind::numbers)
    return std::nullopt;
  return quantities_of_text(declaration, value);
}
} // namespace

bool contains(const Range &range, const double number)
{
  return (range.lower_open ? number > range.lower : number >= range.lower) &&
         (range.upper_open ? number < range.upper : number <= range.upper);
}

NumericEntry::NumericEntry(const ParameterFile &file,
                           const std::string &path,
                           const ParameterSection &section,
                           const std::string &key,
                           const Kind kind)
{
  const std::vector<Declaration> &declarations = file.store->declarations;
  std::vector<std::string> names = names_of_path(path);
  std::size_t given_place = 0;
  const Declaration *declaration = find_declaration(declarations, names);
  if (declaration == nullptr)
  {
    std::vector<std::string> shorter = names;
    given_place = take_place(shorter);
    if (given_place > 0 || shorter != names)
      declaration = find_declaration(declarations, shorter);
  }
  if (declaration == nullptr)
  {
    std::vector<std::string> paths;
    for (const Declaration &other : declarations)
      if (other.number)
        paths.push_back(join_path(other.path()));
    const std::string nearest = nearest_name(join_path(names), paths);
    section.refuse(key, "the file has no entry '" + path + "'",
                   nearest.empty()
                       ? "Give the path of a number, such as 'Geometry/Wall thickness'; continua "
                         "FILE --print-parameters lists all entries"
                       : "Did you mean '" + nearest + "'?");
  }
  entry = join_path(declaration->path());
  const std::optional<Quantities> quantities = quantities_of(*file.store, *declaration, kind);
  if (!quantities)
    section.refuse(key, "'" + entry + "' is no number, but " + declaration->values,
                   "Give the path of a number");
  form = quantities->form;
  is_angle = quantities->is_angle;
  numbers = quantities->numbers;
  const std::string size = std::to_string(numbers.size());
  if (form.is_list)
  {
    if (given_place == 0 && numbers.size() != 1)
      section.refuse(key, "'" + entry + "' is a list of " + size + " numbers",
                     "Add the place of one of them, as in '" + entry + " 1'");
    place = given_place == 0 ? 0 : given_place - 1;
    if (place >= numbers.size())
      section.refuse(key,
                     "the list '" + entry + "' has " + size +
                         (numbers.size() == 1 ? " number" : " numbers"),
                     numbers.empty() ? "Give the list first" : "Give a place from 1 to " + size);
  }
  else if (given_place > 0)
    section.refuse(key, "'" + entry + "' is one number, not a list",
                   "Leave out the place at its end");
  else if (numbers.empty())
    numbers.push_back(undefined);
  its_path = entry + (form.is_list ? " " + std::to_string(place + 1) : "");
}

std::vector<std::string> NumericEntry::paths_given(const ParameterFile &file,
                                                   const std::vector<std::string> &sections,
                                                   const Kind kind)
{
  std::vector<std::string> paths;
  for (const Declaration &declaration : file.store->declarations)
  {
    if (declaration.section.empty() ||
        std::find(sections.begin(), sections.end(), declaration.section.front()) ==
            sections.end() ||
        file.store->given(declaration.section, declaration.key) == nullptr)
      continue;
    const std::optional<Quantities> quantities = quantities_of(*file.store, declaration, kind);
    if (!quantities || quantities->form.is_integer)
      continue;
    const std::string path = join_path(declaration.path());
    for (std::size_t place = 1; place <= quantities->numbers.size(); ++place)
      paths.push_back(quantities->form.is_list ? path + " " + std::to_string(place) : path);
  }
  return paths;
}

bool NumericEntry::accepts(const double number) const
{
  return std::isfinite(number) && contains(form.range, number) &&
         (!form.is_integer || number == std::floor(number));
}

std::vector<std::pair<std::string, std::string>>
NumericEntry::settings(const std::vector<NumericEntry> &entries, const std::vector<double> &numbers)
{
  if (entries.size() != numbers.size())
    throw std::invalid_argument("There is a number for each entry.");
  // In the order of the entries, with the other numbers of a list as they stand in the file.
  std::vector<std::string> order;
  std::map<std::string, std::vector<double>> values;
  std::map<std::string, std::vector<bool>> is_set;
  std::map<std::string, const NumericEntry *> samples;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const NumericEntry &one = entries[i];
    if (samples.emplace(one.entry, &one).second)
    {
      order.push_back(one.entry);
      values[one.entry] = one.numbers;
      is_set[one.entry].resize(one.numbers.size(), false);
    }
    if (is_set[one.entry][one.place])
      throw std::invalid_argument("'" + one.its_path + "' is named twice");
    is_set[one.entry][one.place] = true;
    values[one.entry][one.place] = numbers[i];
  }
  std::vector<std::pair<std::string, std::string>> result;
  for (const std::string &path : order)
  {
    const std::string unit = samples[path]->unit();
    std::vector<std::string> texts;
    for (const double value : values[path])
      texts.push_back((samples[path]->form.is_integer ? std::to_string(std::lround(value))
                                                      : shortest_number(value)) +
                      (unit == "1" ? "" : " " + unit));
    result.emplace_back(path, joined(texts));
  }
  return result;
}
} // namespace Continua
