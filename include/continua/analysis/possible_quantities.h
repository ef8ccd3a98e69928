#ifndef continua_analysis_possible_quantities_h
#define continua_analysis_possible_quantities_h

#include <continua/analysis/case.h>
#include <continua/base/quantity_names.h>

namespace Continua
{
/// What a run of this case can state in its summary; for a case whose probes and outlets are
/// checked.
template <int dim>
QuantityNames possible_quantities(const Case<dim> &input);
} // namespace Continua

#endif
