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
 * A value over time and space: by formula, or from a table over time. In a section, the entry KEY
 * (expression) is used with `Waveform = formula` (default); `Waveform = table` takes `Table`,
 * `Column`, `Interpolation` (linear | cubic), `Offset` and `After the table` (hold | repeat |
 * zero), see TimeTable. KEY is not declared then, and giving it as well is an InputError, as are
 * the entries of the table with a formula. A section holds one waveform, since these entries do not
 * have KEY in their names. Copies share the table.
 */
class Waveform
{
public:
  Waveform(double constant = 0.);
  explicit Waveform(const Expression &expression);

  /// Declares and reads KEY or a table of it. `required`: leaving both out is an InputError; else
  /// the default is 0.
  static Waveform read(ParameterSection &section,
                       const std::string &key,
                       const Dimension &dimension,
                       const std::string &text,
                       bool required);

  /// A vector of `n_components`: KEY with one expression a component, or a table of its size over
  /// time and `Direction`, the components' factors as functions of (x, y, z).
  static std::vector<Waveform> read_vector(ParameterSection &section,
                                           const std::string &key,
                                           unsigned int n_components,
                                           const Dimension &dimension,
                                           const std::string &text);

  /// The value in SI at a point with three coordinates [m] and a time [s].
  double operator()(const double *point, double time) const;
  /// A table depends on time, and counts as not zero, whatever its values are.
  bool depends_on_time() const;
  bool depends_on_space() const;
  bool is_zero() const;

private:
  Expression expression; ///< the value, or what the table's value is multiplied by
  std::shared_ptr<const TimeTable> table;
};
} // namespace Continua

#endif
