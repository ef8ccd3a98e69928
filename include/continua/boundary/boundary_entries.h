#ifndef continua_boundary_boundary_entries_h
#define continua_boundary_boundary_entries_h

#include <continua/base/parameter_section.h>
#include <continua/boundary/boundary_condition.h>

namespace Continua
{
// Entries that several types of boundaries have. Each throws InputError.

void read_tangential(ParameterSection &section, BoundaryCondition &condition);
/// `by_itself`: what holds where the entry is left out.
void read_inflow_pressure(ParameterSection &section,
                          BoundaryCondition &condition,
                          InflowPressure by_itself);
} // namespace Continua

#endif
