#ifndef continua_boundary_outlet_entries_h
#define continua_boundary_outlet_entries_h

#include <continua/base/parameter_section.h>
#include <continua/boundary/boundary_condition.h>

namespace Continua
{
// The entries of boundaries through which a liquid leaves into what is behind them. `dim` has no
// effect. Each throws InputError.

void read_resistance(ParameterSection &section, BoundaryCondition &condition, unsigned int dim);
void read_windkessel(ParameterSection &section, BoundaryCondition &condition, unsigned int dim);
void read_network(ParameterSection &section, BoundaryCondition &condition, unsigned int dim);
void read_absorbing(ParameterSection &section, BoundaryCondition &condition, unsigned int dim);
} // namespace Continua

#endif
