#ifndef continua_base_unit_scale_h
#define continua_base_unit_scale_h

#include <continua/base/units.h>

#include <string>

namespace Continua
{
/// The number nearest to `number` times a power of ten, by way of its shortest decimal text: 43 and
/// -3 give 0.043, where a product would give 0.043000000000000003.
double times_power_of_ten(double number, int power);

/// A unit over that of SI: `factor` times a power of ten.
struct UnitScale
{
  double factor = 1.; ///< 1 where the power of ten says all
  int power_of_ten = 0;

  /// A number of this unit in SI. 43 mm and 0.043 m are one number.
  double in_si(double number) const;
};

/// Sets the unit's dimension. Throws std::invalid_argument if it is unknown.
UnitScale unit_scale(const std::string &unit, Dimension &dimension);

/// "0.043 m": how names of quantities, columns and messages write a position, a time or a
/// frequency. Two values have two names.
std::string named_value(double value, const std::string &unit);

/// The name with the position, time or frequency at its end written as named_value() does:
/// "stations 43 mm" and "stations 4.3 cm: pressure" become "stations 0.043 m" and
/// "stations 0.043 m: pressure". Any other name stays.
std::string with_value_in_si(const std::string &name);
} // namespace Continua

#endif
