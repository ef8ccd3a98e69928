#ifndef continua_studies_station_fit_model_h
#define continua_studies_station_fit_model_h

#include <continua/inference/fit_model.h>
#include <continua/studies/forward_model.h>
#include <continua/studies/material_test.h>
#include <continua/studies/sought_number.h>
#include <continua/studies/station_records.h>

#include <string>
#include <vector>

namespace Continua
{
/// Predicts records at stations by a forward model, from the numbers that are sought.
class StationFitModel : public FitModel
{
public:
  /// `probes`: the names of all probes with stations. `other_entries`: entries with their values,
  /// beside those of the numbers. `tests`: of materials, whose records are those behind the ones
  /// with a source. All must outlive it.
  StationFitModel(ForwardModel &model,
                  const std::vector<SoughtEntry> &sought,
                  const StationRecords &records,
                  const std::vector<std::string> &probes,
                  std::vector<std::pair<std::string, std::string>> other_entries = {},
                  const MaterialTestModel *tests = nullptr);

  std::vector<Prediction> predict(const std::vector<std::vector<double>> &sets) override;
  /// The entries of the file for these numbers.
  std::vector<std::pair<std::string, std::string>> settings(const std::vector<double> &set) const;
  /// The shift of a record's clock for these numbers, beside the times of the record [s].
  double shift_of(unsigned int record, const std::vector<double> &set) const;

private:
  ForwardModel &model;
  const std::vector<SoughtEntry> &sought;
  const StationRecords &records;
  std::vector<std::pair<std::string, std::string>> other_entries;
  const MaterialTestModel *tests;
  static constexpr unsigned int none = -1;
  std::vector<unsigned int> clocks;             ///< by probe: the number that is its shift
  std::vector<std::vector<double>> times;       ///< [s] by probe, of all of its records
  std::vector<std::vector<std::size_t>> places; ///< by record: of its times among these

  ForwardQuestion question(const std::vector<double> &set) const;
  Prediction prediction(const ForwardAnswer &answer) const;
};
} // namespace Continua

#endif
