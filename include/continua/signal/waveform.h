#ifndef continua_signal_waveform_h
#define continua_signal_waveform_h

#include <continua/base/parameter_section.h>
#include <continua/signal/expression.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
class TimeTable;

/// Stands for a time [s] and asks for the mean over the period of Waveform::set_period().
constexpr double mean_over_period = -std::numeric_limits<double>::infinity();

/**
 * A value over time and space. In a section, `Waveform` says where it comes from:
 *
 * formula (default): the entry KEY, an expression of x, y, z, t.
 * table: `Table`, `Column`, `Interpolation` (linear | cubic), `Table factor`, `Offset`, `Table
 * shift`, `Before the table` and `After the table` (hold | repeat | zero) and `Table period`, see
 * TimeTable. sine squared pulse: `Amplitude` A, `Duration` T and `Start` t0
 * give A sin^2(pi (t - t0)/T) from t0 to t0 + T and 0 before and after, a pulse with a continuous
 * first derivative. gaussian pulse: `Amplitude` A, `Time of the peak` t0 and `Width` s give A
 * exp(-((t - t0)/s)^2) for all times.
 *
 * With any of them `Ramp` T (default 0: none) multiplies the value by sin^2(pi t/(2 T)) until T, so
 * that it starts from zero and without a kink. KEY is declared with a formula only; giving it
 * otherwise, or an entry of another waveform, is an InputError. These entries do not have KEY in
 * their names: further waveforms of a section have a prefix, "Tangential table" for "Table". Copies
 * share what they have from a table or pulse.
 */
class Waveform
{
public:
  Waveform(double constant = 0.);
  explicit Waveform(const Expression &expression);

  /// Declares and reads KEY or what stands for it. `required`: leaving both out is an InputError;
  /// else the default is 0.
  static Waveform read(ParameterSection &section,
                       const std::string &key,
                       const Dimension &dimension,
                       const std::string &text,
                       bool required);

  /// A vector of `n_components`: KEY with one expression a component; or a table or pulse of its
  /// size over time and `Direction`, the components' factors as functions of (x, y, z); or a table
  /// with one of its `Columns` for each component. All but KEY have the `prefix`.
  static std::vector<Waveform> read_vector(ParameterSection &section,
                                           const std::string &key,
                                           unsigned int n_components,
                                           const Dimension &dimension,
                                           const std::string &text,
                                           bool required = true,
                                           const std::string &prefix = "");

  /// The value in SI at a point with three coordinates [m] and a time [s], or the mean over time.
  double operator()(const double *point, double time) const;
  /// Gives `mean_over_period` its meaning: the mean, without the ramp, over the period [s] that
  /// ends at `end` [s]. Until then it means the value of a waveform that does not depend on time.
  void set_period(double period, double end);
  /// The period [s] of a table that is repeated after its end; else 0.
  double table_period() const;
  /// The value at t = 0: where it is not zero, a body at rest meets it as a jump.
  double initial_value(const double *point) const { return (*this)(point, 0.); }
  /// A table or pulse depends on time, and counts as not zero, whatever its values are.
  bool depends_on_time() const;
  bool depends_on_space() const;
  bool is_zero() const;

  /// Whether it is a table, without a ramp, whose value at t = 0 is more than a twentieth of the
  /// range of its rows: one of absolute values, or cut out of a record.
  bool table_begins_with_jump() const;

  /// A sentence about a table.
  struct Remark
  {
    std::string text;
    bool is_warning;
  };
  /// About a run to `end_time` [s]: the period of a table that is repeated; and, as warnings, a
  /// table that begins late, ends early or is repeated with a jump, without a word of the user
  /// about it.
  std::vector<Remark> table_remarks(double end_time) const;
  /// The remarks of several waveforms, each once and with `owner` before it.
  static std::vector<Remark> table_remarks(const std::vector<const Waveform *> &waveforms,
                                           const std::string &owner,
                                           double end_time);

  /// What remarks call a table.
  struct TableNames
  {
    std::string file; ///< without its folder
    /// The names of those entries that the user has not given.
    std::string before_key, after_key, period_key;
  };

private:
  struct TimeFunction
  {
    std::function<double(double)> value;
    std::shared_ptr<const TimeTable> table; ///< or null
    TableNames names;
  };

  /// The value, or what the function of time is multiplied by.
  Expression expression;
  std::shared_ptr<const TimeFunction> of_time; ///< a table or pulse, or null
  double ramp = 0.;                            ///< [s]
  // For the mean over time:
  double period = 0., period_begin = 0.; ///< [s]
  double mean_of_time = 1.; ///< of `of_time`, or of all if the expression depends on time alone

  /// Without the ramp.
  double value(const double *point, double time) const;
  double mean(const double *point) const;

  static std::shared_ptr<const TimeFunction> read_pulse(ParameterSection &section,
                                                        const std::string &prefix,
                                                        const std::string &key,
                                                        const Dimension &dimension,
                                                        const std::string &kind);
  static std::shared_ptr<const TimeFunction>
  function_of_table(const std::shared_ptr<const TimeTable> &table, const TableNames &names);
};
} // namespace Continua

#endif
