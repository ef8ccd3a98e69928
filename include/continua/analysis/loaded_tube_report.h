#ifndef continua_analysis_loaded_tube_report_h
#define continua_analysis_loaded_tube_report_h

#include <continua/analysis/run.h>

namespace Continua
{
/**
 * The state of the tube's inlet about which linear wave theory has its waves, with Deformation =
 * finite: `inner radius under the mean pressure` and `outer radius ...` [m], `distensibility`
 * [1/Pa] and `speed of long waves` [m/s] in the summary, and the same over the pressure in
 * loaded-tube.csv.
 */
template <int dim>
class LoadedTubeReport
{
public:
  static void name_quantities(const Case<dim> &input, QuantityNames &names);
  /// Nothing with small deformation.
  static void add(Run<dim> &run);
};
} // namespace Continua

#endif
