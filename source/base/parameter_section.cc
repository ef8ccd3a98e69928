#include <continua/base/nearest_name.h>
#include <continua/base/parameter_file.h>
#include <continua/base/parameter_section.h>
#include <continua/base/parameter_store.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>

namespace Continua
{
namespace
{
const dealii::Patterns::Anything anything;

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

bool contains(const Range &range, const double value)
{
  return (range.lower_open ? value > range.lower : value >= range.lower) &&
         (range.upper_open ? value < range.upper : value <= range.upper);
}

/// At the commas outside parentheses; the items without blanks at their ends.
std::vector<std::string> split(const std::string &text)
{
  std::vector<std::string> items;
  if (text.empty())
    return items;
  items.emplace_back();
  int depth = 0;
  for (const char letter : text)
  {
    depth += letter == '(' ? 1 : letter == ')' ? -1 : 0;
    if (letter == ',' && depth == 0)
      items.emplace_back();
    else
      items.back() += letter;
  }
  for (std::string &item : items)
    item = collapse_blanks(item);
  return items;
}

template <typename T, typename Function>
std::string join(const std::vector<T> &values, const Function &write)
{
  std::string text;
  for (const T &value : values)
    text += (text.empty() ? "" : ", ") + write(value);
  return text;
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

/// Understands `value` and fills `resolved`. Throws std::invalid_argument with the problem.
using Reader = std::function<void(ParameterStore::Declaration &)>;

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

/// An empty text is refused unless it `may_be_empty`, or is the default.
void declare_and_read(ParameterStore &store,
                      const ParameterSection &section,
                      ParameterStore::Declaration declaration,
                      const dealii::Patterns::PatternBase &pattern,
                      const bool may_be_empty,
                      const std::string &remedy,
                      const Reader &read)
{
  const ParameterText::Section *const given = store.text.find(declaration.section);
  const ParameterText::Entry *const entry =
      given == nullptr ? nullptr : given->entry(declaration.key);
  declaration.value = declaration.default_value;
  // An empty text leaves a default of "none" as it is.
  if (entry != nullptr && !(entry->value().empty() && declaration.default_value.empty()))
  {
    declaration.value = entry->value();
    try
    {
      if (declaration.value.empty() && !may_be_empty)
        throw std::invalid_argument("there is no value");
      read(declaration);
    }
    catch (const std::invalid_argument &exception)
    {
      section.refuse(declaration.key, exception.what(), remedy);
    }
  }
  // Where the default is "none", its empty text fits no other pattern.
  if (declaration.default_value.empty() || declaration.value.empty())
    store.declare(declaration, anything);
  else
    store.declare(declaration, pattern);
}

/// The file relative to the one that names it; throws std::invalid_argument if it cannot be read.
std::string find_file(const std::string &name, const Origin &origin)
{
  namespace filesystem = std::filesystem;
  const filesystem::path directory = origin.file == ParameterText::command_line
                                         ? filesystem::path()
                                         : filesystem::path(origin.file).parent_path();
  const filesystem::path path = (directory / name).lexically_normal();
  std::error_code no_access; // what cannot be looked at counts as missing
  if (!filesystem::exists(path, no_access))
    throw std::invalid_argument("the file '" + path.string() + "' does not exist");
  if (!filesystem::is_regular_file(path, no_access))
    throw std::invalid_argument("'" + path.string() + "' is no file");
  if (!std::ifstream(path))
    throw std::invalid_argument("the file '" + path.string() + "' cannot be read");
  return path.string();
}
} // namespace

ParameterSection::ParameterSection(ParameterFile &file, const std::vector<std::string> &path)
    : store(file.store.get()), names(path)
{
  store->declare_section(names);
}

void ParameterSection::add(const std::string &key,
                           double &value,
                           const Dimension &dimension,
                           const std::string &text,
                           const Range &range)
{
  const std::string bounds = range_text(range, dimension);
  const bool has_default = std::isfinite(value) && contains(range, value);
  declare_and_read(*store, *this,
                   {names, key, has_default ? quantity_text(value, dimension) : "",
                    "number" + (bounds.empty() ? "" : " " + bounds), dimension.unit(), text, "",
                    shortest_number(value)},
                   anything, false, quantity_remedy(dimension, range, false),
                   [&](ParameterStore::Declaration &entry)
                   {
                     value = read_quantity(entry.value, dimension, range);
                     entry.resolved = shortest_number(value);
                   });
}

void ParameterSection::add(const std::string &key,
                           std::vector<double> &values,
                           const Dimension &dimension,
                           const std::string &text,
                           const Range &range)
{
  const std::string bounds = range_text(range, dimension);
  const bool has_default = std::all_of(values.begin(), values.end(),
                                       [&](const double value)
                                       { return std::isfinite(value) && contains(range, value); });
  declare_and_read(
      *store, *this,
      {names, key,
       has_default
           ? join(values, [&](const double value) { return quantity_text(value, dimension); })
           : "",
       "list of numbers" + (bounds.empty() ? "" : " " + bounds), dimension.unit(), text, "",
       join(values, shortest_number)},
      anything, true, quantity_remedy(dimension, range, true) + ", separated by commas",
      [&](ParameterStore::Declaration &entry)
      {
        const std::vector<std::string> items = split(entry.value);
        refuse_empty_items(items);
        const std::string last_unit = items.empty() ? "" : unit_of(items.back());
        const bool any_unit =
            std::any_of(items.begin(), items.end(),
                        [](const std::string &item) { return !unit_of(item).empty(); });
        std::vector<double> read;
        for (const std::string &item : items)
        {
          const bool has_unit = !unit_of(item).empty();
          const std::string complete =
              has_unit || last_unit.empty() ? item : item + " " + last_unit;
          read.push_back(read_quantity(complete, dimension, range));
          // In "30 kPa, 25" the second is hardly meant as 25 Pa.
          if (!has_unit && last_unit.empty() && any_unit && read.back() != 0.)
            throw std::invalid_argument("'" + item + "' has no unit, but others in the list have");
        }
        values = read;
        entry.resolved = join(values, shortest_number);
      });
}

void ParameterSection::add(const std::string &key,
                           unsigned int &value,
                           const std::string &text,
                           const unsigned int lower,
                           const unsigned int upper)
{
  const std::string range = integer_range_text(lower, upper);
  const std::string written = std::to_string(value);
  declare_and_read(
      *store, *this,
      {names, key, lower <= value && value <= upper ? written : "", range, "", text, "", written},
      anything, false, "Give a " + range,
      [&](ParameterStore::Declaration &entry)
      {
        value = read_integer(entry.value, lower, upper);
        entry.resolved = std::to_string(value);
      });
}

void ParameterSection::add(const std::string &key, bool &value, const std::string &text)
{
  const std::string written = value ? "true" : "false";
  declare_and_read(
      *store, *this, {names, key, written, "true, false (or yes, no)", "", text, "", written},
      dealii::Patterns::Selection("true|false|yes|no"), false, "Give true or false",
      [&](ParameterStore::Declaration &entry)
      {
        const bool yes = entry.value == "true" || entry.value == "yes";
        if (!yes && entry.value != "false" && entry.value != "no")
          throw std::invalid_argument("'" + entry.value + "' is neither true nor false");
        value = yes;
        entry.resolved = yes ? "true" : "false";
      });
}

void ParameterSection::add(const std::string &key, std::string &value, const std::string &text)
{
  declare_and_read(*store, *this, {names, key, value, "text", "", text, "", value}, anything, true,
                   "",
                   [&](ParameterStore::Declaration &entry)
                   {
                     value = entry.value;
                     entry.resolved = value;
                   });
}

void ParameterSection::add(const std::string &key,
                           std::vector<std::string> &values,
                           const std::string &text)
{
  const auto itself = [](const std::string &word) { return word; };
  const std::string written = join(values, itself);
  declare_and_read(*store, *this, {names, key, written, "list of words", "", text, "", written},
                   anything, true, "Give words separated by commas",
                   [&](ParameterStore::Declaration &entry)
                   {
                     const std::vector<std::string> items = split(entry.value);
                     refuse_empty_items(items);
                     values = items;
                     entry.resolved = join(values, itself);
                   });
}

void ParameterSection::add(const std::string &key,
                           std::vector<unsigned int> &values,
                           const std::string &text,
                           const unsigned int lower)
{
  const unsigned int upper = std::numeric_limits<unsigned int>::max();
  const auto write = [](const unsigned int value) { return std::to_string(value); };
  const std::string written = join(values, write);
  declare_and_read(
      *store, *this,
      {names, key, written, "list of " + integer_range_text(lower, upper), "", text, "", written},
      anything, true, "Give whole numbers >= " + std::to_string(lower) + ", separated by commas",
      [&](ParameterStore::Declaration &entry)
      {
        const std::vector<std::string> items = split(entry.value);
        refuse_empty_items(items);
        std::vector<unsigned int> read;
        for (const std::string &item : items)
          read.push_back(read_integer(item, lower, upper));
        values = read;
        entry.resolved = join(values, write);
      });
}

void ParameterSection::add_choice(const std::string &key,
                                  std::string &value,
                                  const std::vector<std::string> &choices,
                                  const std::string &text)
{
  const std::string list = join(choices, [](const std::string &choice) { return choice; });
  std::string pattern;
  for (const std::string &choice : choices)
    pattern += (pattern.empty() ? "" : "|") + choice;
  declare_and_read(*store, *this, {names, key, value, list, "", text, "", value},
                   dealii::Patterns::Selection(pattern), false, "Give one of: " + list,
                   [&](ParameterStore::Declaration &entry)
                   {
                     const std::string &given = entry.value;
                     if (std::find(choices.begin(), choices.end(), given) == choices.end())
                     {
                       const std::string nearest = nearest_name(given, choices);
                       throw std::invalid_argument(
                           "'" + given + "' does not exist" +
                           (nearest.empty() ? "" : ". Did you mean '" + nearest + "'?"));
                     }
                     value = given;
                     entry.resolved = given;
                   });
}

void ParameterSection::add_input_file(const std::string &key,
                                      std::string &path,
                                      const std::string &text)
{
  declare_and_read(*store, *this, {names, key, path, "file", "", text, "", path}, anything, true,
                   "Check its name; it is relative to the file that names it",
                   [&](ParameterStore::Declaration &entry)
                   {
                     path = entry.value;
                     entry.resolved = "";
                     if (path.empty())
                       return;
                     path = find_file(entry.value, origin(key));
                     // A printed file may stand in another directory.
                     entry.value = std::filesystem::absolute(path).lexically_normal().string();
                     entry.resolved = std::filesystem::path(path).filename().string();
                     store->add_input_file(path);
                   });
}

void ParameterSection::renamed(const std::string &old_key, const std::string &new_key)
{
  const ParameterText::Section *const section = store->text.find(names);
  if (section != nullptr && section->entry(old_key) != nullptr)
    refuse(old_key, "this entry has a new name", "Write '" + new_key + "'");
}

bool ParameterSection::given(const std::string &key) const
{
  const ParameterText::Section *const section = store->text.find(names);
  const ParameterText::Entry *const entry = section == nullptr ? nullptr : section->entry(key);
  return entry != nullptr && !entry->value().empty();
}

void ParameterSection::require(const std::string &key) const
{
  if (!given(key) && !store->is_documentation)
    refuse("", "the entry '" + key + "' is missing", "Add 'set " + key + " = ...'");
}

Origin ParameterSection::origin(const std::string &key) const
{
  // The entry, or else its section, or else the nearest section around it that the user has, at
  // last the file.
  std::vector<std::string> path = names;
  if (const ParameterText::Section *const section = store->text.find(path))
    if (const ParameterText::Entry *const entry = section->entry(key))
      return entry->origin();
  while (store->text.find(path) == nullptr)
    path.pop_back();
  return store->text.find(path)->origin;
}

std::string ParameterSection::path() const
{
  return join_path(names);
}

std::string ParameterSection::name() const
{
  return names.empty() ? "" : names.back();
}

ParameterSection ParameterSection::subsection(const std::string &name)
{
  ParameterSection child = *this;
  child.names.push_back(name);
  store->declare_section(child.names);
  return child;
}

bool ParameterSection::has_subsection(const std::string &name) const
{
  const ParameterText::Section *const section = store->text.find(names);
  return section != nullptr && section->section(name) != nullptr;
}

std::vector<std::string> ParameterSection::subsections() const
{
  std::vector<std::string> children;
  if (const ParameterText::Section *const section = store->text.find(names))
    for (const ParameterText::Section &child : section->sections)
      children.push_back(child.name);
  return children;
}

std::vector<std::pair<std::string, std::string>>
ParameterSection::add_free_entries(const std::string &text)
{
  std::vector<std::pair<std::string, std::string>> entries;
  if (const ParameterText::Section *const section = store->text.find(names))
    for (const ParameterText::Entry &entry : section->entries)
    {
      std::string value;
      add(entry.key, value, text);
      entries.emplace_back(entry.key, value);
    }
  return entries;
}

void ParameterSection::refuse(const std::string &key,
                              const std::string &problem,
                              const std::string &remedy) const
{
  std::vector<std::string> full = names;
  if (!key.empty())
    full.push_back(key);
  throw InputError(origin(key), join_path(full), problem, remedy);
}
} // namespace Continua
