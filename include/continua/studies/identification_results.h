#ifndef continua_studies_identification_results_h
#define continua_studies_identification_results_h

#include <continua/inference/expected_errors.h>
#include <continua/inference/fit_result.h>
#include <continua/inference/model_bias.h>
#include <continua/inference/profile_likelihood.h>
#include <continua/studies/synthetic_experiments.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// Records that may be added to an experiment, and the errors with them.
// NOLINTNEXTLINE(bugprone-exception-escape): deal.II's matrix may throw when it is moved
struct DesignChoice
{
  std::vector<unsigned int> records; ///< numbers of expected records
  ExpectedErrors::Errors errors;
};

/// What an identification has found; what was not asked for is empty.
struct IdentificationResults
{
  std::string model;                 ///< by which
  std::vector<std::string> failures; ///< of steps behind the fit, and why
  std::vector<FitParameter> parameters;
  std::optional<FitResult> fit;
  std::vector<double> shifts; ///< by measured record: of its clock, at the estimates [s]
  std::vector<std::pair<unsigned int, Profile>> profiles; ///< by parameter
  std::string other_model;
  std::optional<ModelBias> bias;

  std::optional<ExpectedErrors::Errors> errors_of_file; ///< of the records that are no candidates
  /// Of what makes up these, if they are waves and material tests: "waves alone" and the like.
  std::vector<std::pair<std::string, ExpectedErrors::Errors>> errors_of_parts;
  std::vector<DesignChoice> choices; ///< best first
  std::optional<SyntheticExperiments::Outcome> synthetic;
};
} // namespace Continua

#endif
