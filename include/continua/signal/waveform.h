#ifndef continua_signal_waveform_h
#define continua_signal_waveform_h

#include <continua/base/parameter_section.h>
#include <continua/signal/expression.h>
#include <continua/signal/time_table.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * A value over time and space: by formula, or from a table over time. In a section, the entry KEY (expression) is used
 * with `Waveform = formula` (default); `Waveform = table` takes `Table`, `Column`, `Interpolation` (linear | cubic),
 * `Offset` and `After the table` (hold | repeat | zero). Giving both KEY and a table is an InputError; KEY then
 * is not declared.
 */
class Waveform
{
public:
  Waveform(double constant = 0.);

  /// Declares and reads. `required`: leaving the value out is an InputError.
  static Waveform read(ParameterSection &section,
                       const std::string &key,
                       const Dimension &dimension,
                       const std::string &text,
                       bool required);

  double operator()(const double *point, double time) const;
  bool depends_on_time() const;
  bool depends_on_space() const;
  bool is_zero() const;

private:
  Expression expression;
  std::shared_ptr<const TimeTable> table;
};
} // namespace Continua

#endif
