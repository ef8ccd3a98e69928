#include <continua/studies/swept_axis.h>

#include <continua/base/input_error.h>
#include <continua/base/quoted_name.h>
#include <continua/base/units.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace Continua
{
namespace
{
/// A place in a list, "Shear moduli 2", is never an entry by itself.
bool ends_with_a_number(const std::string &path)
{
  return !path.empty() && path.back() >= '0' && path.back() <= '9';
}

std::string refusal(const std::string &path, const std::string &value)
{
  return "'" + path + "' does not accept " + value;
}

std::string remedy_of(const NumericEntry &entry)
{
  if (entry.is_integer())
    return "Give whole numbers that the entry accepts";
  const std::string units = usual_units(entry.dimension());
  return "Give numbers that the entry accepts" +
         (units.empty() ? std::string() : ", with a unit like " + units);
}
bool names_an_input_file(const ParameterFile &file, const std::string &path)
{
  std::stringstream text;
  file.print(text, ParameterFile::Style::json);
  const nlohmann::json entries = nlohmann::json::parse(text);
  return std::any_of(entries.begin(), entries.end(),
                     [&path](const nlohmann::json &entry)
                     { return entry.at("path") == path && entry.at("values") == "file"; });
}

/// The run gets the file by its command line, where it would be relative to the working directory.
std::string whole_path(const std::string &value, const std::string &naming_file)
{
  namespace filesystem = std::filesystem;
  const filesystem::path named =
      filesystem::path(naming_file).parent_path() / without_quotes(value);
  return quoted_name(filesystem::absolute(named).lexically_normal().string(), "#");
}
} // namespace

SweptAxis::SweptAxis(const ParameterFile &file,
                     const ParameterSection &section,
                     const SweepParameters::Axis &axis)
    : path(axis.path), values(axis.values), texts(axis.values)
{
  if (axis.naming_file != ParameterText::command_line && names_an_input_file(file, path))
    for (std::string &text : texts)
      text = whole_path(text, axis.naming_file);
  try
  {
    entry.emplace(file, path, section, path);
  }
  catch (const InputError &)
  {
    if (ends_with_a_number(path))
      throw;
    return;
  }
  // "X = 1" may also be "X = 1, 2": a list as a whole.
  if (entry->is_in_list() && entry->path() != path &&
      std::any_of(values.begin(), values.end(),
                  [](const std::string &value)
                  { return find_unquoted(value, ",") != std::string::npos; }))
  {
    entry.reset();
    return;
  }
  for (const std::string &value : values)
    try
    {
      numbers.push_back(parse_quantity(value, entry->dimension()));
      // What stands alone is refused by the entry itself, with its range.
      if (entry->is_in_list() && !entry->accepts(numbers.back()))
        throw std::invalid_argument(refusal(path, value));
    }
    catch (const std::invalid_argument &error)
    {
      section.refuse(path, error.what(), remedy_of(*entry));
    }
}

std::string SweptAxis::in_table(const std::size_t number) const
{
  return entry ? shortest_number(numbers[number]) : without_quotes(values[number]);
}
} // namespace Continua
