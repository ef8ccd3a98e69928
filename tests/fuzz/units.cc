// Quantities with units: refused with std::invalid_argument, or a finite number that has the same
// value in its SI unit.

#include <continua/base/units.h>

#include "input_file.h"

#include <cmath>
#include <stdexcept>

using namespace Continua;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  if (size == 0)
    return 0;
  // The first byte chooses the dimension.
  constexpr Dimension dimensions[] = {
      Dimensions::none,      Dimensions::length,   Dimensions::time,
      Dimensions::pressure,  Dimensions::density,  Dimensions::viscosity,
      Dimensions::flow_rate, Dimensions::velocity, Dimensions::frequency};
  const Dimension &dimension = dimensions[data[0] % (sizeof(dimensions) / sizeof(*dimensions))];
  const std::string text(reinterpret_cast<const char *>(data) + 1, size - 1);
  try
  {
    Dimension found;
    const double factor = unit_factor(text, found);
    Fuzz::require(!(factor < 0.) && !std::isnan(factor), "a unit has the factor of no unit");
  }
  catch (const std::invalid_argument &)
  {
  }
  double value = 0.;
  try
  {
    value = parse_quantity(text, dimension);
  }
  catch (const std::invalid_argument &)
  {
    return 0;
  }
  Fuzz::require(std::isfinite(value), "a quantity is not finite");
  const std::string unit = dimension.unit();
  const std::string again = shortest_number(value) + (unit == "1" ? "" : " " + unit);
  Fuzz::require(parse_quantity(again, dimension) == value,
                "'" + again + "' is read as something else");
  return 0;
}
