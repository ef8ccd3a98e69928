#ifndef continua_studies_identification_parameters_h
#define continua_studies_identification_parameters_h

#include <continua/base/expected_value.h>
#include <continua/base/parameter_section.h>
#include <continua/inference/fit_options.h>
#include <continua/inference/fit_parameter.h>
#include <continua/studies/material_test.h>

#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// A number that is to be found, as the user writes it: the quantities are texts until its entry is
/// known.
struct SoughtNumber
{
  std::string name;  ///< as the user calls it
  std::string entry; ///< path of a NumericEntry
  std::string lower, upper, start, prior_mean, prior_standard_deviation;
  FitParameter::Scale scale = FitParameter::Scale::linear;

  /// Declares and reads a child of the section Parameters. Throws InputError.
  void read(ParameterSection section);
};

/// How the noise of records is known.
struct NoiseEntries
{
  /// By a field, "pressure", or one record, "stations 0.1 m: pressure": a quantity or "from rest".
  std::vector<std::pair<std::string, std::string>> deviations;
};

/// Which model predicts what is measured.
enum class PredictingModel
{
  automatic, ///< theory where it covers the case
  theory,
  simulation
};

/// What else the bias is told of.
enum class OtherModel
{
  none,
  theory,
  simulation
};

/// The section Identification.
struct IdentificationParameters
{
  PredictingModel model = PredictingModel::automatic;
  std::vector<SoughtNumber> sought;
  std::vector<MaterialTest> tests;
  NoiseEntries noise;
  NoiseEntries expected_noise;
  double rest_until = 0.;       ///< [s] in the time of the tables: rows before it are at rest
  double correlation_time = 0.; ///< [s] of noise whose deviation is given; 0: white
  CorrelatedNoise correlated_noise = CorrelatedNoise::autoregressive;
  OrderCriterion order_criterion = OrderCriterion::corrected_akaike;
  double confidence = 0.95;                  ///< [1]
  double tolerance = 1e-3;                   ///< [1] standard errors
  unsigned int largest_n_evaluations = 2000; ///< [1]
  unsigned int n_starts = 1;                 ///< [1]
  double difference_step = 1e-3;             ///< [1]
  bool profiles = false;
  OtherModel other_model = OtherModel::none;
  /// "Section/Key" and value, of the other model.
  std::vector<std::pair<std::string, std::string>> other_entries;
  unsigned int n_parallel = 0; ///< [1]; 0: as many as there are cores

  double sampling_interval = 0.;         ///< [s] of records without data; 0: the time step
  std::vector<std::string> candidates;   ///< probes and material tests whose records may be added
  unsigned int n_added = 1;              ///< [1] of them
  std::string criterion = "determinant"; ///< or the name of a sought number

  unsigned int n_experiments = 0; ///< [1] synthetic ones
  unsigned int seed = 1;          ///< [1]
  bool noise_is_known = true;     ///< to the fits of synthetic experiments of a design
  std::vector<ExpectedValue> expected;

  /// Declares and reads; throws InputError.
  void read(ParameterSection root);
  /// The rules across entries, which hold for the analysis itself. Throws InputError.
  void check(ParameterSection root) const;
  bool is_design() const { return !expected_noise.deviations.empty(); }
};
} // namespace Continua

#endif
