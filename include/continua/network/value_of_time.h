#ifndef continua_network_value_of_time_h
#define continua_network_value_of_time_h

#include <continua/base/parameter_section.h>

#include <functional>
#include <string>

namespace Continua
{
/// Declares and reads a required value over time [s] alone: a formula, a table or a pulse. Throws
/// InputError.
struct ValueOfTime
{
  std::function<double(double)> value;
  double period = 0.; ///< of a table that is repeated [s]; 0: none

  static ValueOfTime read(ParameterSection &section,
                          const std::string &key,
                          const Dimension &dimension,
                          const std::string &text);
};
} // namespace Continua

#endif
