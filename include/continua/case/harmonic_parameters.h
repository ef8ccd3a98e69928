#ifndef continua_case_harmonic_parameters_h
#define continua_case_harmonic_parameters_h

#include <continua/base/parameter_section.h>
#include <continua/case/sensitivity_parameters.h>
#include <continua/continuum/problem.h>

#include <string>
#include <vector>

namespace Continua
{
/// The section Harmonic: at which frequencies a body is shaken, and by what.
struct HarmonicParameters
{
  std::vector<double> listed;            ///< [Hz], as written
  std::vector<double> frequencies;       ///< [Hz], those of the list and of the range, increasing
  std::vector<double> field_frequencies; ///< [Hz], whose fields are written
  std::string unit_load; ///< the name of a boundary that alone has a load, of size one; or empty
  /// Of the responses between the frequencies of the range, over the largest one [1]; 0: the range
  /// is not refined.
  double response_tolerance = 0.;
  unsigned int most_frequencies = 200; ///< of a range that is refined
  double lowest = 0., highest = 0.;    ///< of the range [Hz]
  bool is_logarithmic = false;         ///< the range
  unsigned int n_waves = 1;            ///< that are fitted to stations along a tube
  std::vector<double> phases;          ///< of the loads of the boundaries, by condition [rad]
  double body_force_phase = 0.;        ///< [rad]
  SensitivityParameters sensitivities;
  bool estimates_errors = false; ///< of the responses, by elements of the next degree

  /// Throws InputError.
  void read(ParameterSection section);
  /// The entries Phase, of boundaries and of the body force. Throws InputError.
  void read_phases(ParameterSection root, const std::vector<BoundaryCondition> &conditions);
  /// Declares and reads one of them [rad].
  static double read_phase(ParameterSection section);

private:
  void add_range(ParameterSection section);
};
} // namespace Continua

#endif
