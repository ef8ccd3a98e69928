#ifndef continua_case_measured_waves_h
#define continua_case_measured_waves_h

#include <continua/base/parameter_section.h>
#include <continua/signal/time_table.h>

#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// The entries of a probe about what was measured at its stations.
struct MeasuredWavesEntries
{
  std::string file;            ///< empty: none
  std::vector<double> factors; ///< of the columns, one for all or one for each; none: 1
  double shift = 0.;           ///< [s], added to the times
  double period = 0.;          ///< [s] with which the measurement repeats itself; 0: it does not

  /// Declares and reads them. Throws InputError.
  void read(ParameterSection probe);
};

/**
 * A user's measurements at stations, from a csv file: `time [ms], 0.1 m: pressure [mmHg], 0.3 m:
 * flow rate [l/min]`. The first column is time, each other one is called after a station of the
 * probe and one of its fields. Throws InputError with file, line and remedy for a column that is
 * neither, a missing or wrong unit, times that do not increase and another number of factors than
 * columns.
 */
class MeasuredWaves
{
public:
  /// `positions` [m] and `fields` of the probe.
  MeasuredWaves(const MeasuredWavesEntries &entries,
                const ParameterSection &probe,
                const std::vector<double> &positions,
                const std::vector<std::string> &fields);

  /// What one column says: a field of a station, row by row.
  struct Record
  {
    std::size_t station, field;
    std::vector<double> times;  ///< [s], shifted
    std::vector<double> values; ///< [SI], with the factor
  };
  /// In the order of the columns.
  const std::vector<Record> &records() const { return rows; }

  /// By station, field and time [s], linear between the rows; NaN where nothing was measured.
  std::vector<std::vector<std::vector<double>>> histories(const std::vector<double> &times) const;

private:
  struct Column
  {
    std::size_t station, field;
    TimeTable values;
  };
  std::size_t n_stations, n_fields;
  std::vector<Column> columns;
  std::vector<Record> rows;
};

/// The dimension of a field of stations, by its name; throws std::out_of_range for another name.
const struct Dimension &dimension_of_station_field(const std::string &field);
} // namespace Continua

#endif
