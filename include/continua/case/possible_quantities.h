#ifndef continua_case_possible_quantities_h
#define continua_case_possible_quantities_h

#include <continua/base/quantity_names.h>
#include <continua/case/case.h>

namespace Continua
{
/// What a run of this case can state in its summary; for a case whose probes and outlets are
/// checked.
template <int dim>
QuantityNames possible_quantities(const Case<dim> &input);
} // namespace Continua

#endif
