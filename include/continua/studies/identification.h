#ifndef continua_studies_identification_h
#define continua_studies_identification_h

#include <continua/analysis/analysis_table.h>
#include <continua/studies/forward_model.h>
#include <continua/studies/identification_parameters.h>
#include <continua/studies/identification_results.h>
#include <continua/studies/simulation_model.h>
#include <continua/studies/sought_number.h>
#include <continua/studies/station_records.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
class StationFitModel;

/**
 * `Analysis = identification`: finds numbers of the file from what was measured at the stations of
 * its probes, with errors; or, before there are data, the errors that an experiment would give. The
 * model is linear wave theory or the simulation itself.
 */
class Identification : public Analysis
{
public:
  /// Reads the case, the numbers and the records. Throws InputError.
  explicit Identification(const AnalysisInput &input);

  bool has_own_table() const override { return true; }
  bool has_checkpoints() const override { return true; }
  void check_restart(const OutputDirectory &directory) const override;
  std::vector<std::string> outline() const override;

private:
  const AnalysisTable &analyses;
  IdentificationParameters parameters;
  unsigned int n_dimensions;
  bool by_theory = true;
  std::vector<std::string> probes;   ///< with stations
  std::vector<ProbeColumns> columns; ///< of these
  std::vector<SoughtEntry> sought;
  StationRecords measured, expected;
  std::unique_ptr<MaterialTestModel> tests;          ///< that were made
  std::vector<std::vector<unsigned int>> candidates; ///< records of `expected` that may be added
  std::vector<unsigned int> always;                  ///< records of `expected` that are there
  QuantityNames quantities;                          ///< that it can state

  ParameterSection section() const { return file.root().subsection("Identification"); }
  template <int dim>
  void read_case();
  void choose_model();
  void read_sought();
  void read_candidates();
  void read_tests();
  /// The probe or the material test of an expected record.
  std::string origin_of(unsigned int record) const;
  void check_numbers() const;
  void check_other_model() const;
  template <int dim>
  void read_other_case() const;
  std::string identity() const;
  /// `runs`: what the folders of a simulation are called.
  std::unique_ptr<ForwardModel> make_model(bool theory,
                                           const OutputDirectory &directory,
                                           const std::string &runs,
                                           Log &log) const;
  /// What a run in time of the file may need [B].
  double memory_of_simulation() const;
  std::vector<FitParameter> fit_parameters() const;
  FitOptions fit_options() const;

  void compute(const OutputDirectory &directory, Log &log, Summary &summary) override;
  void fit(StationFitModel &model,
           const OutputDirectory &directory,
           Log &log,
           IdentificationResults &results);
  /// Synthetic experiments with the estimates as the truth.
  void repeat_fit(StationFitModel &model,
                  const FitOptions &options,
                  IdentificationResults &results) const;
  void find_bias(const OutputDirectory &directory, Log &log, IdentificationResults &results) const;
  void design(ForwardModel &model, Log &log, IdentificationResults &results) const;
  /// What waves and material tests give each, where the file's records have both.
  void find_errors_of_parts(const ExpectedErrors &errors, IdentificationResults &results) const;
  /// Synthetic experiments of the file's records, with the best choice.
  void try_design(ForwardModel &model, IdentificationResults &results) const;
  MaterialTestModel model_of_tests(const std::vector<MaterialTest> &chosen) const;
  /// Where the design stands: at the estimates, or at the starts.
  std::vector<FitParameter> parameters_of_design(const IdentificationResults &results) const;
  void finish(const OutputDirectory &directory,
              Log &log,
              Summary &summary,
              const IdentificationResults &results) const;
};
} // namespace Continua

#endif
