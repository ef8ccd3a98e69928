#ifndef continua_base_numeric_form_h
#define continua_base_numeric_form_h

#include <continua/base/parameter_section.h>
#include <continua/base/units.h>

namespace Continua
{
/// What numbers an entry of a parameter file holds.
struct NumericForm
{
  bool is_list = false;    ///< several numbers, separated by commas
  bool is_integer = false; ///< whole numbers, without a unit
  Dimension dimension;
  Range range; ///< that each number has [SI]
};
} // namespace Continua

#endif
