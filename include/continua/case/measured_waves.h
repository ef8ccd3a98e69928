#ifndef continua_case_measured_waves_h
#define continua_case_measured_waves_h

#include <continua/base/interpolant.h>
#include <continua/base/parameter_section.h>

#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * A user's measurements at stations, from a csv file: `time [ms], 0.1 m: pressure [mmHg], 0.3 m:
 * flow rate [l/min]`. The first column is time, each other one is called after a station of the
 * probe and one of its fields. Throws InputError with file, line and remedy for a column that is
 * neither, a missing or wrong unit and times that do not increase.
 */
class MeasuredWaves
{
public:
  MeasuredWaves(const std::string &file,
                const std::vector<double> &positions,
                const std::vector<std::string> &fields);

  /// Declares and reads the entry `Measured` of a probe with stations; empty if there is no table.
  static std::string read_file(ParameterSection probe);

  /// By station, field and time [s], linear between the rows; NaN where nothing was measured.
  std::vector<std::vector<std::vector<double>>> histories(const std::vector<double> &times) const;

private:
  struct Column
  {
    std::size_t station, field;
    Interpolant values;
  };
  std::size_t n_stations, n_fields;
  std::vector<Column> columns;
};

/// The dimension of a field of stations, by its name; throws std::out_of_range for another name.
const struct Dimension &dimension_of_station_field(const std::string &field);
} // namespace Continua

#endif
