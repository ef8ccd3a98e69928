#ifndef continua_signal_time_table_h
#define continua_signal_time_table_h

#include <continua/base/csv_table.h>
#include <continua/base/interpolant.h>

#include <string>

namespace Continua
{
/// A sentence for messages about units: what the entry `key`, a factor of the values, can do.
std::string scaling_advice(const std::string &key);

/**
 * Measured values over time from a csv file (see CsvTable). Header: names with units, "time [ms],
 * pressure [mmHg]"; the first column is time.
 *
 * With the rows (t_i, v_i) of the file, the table has the value factor v_i + offset at t_i + shift.
 *
 * Throws InputError with file, line, column and remedy for whatever CsvTable refuses, times that do
 * not increase, fewer than two rows, and rows that span more than the period.
 */
class TimeTable
{
public:
  using Interpolation = Interpolant::Kind;
  /// What holds before the first row or after the last one.
  enum class Outside
  {
    hold,   ///< the value of that row
    repeat, ///< the table again
    zero,   ///< without the offset
    nothing ///< NaN
  };
  /// What is made of the rows.
  struct Reading
  {
    Interpolation interpolation = Interpolation::linear;
    Outside before = Outside::hold, after = Outside::hold;
    double factor = 1.;
    double offset = 0.; ///< [SI]
    double shift = 0.;  ///< [s]
    /// [s] with which the table repeats itself; 0: last time - first time. A longer one closes the
    /// table by its first row, a period later. Where the last value of a period is not the first
    /// one, the value jumps there.
    double period = 0.;
    std::string period_key = "Table period"; ///< its entry, for messages
    std::string factor_key = "Table factor"; ///< the entry of `factor`, for messages
  };
  /// The value is the only column beside the time, or the one called `column`.
  TimeTable(const std::string &file,
            const Dimension &dimension,
            const Reading &reading,
            const std::string &column = "");
  /// The value is the column with that number.
  TimeTable(const CsvTable &table,
            std::size_t column,
            const Dimension &dimension,
            const Reading &reading);

  double operator()(double time) const;                                 ///< [SI] at a time [s]
  double first_time() const { return begin; }                           ///< [s] of the first row
  double last_time() const { return end; }                              ///< [s] of the last row
  bool is_repeated() const { return reading.after == Outside::repeat; } ///< after its last row
  double period() const { return length; } ///< [s] with which it would be repeated
  std::string period_text() const;         ///< the period with its unit, for messages
  /// Of the difference between the largest and the smallest value, by how much the value jumps
  /// after a period.
  double jump() const { return jump_of_period; }
  double range() const
  {
    return range_of_values;
  } ///< largest minus smallest value of the rows [SI]

private:
  Reading reading;
  double begin = 0., end = 0., length = 0.; ///< [s]
  double jump_of_period = 0., range_of_values = 0.;
  Interpolant values; ///< over time, with factor and offset, to the end of a period
};
} // namespace Continua

#endif
