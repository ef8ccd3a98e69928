#ifndef continua_signal_time_table_h
#define continua_signal_time_table_h

#include <continua/base/interpolant.h>
#include <continua/base/units.h>

#include <string>

namespace Continua
{
/**
 * Measured values over time from a csv file (see CsvTable). Header: names with units, "time [ms],
 * pressure [mmHg]"; the first column is time, the value is the only other column or the one called
 * `column`.
 *
 * Throws InputError with file, line, column and remedy for whatever CsvTable refuses, a missing
 * column, times that do not increase, or fewer than two rows.
 */
class TimeTable
{
public:
  using Interpolation = Interpolant::Kind;
  enum class After
  {
    hold,   ///< the last value
    repeat, ///< with the period last time - first time; where the last value is not the first one,
            ///< the value jumps there
    zero
  };
  TimeTable(const std::string &file,
            const Dimension &dimension,
            Interpolation interpolation,
            After after,
            double offset,
            const std::string &column = "");

  /// Value plus offset [SI] at `time` [s]; before the first row the first value. After::zero means
  /// zero, without the offset.
  double operator()(double time) const;
  double first_time() const; ///< [s]
  double last_time() const;  ///< [s]

private:
  Interpolant values; ///< over time, with the offset
  After after;
};
} // namespace Continua

#endif
