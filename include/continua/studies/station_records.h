#ifndef continua_studies_station_records_h
#define continua_studies_station_records_h

#include <continua/case/case.h>
#include <continua/inference/data_record.h>
#include <continua/studies/identification_parameters.h>
#include <continua/studies/sought_number.h>

#include <string>
#include <vector>

namespace Continua
{
/// Which station and field a record is of.
struct RecordSource
{
  unsigned int probe;   ///< its place among the probes with stations
  unsigned int station; ///< its place in the probe
  unsigned int field;   ///< its place in the probe
  double position;      ///< of the station [m]
  std::string probe_name, field_name;
};

/// Records at the stations of a file's probes, measured ones or those of an experiment that is to
/// be made. Their times are those of the run without a shift of a clock that is sought.
struct StationRecords
{
  std::vector<DataRecord> records;
  std::vector<RecordSource> sources; ///< of each; records behind these are of material tests
  unsigned int n_left_out = 0;       ///< rows outside the time of the run
  std::vector<std::string> notes;    ///< what a user should know of them

  /// Those that were measured, with the noise that the file gives: what it does not give is
  /// unknown. `before_start`: rows before t = 0 count, since the body is at rest there. Throws
  /// InputError.
  template <int dim>
  static StationRecords measured(const Case<dim> &input,
                                 const IdentificationParameters &parameters,
                                 const std::vector<SoughtEntry> &sought,
                                 ParameterSection section,
                                 bool before_start);
  /// All that the probes can record, with the noise that is expected. Throws InputError.
  template <int dim>
  static StationRecords expected(const Case<dim> &input,
                                 const IdentificationParameters &parameters,
                                 ParameterSection section);
  std::size_t n_values() const;
};

/// "stations 0.1 m: pressure".
std::string record_name(const std::string &probe, double position, const std::string &field);
} // namespace Continua

#endif
