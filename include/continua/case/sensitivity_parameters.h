#ifndef continua_case_sensitivity_parameters_h
#define continua_case_sensitivity_parameters_h

#include <continua/base/difference_formula.h>
#include <continua/base/numeric_entry.h>
#include <continua/base/parameter_file.h>
#include <continua/base/parameter_section.h>

#include <string>
#include <vector>

namespace Continua
{
/// The section Harmonic/Sensitivities: by which entries of the file responses are differentiated.
struct SensitivityParameters
{
  bool is_on = false;
  std::vector<std::string> entries; ///< paths, or "all"
  std::vector<std::string> probes;  ///< "PROBE" or "PROBE: FIELD"; empty: all

  /// Throws InputError.
  void read(ParameterSection section);
};

/// An entry by which a response is differentiated.
struct SensitivityEntry
{
  NumericEntry entry;
  DifferenceFormula formula;

  /// In materials, boundaries and the body force, when all of them are declared. Throws InputError.
  static std::vector<SensitivityEntry> find(ParameterFile &file,
                                            const SensitivityParameters &parameters);
};
} // namespace Continua

#endif
