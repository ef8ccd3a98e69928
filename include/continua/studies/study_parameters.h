#ifndef continua_studies_study_parameters_h
#define continua_studies_study_parameters_h

#include <continua/base/expected_value.h>

#include <string>
#include <vector>

namespace Continua
{
/// What the sections of all studies have.
struct StudyParameters
{
  std::string analysis = "automatic";  ///< of the runs; the analysis itself after read()
  std::vector<std::string> quantities; ///< "PROBE: QUANTITY" or "QUANTITY"; empty: all
  unsigned int n_parallel = 1;         ///< runs at a time
  std::vector<ExpectedValue> expected;
};
} // namespace Continua

#endif
