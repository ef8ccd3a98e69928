#ifndef continua_signal_time_table_h
#define continua_signal_time_table_h

#include <continua/base/units.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * Measured values over time from a csv file. Header: names with units, "time [ms], pressure [mmHg]"; the first column is
 * time, the value is the only other column or the one called `column`. Separator comma, semicolon, tab or blanks; lines
 * that start with # are comments. Throws InputError with file, line, key and remedy for a missing file or header, an
 * unknown unit or one of the wrong dimension, a missing column, a row with a missing or malformed number, times that do
 * not increase, or fewer than two rows.
 */
class TimeTable
{
public:
  enum class Interpolation
  {
    linear,
    cubic ///< natural cubic spline, or Akima's if that overshoots less: state which
  };
  enum class After
  {
    hold,   ///< the last value
    repeat, ///< with the period last time - first time
    zero
  };
  TimeTable(const std::string &file,
            const Dimension &dimension,
            Interpolation interpolation,
            After after,
            double offset,
            const std::string &column = "");

  /// Value plus offset [SI]; before the first row the first value. After::zero means zero, without the offset.
  double operator()(double time) const;
  double first_time() const;
  double last_time() const;

private:
  std::vector<double> times;
  std::vector<double> values;
  std::vector<double> slopes; ///< of the cubic, at the rows
  Interpolation interpolation;
  After after;
};
} // namespace Continua

#endif
