#include <continua/base/angle_entry.h>

#include <continua/base/units.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <stdexcept>

namespace Continua
{
void add_angle(ParameterSection section,
               const std::string &key,
               double &value,
               const std::string &text)
{
  constexpr double degree = dealii::numbers::PI / 180.;
  std::string entry = value == 0. ? "0" : shortest_number(value / degree) + " deg";
  section.add(key, entry, text + " [deg or rad]");
  const auto ends_with = [&entry](const std::string &unit)
  {
    return entry.size() >= unit.size() &&
           entry.compare(entry.size() - unit.size(), unit.size(), unit) == 0;
  };
  double given = 0.;
  try
  {
    given = parse_quantity(entry, Dimensions::none);
  }
  catch (const std::invalid_argument &error)
  {
    section.refuse(key, error.what(), "Give an angle with its unit, such as 30 deg");
  }
  if (given != 0. && !ends_with("deg") && !ends_with("rad"))
    section.refuse(key, "the angle '" + entry + "' has no unit",
                   "Write 'deg' or 'rad' behind the number");
  if (!std::isfinite(given))
    section.refuse(key, "the angle is not finite", "Give an angle such as 30 deg");
  value = given;
}
} // namespace Continua
