#ifndef continua_studies_identification_report_h
#define continua_studies_identification_report_h

#include <continua/base/output_directory.h>
#include <continua/base/quantity_names.h>
#include <continua/base/summary.h>
#include <continua/studies/identification_parameters.h>
#include <continua/studies/identification_results.h>
#include <continua/studies/sought_number.h>
#include <continua/studies/station_records.h>

#include <string>
#include <vector>

namespace Continua
{
/// What an identification says: lines for the log, quantities and tables.
class IdentificationReport
{
public:
  /// All must outlive it. `measured` and `expected`: the records that were fitted, and those of the
  /// design.
  IdentificationReport(const std::vector<SoughtEntry> &sought,
                       const StationRecords &measured,
                       const StationRecords &expected,
                       const IdentificationResults &results);

  std::vector<std::string> lines() const;
  /// What a reader must not overlook: directions that the data do not see, noise, failed runs.
  std::vector<std::string> warnings() const;
  /// Of each number NAME: `NAME: estimate`, `standard error`, `lower limit`, `upper limit`, `bias`,
  /// `bias over standard error`, `expected standard error`, `mean synthetic error`, `synthetic
  /// spread`, `synthetic coverage`; of the whole `misfit`, `evaluations`, `flat directions` ...
  void add_quantities(Summary &summary) const;
  static void name_quantities(const IdentificationParameters &parameters,
                              const StationRecords &expected,
                              QuantityNames &names);
  /// Writes identification.csv, correlation.csv, fit.csv, profiles.csv, expected-errors.csv,
  /// synthetic.csv, as far as there is something, and citation.bib.
  void write(const OutputDirectory &directory) const;

private:
  const std::vector<SoughtEntry> &sought;
  const StationRecords &measured, &expected;
  const IdentificationResults &results;

  void add_fit_lines(std::vector<std::string> &lines) const;
  void add_design_lines(std::vector<std::string> &lines) const;
  void add_synthetic_lines(std::vector<std::string> &lines) const;
  std::string numbers_table() const;
  std::string correlation_table() const;
  std::string fit_table() const;
  std::string profiles_table() const;
  std::string expected_errors_table() const;
  std::string synthetic_table() const;
  /// "stations 0.1 m: pressure; stations 0.3 m: pressure": the candidates of a choice.
  std::string added(const DesignChoice &choice) const;
};
} // namespace Continua

#endif
