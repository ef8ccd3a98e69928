#include <continua/studies/swept_axis.h>

#include <continua/base/input_error.h>
#include <continua/base/units.h>

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
  if (entry.is_whole())
    return "Give whole numbers that the entry accepts";
  const std::string units = usual_units(entry.dimension());
  return "Give numbers that the entry accepts" +
         (units.empty() ? std::string() : ", with a unit like " + units);
}
} // namespace

SweptAxis::SweptAxis(const ParameterFile &file,
                     const ParameterSection &section,
                     const std::string &path,
                     const std::vector<std::string> &values)
    : path(path), values(values)
{
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
  return entry ? shortest_number(numbers[number]) : values[number];
}
} // namespace Continua
