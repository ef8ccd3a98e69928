#ifndef continua_case_periodic_state_parameters_h
#define continua_case_periodic_state_parameters_h

#include <continua/base/parameter_section.h>

#include <cstddef>
#include <string>
#include <vector>

namespace Continua
{
/// The section Periodic state: a run of several beats, which are compared one with the next.
struct PeriodicStateParameters
{
  bool is_on = false;              ///< whether the file has the section
  double period = 0.;              ///< of a beat [s]; 0: not given
  std::vector<std::string> probes; ///< that are compared: "PROBE" or "PROBE: FIELD"
  double tolerance = 0.01;         ///< of their differences [1]
  bool stops = true;               ///< whether the run ends when the beats have settled
  /// The first beat, counted from 0, from which on all loads repeat themselves.
  std::size_t first_of_loads = 0;

  /// Declares and reads; throws InputError.
  void read(ParameterSection section);
};
} // namespace Continua

#endif
