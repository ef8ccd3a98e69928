#ifndef continua_studies_sought_number_h
#define continua_studies_sought_number_h

#include <continua/base/numeric_entry.h>
#include <continua/inference/fit_parameter.h>
#include <continua/studies/identification_parameters.h>

namespace Continua
{
/// A number that is sought, with its entry of the file.
struct SoughtEntry
{
  NumericEntry entry;
  FitParameter parameter; ///< called as the user calls it

  /// The probe whose measurements the number shifts in time; empty if it shifts none.
  std::string clock_of() const;
};

/// Finds the entry among those that are declared, and reads bounds, start and prior in its unit.
/// `section`: of the number. Throws InputError.
SoughtEntry
find_sought_entry(const ParameterFile &file, ParameterSection section, const SoughtNumber &number);
} // namespace Continua

#endif
