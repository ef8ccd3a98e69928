#ifndef continua_signal_time_table_h
#define continua_signal_time_table_h

#include <continua/base/units.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * Measured values over time from a csv file. Header: names with units, "time [ms], pressure
 * [mmHg]"; the first column is time, the value is the only other column or the one called `column`.
 * Separator: the first of semicolon, comma, tab and blanks that the header has; blanks around a
 * cell, a byte order mark and Windows line ends do not matter; lines that start with # and empty
 * lines are left out. The decimal separator is a point.
 *
 * Throws InputError with file, line, column and remedy for a missing file or header, a unit that is
 * missing (unless the value has no dimension), unknown or of the wrong dimension, a missing column,
 * a row with another number of cells than the header or with a missing or malformed number in the
 * two columns, times that do not increase, or fewer than two rows.
 */
class TimeTable
{
public:
  enum class Interpolation
  {
    linear,
    /// Piecewise cubic Hermite with the slopes of Fritsch and Butland (SIAM J. Sci. Stat. Comput.
    /// 5, 1984): once continuously differentiable, between two rows never outside their values, so
    /// that it neither overshoots nor rings; exact for a straight line, second-order accurate next
    /// to an extremum and third-order elsewhere.
    cubic
  };
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
  std::vector<double> times;
  std::vector<double> values; ///< with the offset
  std::vector<double> slopes; ///< of the cubic, at the rows
  Interpolation interpolation;
  After after;
};
} // namespace Continua

#endif
