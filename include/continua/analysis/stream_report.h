#ifndef continua_analysis_stream_report_h
#define continua_analysis_stream_report_h

#include <continua/analysis/run.h>

namespace Continua
{
/**
 * What theory says of waves with and against a stream (Wave theory/Mean flow), for a mesh that
 * stays and for a moving wall: `long-wave speed with the stream on the mesh that stays` and so on
 * [m/s], and at a frequency `speed with the stream on the mesh that stays` [m/s] and `attenuation
 * ...` [1/m]. A run with stations that a pulse passes downstream, and others that one passes
 * upstream, has `wave speed with the stream less that against it` as well, by phase.
 */
template <int dim>
class StreamReport
{
public:
  /// Whether theory covers the stream, if there is one. Throws InputError.
  static void check(const Case<dim> &input, ParameterSection root);
  static void name_quantities(const Case<dim> &input, QuantityNames &names);
  /// Logs the speeds and adds them to the summary; nothing without a stream. Throws RunError.
  static void add(Run<dim> &run);
  /// After the wave speeds at the stations are in the summary.
  static void add_difference(Run<dim> &run);
};
} // namespace Continua

#endif
